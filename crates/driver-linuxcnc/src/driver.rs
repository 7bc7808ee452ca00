//! The driver.

use crate::check;
use crate::lines::lines;
use crate::piece::{Kind, Piece, Pieces};
use crate::said;
use crate::status::{Doing, Status};
use crate::zeros::Zeros;
use kerf_machine::driver::{
    Axes, ControllerState, Driver, Facts, Garbled, Hold, Order, Override, Reply, Said, Sent,
    Shares, Signal, Ticket, Trouble, Wired, Zero, ZeroChange, is_sound,
};
use std::collections::VecDeque;

/// A bridge that does not say who it is is asked again after this, seconds.
const GREETING_S: f64 = 1.0;

/// The bridge hears that Kerf is there so often, seconds: it holds the machine after 1.5 s of silence.
const KEEP_S: f64 = 0.2;

/// A piece is begun when no order came for so long, seconds: those of a stack come together.
const GATHER_S: f64 = 0.02;

/// A status that comes so long after a change of shares is not older than it, seconds.
const STALE_S: f64 = 0.3;

/// Orders that may be on their way: those of two pieces.
const WINDOW: usize = 1 << 15;

/// Phase of the driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// The bridge did not say who it is.
    Silent,
    /// It takes orders.
    Ready,
    /// It was told to stop.
    Stopping,
    /// It stands after a stop: it begins anew.
    Stopped,
}

/// LinuxCNC behind a bridge.
#[derive(Debug)]
pub struct LinuxCnc {
    pub(crate) phase: Phase,
    /// What the bridge has told of it; known to others when it is ready.
    pub(crate) told: Option<Facts>,
    pub(crate) facts: Option<Facts>,
    pub(crate) trouble: Option<Trouble>,
    pub(crate) status: Status,
    pub(crate) replies: Vec<Result<Reply, Garbled>>,
    hearing: Vec<u8>,
    out: Vec<u8>,
    /// Number of the next line to the bridge.
    number: u32,
    /// Number of the greeting, and that of the line behind the last one that changes what the machine does: a status from
    /// before either is old.
    pub(crate) greeting: u32,
    pub(crate) acts: u32,
    pub(crate) pieces: Pieces,
    /// Number of the piece that was sent last, and the piece while it is made.
    pub(crate) piece: u32,
    pub(crate) making: Option<Piece>,
    /// Orders that are not done.
    pub(crate) open: VecDeque<Sent>,
    /// Place and outputs behind the last order.
    pub(crate) planned: Axes,
    planned_on: u32,
    /// Outputs that are on, as orders that are done have switched them.
    pub(crate) on: u32,
    pub(crate) taken: Ticket,
    pub(crate) done: Ticket,
    pub(crate) hold: Hold,
    pub(crate) shares: Shares,
    turned_s: f64,
    pub(crate) inputs: u32,
    pub(crate) contact: Option<Axes>,
    pub(crate) zeros: Zeros,
    /// Times of the last order, of the last line to the bridge, and of the last that came.
    ordered_s: f64,
    said_s: f64,
}

impl Default for LinuxCnc {
    fn default() -> Self {
        Self::new()
    }
}

/// A line longer than this is none of a bridge.
const LONGEST: usize = 4096;

impl LinuxCnc {
    /// A machine of which nothing is known.
    pub fn new() -> Self {
        Self {
            phase: Phase::Silent,
            told: None,
            facts: None,
            trouble: None,
            status: Status::default(),
            replies: Vec::new(),
            hearing: Vec::new(),
            out: Vec::new(),
            number: 0,
            greeting: 0,
            acts: 0,
            pieces: Pieces::default(),
            piece: 0,
            making: None,
            open: VecDeque::new(),
            planned: Axes::default(),
            planned_on: 0,
            on: 0,
            taken: 0,
            done: 0,
            hold: Hold::None,
            shares: Shares::default(),
            turned_s: f64::NEG_INFINITY,
            inputs: 0,
            contact: None,
            zeros: Zeros::default(),
            ordered_s: f64::NEG_INFINITY,
            said_s: f64::NEG_INFINITY,
        }
    }

    /// Says a line to the bridge.
    fn say(&mut self, words: &str) {
        let line = check::line(&format!("{} {words}", self.number));
        self.out.extend_from_slice(line.as_bytes());
        self.number += 1;
    }

