//! The receiving side of the driver: lines of the controller and what follows from them.

use crate::at_once;
use crate::driver::{ANSWER_S, Grbl, Line, MODES, Phase, STALE_S, with};
use crate::error_texts;
use crate::facts::{self, INPUTS, PROBE, PROBE_INPUT};
use crate::gap;
use crate::kept_settings::{self, BUSY};
use crate::lines::{Modal, straight};
use crate::place::{millimetres, on_steps};
use crate::report::{Doing, Report, axes};
use crate::tool_wait::{JOG_CANCEL, REFERENCE, TOOL, TOUCH};
use kerf_machine::driver::{Driver, Facts, Garbled, Hold, Order, Reply, Ticket, Trouble};

/// A place that is farther than this from the one that was ordered is another, mm: more than a step of any machine.
const ELSEWHERE_MM: f64 = 0.05;

/// A place that is farther than this from everything that was ordered is none of the path, mm: more than a step, and than
/// any corner is cut.
const OFF_PATH_MM: f64 = 0.1;

impl Grbl {
    pub(crate) fn line(&mut self, line: &str, now_s: f64) {
        if line.is_empty() {
        } else if line == "ok" {
            self.answered(now_s);
        } else if let Some(number) = numbered(line, "error:") {
            self.refused(number);
        } else if let Some(number) = numbered(line, "ALARM:") {
            self.alarm(number);
        } else if line.starts_with('<') {
            match Report::read(line) {
                Some(report) => self.report(&report, now_s),
                None => self.replies.push(Err(Garbled)),
            }
        } else if let Some(told) = line.strip_prefix("[PRB:") {
            self.touched(told);
        } else if self.card.hears_line(line, &self.told) {
            if let Some((number, why)) = self.card.takes_fault() {
                let _ = self.trouble.get_or_insert(Trouble::Refused { number, why: why.into() });
            }
        } else if line.starts_with('[') && line.ends_with(']') {
            self.bracket(line);
        } else if line.starts_with("Grbl") {
            self.greeted(now_s);
        } else if !self.told.setting(line) && !line.starts_with('>') {
            self.replies.push(Err(Garbled));
        }
    }

    fn bracket(&mut self, line: &str) {
        let told = line.trim_matches(['[', ']']).split_once(':');
        if let Some(("GC", modes)) = told {
            self.zeros.modes(modes);
        }
        if !told.is_some_and(|(name, value)| self.zeros.bracket(name, value, &self.told)) {
            self.told.bracket(line);
        }
    }

    /// It has started.
    fn greeted(&mut self, now_s: f64) {
        self.pending.clear();
        self.aside.clear();
        (self.on, self.has_started) = (0, true);
        match self.phase {
            Phase::Resetting => {
                self.greets = true;
                self.out.push(at_once::ASK);
            }
            Phase::Silent | Phase::Asked => self.ask_all(now_s),
            Phase::Ready | Phase::Gap | Phase::Stopping | Phase::Stopped => {
                let _ = self.trouble.get_or_insert(Trouble::Restarted);
                self.fail();
                self.phase = Phase::Stopped;
            }
        }
    }

    fn answered(&mut self, now_s: f64) {
        if self.phase == Phase::Gap {
            return gap::answers_in_gap(self);
        }
        // The answers to what it had put aside may come before the report that it goes on.
        let line = self.pending.pop_front().or_else(|| self.aside.pop_front());
        let Some(line) = line else { return self.replies.push(Err(Garbled)) };
        self.asked_s = now_s;
        if let Some(ticket) = line.ticket
            && self.flights.answered(ticket)
        {
            self.has_moved |= self.flights.moves(ticket);
            self.replies.push(Ok(Reply::Taken(ticket)));
            self.returns(ticket);
        }
        if line.text.contains('=') {
            self.changed = self.told.mend().or(self.changed);
            self.told.setting(&line.text);
        }
        if line.text == TOUCH && self.tool.ends_touch(self.zeros.has_reference()) {
            if !self.zeros.has_reference() {
                self.say(REFERENCE);
            }
            self.asks_zeros();
        }
        if let Some(next) = self.card.answered(&line.text, now_s) {
            self.say(next);
        }
        self.follows_settings(&line.text);
        self.asks_on();
    }

    /// Learns anew what follows from its settings, where the answer to a line has told others than before.
    fn follows_settings(&mut self, answered: &str) {
        let Some(before) = self.facts.as_ref().filter(|_| self.phase == Phase::Ready) else {
            return;
        };
        if !self.told.takes_news() {
            return;
        }
        let facts = Facts { is_fresh: before.is_fresh, ..self.told.facts(before.axes) };
        if let Some(why) = self.told.unfit(facts.axes) {
            let _ = self.trouble.get_or_insert(Trouble::Unfit { why });
        }
        // Somebody else has it hide its place; what Kerf puts back itself is no answer to this question.
        if let Some(changed) = self.told.mend().filter(|_| answered == kept_settings::ASK) {
            self.say(kept_settings::line(changed.number, &changed.is.to_string()));
        }
        self.facts = Some(facts);
    }

