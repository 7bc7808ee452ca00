//! Finds widths and speeds along a track: with and without a limit of jerk, for three axes as long as no
//! other moves.

use super::choice::Choice;
use super::horizon::Horizon;
use super::kernel::Kernel;
use super::reach::{Bounds, Gate};
use super::speeds::{Node, Passes};
use super::timed::Push;
use super::track::Track;
use super::walk::{Smoothed, Walk};
use super::ways::Way;
use super::widths::Smoothing;
use crate::moves::Move;
use kerf_program::{AXES, Dynamics};

/// Speeds are looked for when at least so many cells wait for theirs.
const ENOUGH: usize = 1024;

/// Number of cells that are enough at first where the plan is waited for; it doubles from time to time.
const ENOUGH_SOON: usize = 128;

/// With as many axes as move.
#[derive(Clone, Debug)]
pub(crate) enum Lanes {
    Three(Box<Lane<3>>),
    All(Box<Lane<AXES>>),
    ThreeWithJerk(Box<Horizon<3>>),
    AllWithJerk(Box<Horizon<AXES>>),
}

/// Finds widths and speeds along a track.
pub(crate) trait Speeds {
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

/// Widths and speeds of so many axes without a limit of jerk.
#[derive(Clone, Debug)]
pub(crate) struct Lane<const N: usize> {
    bounds: Bounds<N>,
    smoothing: Smoothing<N>,
    choice: Choice,
    walk: Walk<N>,
    passes: Passes<N>,
    /// Speeds are looked for when so many cells wait.
    enough: usize,
}

impl Lanes {
    /// For a stack that begins under these limits, of three axes until another moves.
    pub fn new(dynamics: &Dynamics) -> Self {
        match dynamics.jerk_mm_s3 {
            None => Self::Three(Box::new(Lane::new(Bounds::of(dynamics)))),
            Some(_) => Self::ThreeWithJerk(Box::new(Horizon::new(dynamics))),
        }
    }

    /// The first speeds come out after few cells.
    pub fn hurry(&mut self) {
        match self {
            Self::Three(lane) => lane.enough = ENOUGH_SOON,
            Self::All(lane) => lane.enough = ENOUGH_SOON,
            Self::ThreeWithJerk(_) | Self::AllWithJerk(_) => {}
        }
    }

    /// Begins in motion, with a limit of jerk.
    pub fn begin_at(&mut self, at_mm: f64, ways: Vec<Way>) {
        match self {
            Self::ThreeWithJerk(lane) => lane.begin_at(at_mm, ways),
            Self::AllWithJerk(lane) => lane.begin_at(at_mm, ways),
            Self::Three(_) | Self::All(_) => {}
        }
    }

    /// Returns `true` if no way was found from the motion in which it began.
    pub fn is_lost(&self) -> bool {
        match self {
            Self::ThreeWithJerk(lane) => lane.lost,
            Self::AllWithJerk(lane) => lane.lost,
            Self::Three(_) | Self::All(_) => false,
        }
    }

    pub fn speeds(&self) -> &dyn Speeds {
        match self {
            Self::Three(lane) => &**lane,
            Self::All(lane) => &**lane,
            Self::ThreeWithJerk(lane) => &**lane,
            Self::AllWithJerk(lane) => &**lane,
        }
    }

    pub fn speeds_mut(&mut self) -> &mut dyn Speeds {
        match self {
            Self::Three(lane) => &mut **lane,
            Self::All(lane) => &mut **lane,
            Self::ThreeWithJerk(lane) => &mut **lane,
            Self::AllWithJerk(lane) => &mut **lane,
        }
    }

    /// All axes from here on.
    pub fn widen(&mut self, dynamics: &Dynamics) {
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
        (&mut self.found.nodes, Some(&mut self.found.pushes))
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
