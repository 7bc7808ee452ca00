//! Planning with a limit of jerk while a program is read: wherever the machine must stand, what lies
//! before is planned for good.

use super::kernel::Kernel;
use super::track::Track;
use super::widths::Smoothing;
use super::{Optimal, Timed};
use crate::moves::Move;
use crate::plan::{Law, Plan};
use crate::shopbot::Model;
use kerf_program::{AXES, Dynamics};

/// A rest is looked for when so many moves are new.
const BLOCK: usize = 64;

/// Moves since the last rest, and what is known of the corners between them.
#[derive(Clone, Debug)]
pub(crate) struct Rests {
    dynamics: Dynamics,
    moves: Vec<Move>,
    /// How many of them are on the track.
    seen: usize,
    track: Track,
    smoothing: Smoothing<AXES>,
    /// When the next piece begins, seconds.
    t_s: f64,
}

impl Rests {
    /// For a stack that begins under these limits.
    pub fn new(dynamics: &Dynamics) -> Self {
        Self {
            dynamics: *dynamics,
            moves: Vec::new(),
            seen: 0,
            track: Track::new(AXES, dynamics.tolerance_mm),
            smoothing: Smoothing::new(Kernel::Triangle),
            t_s: 0.0,
        }
    }

    /// The next move of the stack.
    pub fn push(&mut self, made: Move) {
        self.moves.push(made);
    }

    /// The plan up to the last rest that is known.
    pub fn take(&mut self) -> Option<Plan> {
        if self.moves.len() < self.seen + BLOCK {
            return None;
        }
        let before = self.smoothing.looked_at();
        for i in self.seen..self.moves.len() {
            self.track.follow(&self.moves, i);
        }
        self.seen = self.moves.len();
        self.smoothing.look(&self.track, &self.moves, false);
        let known = self.smoothing.looked_at();
        let rest = (before.max(1)..known).rev().find(|j| self.smoothing.stops(*j))?;
        let plan = self.piece(self.track.owner[rest] as usize);
        self.track = Track::new(AXES, self.dynamics.tolerance_mm);
        self.smoothing = Smoothing::new(Kernel::Triangle);
        self.seen = 0;
        plan
    }

    /// The stack is complete: the rest of its plan.
    pub fn finish(&mut self) -> Option<Plan> {
        let plan = self.piece(self.moves.len());
        *self = Self::new(&self.dynamics);
        plan
    }

    /// Forgets the stack; the moves that did not come out.
    pub fn withdraw(&mut self) -> Vec<Move> {
        let left = std::mem::take(&mut self.moves);
        *self = Self::new(&self.dynamics);
        left
    }

    /// The plan of the first moves, after which the machine stands.
    fn piece(&mut self, count: usize) -> Option<Plan> {
        let rest = self.moves.split_off(count);
        let moves = std::mem::replace(&mut self.moves, rest);
        if moves.is_empty() {
            return None;
        }
        let mut plan = Optimal { dynamics: &self.dynamics }.plan(moves);
        if let Law::Timed(law) = &mut plan.law {
            Timed::delay(law, self.t_s);
        }
        self.t_s = plan.duration_s();
        Some(plan)
    }
}

/// The numbers of the moves before which the machine stands, and the number of all.
pub(crate) fn of(dynamics: &Dynamics, moves: &[Move]) -> Vec<usize> {
    let mut track = Track::new(AXES, dynamics.tolerance_mm);
    (0..moves.len()).for_each(|i| track.follow(moves, i));
    let mut smoothing = Smoothing::<AXES>::new(Kernel::Triangle);
    smoothing.look(&track, moves, true);
    let begins = |j: &usize| smoothing.stops(*j) && track.owner[*j] != track.owner[*j - 1];
    let rests = (1..track.len()).filter(begins).map(|j| track.owner[j] as usize);
    rests.chain((!moves.is_empty()).then_some(moves.len())).collect()
}
