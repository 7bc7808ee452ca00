//! A move as the search sees it: where it goes, and how fast it may be run.

use kerf_program::{AXES, Axes};

/// Axes along which the reference length of a move is measured. Speeds of two moves can be compared only
/// when these are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// The path in XY.
    Xy,
    /// The path in XYZ.
    Space,
    /// One axis: 0 for Z, then A, B and C.
    Axis(u8),
    /// A, B and C together, degrees.
    Rotary,
}

impl Basis {
    /// Returns `true` if an axis counts.
    pub const fn counts(self, axis: usize) -> bool {
        match self {
            Self::Xy => axis < 2,
            Self::Space => axis < 3,
            Self::Axis(own) => axis == own as usize + 2,
            Self::Rotary => axis > 2,
        }
    }

    /// The square of what counts.
    pub fn square(self, all: &[f64]) -> f64 {
        all.iter().enumerate().filter(|(k, _)| self.counts(*k)).map(|(_, v)| v * v).sum()
    }

    /// Returns the number of axes of a path in XY or XYZ; 0 where one axis or the rotary ones count.
    pub const fn axes(self) -> usize {
        match self {
            Self::Xy => 2,
            Self::Space => 3,
            Self::Axis(_) | Self::Rotary => 0,
        }
    }
}

/// Shape of the path of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Straight.
    Line,
    /// A circular arc in XY.
    Arc {
        /// Distance of its start from the centre, mm.
        radius_mm: f64,
        /// Swept angle, radians.
        sweep_rad: f64,
    },
    /// A segment that another model has smoothed: it turns by 45° at most.
    Curve,
}

/// A move as the search sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Start, machine frame.
    pub from: Axes,
    /// End, machine frame.
    pub to: Axes,
    /// Shape of the path between.
    pub shape: Shape,
    /// Axes along which its speeds are meant.
    pub basis: Basis,
    /// Speed asked for, mm/s or degrees/s.
    pub speed_mm_s: f64,
    /// Highest speed: what is asked for, as the operator overrides it.
    pub top_mm_s: f64,
}

impl Leg {
    /// The highest squared speed along the track at which the tool keeps the feed, seen at a slope:
    /// y = F²/Σ q′ₖ² over the axes k that count.
    pub(crate) fn feed_cap<const N: usize>(&self, slope: &[f64; N]) -> f64 {
        let square = self.basis.square(slope);
        if square > 0.0 { self.top_mm_s * self.top_mm_s / square } else { f64::INFINITY }
    }

    /// Returns `true` if an axis of those after the first `dims` moves.
    pub(crate) fn moves_beyond(&self, dims: usize) -> bool {
        (dims..AXES).any(|k| self.from.0[k] != self.to.0[k])
    }
}
