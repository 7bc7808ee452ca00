//! Motion on its way to a board: pieces that end at rest, each with the tail that makes it so.
//!
//! A board keeps the commands it has and makes them; none can be taken back, but all can be dropped at once. When its
//! queue runs dry, a motor stands still in the middle of its speed. So no piece is taken without the tail that brings
//! it to rest, and the tail goes out by itself when nothing follows in time.
//!
//! ```text
//!  speed │     piece n        │ piece n+1 …        made while the host lives
//!        │ ───────────────────┼───────────
//!        │                     ╲ tail of n         sent when piece n+1 is not there
//!        └──────────┬─────────┬──╲───────► clock
//!                   now       end of what was sent; the tail is decided `least` before it
//! ```
//!
//! Clocks are ticks of the board without end.

mod lead;
mod outputs;
mod piece;
mod places;

pub use lead::Lead;
pub use outputs::{Change, Rules};
pub use piece::{Piece, Step};

use crate::compress::{Compressor, Limits, Steps, TooFast};
use outputs::Outputs;
use piece::Prepared;
use places::Places;
use std::collections::VecDeque;

/// Commands of a motor that are remembered behind their time, to tell its count at a past clock.
const REMEMBERED: usize = 512;

/// The reason for which a piece is not taken.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Refused {
    /// Steps too close.
    #[error(transparent)]
    TooFast(#[from] TooFast),
    /// A step or a change lies outside its piece, or the piece before the one that it follows.
    #[error("a piece of motion does not follow the one before it: this is a mistake in Kerf")]
    Order,
    /// As many motors as there are have to be told.
    #[error("a piece of motion is for other motors: this is a mistake in Kerf")]
    Motors,
    /// The tail of the last piece is on its way: the machine comes to rest first.
    #[error("the machine is coming to rest: the motion goes on from there")]
    Stopping,
}

/// A thing to be told to the board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Release {
    /// A motor's steps count from a clock.
    Reset {
        /// Motor.
        motor: usize,
        /// Clock.
        clock: u64,
    },
    /// Direction of the steps that follow.
    Turn {
        /// Motor.
        motor: usize,
        /// Its count rises.
        forward: bool,
    },
    /// Steps.
    Steps {
        /// Motor.
        motor: usize,
        /// The command.
        steps: Steps,
    },
    /// An output changes, or is told again as it is.
    Output(Change),
    /// An output changes as soon as may be.
    AtOnce {
        /// Its place among all outputs.
        output: usize,
        /// Its value as the board takes it.
        value: u32,
    },
}

impl Release {
    /// Clock of the first thing that it does; none for a direction, which goes with the steps behind it.
    pub fn clock(&self) -> Option<u64> {
        match self {
            Self::Turn { .. } => None,
            release => Some(due(release)),
        }
    }
}

/// The host was late: steps that should have gone out are due already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Late;

/// A motor as the board knows it.
#[derive(Clone, Debug, Default)]
struct Told {
    /// Last step that was sent; nothing where the board's clock for it is void.
    to: Option<u64>,
    forward: Option<bool>,
    /// Commands that were sent, newest last.
    sent: VecDeque<Steps>,
    /// Count at the end of all of them.
    count: i64,
}

/// Motion of one board.
#[derive(Clone, Debug)]
pub struct Queue {
    limits: Vec<Limits>,
    /// State of compression at the end of the last piece taken.
    compressors: Vec<Compressor>,
    /// Pieces of which nothing was sent.
    offered: VecDeque<Prepared>,
    /// Commands and changes of pieces that have begun, in order of time.
    sending: VecDeque<Release>,
    /// The way to rest behind the last piece that has begun, and its end.
    tail: Option<Prepared>,
    /// State of compression behind it.
    begun: Vec<Compressor>,
    /// End of the pieces that have begun.
    begun_to: u64,
    /// End of all pieces.
    ends: u64,
    /// The tail was sent.
    stopping: bool,
    told: Vec<Told>,
    places: Places,
    outputs: Outputs,
    /// Shortest time by which a step was sent before it was due, ticks.
    latest: Option<u64>,
}

