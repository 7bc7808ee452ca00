//! The driver.

use crate::at_once;
use crate::card::{BUSY, Card, Opening};
use crate::facts::KnownFacts;
use crate::flights::{Flights, radius_mm};
use crate::gap::{self, Gap};
use crate::kept_settings::{self, KeptSettings};
use crate::lines::{Modal, jogs_alone, lines, parts, told_as};
use crate::place::Place;
use crate::report::Doing;
use crate::said;
use crate::tool_wait::{MODE, ToolWait};
use crate::upload::is_receipt;
use crate::zeros::Zeros;
use kerf_machine::driver::{
    Axes, CardJob, CardNews, CardTask, Changed, ControllerState, Driver, Facts, Garbled, Hold,
    LineKind, Order, Reply, Said, Sent, Shares, Signal, Ticket, ToldSetting, TouchOff, Trouble,
    Wired, Zero, ZeroChange, is_sound,
};
use std::collections::{BTreeMap, VecDeque};

/// Orders that are made and not known to be: a report comes ten times a second, and a board makes some 600 moves a second
/// at most on a serial line.
const UNTOLD: usize = 160;

/// Bytes of a short line.
const SHORT: usize = 12;

/// Modes that hold from the start: arcs in X and Y, millimetres, places and not ways, feeds a minute. A feed is told with them, as one that
/// was reset has none.
pub const MODES: &str = "G17G21G90G94F100";

/// One order of so many has its ticket on its line, where the controller tells the line that it makes.
const NUMBERED_EVERY: Ticket = 8;

/// Numbers of lines are below this: more than there are ever orders on their way.
const NUMBERS: Ticket = 1000;

/// A line longer than this is no answer.
const LONGEST: usize = 4096;

/// Phase of the driver: what is learnt before anything moves, and whether the controller is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// It did not say who it is: it may be starting, or run since long.
    Silent,
    /// It was asked about itself.
    Asked,
    /// It takes orders.
    Ready,
    /// The line was gone: what it has got is looked for.
    Gap,
    /// It slows down; then it is reset.
    Stopping,
    /// It was reset and has not greeted yet.
    Resetting,
    /// It stands after a stop: it begins anew.
    Stopped,
}

/// A line with what it belongs to.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub text: String,
    pub ticket: Option<Ticket>,
}

/// grbl 1.1 or grblHAL.
#[derive(Debug)]
pub struct Grbl {
    pub(crate) phase: Phase,
    pub(crate) told: KnownFacts,
    pub(crate) facts: Option<Facts>,
    pub(crate) trouble: Option<Trouble>,
    /// A setting of it that was changed to drive it.
    pub(crate) changed: Option<Changed>,
    /// It was told to change it.
    pub(crate) mended: bool,
    /// It moved when it was asked about itself.
    pub(crate) busy: bool,
    /// The place at which the probe ended the last order that probes.
    pub(crate) contact: Option<Axes>,
    /// It has come to the place to which it was ordered last.
    pub(crate) arrived: bool,
    /// Time when somebody looked at the line last.
    seen_s: f64,
    /// Time when it was asked where it is, before it was known.
    looked_s: f64,
    /// The line that is being received.
    pub(crate) hearing: Vec<u8>,
    /// Lines to be sent.
    pub(crate) queue: VecDeque<Line>,
    /// Lines that were sent and not answered.
    pub(crate) pending: VecDeque<Line>,
    /// Questions that it has put aside until the tool is in for which it waits: it answers them then, before all else.
    pub(crate) aside: VecDeque<Line>,
    pub(crate) out: Vec<u8>,
    pub(crate) flights: Flights,
    /// Place where the last order leaves the machine.
    pub(crate) planned: Axes,
    pub(crate) place: Place,
    pub(crate) doing: Doing,
    pub(crate) pins: String,
    /// Outputs that are on.
    pub(crate) on: u32,
    /// It has greeted: it started while its line was open.
    pub(crate) has_started: bool,
    /// Words that hold after the last order.
    pub(crate) modal: Modal,
    /// Shares at which it makes what it is told.
    pub(crate) shares: Shares,
    /// Time when it was told another one last.
    pub(crate) turned_s: f64,
    pub(crate) zeros: Zeros,
    pub(crate) kept: KeptSettings,
    /// Its card, and the file that it runs from it.
    pub(crate) card: Card,
    /// The tool for which it waits.
    pub(crate) tool: ToolWait,
    /// Outputs that are on after the last order.
    pub(crate) planned_on: u32,
    /// Time when it was told to stop.
    pub(crate) stopped_s: f64,
    /// Moment at which its reset was sent, seconds.
    pub(crate) reset_s: Option<f64>,
    /// The hold that was ordered.
    pub(crate) hold: Hold,
    /// The search for what was lost while the line was gone.
    pub(crate) gap: Gap,
    /// It has answered a move since it takes orders: its feed holds.
    pub(crate) has_moved: bool,
    /// Time when something came from it last.
    pub(crate) heard_s: f64,
    /// It has said since its reset that it is there.
    pub(crate) greets: bool,
    pub(crate) taken: Ticket,
    pub(crate) done: Ticket,
    /// Time when it was sent a line last, or answered one.
    pub(crate) asked_s: f64,
    pub(crate) replies: Vec<Result<Reply, Garbled>>,
}

