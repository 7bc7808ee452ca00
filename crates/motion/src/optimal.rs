//! The fastest motion within the limits of every axis and a tolerance of the path: moves to the search of
//! `kerf-motion-optimal`, and what it finds to pieces of plan.

use crate::moves::Move;
use crate::plan::{Law, Plan};
use crate::planner::{Model, Planner};
use kerf_motion_optimal::{Solver, SpeedPiece, Timed};
use kerf_program::Dynamics;

/// So many moves are looked at together, and with a limit of jerk.
const BLOCK: usize = 512;
const BLOCK_WITH_JERK: usize = 32;

/// Number of moves looked at together at first where the plan is waited for; it doubles from time to time.
const BLOCK_SOON: usize = 64;

/// The fastest motion that keeps every axis within its limits and the path within the tolerance,
/// over the whole stack.
#[derive(Clone, Copy, Debug)]
pub struct Optimal<'a> {
    /// Limits and tolerance.
    pub dynamics: &'a Dynamics,
}

impl Model for Optimal<'_> {
    fn plan(&self, moves: Vec<Move>) -> Plan {
        let mut planner = OptimalPlanner { moves, ..OptimalPlanner::new(self.dynamics) };
        while planner.moves.len() - planner.seen >= planner.block {
            planner.advance(planner.seen + planner.block, false);
        }
        planner.finish().unwrap_or_default()
    }
}

/// The place at which a plan that was left on the way is joined, and the motion from there on.
#[derive(Clone, Debug)]
pub(crate) struct Running {
    /// The move, and how much of it lies before.
    pub begin: (usize, f64),
    /// Ways within the limits, at least one.
    pub ways: Vec<SpeedPiece>,
}

/// Plans a stack with all that the axes can do while it is read.
#[derive(Clone, Debug)]
pub struct OptimalPlanner {
    solver: Solver,
    block: usize,
    /// Moves of which not all is in a piece.
    moves: Vec<Move>,
    /// Number of them that the search has.
    seen: usize,
}

impl OptimalPlanner {
    /// For a stack that begins under these limits.
    pub fn new(dynamics: &Dynamics) -> Self {
        let solver = Solver::new(dynamics);
        Self { block: most_at_once(solver.dynamics()), solver, moves: Vec::new(), seen: 0 }
    }

    /// The first pieces of plan are needed soon: they come out after few moves.
    pub(crate) fn hurry(&mut self) {
        self.block = self.block.min(BLOCK_SOON);
        self.solver.hurry();
    }

    /// Forgets the stack, and goes on in motion with these moves, of which the first lie before;
    /// under a limit of jerk.
    pub(crate) fn run_on(&mut self, moves: &[Move], running: Running) {
        *self = Self::new(self.dynamics());
        let (index, share) = running.begin;
        self.moves.extend_from_slice(&moves[..=index]);
        self.follow(index + 1);
        self.solver.begin_in_motion(share, running.ways);
        moves[index + 1..].iter().for_each(|made| self.push(*made));
    }

    /// The way to a stand that the last window found, as if it could not be bettered, up to the end of
    /// the last move in it; `None` when none is known.
    pub(crate) fn take_early(&mut self) -> Option<Plan> {
        self.solver.settle_early();
        self.take()
    }

    /// Returns the limits of the axes.
    pub(crate) const fn dynamics(&self) -> &Dynamics {
        self.solver.dynamics()
    }

    /// Returns `true` if no way was found from the motion in which it began.
    pub(crate) fn is_lost(&self) -> bool {
        self.solver.is_lost()
    }

    /// Gives moves to the search, up to so many.
    fn follow(&mut self, moves: usize) {
        for made in &self.moves[self.seen..moves] {
            self.solver.follow(made.leg(), |share| made.position(share));
        }
        self.seen = moves;
    }

    fn advance(&mut self, moves: usize, ended: bool) {
        self.follow(moves);
        self.solver.advance(ended);
    }

    /// A piece of plan of the first moves.
    fn piece(&mut self, (count, timed): (usize, Timed)) -> Plan {
        let rest = self.moves.split_off(count);
        let moves = std::mem::replace(&mut self.moves, rest);
        self.seen -= moves.len();
        Plan { moves, law: Law::Timed(Box::new(timed)) }
    }
}

/// Number of moves that are looked at together.
fn most_at_once(dynamics: &Dynamics) -> usize {
    dynamics.jerk_mm_s3.map_or(BLOCK, |_| BLOCK_WITH_JERK)
}

impl Planner for OptimalPlanner {
    fn push(&mut self, made: Move) {
        self.moves.push(made);
        if self.moves.len() - self.seen >= self.block {
            self.advance(self.moves.len(), false);
            self.block = (2 * self.block).min(most_at_once(self.dynamics()));
        }
    }

    fn take(&mut self) -> Option<Plan> {
        let piece = self.solver.take()?;
        Some(self.piece(piece))
    }

    fn finish(&mut self) -> Option<Plan> {
        if self.moves.is_empty() {
            return None;
        }
        self.advance(self.moves.len(), true);
        let rest = self.solver.rest();
        let piece = self.piece(rest);
        *self = Self::new(self.dynamics());
        Some(piece)
    }

    fn withdraw(&mut self) -> Vec<Move> {
        let left = std::mem::take(&mut self.moves);
        *self = Self::new(self.dynamics());
        left
    }
}
