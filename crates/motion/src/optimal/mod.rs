//! The fastest motion within the limits of every axis and a tolerance of the path.
//!
//! Three steps, each in its own file. The moves become a polyline over one length ([`track`]). Its
//! corners are smoothed by bumps as wide as the tolerance allows ([`widths`]); the sum of polyline
//! and bumps is a path whose derivatives are known in closed form ([`cells`]). Along it the fastest
//! speed is found by a pass back and a pass forward ([`reach`], [`speeds`]). The outcome is a list
//! of nodes between which the motion along the path has a closed form ([`timed`]).

mod cells;
mod jerk;
mod limited;
mod pieces;
mod reach;
mod scurve;
mod speeds;
mod timed;
mod track;
mod widths;

pub(crate) use speeds::Node;
pub(crate) use timed::{Push, Timed};

use crate::moves::Move;
use crate::plan::{Law, Plan};
use crate::shopbot::Model;
use cells::Cells;
use kerf_program::{AXES, Dynamics};
use limited::Limited;
use reach::{Bounds, Gate};
use track::Track;
use widths::{Kernel, Overlap, widths};

/// The fastest motion that keeps every axis within its limits and the path within the tolerance,
/// over the whole stack.
#[derive(Clone, Copy, Debug)]
pub struct Optimal<'a> {
    /// Limits and tolerance.
    pub dynamics: &'a Dynamics,
}

impl Model for Optimal<'_> {
    fn plan(&self, moves: Vec<Move>) -> Plan {
        if moves.is_empty() {
            return Plan::default();
        }
        let (track, breaks) = Track::of(&moves, self.dynamics.tolerance_mm.max(0.0));
        let timed = match track.dims {
            3 => self.time::<3>(track, &breaks, &moves),
            _ => self.time::<AXES>(track, &breaks, &moves),
        };
        Plan { moves, law: Law::Timed(Box::new(timed)) }
    }
}

impl Optimal<'_> {
    fn time<const N: usize>(&self, track: Track, breaks: &[usize], moves: &[Move]) -> Timed {
        match self.dynamics.jerk_mm_s3 {
            None => self.free::<N>(track, breaks, moves),
            Some(jerk) => self.limited::<N>(track, breaks, moves, &jerk.0),
        }
    }

    fn limited<const N: usize>(
        &self,
        track: Track,
        breaks: &[usize],
        moves: &[Move],
        jerk: &[f64],
    ) -> Timed {
        let dynamics = *self.dynamics;
        let kernel = Kernel::Triangle;
        let widths = widths::<N>(&track, breaks, moves, kernel, Overlap::Widest);
        let mut nodes: Vec<Node> = track
            .at_mm
            .first()
            .map(|at| Node { at_mm: *at, v: 0.0, t_s: 0.0 })
            .into_iter()
            .collect();
        let mut pushes = vec![Push { accel: 0.0, jerk: None }];
        let bounds = Bounds::<N>::new(&dynamics.speed_mm_s.0, &dynamics.accel_mm_s2.0);
        let jerk = std::array::from_fn(|k| jerk[k].max(1e-3));
        let limited = Limited { track: &track, widths: &widths, moves, bounds, jerk };
        for run in runs(&widths) {
            limited.run(run, &mut nodes, &mut pushes);
        }
        Timed { track, widths, kernel, nodes, pushes, dynamics }
    }

    fn free<const N: usize>(&self, track: Track, breaks: &[usize], moves: &[Move]) -> Timed {
        let bounds = Bounds::<N>::new(&self.dynamics.speed_mm_s.0, &self.dynamics.accel_mm_s2.0);
        let mut nodes = Vec::with_capacity(2 * track.len());
        nodes.extend(track.at_mm.first().map(|at| Node { at_mm: *at, v: 0.0, t_s: 0.0 }));
        let narrow = widths::<N>(&track, breaks, moves, Kernel::Box, Overlap::None);
        let mut chosen = widths::<N>(&track, breaks, moves, Kernel::Box, Overlap::Widest);
        for run in runs(&narrow) {
            let [first, last] = run;
            let since = nodes.len();
            let start = nodes[since - 1];
            let time = |widths: &[f64], nodes: &mut Vec<Node>| {
                let cells = Cells::new(&track, widths, Kernel::Box, moves, run);
                let mut gates: Vec<Gate<N>> =
                    cells.map(|cell| Gate::new(&cell, &bounds, moves)).collect();
                speeds::run(&mut gates, &bounds, nodes);
                // Sums of cells are rounded; the end of a run is a vertex.
                if let Some(end) = nodes.last_mut() {
                    end.at_mm = track.at_mm[last];
                }
            };
            time(&narrow, &mut nodes);
            if narrow[first..last] == chosen[first..last] {
                continue;
            }
            let mut other = vec![start];
            time(&chosen, &mut other);
            let ends = |nodes: &[Node]| nodes.last().map_or(0.0, |n| n.t_s);
            if ends(&other) < ends(&nodes) {
                nodes.truncate(since);
                nodes.extend_from_slice(&other[1..]);
            } else {
                chosen[first..last].copy_from_slice(&narrow[first..last]);
            }
        }
        Timed {
            track,
            widths: chosen,
            kernel: Kernel::Box,
            nodes,
            pushes: Vec::new(),
            dynamics: *self.dynamics,
        }
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