impl Default for Grbl {
    fn default() -> Self {
        Self::new()
    }
}

/// A controller that does not say who it is is asked again after this, seconds. One that was reset by
/// opening its port needs about two seconds to start.
const GREETING_S: f64 = 1.0;

/// Whoever looks at the line looks more often than this, seconds, unless the computer sleeps.
const ASLEEP_S: f64 = 0.5;

/// While its place is not known it is asked so often where it is, seconds.
const LOOK_S: f64 = 0.1;

/// Said of one that runs a file by itself before it has told who it is.
const RUNS: &str = "it runs a file from its own card, and Kerf leaves it alone: kerf machine card follow tells of it";

/// A controller that stands answers a line within this, seconds: writing a setting takes longest.
pub(crate) const ANSWER_S: f64 = 2.0;

/// A controller that was told to stop and is not heard for so long is reset, seconds: its line back may be
/// broken, and a hold alone leaves its spindle on.
const DEAF_S: f64 = 2.0;

/// A report that comes so long after a signal is not older than it, seconds.
pub(crate) const STALE_S: f64 = 0.3;

impl Grbl {
    /// A controller of which nothing is known.
    pub fn new() -> Self {
        Self {
            phase: Phase::Silent,
            told: KnownFacts::default(),
            facts: None,
            trouble: None,
            changed: None,
            mended: false,
            busy: false,
            contact: None,
            arrived: true,
            seen_s: f64::NEG_INFINITY,
            looked_s: f64::NEG_INFINITY,
            hearing: Vec::new(),
            queue: VecDeque::new(),
            pending: VecDeque::new(),
            aside: VecDeque::new(),
            out: Vec::new(),
            flights: Flights::default(),
            planned: Axes::default(),
            place: Place::default(),
            doing: Doing::Idle,
            pins: String::new(),
            on: 0,
            has_started: false,
            modal: Modal::default(),
            shares: Shares::default(),
            turned_s: f64::NEG_INFINITY,
            zeros: Zeros::default(),
            kept: KeptSettings::default(),
            card: Card::default(),
            tool: ToolWait::default(),
            planned_on: 0,
            stopped_s: 0.0,
            reset_s: None,
            hold: Hold::None,
            gap: Gap::default(),
            has_moved: false,
            heard_s: f64::NEG_INFINITY,
            greets: false,
            taken: 0,
            done: 0,
            asked_s: f64::NEG_INFINITY,
            replies: Vec::new(),
        }
    }

    /// Returns its settings as it writes them, by their numbers.
    pub const fn settings(&self) -> &BTreeMap<u16, String> {
        self.told.texts()
    }

    /// Asks for the next part of its settings in its own words, where it has such: lists of them first, then what each does.
    /// Tells whether there was more to be asked.
    pub fn asks_settings(&mut self) -> bool {
        let lines = self.kept.asks_words(&self.told);
        let asks = !lines.is_empty();
        lines.into_iter().for_each(|line| self.say(line));
        asks
    }

