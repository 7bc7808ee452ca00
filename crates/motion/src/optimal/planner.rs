//! Planning without a limit of jerk while a program is read: vertices, widths, cells and speeds each
//! follow as far as the one before is final.
//!
//! ```text
//!  moves ─► Track ─► Smoothing ─► Choice ─► Walk ─► Passes ─► nodes ─► pieces of plan
//!                    a few vertices behind          one braking distance behind
//! ```

use super::choice::Choice;
use super::kernel::Kernel;
use super::reach::{Bounds, Gate};
use super::speeds::{Node, Passes};
use super::timed::Timed;
use super::track::Track;
use super::walk::{Smoothed, Walk};
use super::widths::{REACH, Smoothing};
use crate::moves::Move;
use crate::plan::{Law, Plan};
use kerf_program::{AXES, Dynamics};

/// So many moves are looked at together.
const BLOCK: usize = 512;

/// Speeds are looked for when at least so many cells wait for theirs.
const ENOUGH: usize = 1024;

/// Nodes closer to the end of a move than this are at it, mm.
const SAME_MM: f64 = 1e-9;

/// Plans a stack of moves while it is read, without a limit of jerk.
#[derive(Clone, Debug)]
pub(crate) struct Stream {
    dynamics: Dynamics,
    /// Moves of which not all is in a piece.
    moves: Vec<Move>,
    /// How many of them are on the track.
    seen: usize,
    track: Track,
    /// The vertex at which the next piece begins.
    begin: usize,
    lanes: Lanes,
}

/// With as many axes as move.
#[derive(Clone, Debug)]
enum Lanes {
    Three(Box<Lane<3>>),
    All(Box<Lane<AXES>>),
}

#[derive(Clone, Debug)]
struct Lane<const N: usize> {
    bounds: Bounds<N>,
    smoothing: Smoothing<N>,
    choice: Choice,
    walk: Walk<N>,
    passes: Passes<N>,
    /// Speeds are looked for when so many cells wait.
    enough: usize,
}

impl Stream {
    /// For a stack that begins under these limits.
    pub fn new(dynamics: &Dynamics) -> Self {
        Self {
            dynamics: *dynamics,
            moves: Vec::new(),
            seen: 0,
            track: Track::new(3, dynamics.tolerance_mm),
            begin: 0,
            lanes: Lanes::Three(Box::new(Lane::new(Bounds::of(dynamics)))),
        }
    }

    /// The plan of a whole stack.
    pub fn whole(dynamics: &Dynamics, moves: Vec<Move>) -> Plan {
        let mut stream = Self { moves, ..Self::new(dynamics) };
        while stream.moves.len() - stream.seen >= BLOCK {
            stream.advance(stream.seen + BLOCK, false);
        }
        stream.finish().unwrap_or_default()
    }

    /// The next move of the stack.
    pub fn push(&mut self, made: Move) {
        self.moves.push(made);
        if self.moves.len() - self.seen >= BLOCK {
            self.advance(self.moves.len(), false);
        }
    }

    /// The next piece of plan that no later move can change.
    pub fn take(&mut self) -> Option<Plan> {
        let end = self.settled()?;
        let piece = self.piece(end);
        self.forget(end);
        Some(piece)
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
        for i in self.seen..moves {
            if !self.track.holds(&self.moves[i]) {
                self.track.widen();
                self.lanes.widen(&self.dynamics);
            }
            self.track.follow(&self.moves, i);
        }
        self.seen = moves;
        if ended {
            self.track.end();
        }
        match &mut self.lanes {
            Lanes::Three(lane) => lane.advance(&self.track, &self.moves, ended),
            Lanes::All(lane) => lane.advance(&self.track, &self.moves, ended),
        }
    }

    fn nodes(&mut self) -> &mut Vec<Node> {
        match &mut self.lanes {
            Lanes::Three(lane) => &mut lane.passes.nodes,
            Lanes::All(lane) => &mut lane.passes.nodes,
        }
    }

    fn widths(&self) -> &[f64] {
        match &self.lanes {
            Lanes::Three(lane) => &lane.choice.widths,
            Lanes::All(lane) => &lane.choice.widths,
        }
    }

    /// The last vertex at which a move ends and up to which the speed is known; `None` when there is
    /// none beyond the beginning.
    fn settled(&mut self) -> Option<usize> {
        let at_mm = self.nodes().last()?.at_mm;
        let track = &self.track;
        let passed = track.at_mm.partition_point(|at| *at <= at_mm);
        let ends = |j: &usize| track.owner[*j] != track.owner[*j - 1];
        (self.begin + 1..passed).rev().find(ends)
    }

