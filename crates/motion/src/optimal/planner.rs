//! Planning while a program is read: vertices, widths, cells and speeds each follow as far as the one
//! before is final.
//!
//! ```text
//!  moves ─► Track ─► Smoothing ─► Choice ─► Walk ─► Passes ─► nodes ─► pieces of plan
//!                              └────► Cells ─────► Horizon ───┘  with a limit of jerk
//!                    a few vertices behind          one braking distance behind
//! ```

use super::choice::Choice;
use super::horizon::{Horizon, Way};
use super::kernel::Kernel;
use super::reach::{Bounds, Gate};
use super::speeds::{Node, Passes};
use super::timed::{Push, Timed, halve};
use super::track::Track;
use super::walk::{Smoothed, Walk};
use super::widths::{REACH, Smoothing};
use crate::moves::Move;
use crate::plan::{Law, Plan};
use kerf_program::{AXES, Axes, Dynamics};

/// So many moves are looked at together, and with a limit of jerk.
const BLOCK: usize = 512;
const BLOCK_WITH_JERK: usize = 32;

/// Speeds are looked for when at least so many cells wait for theirs.
const ENOUGH: usize = 1024;

/// Where somebody waits for the plan both begin with so few, and double from time to time.
const BLOCK_SOON: usize = 64;
const ENOUGH_SOON: usize = 128;

/// Nodes closer to the end of a move than this are at it, mm.
const SAME_MM: f64 = 1e-9;

/// An axis whose jerk is free reaches its acceleration within this, seconds: the search needs a number.
const FREE_RISE_S: f64 = 1e-3;

/// Plans a stack of moves while it is read.
#[derive(Clone, Debug)]
pub(crate) struct Stream {
    pub dynamics: Dynamics,
    block: usize,
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
    ThreeWithJerk(Box<Horizon<3>>),
    AllWithJerk(Box<Horizon<AXES>>),
}

/// Finds widths and speeds along a track.
trait Speeds {
    fn advance(&mut self, track: &Track, moves: &[Move], ended: bool);

    /// Takes the motion as final that was found, although it could be bettered.
    fn settle_early(&mut self) {}

    /// The nodes that are final, and with a limit of jerk how the motion goes on after each.
    fn nodes(&mut self) -> (&mut Vec<Node>, Option<&mut Vec<Push>>);

    fn widths(&self) -> &[f64];

    /// The first vertex that is still needed.
    fn needs(&self) -> usize;

    /// Forgets the first vertices.
    fn forget(&mut self, vertices: usize);

    /// Counts moves from a later one on.
    fn count_from(&mut self, moves: usize);
}

