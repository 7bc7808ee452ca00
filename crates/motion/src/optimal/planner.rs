//! Planning while a program is read: vertices, widths, cells and speeds each follow as far as the one
//! before is final.
//!
//! ```text
//!  moves ─► Track ─► Smoothing ─► Choice ─► Walk ─► Passes ─► nodes ─► pieces of plan
//!                              └────► Cells ─────► Horizon ───┘  with a limit of jerk
//!                    a few vertices behind          one braking distance behind
//! ```

use super::cut::{SAME_MM, cut, cut_pushes};
use super::kernel::Kernel;
use super::lanes::Lanes;
use super::timed::Timed;
use super::track::Track;
use super::ways::Way;
use super::widths::REACH;
use crate::moves::Move;
use crate::plan::{Law, Plan};
use kerf_program::{Axes, Dynamics};

/// So many moves are looked at together, and with a limit of jerk.
const BLOCK: usize = 512;
const BLOCK_WITH_JERK: usize = 32;

/// Number of moves looked at together at first where the plan is waited for; it doubles from time to time.
const BLOCK_SOON: usize = 64;

/// An axis whose jerk is free reaches its acceleration within this, seconds: the search needs a number.
const FREE_RISE_S: f64 = 1e-3;

/// Plans a stack of moves while it is read.
#[derive(Clone, Debug)]
pub(crate) struct Stream {
    pub dynamics: Dynamics,
    block: usize,
    /// Moves of which not all is in a piece.
    moves: Vec<Move>,
    /// Number of them that are on the track.
    seen: usize,
    track: Track,
    /// The vertex at which the next piece begins.
    begin: usize,
    lanes: Lanes,
}

/// The place at which a plan that was left on the way is joined, and the motion from there on.
#[derive(Clone, Debug)]
pub(crate) struct Running {
    /// The move, and how much of it lies before.
    pub begin: (usize, f64),
    /// Ways within the limits, at least one.
    pub ways: Vec<Way>,
}

/// A limit of jerk that leaves an axis free as a high one, and one that leaves all of them free as none.
fn bounded(dynamics: Dynamics) -> Dynamics {
    let limit = dynamics.jerk_mm_s3.filter(|jerk| jerk.0.iter().any(|j| j.is_finite()));
    let high = |k: usize| dynamics.accel_mm_s2.0[k] / FREE_RISE_S;
    let finite = |jerk: Axes| Axes(std::array::from_fn(|k| jerk.0[k].min(high(k))));
    Dynamics { jerk_mm_s3: limit.map(finite), ..dynamics }
}

impl Stream {
    /// For a stack that begins under these limits.
    pub fn new(dynamics: &Dynamics) -> Self {
        let dynamics = &bounded(*dynamics);
        let block = dynamics.jerk_mm_s3.map_or(BLOCK, |_| BLOCK_WITH_JERK);
        let (track, lanes) = (Track::new(3, dynamics.tolerance_mm), Lanes::new(dynamics));
        Self { dynamics: *dynamics, block, moves: Vec::new(), seen: 0, track, begin: 0, lanes }
    }

    /// The first pieces of plan come out after few moves.
    pub fn hurry(&mut self) {
        self.block = self.block.min(BLOCK_SOON);
        self.lanes.hurry();
    }

    /// Begins in motion, with a limit of jerk; the first of the moves lie before.
    pub fn running(dynamics: &Dynamics, moves: &[Move], running: Running) -> Self {
        let mut stream = Self::new(dynamics);
        let (index, share) = running.begin;
        for made in &moves[..=index] {
            stream.moves.push(*made);
        }
        stream.follow(index + 1);
        let track = &stream.track;
        let first = track.owner.partition_point(|owner| (*owner as usize) < index);
        let (a, b) = (track.at_mm[first], track.at_mm[track.len() - 1]);
        let at_mm = a + share * (b - a);
        stream.lanes.begin_at(at_mm, running.ways);
        for made in &moves[index + 1..] {
            stream.push(*made);
        }
        stream
    }

    /// Returns `true` if no way was found from the motion in which it began.
    pub fn is_lost(&self) -> bool {
        self.lanes.is_lost()
    }

    /// The plan of a whole stack.
    pub fn whole(dynamics: &Dynamics, moves: Vec<Move>) -> Plan {
        let mut stream = Self { moves, ..Self::new(dynamics) };
        while stream.moves.len() - stream.seen >= stream.block {
            stream.advance(stream.seen + stream.block, false);
        }
        stream.finish().unwrap_or_default()
    }