    /// All that it was asked about itself is answered: a setting that hides its place is changed, then it is asked
    /// where it is.
    fn asks_on(&mut self) {
        if self.phase != Phase::Asked || !self.has_said_all() {
            return;
        }
        let mend = self.told.mend().filter(|_| !self.mended);
        self.mended |= mend.is_some();
        if mend.is_none() && self.told.asks_words() {
            ["$EA", "$EE"].into_iter().for_each(|line| self.say(line));
            return;
        }
        match mend {
            Some(changed) => self.say(format!("${}={}", changed.number, changed.is)),
            None => self.out.push(at_once::ASK),
        }
    }

    fn refused(&mut self, number: u16) {
        if self.phase == Phase::Gap {
            return gap::answers_in_gap(self);
        }
        let line = self.pending.pop_front();
        let why = self.told.error(number);
        if self.phase == Phase::Asked {
            // Older versions do not know everything that is asked; an empty line may end a garbled one. While it moves
            // it tells nothing of itself: it is asked again.
            self.busy |= number == BUSY && line.is_some_and(|line| !line.text.contains('='));
            return self.asks_on();
        }
        let asked = line.as_ref().filter(|line| line.ticket.is_none());
        if asked.is_some_and(|line| line.text == TOUCH) {
            return self.tool.refuses_touch(format!("error {number}: {why}"));
        }
        let text = asked.map(|line| &*line.text);
        if self.card.is_refused(text, (number, &why), &self.told) {
            return;
        }
        if self.kept.is_refused(text, number, &why) {
            return;
        }
        let _ = self.trouble.get_or_insert(Trouble::Refused { number, why });
        match line.and_then(|line| line.ticket) {
            Some(ticket) => {
                self.replies.push(Ok(Reply::Refused(ticket, error_texts::error(number))))
            }
            None => self.fail(),
        }
    }

    pub(crate) fn alarm(&mut self, number: u16) {
        let (why, lost) = (self.told.alarm(number), error_texts::is_lost(number));
        self.trouble = Some(Trouble::Alarm { number, why, lost });
        self.on = 0;
        self.fail();
    }

    /// It tells where the probe changed: `-1.000,2.000,-3.125:1`, in the machine frame; 0 where it did not.
    fn touched(&mut self, told: &str) {
        let place = told.trim_end_matches(']').rsplit_once(':').and_then(|(place, changed)| {
            let (place, _) = axes(place)?;
            Some((place, changed))
        });
        match place {
            None => self.replies.push(Err(Garbled)),
            Some((_, changed)) if self.tool.is_touching() => self.tool.hears_touch(changed == "1"),
            Some((place, "1")) if self.flights.probing().is_some() => {
                self.contact = Some(on_steps(millimetres(place, &self.told), &self.told));
            }
            Some(_) => {}
        }
    }

    /// Behind a contact it stands at the end of its ramp: it goes back to where the contact was.
    fn returns(&mut self, ticket: Ticket) {
        let probing = self.flights.probing().filter(|sent| sent.ticket == ticket);
        let Some(Order::Probe { to, speed_mm_s, .. }) = probing.map(|sent| sent.order) else {
            return;
        };
        let Some(contact) = self.contact.filter(|contact| *contact != self.planned) else { return };
        let Some(facts) = &self.facts else { return };
        if let Ok(text) = straight(to, contact, speed_mm_s, facts, &mut self.modal) {
            self.planned = contact;
            self.flights.extends(0);
            self.queue.push_back(Line { text, ticket: Some(ticket) });
        }
    }

    /// Nothing that was ordered will be done.
    pub(crate) fn fail(&mut self) {
        let why = "it stopped by itself";
        if self.done < self.taken {
            self.replies.push(Ok(Reply::Refused(self.done + 1, why)));
        }
        self.queue.clear();
    }