impl Queue {
    /// Motors that stand still, outputs with the board's rules for them, and the places that the board has for commands.
    pub fn new(limits: Vec<Limits>, outputs: &[Rules], places: usize) -> Self {
        let compressors: Vec<_> = limits.iter().map(|limits| Compressor::new(*limits, 0)).collect();
        Self {
            told: vec![Told::default(); limits.len()],
            limits,
            begun: compressors.clone(),
            compressors,
            offered: VecDeque::new(),
            sending: VecDeque::new(),
            tail: None,
            begun_to: 0,
            ends: 0,
            stopping: false,
            places: Places::new(places.saturating_sub(outputs.len())),
            outputs: Outputs::new(outputs),
            latest: None,
        }
    }

    /// Motion begins at a clock, from rest. Counts are those of the motors.
    pub fn start(&mut self, clock: u64, counts: &[i64]) {
        let anew = |limits: &Limits| Compressor::new(*limits, clock);
        self.compressors = self.limits.iter().map(anew).collect();
        self.begun.clone_from(&self.compressors);
        self.offered.clear();
        // What was switched a moment ago is on its way still.
        self.sending
            .retain(|release| matches!(release, Release::Output(_) | Release::AtOnce { .. }));
        (self.tail, self.stopping) = (None, false);
        (self.begun_to, self.ends) = (clock, clock);
        for (told, count) in self.told.iter_mut().zip(counts) {
            *told = Told { count: *count, ..Told::default() };
        }
    }

    /// The board drops all motion. Outputs that are on are to go off.
    pub fn dropped(&mut self) {
        self.drop_motion();
        self.sending = self.outputs.off().collect();
    }

    /// The board drops all motion. Outputs stay as they are.
    pub fn drop_motion(&mut self) {
        self.offered.clear();
        self.sending.clear();
        self.tail = None;
        self.places.free_all();
    }

    /// The board has shut down: all that it had is void, and its outputs are off.
    pub fn shut_down(&mut self) {
        self.dropped();
        self.sending.clear();
        self.outputs.forget();
    }

    /// Takes a piece behind those that are there. Nothing of it is taken where it is refused.
    ///
    /// # Errors
    ///
    /// It does not follow, or has steps that no motor can make.
    pub fn offer(&mut self, piece: &Piece) -> Result<(), Refused> {
        if self.stopping {
            return Err(Refused::Stopping);
        }
        let prepared = Prepared::new(piece, self.ends, &self.compressors)?;
        self.compressors.clone_from(&prepared.behind);
        self.ends = prepared.ends;
        self.offered.push_back(prepared);
        Ok(())
    }

    /// Takes back the piece that was offered last, and of which nothing was sent.
    pub fn take_back(&mut self) {
        self.offered.pop_back();
        let last = self.offered.back().map(|piece| (&piece.behind, piece.ends));
        let (behind, ends) = last.unwrap_or((&self.begun, self.begun_to));
        self.compressors.clone_from(behind);
        self.ends = ends;
    }

    /// An output changes while nothing moves, or beside what moves: as soon as may be, behind those that were told so before.
    pub fn set(&mut self, output: usize, value: u32) {
        let at_once = |release: &&Release| matches!(release, Release::AtOnce { .. });
        let before = self.sending.iter().take_while(at_once).count();
        self.sending.insert(before, Release::AtOnce { output, value });
    }

    /// All outputs that have a watch go off as soon as may be, whatever a former session told of them: nobody tells them again.
    pub fn put_off(&mut self) {
        let watched: Vec<_> = self.outputs.watched().collect();
        watched.into_iter().for_each(|(output, off)| self.set(output, off));
    }

    /// Takes back the pieces of which nothing was sent, and returns the clock from which others may follow.
    pub fn withdraw(&mut self) -> u64 {
        self.offered.clear();
        self.compressors.clone_from(&self.begun);
        self.ends = self.begun_to;
        self.ends
    }

    /// End of all that was taken, tail included where it is on its way.
    pub const fn ends(&self) -> u64 {
        self.ends
    }

    /// The tail is on its way: nothing follows before the machine stands.
    pub const fn is_stopping(&self) -> bool {
        self.stopping
    }

    /// Everything that was taken has been sent.
    pub fn is_sent(&self) -> bool {
        self.offered.is_empty() && self.sending.is_empty() && self.tail.is_none()
    }