    /// Changes a setting, while nothing moves.
    pub fn writes(&mut self, number: u16, value: &str) {
        self.say(kept_settings::line(number, value));
    }

    /// Time in which nobody looked at the line is no time in which an answer did not come.
    fn wakes(&mut self, now_s: f64) {
        let slept_s = now_s - self.seen_s;
        self.seen_s = now_s;
        if slept_s > ASLEEP_S && slept_s.is_finite() {
            let moments = [&mut self.asked_s, &mut self.stopped_s, &mut self.heard_s];
            for moment_s in moments.into_iter().chain(&mut self.reset_s) {
                *moment_s += slept_s;
            }
        }
    }

    /// Asks again what it has not told.
    fn ask_again(&mut self, now_s: f64) {
        let has_said_all = self.phase == Phase::Asked && !self.busy && self.told.is_known();
        // A file that it runs by itself hears no lines.
        if !has_said_all && !self.card.runs() && now_s - self.asked_s > GREETING_S {
            self.ask_all(now_s);
        }
        // One that sleeps or is held answers this alone; one that tells places of the workpiece tells its zero seldom.
        if now_s - self.looked_s > LOOK_S {
            self.looked_s = now_s;
            self.out.push(at_once::ASK);
        }
    }

    pub(crate) fn say(&mut self, text: impl Into<String>) {
        self.queue.push_back(Line { text: text.into(), ticket: None });
    }

    /// Asks who it is.
    pub(crate) fn ask_all(&mut self, now_s: f64) {
        self.phase = Phase::Asked;
        self.asked_s = now_s;
        (self.told, self.mended, self.busy) = (KnownFacts::default(), false, false);
        self.kept = KeptSettings::default();
        (self.queue, self.pending) = (VecDeque::new(), VecDeque::new());
        self.aside.clear();
        // An empty line first: whatever stands half received is answered and gone.
        ["", "$I", "$$", "$G", "$#"].into_iter().for_each(|line| self.say(line));
    }

    /// Takes orders from where it stands.
    pub(crate) fn begin(&mut self) {
        (self.phase, self.hold, self.has_moved) = (Phase::Ready, Hold::None, false);
        (self.planned, self.modal) = (self.position(), Modal::default());
        self.shares = Shares::default();
        if self.trouble.is_none() {
            self.say(MODES);
            // A reset has chosen another.
            let chosen = self.zeros.chosen().map(str::to_owned);
            chosen.into_iter().for_each(|system| self.say(system));
        }
    }

    /// Asks for its zero points, and which of them holds.
    pub(crate) fn asks_zeros(&mut self) {
        ["$#", "$G"].into_iter().for_each(|line| self.say(line));
    }

    /// Returns `true` if it stands because of a stop. It may be idle because the report is older than that.
    pub(crate) fn has_stopped(&self, now_s: f64) -> bool {
        let may_be_old = matches!(self.doing, Doing::Idle | Doing::Tool);
        self.doing.stands() && (!may_be_old || now_s - self.stopped_s > STALE_S)
    }

    pub(crate) fn reset(&mut self) {
        (self.phase, self.greets, self.reset_s) = (Phase::Resetting, false, None);
        self.card.was_reset();
        self.out.push(at_once::RESET);
    }

    /// Returns its place when it told last, machine frame.
    pub(crate) fn position(&self) -> Axes {
        self.place.machine().unwrap_or_default()
    }

    pub(crate) fn standing(&self) -> ControllerState {
        let (position, done) = (self.position(), self.done);
        ControllerState { position, moving: !self.doing.stands(), outputs: self.on, done }
    }

