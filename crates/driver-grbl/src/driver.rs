//! The driver.

use crate::facts::{self, Told};
use crate::flights::Flights;
use crate::lines::lines;
use crate::report::{Doing, Frame, Report};
use crate::words;
use kerf_machine::driver::{
    Axes, Driver, Facts, Garbled, Order, Reply, Sent, Signal, Standing, Ticket, Trouble, Wired,
    is_sound,
};
use std::collections::VecDeque;

/// Orders that it keeps: enough for the planner and the receive buffer of the larger boards.
const WINDOW: usize = 48;

/// Modes that hold from the start: millimetres, places and not ways, feeds a minute.
pub const MODES: &str = "G21G90G94";

/// A line longer than this is no answer.
const LONGEST: usize = 1024;

/// Characters that act at once and are no part of a line.
mod at_once {
    /// Feed override: back to 100 %, 10 % and 1 % up and down.
    const FEED: u8 = 0x90;
    const TEN_UP: u8 = 0x91;
    const TEN_DOWN: u8 = 0x92;
    const ONE_UP: u8 = 0x93;
    const ONE_DOWN: u8 = 0x94;

    /// Commands that set the feed override to so many percent, 10 to 200.
    pub fn feed(percent: u8) -> Vec<u8> {
        let off = i32::from(percent.clamp(10, 200)) - 100;
        let steps =
            |by: i32, up, down| vec![if by > 0 { up } else { down }; by.unsigned_abs() as usize];
        let (tens, ones) = (off / 10, off % 10);
        [vec![FEED], steps(tens, TEN_UP, TEN_DOWN), steps(ones, ONE_UP, ONE_DOWN)].concat()
    }

    pub const ASK: u8 = b'?';
    pub const HOLD: u8 = b'!';
    pub const RESUME: u8 = b'~';
    pub const RESET: u8 = 0x18;
}

/// Phase of the driver: what is learnt before anything moves, and whether the controller is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    /// It did not say who it is: it may be starting, or run since long.
    Silent,
    /// It was asked about itself.
    Asked,
    /// It takes orders.
    Ready,
    /// It slows down; then it is reset.
    Stopping,
    /// It was reset and has not greeted yet.
    Resetting,
    /// It stands after a stop: it begins anew.
    Stopped,
}

/// A line with what it belongs to.
#[derive(Clone, Debug)]
struct Line {
    text: String,
    ticket: Option<Ticket>,
}

/// grbl 1.1 or grblHAL.
#[derive(Debug)]
pub struct Grbl {
    phase: Phase,
    told: Told,
    facts: Option<Facts>,
    trouble: Option<Trouble>,
    /// The line that is being received.
    hearing: Vec<u8>,
    /// Lines to be sent.
    queue: VecDeque<Line>,
    /// Lines that were sent and not answered.
    pending: VecDeque<Line>,
    out: Vec<u8>,
    flights: Flights,
    /// Place where the last order leaves the machine.
    planned: Axes,
    position: Axes,
    offset: Axes,
    doing: Doing,
    pins: String,
    /// Outputs that are on.
    on: u32,
    /// Outputs that are on after the last order.
    planned_on: u32,
    /// Time when it was told to stop.
    stopped_s: f64,
    /// Time when something came from it last.
    heard_s: f64,
    /// It has said since its reset that it is there.
    greets: bool,
    taken: Ticket,
    done: Ticket,
    /// Time when it was sent a line last, or answered one.
    asked_s: f64,
    replies: Vec<Result<Reply, Garbled>>,
}

impl Default for Grbl {
    fn default() -> Self {
        Self::new()
    }
}

/// A controller that does not say who it is is asked again after this, seconds. One that was reset by
/// opening its port needs about two seconds to start.
const GREETING_S: f64 = 1.0;

/// A controller that stands answers a line within this, seconds: writing a setting takes longest.
const ANSWER_S: f64 = 2.0;

/// A controller that was told to stop and is not heard for so long is reset, seconds: its line back may be
/// broken, and a hold alone leaves its spindle on.
const DEAF_S: f64 = 2.0;