    /// Returns what is to be told to the board at a clock. `off` is the farthest that this clock may be off, ticks;
    /// nothing `moves` yet while latches are being armed.
    ///
    /// # Errors
    ///
    /// It is too late for a step: the board would shut down over it.
    pub fn release(
        &mut self,
        now: u64,
        off: u64,
        lead: &Lead,
        moves: bool,
    ) -> Result<Vec<Release>, Late> {
        if moves {
            self.begin(now + lead.full());
        }
        if self.tail.is_some() && self.offered.is_empty() && self.begun_to <= now + lead.least() {
            self.come_to_rest();
        }
        self.places.free(now.saturating_sub(off));
        let mut out = self.outputs.again([now, off], lead);
        if !moves {
            return Ok(out);
        }
        while let Some(next) = self.sending.front().copied() {
            if self.places.is_full() || !self.may_go(&next, now, off) {
                break;
            }
            let late = due(&next) < now + off;
            if late && matches!(next, Release::Steps { .. }) {
                return Err(Late);
            }
            self.sending.pop_front();
            if matches!(next, Release::Steps { .. }) {
                let before = due(&next).saturating_sub(now + off);
                self.latest = Some(self.latest.map_or(before, |latest| latest.min(before)));
            }
            self.tell(next, [now, off], lead, &mut out);
        }
        Ok(out)
    }

    /// Count of a motor at a clock that is not long past, if it made all that it was told.
    pub fn count_at(&self, motor: usize, clock: u64) -> Option<i64> {
        let told = self.told.get(motor)?;
        let mut count = told.count;
        for steps in told.sent.iter().rev() {
            if steps.to() <= clock {
                break;
            }
            let later = (1..=steps.count).rev().take_while(|k| steps.at(*k) > clock).count() as i64;
            count -= if steps.forward { later } else { -later };
        }
        Some(count)
    }

    /// Shortest time by which a step was sent before it was due, ticks.
    pub const fn latest(&self) -> Option<u64> {
        self.latest
    }

    /// Counts of all motors once they have made what was sent.
    pub fn counts(&self) -> Vec<i64> {
        self.told.iter().map(|told| told.count).collect()
    }

    /// Pieces begin whose time has come: all that they do may go out.
    fn begin(&mut self, horizon: u64) {
        while self.offered.front().is_some_and(|piece| piece.starts <= horizon) {
            let Some(mut piece) = self.offered.pop_front() else { return };
            self.begun.clone_from(&piece.behind);
            self.begun_to = piece.ends;
            self.tail = piece.tail.take().map(|tail| *tail);
            self.sending.extend(piece.releases);
        }
    }

    fn come_to_rest(&mut self) {
        let Some(tail) = self.tail.take() else { return };
        self.sending.extend(tail.releases);
        self.begun_to = tail.ends;
        self.ends = tail.ends;
        self.stopping = true;
    }

    /// A motor's clock can be set only while it stands.
    fn may_go(&self, release: &Release, now: u64, off: u64) -> bool {
        let Release::Steps { motor, steps } = release else { return true };
        let to = self.told.get(*motor).and_then(|told| told.to);
        to.is_none_or(|to| to == steps.from || to + off < now)
    }

    fn tell(
        &mut self,
        release: Release,
        [now, off]: [u64; 2],
        lead: &Lead,
        out: &mut Vec<Release>,
    ) {
        let Release::Steps { motor, steps } = release else {
            let told = match release {
                Release::Output(change) => Release::Output(self.outputs.sent(change, now + off)),
                Release::AtOnce { output, value } => {
                    self.outputs.soon(output, value, [now, off], lead)
                }
                other => other,
            };
            if let Release::Output(change) = told {
                self.places.take(change.clock);
            }
            return out.push(told);
        };
        let Some(told) = self.told.get_mut(motor) else { return };
        if told.to != Some(steps.from) {
            out.push(Release::Reset { motor, clock: steps.from });
        }
        if told.forward != Some(steps.forward) {
            out.push(Release::Turn { motor, forward: steps.forward });
        }
        (told.to, told.forward) = (Some(steps.to()), Some(steps.forward));
        told.count += if steps.forward { i64::from(steps.count) } else { -i64::from(steps.count) };
        told.sent.push_back(steps);
        if told.sent.len() > REMEMBERED {
            told.sent.pop_front();
        }
        self.places.take(steps.from);
        out.push(release);
    }
}

/// Clock of the first thing that a release does.
fn due(release: &Release) -> u64 {
    match release {
        Release::Steps { steps, .. } => steps.at(1),
        Release::Output(change) => change.clock,
        Release::Reset { clock, .. } => *clock,
        Release::Turn { .. } => u64::MAX,
        Release::AtOnce { .. } => 0,
    }
}
