//! Paths that offsets are made of, and where each of their segments comes from.

use crate::Polyarc;
use std::fmt;

/// Tolerance of a result's distance from its source. A hundredth of the 1e-4 mm that is promised, a thousand times
/// what rounding accounts for.
pub const CHECK_MM: f64 = 1e-6;

/// Element of the source to which a segment of an offset is parallel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Number of the contour.
    pub contour: usize,
    /// Number of the segment, or of the vertex when it is a corner.
    pub element: usize,
    /// An arc about a vertex instead of a parallel of a segment.
    pub corner: bool,
}

/// An offset curve and where each of its segments comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct OffsetPath {
    /// The curve.
    pub path: Polyarc,
    /// For each segment of the path what it is parallel to.
    pub origins: Vec<Origin>,
    /// Tolerance of the path's distance from its source: [`CHECK_MM`], unless it had to be made of chords; then a
    /// person should be told.
    pub within_mm: f64,
}

/// An offset that could not be made exactly; its message tells a person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coarse {
    /// Greatest error, mm.
    pub within_mm: f64,
}

impl Coarse {
    /// Sums up some paths; nothing when all are as exact as usual.
    pub fn of(paths: &[OffsetPath]) -> Option<Self> {
        let within_mm = paths.iter().map(|path| path.within_mm).fold(0.0, f64::max);
        (within_mm > CHECK_MM).then_some(Self { within_mm })
    }
}

impl fmt::Display for Coarse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "its offset could not be made exactly: it may be off by {} mm", self.within_mm)
    }
}

/// Function that proposes an offset of contours by a distance, or nothing. The contours lie about the origin, have no
/// segment without length and no arc of more than half a circle.
pub type Proposer<'a> = dyn Fn(&[Polyarc], f64) -> Option<Vec<OffsetPath>> + 'a;