/// A report that comes so long after a signal is not older than it, seconds.
const STALE_S: f64 = 0.3;

impl Grbl {
    /// A controller of which nothing is known.
    pub fn new() -> Self {
        Self {
            phase: Phase::Silent,
            told: Told::default(),
            facts: None,
            trouble: None,
            hearing: Vec::new(),
            queue: VecDeque::new(),
            pending: VecDeque::new(),
            out: Vec::new(),
            flights: Flights::default(),
            planned: Axes::default(),
            position: Axes::default(),
            offset: Axes::default(),
            doing: Doing::Idle,
            pins: String::new(),
            on: 0,
            planned_on: 0,
            stopped_s: 0.0,
            heard_s: f64::NEG_INFINITY,
            greets: false,
            taken: 0,
            done: 0,
            asked_s: f64::NEG_INFINITY,
            replies: Vec::new(),
        }
    }

    fn say(&mut self, text: impl Into<String>) {
        self.queue.push_back(Line { text: text.into(), ticket: None });
    }

    /// Asks who it is.
    fn ask_all(&mut self, now_s: f64) {
        self.phase = Phase::Asked;
        self.asked_s = now_s;
        self.told = Told::default();
        (self.queue, self.pending) = (VecDeque::new(), VecDeque::new());
        // An empty line first: whatever stands half received is answered and gone.
        ["", "$I", "$$"].into_iter().for_each(|line| self.say(line));
    }