    fn report(&mut self, report: &Report, now_s: f64) {
        self.doing = report.doing;
        self.follows_hold();
        self.place.hear(report, &self.told);
        report.offset.into_iter().for_each(|zero| self.zeros.hear(zero));
        // What was told before it heard of another share is old.
        if let Some(shares) = report.shares.filter(|_| now_s - self.turned_s > STALE_S) {
            self.shares = shares;
        }
        self.tell_inputs(&report.pins);
        self.hears_of_tool(report.doing, now_s);
        if self.card.follows(report, now_s) {
            self.ends_card_file();
        }
        let runs = self.card.runs();
        match self.phase {
            Phase::Silent | Phase::Asked if runs => {}
            Phase::Silent | Phase::Asked => self.learns(report),
            Phase::Ready if runs => self.is_alarmed(report.doing),
            Phase::Ready => self.follows(report, now_s),
            Phase::Gap => gap::reports_in_gap(self, now_s),
            Phase::Stopping if self.tool.takes_jogs() => self.ends_jog(now_s),
            Phase::Stopping if self.has_stopped(now_s) => self.reset(),
            // A hold that came while its spindle came up is forgotten by then.
            Phase::Stopping if self.runs_on(now_s) => self.out.push(at_once::HOLD),
            // One that was stopped before it told of itself is asked now.
            Phase::Resetting if self.greets && self.facts.is_none() => self.phase = Phase::Silent,
            Phase::Resetting if self.greets => self.phase = Phase::Stopped,
            Phase::Stopping | Phase::Resetting | Phase::Stopped => {}
        }
        self.replies.push(Ok(Reply::State(self.standing())));
    }

    /// It waits for a tool, or does no more. What it is asked about itself it answers once it was told that it was heard.
    fn hears_of_tool(&mut self, doing: Doing, now_s: f64) {
        self.tool.sees(doing, !self.flights.is_empty());
        if !self.tool.is_on() {
            let since = std::mem::replace(&mut self.pending, std::mem::take(&mut self.aside));
            self.pending.extend(since);
        }
        if matches!(self.phase, Phase::Silent | Phase::Asked) && self.tool.hears() {
            self.out.push(TOOL);
            self.ask_all(now_s);
        }
    }

    /// A jog was ended while it waits for a tool: it stands, and begins anew without a reset.
    fn ends_jog(&mut self, now_s: f64) {
        if self.has_stopped(now_s) && self.has_said_all() {
            self.phase = Phase::Stopped;
        } else if self.runs_on(now_s) {
            self.out.push(JOG_CANCEL);
        }
    }

    /// Follows the hold that was ordered: what moves again behind it was had to go on at the controller.
    const fn follows_hold(&mut self) {
        self.hold = match (self.hold, self.doing) {
            (Hold::Ordered, Doing::Held) => Hold::Stands,
            (Hold::Stands, Doing::Run | Doing::Idle) => Hold::WentOn,
            (hold, _) => hold,
        };
    }

    fn runs_on(&self, now_s: f64) -> bool {
        self.doing == Doing::Run && now_s - self.stopped_s > STALE_S
    }

    /// It is asked about itself, and tells where it is.
    fn learns(&mut self, report: &Report) {
        if let Some(why) = report.doing.unfit() {
            self.trouble = Some(Trouble::Unfit { why });
        } else if self.phase == Phase::Asked && !self.busy && self.has_said_all() {
            self.ready(report);
        }
    }

    /// It has told everything; a place of the workpiece without its zero is none.
    fn ready(&mut self, report: &Report) {
        let knows_planner = report.free.is_none_or(|room| self.told.learns_planner(room));
        if self.place.machine().is_none() || !knows_planner {
            return;
        }
        let facts = self.told.facts(report.axes);
        let hides = "it does not tell its buffers: set $10=3, or $10=511 in grblHAL";
        let unfit = self.told.unfit(report.axes).or(report.free.is_none().then_some(hides));
        self.trouble = match (unfit, report.doing) {
            (Some(why), _) => Some(Trouble::Unfit { why }),
            (None, Doing::Alarm(_)) => Some(Trouble::Locked { why: facts::locked(facts.homes) }),
            (None, _) => None,
        };
        self.facts = Some(Facts { is_fresh: self.has_started, ..facts });
        self.begin();
    }

    /// It is at work.
    fn follows(&mut self, report: &Report, now_s: f64) {
        if report.doing.waits().is_some() {
            self.flights.waits(now_s);
        }
        self.keeps_to_its_path();
        if let Some(free) = report.free {
            self.flights.left(self.told.left(free), now_s);
        }
        let comes_to = report.line.filter(|_| self.told.tells_lines());
        if let Some(ticket) = comes_to.and_then(|line| self.numbered(line)) {
            self.flights.come_to(ticket, now_s);
        }
        self.flights.passes(self.position(), now_s);
        self.finish(now_s);
        self.misses_answer(now_s);
        self.is_alarmed(report.doing);
        match report.doing {
            _ if self.trouble.is_some() => {}
            Doing::Check | Doing::Sleep => {
                let why = report.doing.unfit().unwrap_or_default();
                self.trouble = Some(Trouble::Unfit { why });
                self.fail();
            }
            // It has touched a tool off where it stands now, or somebody has moved it.
            Doing::Tool if self.has_said_all() && self.flights.is_empty() => {
                (self.planned, self.arrived) = (self.position(), true);
            }
            Doing::Idle if self.has_said_all() && self.flights.is_empty() => {
                self.stands_there();
                if self.zeros.are_stale() {
                    self.asks_zeros();
                }
                if self.kept.is_due(now_s) {
                    self.say(kept_settings::ASK);
                    if !self.kept.has_asked_words() {
                        self.asks_settings();
                    }
                } else if self.kept.has_asked_words() {
                    self.asks_settings();
                }
            }
            _ => {}
        }
    }

