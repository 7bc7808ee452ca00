//! Several boards that move one machine, as one: its motors, switches and outputs are counted through, and its clock is
//! that of the first.
//!
//! ```text
//!  motion, outputs ─► Crew ─┬─ Share, Timeline ─► Board ─► line
//!  in ticks of the first    ├─ Share, Timeline ─► Board ─► line
//!  news, counts ◄───────────┴─ relay: what stops one stops all
//! ```
//!
//! Boards do not know each other. A piece of motion is taken by all of them or by none; motion is over when it is over
//! on all. A machine with one board is a crew of one.

mod member;
mod news;
mod relay;

use crate::board::{Board, FIRST_S, Holds, Home, News, NotNow, Options, Start, Watched};
use crate::link::Outgoing;
use crate::queue::{Piece, Refused};
use crate::setup::{Setup, SetupError, own};
use crate::timeline::Timeline;
use member::Member;
use relay::Away;
use std::collections::VecDeque;

/// Boards that move one machine.
pub struct Crew {
    members: Vec<Member>,
    /// Switches of one board that stop motors of another one, in the motion under way.
    away: Vec<Away>,
    /// Moment at which motion began, seconds.
    begins_s: f64,
    /// Time without word from the host after which a board stops its motors, seconds.
    deadline_s: f64,
    /// Motion has begun and is not known to be over.
    moving: bool,
    /// States of the inputs that are looked at all the time, a bit each.
    pressed: u8,
    news: VecDeque<News>,
}

impl Crew {
    /// Begins to look for boards by their names, the first one first. Pins of the setup name their board by its place.
    ///
    /// # Errors
    ///
    /// A motor has its pins on two boards.
    pub fn new(
        setup: &Setup,
        names: &[String],
        options: Options,
        now_s: f64,
    ) -> Result<Self, SetupError> {
        let shares = setup.shares(names.len().max(1))?;
        let names = names.iter().cloned().chain([String::new()]);
        let member = |(share, name)| Member::new(name, share, options, now_s);
        Ok(Self {
            members: shares.into_iter().zip(names).map(member).collect(),
            away: Vec::new(),
            begins_s: f64::INFINITY,
            deadline_s: options.deadline_s,
            moving: false,
            pressed: 0,
            news: VecDeque::new(),
        })
    }

    /// Number of boards.
    pub const fn count(&self) -> usize {
        self.members.len()
    }

    /// Reads bytes that came from a board.
    pub fn receive(&mut self, board: usize, bytes: &[u8], now_s: f64) {
        if let Some(member) = self.members.get_mut(board) {
            member.board.receive(bytes, now_s);
        }
        self.gather();
    }

    /// Returns the bytes to be written to a board now.
    pub fn transmit(&mut self, board: usize, now_s: f64) -> Outgoing {
        self.relay(now_s);
        let member = self.members.get_mut(board);
        let out = member.map(|member| member.board.transmit(now_s)).unwrap_or_default();
        self.gather();
        out
    }

    /// Returns the moment at which [`transmit`](Self::transmit) has something to do, if nothing comes before.
    pub fn due_s(&self) -> f64 {
        self.boards().map(Board::due_s).fold(f64::INFINITY, f64::min)
    }

    /// Takes the oldest news.
    pub fn news(&mut self) -> Option<News> {
        self.news.pop_front()
    }

    /// The boards.
    pub fn boards(&self) -> impl Iterator<Item = &Board> {
        self.members.iter().map(|member| &member.board)
    }

    /// Motion begins on all boards at one moment, from rest. Switches of `homes` stop their motors, on whatever boards.
    ///
    /// # Errors
    ///
    /// One of the boards cannot be moved now; then none is.
    pub fn start(&mut self, homes: &[Home], now_s: f64) -> Result<Start, NotNow> {
        self.boards().try_for_each(Board::may_start)?;
        let lead_s = self.lead_s()[1].max(FIRST_S);
        let lines: Option<Vec<_>> = self.boards().map(|board| board.line().cloned()).collect();
        let lines = lines.ok_or(NotNow::Busy)?;
        let first = lines.first().ok_or(NotNow::Absent)?;
        let clock = first.at(now_s + lead_s).max(0.0).trunc();
        let holds = self.holds(homes);
        for (n, (member, line)) in self.members.iter_mut().zip(&lines).enumerate() {
            member.line = (n > 0).then(|| Timeline::new(first, line, clock));
            member.ends = member.clock(clock as u64);
        }
        self.away = relay::away(homes, &self.members);
        for (n, holds) in holds.iter().enumerate() {
            if let Err(why) = self.members[n].begin(holds, now_s) {
                self.stop().ok();
                return Err(why);
            }
        }
        (self.begins_s, self.moving) = (now_s, true);
        Ok(Start { clock: clock as u64, ticks_per_s: first.rate() })
    }

    /// The motors of each board that stop by switches of their own.
    fn holds(&self, homes: &[Home]) -> Vec<Holds> {
        self.members.iter().map(|member| member.holds(homes)).collect()
    }

    /// Takes a piece of motion behind those that it has: all boards do, or none.
    ///
    /// # Errors
    ///
    /// It does not follow, or cannot be made. Nothing of it is taken.
    pub fn offer(&mut self, piece: &Piece) -> Result<(), Refused> {
        if !self.boards().all(Board::takes_pieces) {
            return Err(Refused::Stopping);
        }
        self.bend();
        for n in 0..self.members.len() {
            if let Err(why) = self.members[n].offer(piece) {
                self.members[..n].iter_mut().for_each(|member| member.board.take_back());
                return Err(why);
            }
        }
        let ends = piece.ends;
        self.members.iter_mut().for_each(|member| member.ends = member.clock(ends));
        Ok(())
    }

