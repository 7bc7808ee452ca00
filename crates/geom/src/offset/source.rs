//! The contours that are offset, and how far places are from them.

use crate::{BoxTree, Point2, Polyarc, Segment};

/// All segments of all contours with an index.
pub(super) struct Source<'a> {
    pub contours: &'a [Polyarc],
    pub segments: Vec<Segment>,
    /// Number of the first segment of each contour.
    pub first: Vec<usize>,
    pub index: BoxTree,
}

impl<'a> Source<'a> {
    pub fn new(contours: &'a [Polyarc]) -> Self {
        let mut first = Vec::with_capacity(contours.len());
        let mut segments = Vec::new();
        for contour in contours {
            first.push(segments.len());
            segments.extend(contour.segments());
        }
        let index = BoxTree::new(segments.iter().map(Segment::bounds));
        Self { contours, segments, first, index }
    }

    /// Whether some segment lies nearer to a place than `limit`.
    pub fn is_nearer(&self, place: Point2, limit: f64) -> bool {
        let square = limit * limit;
        !self.index.search(
            |b| b.distance_squared(place) < square,
            |k| self.segments[k].distance(place) >= limit,
        )
    }
}