    /// A file of its card is over: its modes may be others than Kerf's.
    fn ends_card_file(&mut self) {
        (self.planned, self.arrived, self.modal) = (self.position(), true, Modal::default());
        if self.phase == Phase::Ready && self.trouble.is_none() {
            self.say(MODES);
            self.asks_zeros();
        }
    }

    /// It has an alarm, and the line that told of it did not come through.
    fn is_alarmed(&mut self, doing: Doing) {
        if let (Doing::Alarm(number), None) = (doing, &self.trouble) {
            self.alarm(number.unwrap_or(0));
        }
    }

    /// The place that it told last lies on the way of something that is under way: a line that was garbled leads elsewhere.
    fn keeps_to_its_path(&mut self) {
        let far_mm = self.flights.distance_mm(self.position());
        if self.trouble.is_none() && far_mm.is_some_and(|far_mm| far_mm > OFF_PATH_MM) {
            self.is_elsewhere("it has left its path");
        }
    }

    fn is_elsewhere(&mut self, why: &'static str) {
        self.trouble = Some(Trouble::Elsewhere { why });
        self.fail();
    }

    /// It stands with nothing left to do, at the place to which it was told to go: a line that was garbled on its way
    /// leads elsewhere. Somebody may have moved it since by hand.
    fn stands_there(&mut self) {
        let place = self.position();
        let apart = place.minus(self.planned).0.iter().any(|way| way.abs() > ELSEWHERE_MM);
        if !apart {
            self.arrived = true;
        } else if self.arrived {
            self.planned = place;
        } else {
            self.is_elsewhere("it stands elsewhere than it was told to");
        }
    }

    /// Returns `true` if every line is sent and answered.
    pub fn has_said_all(&self) -> bool {
        self.pending.is_empty() && self.queue.is_empty()
    }

    fn finish(&mut self, now_s: f64) {
        let stands =
            self.doing == Doing::Idle || self.doing == Doing::Tool && self.tool.takes_jogs();
        while let Some(flight) = self.flights.done(stands, now_s) {
            self.done = flight.sent.ticket;
            match flight.sent.order {
                Order::Output { line, on } => self.on = with(self.on, line, on),
                Order::Home | Order::Unlock => {
                    (self.planned, self.trouble) = (self.position(), None);
                }
                Order::Move { .. }
                | Order::Jog { .. }
                | Order::Arc { .. }
                | Order::Probe { .. }
                | Order::Spindle { .. } => {}
            }
            self.replies.push(Ok(Reply::Done(self.done)));
            if let (Order::Probe { active, .. }, Some(_)) = (flight.sent.order, self.contact) {
                self.tell_probe(active);
            }
        }
    }

    /// It stands, and a line that it must have read long ago is not answered: nobody knows whether it
    /// took it.
    fn misses_answer(&mut self, now_s: f64) {
        let waits = !self.pending.is_empty() && self.doing == Doing::Idle && !self.quiet();
        if waits && self.trouble.is_none() && now_s - self.asked_s > ANSWER_S {
            let why = "an answer did not come through: look at the cable".into();
            self.trouble = Some(Trouble::Refused { number: 0, why });
            self.fail();
        }
    }

    /// The contact that ended a move is told behind it, whatever reports say meanwhile.
    fn tell_probe(&mut self, on: bool) {
        self.pins.retain(|pin| pin != PROBE);
        if on {
            self.pins.push(PROBE);
        }
        self.replies.push(Ok(Reply::Input { line: PROBE_INPUT, on }));
    }

    fn tell_inputs(&mut self, pins: &str) {
        let mut pins = pins.to_owned();
        if self.flights.probing().is_some() {
            pins.retain(|pin| pin != PROBE);
            pins.extend(self.pins.chars().filter(|pin| *pin == PROBE));
        }
        for (pin, line) in INPUTS {
            let (was, on) = (self.pins.contains(pin), pins.contains(pin));
            if was != on {
                self.replies.push(Ok(Reply::Input { line, on }));
            }
        }
        self.pins = pins;
    }
}

fn numbered(line: &str, before: &str) -> Option<u16> {
    line.strip_prefix(before)?.parse().ok()
}
