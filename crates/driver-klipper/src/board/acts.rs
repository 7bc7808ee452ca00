//! Requests of a session's owner.

use super::channel::Channel;
use super::latch::{Holds, Home, Watched};
use super::motion::State;
use super::news::{Ended, NotNow, Start};
use super::session::Session;
use crate::orders::{Order, OrderError};
use crate::queue::{Piece, Refused};

/// Shortest time between the wish to move and the first step, seconds.
pub const FIRST_S: f64 = 0.25;

impl Session {
    pub fn start(&mut self, homes: &[Home], now_s: f64) -> Result<Start, NotNow> {
        let Some((now, _)) = self.channel.now(now_s) else { return Err(NotNow::Busy) };
        let starts = now + self.channel.ticks(self.motion.lead.full_s().max(FIRST_S));
        self.start_at(&Holds { homes: homes.to_vec(), ..Holds::default() }, starts, now_s)
    }

    /// Motion begins at a clock that is far enough ahead.
    pub fn start_at(&mut self, holds: &Holds, starts: u64, now_s: f64) -> Result<Start, NotNow> {
        self.may_start()?;
        let Some((now, _)) = self.channel.now(now_s) else { return Err(NotNow::Busy) };
        Ok(self.motion.start_at(&mut self.channel, holds, [now, starts], now_s)?)
    }

    pub fn may_start(&self) -> Result<(), NotNow> {
        match (self.shutdown, self.is_at_rest()) {
            (true, _) => Err(NotNow::Shutdown),
            (_, false) => Err(NotNow::Busy),
            _ => Ok(()),
        }
    }

    /// Takes pieces of motion.
    pub fn takes_pieces(&self) -> bool {
        self.motion.moves() && !self.motion.queue.is_stopping()
    }

    pub fn offer(&mut self, piece: &Piece) -> Result<(), Refused> {
        if self.motion.moves() { self.motion.queue.offer(piece) } else { Err(Refused::Stopping) }
    }

    pub fn withdraw(&mut self) -> Result<u64, NotNow> {
        if self.takes_pieces() { Ok(self.motion.queue.withdraw()) } else { Err(NotNow::Rest) }
    }

    /// Has these switches stop all motors that no switch of their own does.
    pub fn watch(&mut self, watched: &[Watched], now_s: f64) -> Result<(), NotNow> {
        let (now, _) = self.when_ready(now_s)?;
        Ok(self.motion.watch(&mut self.channel, watched, now)?)
    }

    /// Drops all motion at once.
    pub fn stop(&mut self, why: Ended) -> Result<(), OrderError> {
        self.motion.stop(&mut self.channel, why)
    }

    pub fn emergency_stop(&mut self) -> Result<(), OrderError> {
        self.channel.link.forget();
        self.channel.hurry(Order::EmergencyStop, [])
    }

    /// Clears a shutdown, and reads the counts.
    pub fn recover(&mut self) -> Result<(), NotNow> {
        if !self.shutdown {
            return Err(NotNow::Rest);
        }
        self.channel.send(Order::ClearShutdown, [])?;
        self.shutdown = false;
        Ok(self.motion.read_counts(&mut self.channel, Ended::Shutdown)?)
    }

    /// Begins to look at the condition of the motor drivers.
    pub fn check_drivers(&mut self) -> Result<(), NotNow> {
        if !self.is_ready() || self.shutdown {
            return Err(NotNow::Busy);
        }
        self.drivers.check(&self.channel.setup.tuned);
        Ok(())
    }

    pub fn set_output(&mut self, output: usize, share: f64, now_s: f64) -> Result<(), NotNow> {
        self.when_ready(now_s)?;
        let value = self.channel.output_value(output, share);
        self.motion.queue.set(output, value);
        Ok(())
    }

    /// Clock of a board that is ready and not shut down, and the farthest that it may be off.
    fn when_ready(&self, now_s: f64) -> Result<(u64, u64), NotNow> {
        let ready = self.channel.now(now_s).filter(|_| self.is_ready() && !self.shutdown);
        ready.ok_or(NotNow::Busy)
    }

    /// Nothing moves, and motion could begin.
    pub fn is_at_rest(&self) -> bool {
        self.is_ready() && self.motion.state == State::Rest && !self.shutdown
    }

    /// The reason for which motion is broken off, while it is.
    pub fn stops(&self) -> Option<Ended> {
        match self.motion.state {
            State::Ending(why) | State::Reading(why) => Some(why).filter(|it| *it != Ended::Rested),
            _ => self.shutdown.then_some(Ended::Shutdown),
        }
    }

    /// Longest stall of the host that was seen, and the lead, seconds.
    pub fn lead_s(&self) -> [f64; 2] {
        [self.motion.lead.stall_s(), self.motion.lead.full_s()]
    }

    /// The way to the board, for questions.
    pub const fn way(&mut self) -> &mut Channel {
        &mut self.channel
    }
}