    fn take(&mut self, sent: &Sent, facts: &Facts) {
        let order = told_as(sent.order, self.planned, facts, self.shares);
        let lines = match self.tool.takes_jogs() {
            true => jogs_alone(&order, self.planned, facts),
            false => lines(&order, self.planned, facts, self.planned_on, &mut self.modal),
        };
        let mut lines = match lines {
            Ok(lines) => lines,
            Err(why) => {
                let refused = Trouble::Refused { number: 0, why: why.into() };
                let _ = self.trouble.get_or_insert(refused);
                return self.replies.push(Ok(Reply::Refused(sent.ticket, why)));
            }
        };
        self.taken = sent.ticket;
        let (to, blocks) = match sent.order {
            Order::Probe { to, .. } => {
                // The line is answered when the move is over.
                (self.contact, self.arrived) = (None, false);
                (to, 0)
            }
            Order::Move { to, .. } | Order::Jog { to, .. } => {
                self.arrived = false;
                let numbers = sent.ticket.is_multiple_of(NUMBERED_EVERY) && !self.tool.takes_jogs();
                self.number(&mut lines, sent.ticket, numbers);
                (to, usize::from(self.steps(to)))
            }
            Order::Arc { to, centre, sweep_rad, .. } => {
                self.arrived = false;
                // It is answered when the last of it is in the planner.
                self.number(&mut lines, sent.ticket, true);
                let radius_mm = radius_mm(self.planned, centre);
                (to, parts(radius_mm, sweep_rad, facts.arc_tolerance_mm))
            }
            Order::Output { line, on } => {
                self.planned_on = with(self.planned_on, line, on);
                (self.planned, 0)
            }
            Order::Spindle { .. } | Order::Home | Order::Unlock => (self.planned, 0),
        };
        self.flights.push(*sent, self.planned, blocks, lines.len());
        self.planned = to;
        let ticket = Some(sent.ticket);
        self.queue.extend(lines.into_iter().map(|text| Line { text, ticket }));
    }

    /// Writes the number of an order on its line, where the controller tells the line that it makes.
    fn number(&self, lines: &mut [String], ticket: Ticket, numbers: bool) {
        if let Some(first) = lines.first_mut()
            && self.told.tells_lines()
            && numbers
        {
            *first = format!("N{}{first}", ticket % NUMBERS);
        }
    }

    /// Returns the ticket of a line that it tells to make: the last one with this number that it was sent.
    pub(crate) const fn numbered(&self, line: u32) -> Option<Ticket> {
        let behind = (self.taken % NUMBERS + NUMBERS - line % NUMBERS) % NUMBERS;
        self.taken.checked_sub(behind)
    }

    /// Returns `true` if a move is a step of any motor: what is none does not reach the planner.
    pub(crate) fn steps(&self, to: Axes) -> bool {
        (0..to.0.len()).any(|axis| {
            let step = |place: f64| (place * self.told.steps(axis)).round();
            step(to.0[axis]) != step(self.planned.0[axis])
        })
    }
}

pub(crate) const fn with(outputs: u32, line: u8, on: bool) -> u32 {
    let bit = 1 << (line - 1);
    if on { outputs | bit } else { outputs & !bit }
}

impl Driver for Grbl {
    fn send(&mut self, sent: &Sent, _: f64) {
        if sent.ticket <= self.done {
            return self.replies.push(Ok(Reply::Done(sent.ticket)));
        }
        if sent.ticket <= self.taken
            || sent.ticket != self.taken + 1
            || self.phase != Phase::Ready
            || self.quiet()
            || self.flights.probing().is_some()
            || self.card.runs()
        {
            return;
        }
        if !is_sound(&sent.order) {
            let why = "no machine can do this";
            return self.replies.push(Ok(Reply::Refused(sent.ticket, why)));
        }
        if let Some(facts) = self.facts.take() {
            self.take(sent, &facts);
            self.facts = Some(facts);
        }
    }

    fn signal(&mut self, signal: Signal, now_s: f64) {
        self.take_signal(signal, now_s);
    }

    fn replies(&mut self, _: f64) -> Vec<Result<Reply, Garbled>> {
        std::mem::take(&mut self.replies)
    }

    fn window(&self) -> usize {
        self.told.planner + self.told.rx / SHORT + UNTOLD
    }

    fn quiet(&self) -> bool {
        self.flights.goes_home() || self.card.is_asked()
    }
}

