//! Finds widths and speeds along a track: with and without a limit of jerk, for three axes as long as no
//! other moves.

use crate::bounds::Bounds;
use crate::choice::Choice;
use crate::gate::Gate;
use crate::horizon::Horizon;
use crate::kernel::Kernel;
use crate::leg::Leg;
use crate::node::{Node, Push};
use crate::passes::Passes;
use crate::speed_piece::SpeedPiece;
use crate::track::Track;
use crate::walk::{Smoothed, Walk};
use crate::widths::Smoothing;
use kerf_program::{AXES, Dynamics};

/// Speeds are looked for when at least so many cells wait for theirs.
const ENOUGH: usize = 1024;

/// Number of cells that are enough at first where the plan is waited for; it doubles from time to time.
const ENOUGH_SOON: usize = 128;

/// With as many axes as move.
#[derive(Clone, Debug)]
pub(crate) enum Variant {
    Three(Box<ByAccel<3>>),
    All(Box<ByAccel<AXES>>),
    ThreeWithJerk(Box<Horizon<3>>),
    AllWithJerk(Box<Horizon<AXES>>),
}

/// Finds widths and speeds along a track.
pub(crate) trait Speeds {
    fn advance(&mut self, track: &Track, legs: &[Leg], ended: bool);

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
    fn count_from(&mut self, legs: usize);
}

/// Widths and speeds of so many axes without a limit of jerk.
#[derive(Clone, Debug)]
pub(crate) struct ByAccel<const N: usize> {
    bounds: Bounds<N>,
    smoothing: Smoothing<N>,
    choice: Choice,
    walk: Walk<N>,
    passes: Passes<N>,
    /// Speeds are looked for when so many cells wait.
    enough: usize,
}

impl Variant {
    /// For a stack that begins under these limits, of three axes until another moves.
    pub fn new(dynamics: &Dynamics) -> Self {
        match dynamics.jerk_mm_s3 {
            None => Self::Three(Box::new(ByAccel::new(Bounds::of(dynamics)))),
            Some(_) => Self::ThreeWithJerk(Box::new(Horizon::new(dynamics))),
        }
    }

    /// The first speeds come out after few cells.
    pub fn hurry(&mut self) {
        match self {
            Self::Three(search) => search.enough = ENOUGH_SOON,
            Self::All(search) => search.enough = ENOUGH_SOON,
            Self::ThreeWithJerk(_) | Self::AllWithJerk(_) => {}
        }
    }

    /// Begins in motion, with a limit of jerk.
    pub fn begin_at(&mut self, at_mm: f64, ways: Vec<SpeedPiece>) {
        match self {
            Self::ThreeWithJerk(search) => search.begin_at(at_mm, ways),
            Self::AllWithJerk(search) => search.begin_at(at_mm, ways),
            Self::Three(_) | Self::All(_) => {}
        }
    }

    /// Returns `true` if no way was found from the motion in which it began.
    pub fn is_lost(&self) -> bool {
        match self {
            Self::ThreeWithJerk(search) => search.lost,
            Self::AllWithJerk(search) => search.lost,
            Self::Three(_) | Self::All(_) => false,
        }
    }

    pub fn speeds(&self) -> &dyn Speeds {
        match self {
            Self::Three(search) => &**search,
            Self::All(search) => &**search,
            Self::ThreeWithJerk(search) => &**search,
            Self::AllWithJerk(search) => &**search,
        }
    }

    pub fn speeds_mut(&mut self) -> &mut dyn Speeds {
        match self {
            Self::Three(search) => &mut **search,
            Self::All(search) => &mut **search,
            Self::ThreeWithJerk(search) => &mut **search,
            Self::AllWithJerk(search) => &mut **search,
        }
    }

    /// All axes from here on.
    pub fn widen(&mut self, dynamics: &Dynamics) {
        if let Self::ThreeWithJerk(search) = self {
            *self = Self::AllWithJerk(Box::new(search.widen(dynamics)));
        } else if let Self::Three(search) = self {
            *self = Self::All(Box::new(ByAccel {
                bounds: Bounds::of(dynamics),
                smoothing: search.smoothing.widen(),
                choice: std::mem::take(&mut search.choice),
                walk: search.walk.widen(),
                passes: search.passes.widen(Bounds::of(dynamics)),
                enough: search.enough,
            }));
        }
    }
}

impl<const N: usize> ByAccel<N> {
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

impl<const N: usize> Speeds for ByAccel<N> {
    fn advance(&mut self, track: &Track, legs: &[Leg], ended: bool) {
        let Self { bounds, smoothing, choice, walk, passes, .. } = self;
        let wide = smoothing.advance(track, legs, ended);
        choice.advance(smoothing, track, legs, bounds, wide, ended);
        let widths = &choice.widths[..choice.done];
        let path = Smoothed { track, smoothing, widths, legs };
        while let Some((cell, stands)) = walk.next(&path) {
            let mut gate = Gate::new(&cell, bounds, legs);
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
    fn advance(&mut self, track: &Track, legs: &[Leg], ended: bool) {
        Self::advance(self, track, legs, ended);
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

    fn count_from(&mut self, legs: usize) {
        Self::count_from(self, legs);
    }
}
