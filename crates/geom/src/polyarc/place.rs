//! A place on a polyarc.

use crate::Point2;

/// A place on a polyarc.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PolyarcPlace {
    /// Number of the segment.
    pub segment: usize,
    /// Share of the segment's path, 0 … 1.
    pub share: f64,
    /// Coordinates of the place.
    pub at: Point2,
}