/// Where a plan is joined that was left on the way: what it does from there on.
#[derive(Clone, Debug)]
pub(crate) struct Running {
    /// The move, and how much of it lies before.
    pub begin: (usize, f64),
    /// Ways within the limits, at least one.
    pub ways: Vec<Way>,
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
        let (block, lanes) = match dynamics.jerk_mm_s3 {
            None => (BLOCK, Lanes::Three(Box::new(Lane::new(Bounds::of(dynamics))))),
            Some(_) => (BLOCK_WITH_JERK, Lanes::ThreeWithJerk(Box::new(Horizon::new(dynamics)))),
        };
        let track = Track::new(3, dynamics.tolerance_mm);
        Self { dynamics: *dynamics, block, moves: Vec::new(), seen: 0, track, begin: 0, lanes }
    }

    /// The first pieces of plan come out after few moves.
    pub fn hurry(&mut self) {
        self.block = self.block.min(BLOCK_SOON);
        match &mut self.lanes {
            Lanes::Three(lane) => lane.enough = ENOUGH_SOON,
            Lanes::All(lane) => lane.enough = ENOUGH_SOON,
            Lanes::ThreeWithJerk(_) | Lanes::AllWithJerk(_) => {}
        }
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
        match &mut stream.lanes {
            Lanes::ThreeWithJerk(lane) => lane.begin_at(at_mm, running.ways),
            Lanes::AllWithJerk(lane) => lane.begin_at(at_mm, running.ways),
            Lanes::Three(_) | Lanes::All(_) => {}
        }
        for made in &moves[index + 1..] {
            stream.push(*made);
        }
        stream
    }

    /// Whether no way was found from the motion in which it began.
    pub fn is_lost(&self) -> bool {
        match &self.lanes {
            Lanes::ThreeWithJerk(lane) => lane.lost,
            Lanes::AllWithJerk(lane) => lane.lost,
            Lanes::Three(_) | Lanes::All(_) => false,
        }
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

/// The same for how the motion goes on after each node; in the middle between two of them a node is
/// added.
fn cut_pushes(nodes: &mut Vec<Node>, pushes: &mut Vec<Push>, at_mm: f64) -> Vec<Push> {
    let index = nodes.partition_point(|n| n.at_mm < at_mm - SAME_MM);
    if index > 0 && nodes.get(index).is_some_and(|next| next.at_mm > at_mm + SAME_MM) {
        let (node, push) = halve(&nodes[index - 1], &pushes[index - 1], &nodes[index], at_mm);
        nodes.insert(index, node);
        pushes.insert(index, push);
    }
    let rest = pushes.split_off(index);
    let mut made = std::mem::replace(pushes, rest);
    made.extend(pushes.first());
    made
}

impl Lanes {
    fn speeds(&self) -> &dyn Speeds {
        match self {
            Self::Three(lane) => &**lane,
            Self::All(lane) => &**lane,
            Self::ThreeWithJerk(lane) => &**lane,
            Self::AllWithJerk(lane) => &**lane,
        }
    }

    fn speeds_mut(&mut self) -> &mut dyn Speeds {
        match self {
            Self::Three(lane) => &mut **lane,
            Self::All(lane) => &mut **lane,
            Self::ThreeWithJerk(lane) => &mut **lane,
            Self::AllWithJerk(lane) => &mut **lane,
        }
    }

    /// All axes from here on.
    fn widen(&mut self, dynamics: &Dynamics) {
        if let Self::ThreeWithJerk(lane) = self {
            *self = Self::AllWithJerk(Box::new(lane.widen(dynamics)));
        } else if let Self::Three(lane) = self {
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
}

impl<const N: usize> Speeds for Lane<N> {
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
            self.enough = ENOUGH.min(2 * self.enough).max(2 * passes.gates.len());
        }
    }

    fn nodes(&mut self) -> (&mut Vec<Node>, Option<&mut Vec<Push>>) {
        (&mut self.passes.nodes, None)
    }

    fn widths(&self) -> &[f64] {
        &self.choice.widths
    }

    fn needs(&self) -> usize {
        self.walk.needs().min(self.choice.done)
    }

    fn forget(&mut self, vertices: usize) {
        self.smoothing.forget(vertices);
        self.choice.forget(vertices);
        self.walk.forget(vertices);
    }

    fn count_from(&mut self, _: usize) {}
}

impl<const N: usize> Speeds for Horizon<N> {
    fn advance(&mut self, track: &Track, moves: &[Move], ended: bool) {
        Self::advance(self, track, moves, ended);
    }

    fn settle_early(&mut self) {
        Self::settle_early(self);
    }

    fn nodes(&mut self) -> (&mut Vec<Node>, Option<&mut Vec<Push>>) {
        (&mut self.nodes, Some(&mut self.pushes))
    }

    fn widths(&self) -> &[f64] {
        &self.widths
    }

    fn needs(&self) -> usize {
        Self::needs(self)
    }

    fn forget(&mut self, vertices: usize) {
        Self::forget(self, vertices);
    }

    fn count_from(&mut self, moves: usize) {
        Self::count_from(self, moves);
    }
}

/// The same with zeros for the axes that stood still.
pub(crate) fn padded<const N: usize, const M: usize>(v: &[f64; N]) -> [f64; M] {
    std::array::from_fn(|k| v.get(k).copied().unwrap_or(0.0))
}
