//! Many questions to the same curves, each answered without looking at all of them.

use crate::polyarc::winding_of;
use crate::{Bounds2, BoxTree, Foot, Point2, Polyarc, Segment};

/// Segments with an index over them.
#[derive(Clone, Debug, Default)]
pub struct Indexed {
    segments: Vec<Segment>,
    tree: BoxTree,
}

impl Indexed {
    /// The segments of all contours, numbered through.
    pub fn new<'a>(contours: impl IntoIterator<Item = &'a Polyarc>) -> Self {
        Self::in_lists((Vec::new(), Vec::new()), contours)
    }

    /// The same in empty lists that somebody has at hand.
    pub(crate) fn in_lists<'a>(
        (mut segments, boxes): (Vec<Segment>, Vec<Bounds2>),
        contours: impl IntoIterator<Item = &'a Polyarc>,
    ) -> Self {
        // Contour by contour, as each knows how many it has.
        contours.into_iter().for_each(|contour| segments.extend(contour.segments()));
        let tree = BoxTree::in_list(boxes, segments.iter().map(Segment::bounds));
        Self { segments, tree }
    }

    /// The segments, contour after contour.
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Their boxes.
    pub fn tree(&self) -> &BoxTree {
        &self.tree
    }

    /// The lists, to be used again.
    pub(crate) fn into_lists(self) -> (Vec<Segment>, Vec<Bounds2>) {
        (self.segments, self.tree.into_list())
    }

    /// The nearest segment and its nearest place; nothing when there are no segments.
    pub fn nearest(&self, place: Point2) -> Option<(usize, Foot)> {
        let distance = |k: usize| self.segments[k].distance(place);
        let (number, _) = self.tree.nearest(place, f64::INFINITY, distance)?;
        Some((number, self.segments[number].nearest(place)))
    }

    /// Tells whether some segment lies nearer to a place than `limit`.
    pub fn is_nearer(&self, place: Point2, limit: f64) -> bool {
        let square = limit * limit;
        !self.tree.search(
            |b| b.distance_squared(place) < square,
            |k| !self.segments[k].is_nearer(place, limit),
        )
    }

    /// Counts how often closed contours wind counter-clockwise round a place that is on none of them.
    pub fn winding(&self, place: Point2) -> i32 {
        let mut winding = 0;
        self.tree.search(
            |b| b.min.y <= place.y && place.y <= b.max.y && place.x <= b.max.x,
            |k| {
                winding += winding_of(&self.segments[k], place);
                true
            },
        );
        winding
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_what_the_polyarc_answers() {
        let shape = Polyarc::rounded_rectangle(Point2::new(0., 0.), Point2::new(9., 5.), 2.0);
        let indexed = Indexed::new([&shape]);
        for k in 0..200 {
            let place = Point2::new(f64::from(k % 20) * 0.71 - 2.0, f64::from(k / 20) * 0.83 - 1.5);
            assert_eq!(indexed.winding(place), shape.winding(place), "{place:?}");
            let far = shape.nearest(place).map_or(f64::MAX, |n| n.1);
            let found = indexed.nearest(place).map_or(0.0, |n| n.1.distance);
            assert!((found - far).abs() < 1e-12);
            assert!(indexed.is_nearer(place, far + 1e-9) && !indexed.is_nearer(place, far - 1e-9));
        }
    }
}