    /// Bends the boards' lines together again, from the end of what was handed out.
    fn bend(&mut self) {
        let Some((first, others)) = self.members.split_first_mut() else { return };
        let Some(clock) = first.board.line() else { return };
        let from = first.ends as f64;
        for member in others {
            if let (Some(line), Some(own)) = (&mut member.line, member.board.line()) {
                line.bend(clock, own, from);
            }
        }
    }

    /// From now on these switches stop all motors that no switch of their own does, and no others.
    ///
    /// # Errors
    ///
    /// A board is not ready.
    pub fn watch(&mut self, watched: &[Watched], now_s: f64) -> Result<(), NotNow> {
        self.members.iter_mut().try_for_each(|member| {
            let of = |it: &Watched| {
                Some(Watched { switch: own(&member.share.switches, it.switch)?, ..*it })
            };
            let watched: Vec<Watched> = watched.iter().filter_map(of).collect();
            member.board.watch(&watched, now_s)
        })
    }

    /// Stops all motors at once, without a ramp.
    ///
    /// # Errors
    ///
    /// A board is not there; the others stop all the same.
    pub fn stop(&mut self) -> Result<(), NotNow> {
        let stops: Vec<_> = self.members.iter_mut().map(|member| member.board.stop()).collect();
        stops.into_iter().collect()
    }

    /// Motion that is over is ended and counted, and latches are disarmed without waiting for more of it.
    pub fn let_rest(&mut self) {
        self.members.iter_mut().for_each(|member| member.board.let_rest());
    }

    /// Goes on after a shutdown of some of the boards.
    ///
    /// # Errors
    ///
    /// None is shut down, or one is not there.
    pub fn recover(&mut self) -> Result<(), NotNow> {
        let recover = |member: &mut Member| member.board.recover();
        let each: Vec<_> = self.members.iter_mut().map(recover).collect();
        let some = each.iter().any(Result::is_ok);
        each.into_iter()
            .find(|it| it.is_err() && !(some && *it == Err(NotNow::Rest)))
            .unwrap_or(Ok(()))
    }

    /// Sets an output, counted as in the setup: those that go on and off, then those with a share of time; from 0 (off)
    /// to 1.
    ///
    /// # Errors
    ///
    /// Its board is not ready.
    pub fn set_output(&mut self, output: usize, share: f64, now_s: f64) -> Result<(), NotNow> {
        let mut members = self.members.iter_mut();
        let found = members.find_map(|it| Some((own(&it.share.outputs, output)?, it)));
        let (output, member) = found.ok_or(NotNow::Absent)?;
        member.board.set_output(output, share, now_s)
    }

    /// Value of an output as its board takes it, for a share from 0 (off) to 1; nothing before the board is known.
    pub fn output_value(&self, output: usize, share: f64) -> Option<u32> {
        let own = |it: &Member| it.board.output_value(own(&it.share.outputs, output)?, share);
        self.members.iter().find_map(own)
    }

    /// Asks for the state of a switch.
    ///
    /// # Errors
    ///
    /// Its board is not there.
    pub fn ask_switch(&mut self, switch: usize) -> Result<(), NotNow> {
        let mut members = self.members.iter_mut();
        let found = members.find_map(|it| Some((own(&it.share.switches, switch)?, it)));
        let (switch, member) = found.ok_or(NotNow::Absent)?;
        member.board.ask_switch(switch)
    }

    /// Measures a voltage again and again, every so many seconds, or no more.
    ///
    /// # Errors
    ///
    /// Its board is not ready.
    pub fn measure(
        &mut self,
        voltage: usize,
        every_s: Option<f64>,
        now_s: f64,
    ) -> Result<(), NotNow> {
        let mut members = self.members.iter_mut();
        let found = members.find_map(|it| Some((own(&it.share.voltages, voltage)?, it)));
        let (voltage, member) = found.ok_or(NotNow::Absent)?;
        member.board.measure(voltage, every_s, now_s)
    }

    /// Looks at the condition of all motor drivers.
    ///
    /// # Errors
    ///
    /// A board is not ready.
    pub fn check_drivers(&mut self) -> Result<(), NotNow> {
        self.members.iter_mut().try_for_each(|member| member.board.check_drivers())
    }

    /// Clock of the first board at a moment, and the farthest that any of them may be off, ticks; nothing before all are
    /// known.
    pub fn clock(&self, now_s: f64) -> Option<(u64, u64)> {
        let (clock, mut most) = self.boards().next()?.clock(now_s)?;
        for member in &self.members {
            let (_, off) = member.board.clock(now_s)?;
            let rate = member.line.map_or(1.0, |line| line.rate());
            most = most.max((off as f64 / rate) as u64);
        }
        Some((clock, most))
    }

    /// Longest stall of the host that was seen, and the longest lead that follows, seconds.
    pub fn lead_s(&self) -> [f64; 2] {
        let leads = self.boards().filter_map(Board::lead_s);
        leads.fold([0.0, 0.0], |[stall, lead], [a, b]| [a.max(stall), b.max(lead)])
    }

    /// All stand, and motion could begin.
    pub fn is_at_rest(&self) -> bool {
        self.boards().all(Board::is_at_rest)
    }

    /// Motion goes on on all, or is about to.
    pub fn is_moving(&self) -> bool {
        self.boards().all(Board::is_moving)
    }

    /// Motion is broken off on one of them.
    pub fn is_stopping(&self) -> bool {
        self.boards().any(Board::is_stopping)
    }
}