    fn line(&mut self, line: &str, now_s: f64) {
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
        } else if line.starts_with('[') && line.ends_with(']') {
            self.told.bracket(line);
        } else if line.starts_with("Grbl") {
            self.greeted(now_s);
        } else if !self.told.setting(line) && !line.starts_with('>') {
            self.replies.push(Err(Garbled));
        }
    }

    /// It has started.
    fn greeted(&mut self, now_s: f64) {
        self.pending.clear();
        self.on = 0;
        match self.phase {
            Phase::Resetting => {
                self.greets = true;
                self.out.push(at_once::ASK);
            }
            Phase::Silent | Phase::Asked => self.ask_all(now_s),
            Phase::Ready | Phase::Stopping | Phase::Stopped => {
                let _ = self.trouble.get_or_insert(Trouble::Restarted);
                self.fail();
                self.phase = Phase::Stopped;
            }
        }
    }

    fn answered(&mut self, now_s: f64) {
        let Some(line) = self.pending.pop_front() else { return self.replies.push(Err(Garbled)) };
        self.asked_s = now_s;
        if let Some(ticket) = line.ticket {
            if self.flights.answered(ticket) {
                self.replies.push(Ok(Reply::Taken(ticket)));
            }
        } else if self.phase == Phase::Asked && self.pending.is_empty() && self.queue.is_empty() {
            self.out.push(at_once::ASK);
        }
    }

    fn refused(&mut self, number: u16) {
        let line = self.pending.pop_front();
        let why = words::error(number);
        if self.phase == Phase::Asked {
            // Older versions do not know everything that is asked; an empty line may end a garbled one.
            return;
        }
        let _ = self.trouble.get_or_insert(Trouble::Refused { number, why });
        match line.and_then(|line| line.ticket) {
            Some(ticket) => self.replies.push(Ok(Reply::Refused(ticket, why))),
            None => self.fail(),
        }
    }

    fn alarm(&mut self, number: u16) {
        let (why, lost) = (words::alarm(number), words::is_lost(number));
        self.trouble = Some(Trouble::Alarm { number, why, lost });
        self.on = 0;
        self.fail();
    }

    /// Nothing that was ordered will be done.
    fn fail(&mut self) {
        let why = "it stopped by itself";
        if self.done < self.taken {
            self.replies.push(Ok(Reply::Refused(self.done + 1, why)));
        }
        self.queue.clear();
    }

    fn report(&mut self, report: &Report, now_s: f64) {
        self.doing = report.doing;
        self.offset = report.offset.unwrap_or(self.offset);
        if let Some((frame, place)) = report.place {
            let work = frame == Frame::Work;
            self.position = if work { place.plus(self.offset) } else { place };
        }
        self.tell_inputs(&report.pins);
        if self.phase == Phase::Asked && self.pending.is_empty() && self.queue.is_empty() {
            self.ready(report);
        }
        if let Some(free) = report.free {
            self.told.planner = self.told.planner.max(free);
            self.flights.left(self.told.planner - free, now_s);
        }
        if self.phase == Phase::Ready {
            self.finish(now_s);
            self.misses_answer(now_s);
        }
        match self.phase {
            Phase::Stopping if self.has_stopped(now_s) => self.reset(),
            Phase::Resetting if self.greets => self.phase = Phase::Stopped,
            _ => {}
        }
        self.replies.push(Ok(Reply::Standing(self.standing())));
    }

    /// It has told everything.
    fn ready(&mut self, report: &Report) {
        if report.place.is_none() {
            return;
        }
        let facts = self.told.facts(report.axes);
        if report.doing == Doing::Alarm {
            self.trouble = Some(Trouble::Locked { why: facts::locked(facts.homes) });
        }
        self.facts = Some(facts);
        self.begin();
        if let Some(mend) = self.told.mend() {
            self.say(mend);
        }
    }

    /// Takes orders from where it stands.
    fn begin(&mut self) {
        self.phase = Phase::Ready;
        self.planned = self.position;
        if self.trouble.is_none() {
            self.say(MODES);
        }
    }

    fn finish(&mut self, now_s: f64) {
        let stands = self.doing == Doing::Idle;
        while let Some(flight) = self.flights.done(stands, now_s) {
            self.done = flight.sent.ticket;
            match flight.sent.order {
                Order::Output { line, on } => self.on = with(self.on, line, on),
                Order::Home | Order::Unlock => {
                    (self.planned, self.trouble) = (self.position, None);
                }
                Order::Move { .. } | Order::Spindle { .. } => {}
            }
            self.replies.push(Ok(Reply::Done(self.done)));
        }
    }

    /// It stands, and a line that it must have read long ago is not answered: nobody knows whether it
    /// took it.
    fn misses_answer(&mut self, now_s: f64) {
        let waits = !self.pending.is_empty() && self.doing == Doing::Idle && !self.quiet();
        if waits && self.trouble.is_none() && now_s - self.asked_s > ANSWER_S {
            let why = "an answer did not come through: look at the cable";
            self.trouble = Some(Trouble::Refused { number: 0, why });
            self.fail();
        }
    }

    /// Returns `true` if nothing moves.
    fn stands(&self) -> bool {
        matches!(self.doing, Doing::Idle | Doing::Held | Doing::Alarm | Doing::Other)
    }

    /// Returns `true` if it stands because of a stop. It may be idle because the report is older than that.
    fn has_stopped(&self, now_s: f64) -> bool {
        self.stands() && (self.doing != Doing::Idle || now_s - self.stopped_s > STALE_S)
    }

    fn reset(&mut self) {
        (self.phase, self.greets) = (Phase::Resetting, false);
        self.out.push(at_once::RESET);
    }

    fn stop(&mut self, now_s: f64) {
        self.queue.clear();
        self.stopped_s = now_s;
        match self.phase {
            // It hears nothing else while it goes home.
            Phase::Ready if self.quiet() => self.reset(),
            Phase::Ready => {
                self.phase = Phase::Stopping;
                self.out.extend([at_once::HOLD, at_once::ASK]);
                // What it does is asked anew: it may have stood a moment ago.
                self.doing = Doing::Slowing;
            }
            Phase::Silent | Phase::Asked | Phase::Stopping | Phase::Resetting | Phase::Stopped => {}
        }
    }

    fn tell_inputs(&mut self, pins: &str) {
        for (pin, line) in INPUTS {
            let (was, on) = (self.pins.contains(pin), pins.contains(pin));
            if was != on {
                self.replies.push(Ok(Reply::Input { line, on }));
            }
        }
        pins.clone_into(&mut self.pins);
    }

    fn standing(&self) -> Standing {
        let (position, done) = (self.position, self.done);
        Standing { position, moving: !self.stands(), outputs: self.on, done }
    }

    fn take(&mut self, sent: &Sent, facts: &Facts) {
        let lines = match lines(&sent.order, self.planned, facts, self.planned_on) {
            Ok(lines) => lines,
            Err(why) => {
                let _ = self.trouble.get_or_insert(Trouble::Refused { number: 0, why });
                return self.replies.push(Ok(Reply::Refused(sent.ticket, why)));
            }
        };
        self.taken = sent.ticket;
        let (to, blocks) = match sent.order {
            Order::Move { to, .. } => (to, usize::from(self.steps(to))),
            Order::Output { line, on } => {
                self.planned_on = with(self.planned_on, line, on);
                (self.planned, 0)
            }
            Order::Spindle { .. } | Order::Home | Order::Unlock => (self.planned, 0),
        };
        self.flights.push(*sent, blocks, lines.len());
        self.planned = to;
        let ticket = Some(sent.ticket);
        self.queue.extend(lines.into_iter().map(|text| Line { text, ticket }));
    }

    /// Returns `true` if a move is a step of any motor: what is none does not reach the planner.
    fn steps(&self, to: Axes) -> bool {
        (0..to.0.len()).any(|axis| {
            let step = |place: f64| (place * self.told.steps(axis)).round();
            step(to.0[axis]) != step(self.planned.0[axis])
        })
    }
}

