//! The fastest motion within the limits of every axis and a tolerance of the path.
//!
//! Three steps, each in its own files. The moves become a polyline over one length ([`track`]). Its
//! corners are smoothed by bumps ([`kernel`]) as wide as the tolerance allows ([`widths`],
//! [`choice`]); the sum of polyline and bumps is a path whose derivatives are known in closed form
//! ([`walk`], [`cells`]). Along it the fastest speed is found by a pass back and a pass forward
//! ([`reach`], [`speeds`]). The outcome is a list of nodes between which the motion along the path
//! has a closed form ([`timed`]). Without a limit of jerk all of it happens while the moves are read
//! ([`planner`]).

mod cells;
mod choice;
mod jerk;
mod kernel;
mod limited;
mod pieces;
mod planner;
mod reach;
mod scurve;
mod speeds;
mod timed;
mod track;
mod walk;
mod widths;

pub(crate) use speeds::Node;
pub(crate) use timed::{Push, Timed};

use crate::moves::Move;
use crate::plan::{Law, Plan};
use crate::planner::Planner;
use crate::shopbot::Model;
use kerf_program::{AXES, Axes, Dynamics};
use kernel::Kernel;
use limited::Limited;
use planner::Stream;
use reach::Bounds;
use track::Track;
use widths::widest;

/// The fastest motion that keeps every axis within its limits and the path within the tolerance,
/// over the whole stack.
#[derive(Clone, Copy, Debug)]
pub struct Optimal<'a> {
    /// Limits and tolerance.
    pub dynamics: &'a Dynamics,
}

impl Model for Optimal<'_> {
    fn plan(&self, moves: Vec<Move>) -> Plan {
        let Some(jerk) = self.dynamics.jerk_mm_s3 else {
            return Stream::whole(self.dynamics, moves);
        };
        if moves.is_empty() {
            return Plan::default();
        }
        let track = Track::of(&moves, self.dynamics.tolerance_mm);
        let timed = match track.dims {
            3 => self.limited::<3>(track, &moves, &jerk),
            _ => self.limited::<AXES>(track, &moves, &jerk),
        };
        Plan { moves, law: Law::Timed(Box::new(timed)) }
    }
}

/// Plans a stack with all that the axes can do while it is read; with a limit of jerk, when it is
/// complete.
#[derive(Clone, Debug)]
pub struct OptimalPlanner {
    dynamics: Dynamics,
    stream: Stream,
    /// Moves that wait for the end of the stack, where jerk is limited.
    moves: Vec<Move>,
}

impl OptimalPlanner {
    /// For a stack that begins under these limits.
    pub fn new(dynamics: &Dynamics) -> Self {
        Self { dynamics: *dynamics, stream: Stream::new(dynamics), moves: Vec::new() }
    }
}

impl Planner for OptimalPlanner {
    fn push(&mut self, made: Move) {
        match self.dynamics.jerk_mm_s3 {
            None => self.stream.push(made),
            Some(_) => self.moves.push(made),
        }
    }

    fn take(&mut self) -> Option<Plan> {
        self.stream.take()
    }

    fn finish(&mut self) -> Option<Plan> {
        let moves = std::mem::take(&mut self.moves);
        if moves.is_empty() {
            return self.stream.finish();
        }
        Some(Optimal { dynamics: &self.dynamics }.plan(moves))
    }
}

impl Optimal<'_> {
    fn limited<const N: usize>(&self, track: Track, moves: &[Move], jerk: &Axes) -> Timed {
        let dynamics = *self.dynamics;
        let kernel = Kernel::Triangle;
        let widths = widest::<N>(&track, moves, kernel);
        let mut nodes = vec![Node { at_mm: 0.0, v: 0.0, t_s: 0.0 }];
        let mut pushes = vec![Push { accel: 0.0, jerk: None }];
        let bounds = Bounds::<N>::of(&dynamics);
        let jerk = std::array::from_fn(|k| jerk.0[k].max(1e-3));
        let limited = Limited { track: &track, widths: &widths, moves, bounds, jerk };
        for run in runs(&widths) {
            limited.run(run, &mut nodes, &mut pushes);
        }
        Timed { track, widths, kernel, nodes, pushes, dynamics }
    }
}

/// The runs from rest to rest, as pairs of vertices.
fn runs(widths: &[f64]) -> impl Iterator<Item = [usize; 2]> {
    let mut first = 0;
    (1..widths.len()).filter(|j| widths[*j] == 0.0).map(move |last| {
        let run = [first, last];
        first = last;
        run
    })
}