    /// The plan from where the last piece ended up to a vertex at which a move ends.
    fn piece(&mut self, end: usize) -> Plan {
        let track = &self.track;
        let whole = end + 1 == track.len();
        let count = if whole { self.moves.len() } else { track.owner[end] as usize };
        // A chain that is broken here ends at the vertex before.
        let last = if !whole && track.breaks[end] && track.breaks[end - 1] { end - 1 } else { end };
        let (end_mm, widths) = (track.at_mm[end], self.widths());
        let near = |j: &usize| track.at_mm[*j] - widths[*j].abs() < end_mm;
        let beyond = (last + 1..widths.len()).take_while(near).count();
        let from = self.begin.saturating_sub(REACH);
        // And the vertex after them, for the direction after the last.
        let to = if last < end { end } else { (last + beyond + 2).min(widths.len()) };
        let part = track.part(from, to, count.saturating_sub(1));
        let widths = widths[from..to].to_vec();
        let nodes = cut(self.nodes(), end_mm);
        let rest = self.moves.split_off(count);
        let moves = std::mem::replace(&mut self.moves, rest);
        let timed = Timed {
            track: part,
            widths,
            kernel: Kernel::Box,
            nodes,
            pushes: Vec::new(),
            dynamics: self.dynamics,
        };
        self.seen -= moves.len();
        self.track.count_from(moves.len());
        Plan { moves, law: Law::Timed(Box::new(timed)) }
    }

    /// Forgets what no later piece needs, after one that ended at a vertex.
    fn forget(&mut self, end: usize) {
        let needs = match &self.lanes {
            Lanes::Three(lane) => lane.needs(),
            Lanes::All(lane) => lane.needs(),
        };
        let count = end.min(needs).saturating_sub(2 * REACH);
        self.begin = end - count;
        self.track.forget(count);
        match &mut self.lanes {
            Lanes::Three(lane) => lane.forget(count),
            Lanes::All(lane) => lane.forget(count),
        }
    }
}

/// Takes the nodes up to a place, and leaves those from there on.
fn cut(nodes: &mut Vec<Node>, at_mm: f64) -> Vec<Node> {
    let index = nodes.partition_point(|n| n.at_mm < at_mm - SAME_MM);
    let rest = nodes.split_off(index);
    let mut made = std::mem::replace(nodes, rest);
    let Some(next) = nodes.first_mut() else { return made };
    if next.at_mm <= at_mm + SAME_MM {
        next.at_mm = at_mm;
        made.push(*next);
    } else if let Some(before) = made.last() {
        let share = (at_mm - before.at_mm) / (next.at_mm - before.at_mm);
        let square = before.v * before.v;
        let v = (square + share * (next.v * next.v - square)).sqrt();
        let t_s = before.t_s + 2.0 * (at_mm - before.at_mm) / (before.v + v);
        let node = Node { at_mm, v, t_s };
        made.push(node);
        nodes.insert(0, node);
    }
    made
}

impl Lanes {
    /// All axes from here on.
    fn widen(&mut self, dynamics: &Dynamics) {
        if let Self::Three(lane) = self {
            *self = Self::All(Box::new(Lane {
                bounds: Bounds::of(dynamics),
                smoothing: lane.smoothing.widen(),
                choice: std::mem::take(&mut lane.choice),
                walk: lane.walk.widen(),
                passes: lane.passes.widen(Bounds::of(dynamics)),
                enough: lane.enough,
            }));
        }
    }
}

impl<const N: usize> Lane<N> {
    fn new(bounds: Bounds<N>) -> Self {
        Self {
            bounds,
            smoothing: Smoothing::new(Kernel::Box),
            choice: Choice::default(),
            walk: Walk::new(),
            passes: Passes::new(bounds, 0.0),
            enough: ENOUGH,
        }
    }

    fn advance(&mut self, track: &Track, moves: &[Move], ended: bool) {
        let Self { bounds, smoothing, choice, walk, passes, .. } = self;
        let wide = smoothing.advance(track, moves, ended);
        choice.advance(smoothing, track, moves, bounds, wide, ended);
        let widths = &choice.widths[..choice.done];
        let path = Smoothed { track, smoothing, widths, moves };
        while let Some((cell, stands)) = walk.next(&path) {
            let mut gate = Gate::new(&cell, bounds, moves);
            gate.stands = stands;
            passes.gates.push(gate);
        }
        if ended || passes.gates.len() >= self.enough {
            passes.settle(ended);
            self.enough = ENOUGH.max(2 * passes.gates.len());
        }
    }

    /// The first vertex that is still needed.
    fn needs(&self) -> usize {
        self.walk.needs().min(self.choice.done)
    }

    fn forget(&mut self, vertices: usize) {
        self.smoothing.forget(vertices);
        self.choice.forget(vertices);
        self.walk.forget(vertices);
    }
}

/// The same with zeros for the axes that stood still.
pub(crate) fn padded<const N: usize, const M: usize>(v: &[f64; N]) -> [f64; M] {
    std::array::from_fn(|k| v.get(k).copied().unwrap_or(0.0))
}