impl Wired for Grbl {
    fn hear(&mut self, bytes: &[u8], now_s: f64) {
        self.wakes(now_s);
        if !bytes.is_empty() {
            self.heard_s = now_s;
        }
        for byte in bytes {
            match byte {
                _ if self.card.hears_byte(*byte, now_s) => {}
                b'\r' => {}
                // A file was given up, and its receiver answers what was on its way.
                _ if self.hearing.is_empty() && is_receipt(*byte) => {}
                b'\n' => {
                    let line =
                        String::from_utf8_lossy(&std::mem::take(&mut self.hearing)).into_owned();
                    self.line(line.trim(), now_s);
                }
                _ if self.hearing.len() < LONGEST => self.hearing.push(*byte),
                _ => {}
            }
        }
    }

    fn speak(&mut self, now_s: f64) -> Vec<u8> {
        self.wakes(now_s);
        if self.card.speaks(&mut self.out, now_s) {
            self.hearing.clear();
            return std::mem::take(&mut self.out);
        }
        let asks = matches!(self.phase, Phase::Silent | Phase::Asked);
        if asks && self.facts.is_none() {
            self.ask_again(now_s);
        }
        let silent_s = now_s - self.stopped_s.max(self.heard_s);
        if self.phase == Phase::Stopping && silent_s > DEAF_S {
            self.reset();
        }
        if self.phase == Phase::Resetting && !self.greets {
            let sent_s = *self.reset_s.get_or_insert(now_s);
            // The reset did not come through: its spindle still turns.
            if now_s - sent_s > DEAF_S {
                self.reset();
            }
        }
        if self.phase == Phase::Gap {
            gap::looks_through_gap(self, now_s);
            return std::mem::take(&mut self.out);
        }
        let mut used: usize = self.pending.iter().map(|line| line.text.len() + 1).sum();
        while let Some(line) = self.queue.front() {
            used += line.text.len() + 1;
            // What it is asked about itself is answered line by line.
            if self.card.runs()
                || used >= self.told.rx
                || (self.phase == Phase::Asked && !self.pending.is_empty())
            {
                break;
            }
            self.out.extend_from_slice(line.text.as_bytes());
            self.out.push(b'\n');
            self.pending.extend(self.queue.pop_front());
            self.asked_s = now_s;
        }
        std::mem::take(&mut self.out)
    }

    fn facts(&self) -> Option<&Facts> {
        self.facts.as_ref()
    }

    fn stands(&self) -> Option<ControllerState> {
        self.facts.as_ref().map(|_| self.standing())
    }

    fn contact(&self) -> Option<Axes> {
        self.contact
    }

