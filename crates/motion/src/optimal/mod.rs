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
mod condition;
mod jerk;
mod join;
mod kernel;
mod limited;
mod newton;
mod pieces;
mod planner;
mod reach;
mod rests;
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
use rests::Rests;
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
        let mut made: Option<Timed> = None;
        let mut begun = 0;
        for end in rests::of(self.dynamics, &moves) {
            let mut run = self.run(&moves[begun..end], &jerk);
            match &mut made {
                None => made = Some(run),
                Some(made) => {
                    run.delay(made.duration_s());
                    made.join(run, begun);
                }
            }
            begun = end;
        }
        match made {
            None => Plan::default(),
            Some(made) => Plan { moves, law: Law::Timed(Box::new(made)) },
        }
    }
}

/// Plans a stack with all that the axes can do while it is read. With a limit of jerk a piece of plan
/// ends where the machine must stand.
#[derive(Clone, Debug)]
pub struct OptimalPlanner(Reading);

#[derive(Clone, Debug)]
enum Reading {
    Free(Box<Stream>),
    Limited(Box<Rests>),
}

impl OptimalPlanner {
    /// For a stack that begins under these limits.
    pub fn new(dynamics: &Dynamics) -> Self {
        Self(match dynamics.jerk_mm_s3 {
            None => Reading::Free(Box::new(Stream::new(dynamics))),
            Some(_) => Reading::Limited(Box::new(Rests::new(dynamics))),
        })
    }
}

impl Planner for OptimalPlanner {
    fn push(&mut self, made: Move) {
        match &mut self.0 {
            Reading::Free(stream) => stream.push(made),
            Reading::Limited(rests) => rests.push(made),
        }
    }

    fn take(&mut self) -> Option<Plan> {
        match &mut self.0 {
            Reading::Free(stream) => stream.take(),
            Reading::Limited(rests) => rests.take(),
        }
    }

    fn finish(&mut self) -> Option<Plan> {
        match &mut self.0 {
            Reading::Free(stream) => stream.finish(),
            Reading::Limited(rests) => rests.finish(),
        }
    }

    fn withdraw(&mut self) -> Vec<Move> {
        match &mut self.0 {
            Reading::Free(stream) => stream.withdraw(),
            Reading::Limited(rests) => rests.withdraw(),
        }
    }
}

impl Optimal<'_> {
    /// Moves from rest to rest, with a limit of jerk. By itself, so that its plan does not depend on
    /// what is before and after.
    fn run(&self, moves: &[Move], jerk: &Axes) -> Timed {
        let track = Track::of(moves, self.dynamics.tolerance_mm);
        match track.dims {
            3 => self.limited::<3>(track, moves, jerk),
            _ => self.limited::<AXES>(track, moves, jerk),
        }
    }

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