/// The pins whose state is told, as inputs: the probe, the door, which is a stop input, and the limits.
const INPUTS: [(char, u8); 6] = [('P', 1), ('D', 4), ('X', 5), ('Y', 6), ('Z', 7), ('A', 8)];

const fn with(outputs: u32, line: u8, on: bool) -> u32 {
    let bit = 1 << (line - 1);
    if on { outputs | bit } else { outputs & !bit }
}

fn numbered(line: &str, before: &str) -> Option<u16> {
    line.strip_prefix(before)?.parse().ok()
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
        match signal {
            Signal::Ask => self.out.push(at_once::ASK),
            Signal::Hold => self.out.push(at_once::HOLD),
            Signal::Resume => self.out.push(at_once::RESUME),
            Signal::Stop => self.stop(now_s),
            Signal::Feed(percent) => self.out.extend(at_once::feed(percent)),
        }
    }

    fn replies(&mut self, _: f64) -> Vec<Result<Reply, Garbled>> {
        std::mem::take(&mut self.replies)
    }

    fn window(&self) -> usize {
        WINDOW
    }

    fn quiet(&self) -> bool {
        self.flights.goes_home()
    }
}

impl Wired for Grbl {
    fn hear(&mut self, bytes: &[u8], now_s: f64) {
        if !bytes.is_empty() {
            self.heard_s = now_s;
        }
        for byte in bytes {
            match byte {
                b'\r' => {}
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
        let asks = matches!(self.phase, Phase::Silent | Phase::Asked);
        if asks && self.facts.is_none() && now_s - self.asked_s > GREETING_S {
            self.ask_all(now_s);
        }
        let silent_s = now_s - self.stopped_s.max(self.heard_s);
        if self.phase == Phase::Stopping && silent_s > DEAF_S {
            self.reset();
        }
        let mut used: usize = self.pending.iter().map(|line| line.text.len() + 1).sum();
        while let Some(line) = self.queue.front() {
            used += line.text.len() + 1;
            // What it is asked about itself is answered line by line.
            if used >= self.told.rx || (self.phase == Phase::Asked && !self.pending.is_empty()) {
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

    fn stands(&self) -> Option<Standing> {
        self.facts.as_ref().map(|_| self.standing())
    }

    fn trouble(&self) -> Option<&Trouble> {
        self.trouble.as_ref()
    }

    fn begin_anew(&mut self) -> bool {
        if self.phase != Phase::Stopped {
            return false;
        }
        self.flights.clear();
        (self.taken, self.done, self.on, self.planned_on) = (0, 0, 0, 0);
        self.trouble = None;
        self.replies.clear();
        self.begin();
        true
    }
}