    fn waits(&self) -> Option<&'static str> {
        let ours = matches!(self.hold, Hold::Ordered | Hold::Stands);
        let is_held = matches!(self.doing, Doing::Slowing | Doing::Held);
        let waits = self.doing.waits().filter(|_| !(ours && is_held));
        let asked = matches!(self.phase, Phase::Silent | Phase::Asked);
        let runs = (asked && self.card.runs()).then_some(RUNS);
        self.tool.waits(self.told.of(MODE)).or(waits).or(runs)
    }

    fn hold(&self) -> Hold {
        self.hold
    }

    fn waits_for_tool(&self) -> bool {
        self.tool.is_on()
    }

    fn touch_off(&self) -> Option<TouchOff> {
        self.tool.touch_off(self.told.of(MODE))
    }

    fn shares(&self) -> Option<Shares> {
        Some(self.shares)
    }

    fn zeros(&self) -> &[Zero] {
        self.zeros.told()
    }

    fn keeps_zero(&mut self, name: &str, change: ZeroChange) -> bool {
        let axes = self.facts.as_ref().map_or(0, |facts| facts.axes);
        let rests = self.phase == Phase::Ready && self.flights.is_empty() && self.trouble.is_none();
        let Some(line) = self.zeros.line(name, change, axes).filter(|_| rests) else {
            return false;
        };
        self.say(line);
        self.asks_zeros();
        true
    }

    fn steps_per_mm(&self) -> Vec<f64> {
        let axes = self.facts.as_ref().map_or(0, |facts| facts.axes);
        let steps = (0..axes).map(|axis| self.told.steps(axis));
        steps.take_while(|steps| *steps > 0.0).collect()
    }

    fn setting(&self, number: u16) -> Option<&str> {
        self.settings().get(&number).map(String::as_str)
    }

    fn told_settings(&self) -> Vec<ToldSetting> {
        let changed = self.changed();
        let told = |(number, value): (&u16, &String)| {
            let was = changed.as_ref().filter(|changed| changed.number == *number);
            let value = was.map_or_else(|| value.trim().to_owned(), |it| it.was.to_string());
            kept_settings::told(*number, value, &self.told)
        };
        self.settings().iter().map(told).collect()
    }

    fn keeps_setting(&mut self, number: u16, value: &str) -> Result<(), String> {
        if self.phase != Phase::Ready || !self.flights.is_empty() || self.trouble.is_some() {
            return Err("it is at work, or takes no orders".into());
        }
        self.kept.takes(self.told.texts(), number, value)?;
        self.writes(number, value);
        self.say(kept_settings::ASK);
        Ok(())
    }

    fn asks(&mut self, question: &str) -> Result<(), String> {
        if self.phase != Phase::Ready || !self.flights.is_empty() || self.trouble.is_some() {
            return Err("it is at work, or takes no orders".into());
        }
        self.kept.takes_question(question)?;
        self.say(question);
        Ok(())
    }

    fn takes_refusal(&mut self) -> Option<String> {
        self.kept.takes_refusal()
    }

    fn knows_zeros(&self) -> bool {
        self.has_said_all()
    }

    fn at_once(&self, byte: u8) -> Option<Said> {
        said::at_once(byte)
    }

    fn sends_file(&self) -> bool {
        self.card.uploads()
    }

    fn said(&self, line: &str, is_sent: bool) -> Said {
        if is_sent { Said::plain(LineKind::Line) } else { said::came(line, &self.told) }
    }

    fn has_card(&self) -> Result<(), &'static str> {
        self.told.card().map(drop)
    }

    fn does_on_card(&mut self, task: CardTask) -> Result<(), String> {
        let words = self.told.card()?;
        let rests = self.flights.is_empty() && self.has_said_all();
        if self.phase != Phase::Ready || !rests || self.trouble.is_some() {
            return Err(BUSY.into());
        }
        match self.card.begins(task, words)? {
            Opening::Line(line) => self.say(line),
            Opening::Bytes(bytes) => self.out.extend(bytes),
        }
        Ok(())
    }

    fn card_news(&mut self) -> Option<CardNews> {
        self.card.takes_news()
    }

    fn leaves_card(&mut self) {
        let end = self.card.gives_up(self.seen_s);
        self.out.extend(end);
    }

    fn card_job(&self) -> Option<CardJob> {
        self.card.job()
    }

    fn line_is_back(&mut self, _: f64) {
        // A file that it runs by itself goes on: nothing of Kerf's was under way.
        if !self.card.runs() {
            gap::begins_gap(self);
        }
    }

    fn changed(&self) -> Option<Changed> {
        self.changed
    }

    fn puts_back(&mut self, changed: Changed) -> bool {
        let Changed { number, was, is } = changed;
        if self.told.of(number) != Some(f64::from(is)) {
            return true;
        }
        if self.phase == Phase::Ready && self.queue.is_empty() && self.pending.is_empty() {
            self.say(format!("${number}={was}"));
        }
        false
    }

    fn trouble(&self) -> Option<&Trouble> {
        self.trouble.as_ref()
    }

    fn begin_anew(&mut self) -> bool {
        if self.phase != Phase::Stopped {
            return false;
        }
        (self.arrived, self.contact) = (true, None);
        self.flights.clear();
        (self.taken, self.done, self.on, self.planned_on) = (0, 0, 0, 0);
        self.trouble = None;
        self.replies.clear();
        self.begin();
        true
    }
}