    /// The next move of the stack.
    pub fn push(&mut self, made: Move) {
        self.moves.push(made);
        if self.moves.len() - self.seen >= self.block {
            self.advance(self.moves.len(), false);
            let most = self.dynamics.jerk_mm_s3.map_or(BLOCK, |_| BLOCK_WITH_JERK);
            self.block = (2 * self.block).min(most);
        }
    }

    /// The next piece of plan that no later move can change.
    pub fn take(&mut self) -> Option<Plan> {
        let end = self.settled()?;
        let piece = self.piece(end);
        self.forget(end);
        Some(piece)
    }

    /// The next piece, where the motion that was found last is taken as final, to its stand, although
    /// more of the path could better it.
    pub fn take_early(&mut self) -> Option<Plan> {
        self.lanes.speeds_mut().settle_early();
        self.take()
    }

    /// The stack is complete: the rest of its plan.
    pub fn finish(&mut self) -> Option<Plan> {
        if self.moves.is_empty() {
            return None;
        }
        self.advance(self.moves.len(), true);
        let piece = self.piece(self.track.len() - 1);
        *self = Self::new(&self.dynamics);
        Some(piece)
    }

    /// Forgets the stack; the moves that did not come out.
    pub fn withdraw(&mut self) -> Vec<Move> {
        let left = std::mem::take(&mut self.moves);
        *self = Self::new(&self.dynamics);
        left
    }

    fn advance(&mut self, moves: usize, ended: bool) {
        self.follow(moves);
        if ended {
            self.track.end();
        }
        let Self { lanes, track, moves, .. } = self;
        lanes.speeds_mut().advance(track, moves, ended);
    }

    /// Takes moves onto the track, up to so many.
    fn follow(&mut self, moves: usize) {
        for i in self.seen..moves {
            if !self.track.holds(&self.moves[i]) {
                self.track.widen();
                self.lanes.widen(&self.dynamics);
            }
            self.track.follow(&self.moves, i);
        }
        self.seen = moves;
    }

    /// The last vertex at which a move ends and up to which the speed is known; `None` when there is
    /// none beyond the beginning.
    fn settled(&mut self) -> Option<usize> {
        let (nodes, _) = self.lanes.speeds_mut().nodes();
        let (from_mm, at_mm) = (nodes.first()?.at_mm, nodes.last()?.at_mm);
        let track = &self.track;
        let passed = track.at_mm.partition_point(|at| *at <= at_mm);
        let ends = |j: &usize| track.owner[*j] != track.owner[*j - 1];
        let settled = (self.begin + 1..passed).rev().find(ends);
        settled.filter(|j| track.at_mm[*j] > from_mm + SAME_MM)
    }

    /// The plan from where the last piece ended up to a vertex at which a move ends.
    fn piece(&mut self, end: usize) -> Plan {
        let track = &self.track;
        let whole = end + 1 == track.len();
        let count = if whole { self.moves.len() } else { track.owner[end] as usize };
        // A chain that is broken here ends at the vertex before.
        let last = if !whole && track.breaks[end] && track.breaks[end - 1] { end - 1 } else { end };
        let (end_mm, widths) = (track.at_mm[end], self.lanes.speeds().widths());
        let near = |j: &usize| track.at_mm[*j] - widths[*j].abs() < end_mm;
        let beyond = (last + 1..widths.len()).take_while(near).count();
        let from = self.begin.saturating_sub(REACH);
        // And the vertex after them, for the direction after the last.
        let to = if last < end { end } else { (last + beyond + 2).min(widths.len()) };
        let part = track.part(from, to, count.saturating_sub(1));
        let (widths, from_mm) = (widths[from..to].to_vec(), track.at_mm[self.begin]);
        let (nodes, pushes) = self.lanes.speeds_mut().nodes();
        let kernel = if pushes.is_some() { Kernel::Triangle } else { Kernel::Box };
        let pushes = pushes.map(|pushes| cut_pushes(nodes, pushes, end_mm)).unwrap_or_default();
        let nodes = cut(nodes, end_mm);
        let rest = self.moves.split_off(count);
        let moves = std::mem::replace(&mut self.moves, rest);
        let dynamics = self.dynamics;
        let timed = Timed { track: part, from_mm, widths, kernel, nodes, pushes, dynamics };
        self.seen -= moves.len();
        self.track.count_from(moves.len());
        self.lanes.speeds_mut().count_from(moves.len());
        Plan { moves, law: Law::Timed(Box::new(timed)) }
    }

    /// Forgets what no later piece needs, after one that ended at a vertex.
    fn forget(&mut self, end: usize) {
        let needs = self.lanes.speeds().needs();
        let count = end.min(needs).saturating_sub(2 * REACH);
        self.begin = end - count;
        self.track.forget(count);
        self.lanes.speeds_mut().forget(count);
    }
}
