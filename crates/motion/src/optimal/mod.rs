//! The fastest motion within the limits of every axis and a tolerance of the path.
//!
//! Three steps, each in its own files. The moves become a polyline over one length ([`track`]). Its
//! corners are smoothed by bumps ([`kernel`]) as wide as the tolerance allows ([`widths`],
//! [`choice`]); the sum of polyline and bumps is a path whose derivatives are known in closed form
//! ([`walk`], [`cells`]). Along it the fastest speed is found by a pass back and a pass forward
//! ([`reach`], [`speeds`]). The outcome is a list of nodes between which the motion along the path
//! has a closed form ([`timed`]). With a limit of jerk the speed is found in windows instead
//! ([`horizon`]), each as a convex problem ([`jerk`]). All of it happens while the moves are read
//! ([`planner`]).

mod barriers;
mod cells;
mod choice;
mod condition;
mod cut;
mod found;
mod grid;
mod horizon;
mod jerk;
mod kernel;
mod lanes;
mod launch;
mod newton;
mod pieces;
mod planner;
mod problem;
mod reach;
mod scurve;
mod speeds;
mod timed;
mod track;
mod walk;
mod ways;
mod widths;

pub(crate) use planner::Running;
pub(crate) use speeds::Node;
pub(crate) use timed::Timed;
pub(crate) use ways::Way;

use crate::moves::Move;
use crate::plan::Plan;
use crate::planner::Planner;
use crate::shopbot::Model;
use kerf_program::Dynamics;
use planner::Stream;

/// The fastest motion that keeps every axis within its limits and the path within the tolerance,
/// over the whole stack.
#[derive(Clone, Copy, Debug)]
pub struct Optimal<'a> {
    /// Limits and tolerance.
    pub dynamics: &'a Dynamics,
}

impl Model for Optimal<'_> {
    fn plan(&self, moves: Vec<Move>) -> Plan {
        Stream::whole(self.dynamics, moves)
    }
}

/// Plans a stack with all that the axes can do while it is read.
#[derive(Clone, Debug)]
pub struct OptimalPlanner(Stream);

impl OptimalPlanner {
    /// For a stack that begins under these limits.
    pub fn new(dynamics: &Dynamics) -> Self {
        Self(Stream::new(dynamics))
    }

    /// The first pieces of plan are needed soon: they come out after few moves.
    pub(crate) fn hurry(&mut self) {
        self.0.hurry();
    }

    /// Forgets the stack, and goes on in motion with these moves, of which the first lie before;
    /// under a limit of jerk.
    pub(crate) fn run_on(&mut self, moves: &[Move], running: Running) {
        self.0 = Stream::running(self.dynamics(), moves, running);
    }

    /// The way to a stand that the last window found, as if it could not be bettered, up to the end of
    /// the last move in it; `None` when none is known.
    pub(crate) fn take_early(&mut self) -> Option<Plan> {
        self.0.take_early()
    }

    /// Returns the limits of the axes.
    pub(crate) const fn dynamics(&self) -> &Dynamics {
        &self.0.dynamics
    }

    /// Returns `true` if no way was found from the motion in which it began.
    pub(crate) fn is_lost(&self) -> bool {
        self.0.is_lost()
    }
}

impl Planner for OptimalPlanner {
    fn push(&mut self, made: Move) {
        self.0.push(made);
    }

    fn take(&mut self) -> Option<Plan> {
        self.0.take()
    }

    fn finish(&mut self) -> Option<Plan> {
        self.0.finish()
    }

    fn withdraw(&mut self) -> Vec<Move> {
        self.0.withdraw()
    }
}