    /// Asks the bridge who it is; its lines are counted from here.
    pub(crate) fn greets(&mut self) {
        self.number = 0;
        self.greeting += 1;
        self.acts(&format!("hi {}", self.greeting));
    }

    /// Says a line that changes what the machine does.
    fn acts(&mut self, words: &str) {
        self.say(words);
        self.acts = self.number;
    }

    /// Takes orders from where it stands.
    pub(crate) fn begin(&mut self) {
        (self.phase, self.hold) = (Phase::Ready, Hold::None);
        self.planned = self.status.position;
        (self.on, self.planned_on) = (self.status.outputs, self.status.outputs);
        self.facts = self.told.clone();
    }

    pub(crate) fn standing(&self) -> ControllerState {
        let Status { position, moves, .. } = self.status;
        ControllerState { position, moving: moves, outputs: self.on, done: self.done }
    }

    /// Nothing that was ordered will be done.
    pub(crate) fn fail(&mut self, trouble: Trouble) {
        let _ = self.trouble.get_or_insert(trouble);
        if self.done < self.taken {
            self.replies.push(Ok(Reply::Refused(self.done + 1, "it stopped by itself")));
        }
        self.forget();
    }

    pub(crate) fn forget(&mut self) {
        self.pieces.clear();
        self.open.clear();
        self.making = None;
    }

    /// Sends the next piece when the one before is made.
    fn sends_piece(&mut self, now_s: f64) {
        let waits = self.making.is_some() || self.hold != Hold::None || self.is_in_trouble();
        if self.phase != Phase::Ready || waits {
            return;
        }
        let Some(piece) = self.pieces.take(now_s - self.ordered_s > GATHER_S) else { return };
        self.piece += 1;
        self.say(&format!("piece {}", self.piece));
        for (ticket, line) in &piece.lines {
            self.say(&format!("g {ticket} {line}"));
        }
        self.acts(match piece.kind {
            Kind::Path | Kind::Probe => "run",
            Kind::Home => "home",
            Kind::Unlock => "unlock",
        });
        self.making = Some(piece);
    }

    /// Returns `true` if it has a trouble other than a lock, which going home or switching on may end.
    pub(crate) const fn is_in_trouble(&self) -> bool {
        !matches!(self.trouble, None | Some(Trouble::Locked { .. }))
    }

    fn take(&mut self, sent: &Sent) -> Result<(), Trouble> {
        let refused = |why: &'static str| Trouble::Refused { number: 0, why: why.into() };
        let opens = matches!(sent.order, Order::Home | Order::Unlock);
        if let Some(locked) = self.trouble.clone().filter(|_| !opens) {
            return Err(locked);
        }
        if !is_sound(&sent.order) {
            return Err(refused("no machine can do this"));
        }
        let facts = self.facts.as_ref().ok_or_else(|| refused("it did not say what it is"))?;
        let lines = lines(&sent.order, self.planned, facts, self.planned_on, self.shares);
        let lines = lines.map_err(refused)?;
        if matches!(sent.order, Order::Probe { .. }) {
            self.contact = None;
        }
        if let Order::Output { line, on } = sent.order {
            self.planned_on = with(self.planned_on, line, on);
        }
        self.planned = sent.order.to().unwrap_or(self.planned);
        self.pieces.push(sent, lines, self.planned);
        Ok(())
    }

    fn stop(&mut self) {
        if self.phase == Phase::Silent {
            self.greets();
        }
        self.forget();
        self.phase = Phase::Stopping;
        self.status.doing = Doing::Stopping;
        self.acts("stop");
    }
}

pub(crate) const fn with(outputs: u32, line: u8, on: bool) -> u32 {
    let bit = 1 << (line - 1);
    if on { outputs | bit } else { outputs & !bit }
}

impl Driver for LinuxCnc {
    fn send(&mut self, sent: &Sent, now_s: f64) {
        if sent.ticket <= self.done {
            return self.replies.push(Ok(Reply::Done(sent.ticket)));
        }
        if sent.ticket != self.taken + 1 || self.phase != Phase::Ready {
            return;
        }
        if let Err(trouble) = self.take(sent) {
            let _ = self.trouble.get_or_insert(trouble);
            let why = "it cannot do this as it stands";
            return self.replies.push(Ok(Reply::Refused(sent.ticket, why)));
        }
        (self.taken, self.ordered_s) = (sent.ticket, now_s);
        self.open.push_back(*sent);
        self.replies.push(Ok(Reply::Taken(sent.ticket)));
    }

