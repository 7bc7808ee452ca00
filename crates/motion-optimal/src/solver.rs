//! The search while a program is read: vertices, widths, cells and speeds each follow as far as the one
//! before is final.
//!
//! ```text
//!  moves ─► Track ─► Smoothing ─► Choice ─► Walk ─► Passes ─► nodes ─► pieces of plan
//!                              └────► Cells ─────► Horizon ───┘  with a limit of jerk
//!                    a few vertices behind          one braking distance behind
//! ```

use crate::cut::{SAME_MM, cut, cut_pushes};
use crate::kernel::Kernel;
use crate::leg::Leg;
use crate::speed_piece::SpeedPiece;
use crate::timed::Timed;
use crate::track::Track;
use crate::variants::Variant;
use crate::widths::REACH;
use kerf_program::{Axes, Dynamics};

/// An axis whose jerk is free reaches its acceleration within this, seconds: the search needs a number.
const FREE_RISE_S: f64 = 1e-3;

/// Finds the motion along a stack of moves while it is read.
#[derive(Clone, Debug)]
pub struct Solver {
    dynamics: Dynamics,
    /// Moves on the track of which not all is in a piece.
    legs: Vec<Leg>,
    track: Track,
    /// The vertex at which the next piece begins.
    begin: usize,
    search: Variant,
}

/// A limit of jerk that leaves an axis free as a high one, and one that leaves all of them free as none.
fn bounded(dynamics: Dynamics) -> Dynamics {
    let limit = dynamics.jerk_mm_s3.filter(|jerk| jerk.0.iter().any(|j| j.is_finite()));
    let high = |k: usize| dynamics.accel_mm_s2.0[k] / FREE_RISE_S;
    let finite = |jerk: Axes| Axes(std::array::from_fn(|k| jerk.0[k].min(high(k))));
    Dynamics { jerk_mm_s3: limit.map(finite), ..dynamics }
}

impl Solver {
    /// For a stack that begins under these limits.
    pub fn new(dynamics: &Dynamics) -> Self {
        let dynamics = bounded(*dynamics);
        let (track, search) = (Track::new(3, dynamics.tolerance_mm), Variant::new(&dynamics));
        Self { dynamics, legs: Vec::new(), track, begin: 0, search }
    }

    /// Returns the limits of the axes.
    pub const fn dynamics(&self) -> &Dynamics {
        &self.dynamics
    }

    /// The first speeds come out after few cells.
    pub fn hurry(&mut self) {
        self.search.hurry();
    }

    /// Begins in motion, with a limit of jerk: in the last of the moves on the track, after a share of it, by
    /// ways within the limits, at least one.
    pub fn begin_in_motion(&mut self, share: f64, ways: Vec<SpeedPiece>) {
        let index = self.legs.len().saturating_sub(1);
        let track = &self.track;
        let first = track.owner.partition_point(|owner| (*owner as usize) < index);
        let (a, b) = (track.at_mm[first], track.at_mm[track.len() - 1]);
        self.search.begin_at(a + share * (b - a), ways);
    }

    /// Returns `true` if no way was found from the motion in which it began.
    pub fn is_lost(&self) -> bool {
        self.search.is_lost()
    }

    /// Takes a move onto the track, whose position at a share of its path is asked for.
    pub fn follow(&mut self, leg: Leg, position: impl Fn(f64) -> Axes) {
        if !self.track.holds(&leg) {
            self.track.widen();
            self.search.widen(&self.dynamics);
        }
        self.legs.push(leg);
        self.track.follow(&self.legs, self.legs.len() - 1, position);
    }

    /// Finds widths and speeds as far as the track lets them be final; `ended` when the stack is complete.
    pub fn advance(&mut self, ended: bool) {
        if ended {
            self.track.end();
        }
        self.search.speeds_mut().advance(&self.track, &self.legs, ended);
    }

    /// Takes the motion that was found last as final, to its stand, although more of the path could better it.
    pub fn settle_early(&mut self) {
        self.search.speeds_mut().settle_early();
    }

    /// The next piece that no later move can change, and of how many moves it is.
    pub fn take(&mut self) -> Option<(usize, Timed)> {
        let end = self.settled()?;
        let piece = self.piece(end);
        self.forget(end);
        Some(piece)
    }

    /// The rest of a stack that is complete, and of how many moves it is.
    pub fn rest(&mut self) -> (usize, Timed) {
        self.piece(self.track.len() - 1)
    }

    /// The last vertex at which a move ends and up to which the speed is known; `None` when there is
    /// none beyond the beginning.
    fn settled(&mut self) -> Option<usize> {
        let (nodes, _) = self.search.speeds_mut().nodes();
        let (from_mm, at_mm) = (nodes.first()?.at_mm, nodes.last()?.at_mm);
        let track = &self.track;
        let passed = track.at_mm.partition_point(|at| *at <= at_mm);
        let ends = |j: &usize| track.owner[*j] != track.owner[*j - 1];
        let settled = (self.begin + 1..passed).rev().find(ends);
        settled.filter(|j| track.at_mm[*j] > from_mm + SAME_MM)
    }

    /// The motion from where the last piece ended up to a vertex at which a move ends, and of how many moves it is.
    fn piece(&mut self, end: usize) -> (usize, Timed) {
        let track = &self.track;
        let whole = end + 1 == track.len();
        let count = if whole { self.legs.len() } else { track.owner[end] as usize };
        // A chain that is broken here ends at the vertex before.
        let last = if !whole && track.breaks[end] && track.breaks[end - 1] { end - 1 } else { end };
        let (end_mm, widths) = (track.at_mm[end], self.search.speeds().widths());
        let near = |j: &usize| track.at_mm[*j] - widths[*j].abs() < end_mm;
        let beyond = (last + 1..widths.len()).take_while(near).count();
        let from = self.begin.saturating_sub(REACH);
        // And the vertex after them, for the direction after the last.
        let to = if last < end { end } else { (last + beyond + 2).min(widths.len()) };
        let part = track.part(from, to, count.saturating_sub(1));
        let (widths, from_mm) = (widths[from..to].to_vec(), track.at_mm[self.begin]);
        let (nodes, pushes) = self.search.speeds_mut().nodes();
        let kernel = if pushes.is_some() { Kernel::Triangle } else { Kernel::Box };
        let pushes = pushes.map(|pushes| cut_pushes(nodes, pushes, end_mm)).unwrap_or_default();
        let nodes = cut(nodes, end_mm);
        let dynamics = self.dynamics;
        let timed = Timed { track: part, from_mm, widths, kernel, nodes, pushes, dynamics };
        self.legs.drain(..count);
        self.track.count_from(count);
        self.search.speeds_mut().count_from(count);
        (count, timed)
    }

    /// Forgets what no later piece needs, after one that ended at a vertex.
    fn forget(&mut self, end: usize) {
        let needs = self.search.speeds().needs();
        let count = end.min(needs).saturating_sub(2 * REACH);
        self.begin = end - count;
        self.track.forget(count);
        self.search.speeds_mut().forget(count);
    }
}