    fn signal(&mut self, signal: Signal, now_s: f64) {
        match signal {
            Signal::Ask | Signal::ByHand | Signal::ToolIn | Signal::TouchOff | Signal::ToolOff => {}
            Signal::Hold => {
                self.hold = Hold::Ordered;
                self.acts("hold");
            }
            Signal::Resume => {
                self.hold = Hold::None;
                self.acts("resume");
            }
            Signal::Stop => self.stop(),
            Signal::Feed(percent) => {
                (self.shares.feed, self.turned_s) = (percent, now_s);
                self.say(&format!("feed {percent}"));
            }
            Signal::Override(Override::Rapid(percent)) => {
                (self.shares.rapid, self.turned_s) = (percent.min(100), now_s);
                self.say(&format!("rapid {}", percent.min(100)));
            }
            Signal::Override(Override::Spindle(percent)) => {
                (self.shares.spindle, self.turned_s) = (percent, now_s);
                self.say(&format!("turn {percent}"));
            }
        }
    }

    fn replies(&mut self, _: f64) -> Vec<Result<Reply, Garbled>> {
        std::mem::take(&mut self.replies)
    }

    fn window(&self) -> usize {
        WINDOW
    }
}

impl Wired for LinuxCnc {
    fn hear(&mut self, bytes: &[u8], now_s: f64) {
        for byte in bytes {
            match byte {
                b'\n' => {
                    let line = std::mem::take(&mut self.hearing);
                    let shares_are_new = now_s - self.turned_s > STALE_S;
                    self.line(&line, shares_are_new);
                }
                _ if self.hearing.len() < LONGEST => self.hearing.push(*byte),
                _ => {}
            }
        }
    }

    fn speak(&mut self, now_s: f64) -> Vec<u8> {
        self.sends_piece(now_s);
        let silent_s = now_s - self.said_s;
        if self.told.is_none() && silent_s > GREETING_S && self.out.is_empty() {
            self.greets();
        } else if self.told.is_some() && silent_s > KEEP_S && self.out.is_empty() {
            self.say("keep");
        }
        if !self.out.is_empty() {
            self.said_s = now_s;
        }
        std::mem::take(&mut self.out)
    }

    fn facts(&self) -> Option<&Facts> {
        self.facts.as_ref()
    }

    fn contact(&self) -> Option<Axes> {
        self.contact
    }

    fn waits(&self) -> Option<&'static str> {
        match self.status.doing {
            Doing::Panel => Some("it is held at its own panel"),
            Doing::Foreign => Some("it is at work for somebody at its own panel"),
            _ => None,
        }
    }

    fn hold(&self) -> Hold {
        self.hold
    }

    fn shares(&self) -> Option<Shares> {
        Some(self.shares)
    }

    fn zeros(&self) -> &[Zero] {
        &self.zeros.told
    }

    fn keeps_zero(&mut self, name: &str, change: ZeroChange) -> bool {
        let axes = self.facts.as_ref().map_or(0, |facts| facts.axes);
        let rests = self.phase == Phase::Ready && self.open.is_empty() && self.trouble.is_none();
        let Some(line) = self.zeros.line(name, change, axes).filter(|_| rests) else {
            return false;
        };
        self.acts(&format!("zero {line}"));
        true
    }

    fn knows_zeros(&self) -> bool {
        self.zeros.greeting == self.greeting && self.zeros.next >= self.acts
    }

    fn said(&self, line: &str, is_sent: bool) -> Said {
        if is_sent { said::sent(line) } else { said::came(line) }
    }

    fn line_is_back(&mut self, _: f64) {
        self.is_back();
    }

    fn stands(&self) -> Option<ControllerState> {
        self.facts.as_ref().map(|_| self.standing())
    }

    fn trouble(&self) -> Option<&Trouble> {
        self.trouble.as_ref()
    }

    fn begin_anew(&mut self) -> bool {
        if self.phase != Phase::Stopped {
            return false;
        }
        self.forget();
        (self.taken, self.done, self.trouble, self.contact) = (0, 0, None, None);
        self.replies.clear();
        self.greets();
        self.begin();
        self.heeds_locks();
        true
    }
}
