//! Exact bounds of a segment.

use super::Segment;
use crate::{Bounds2, Point2};

impl Segment {
    /// The smallest upright rectangle around the path.
    pub fn bounds(&self) -> Bounds2 {
        let mut bounds = Bounds2::of(self.start(), self.end());
        let Self::Arc { start, end, centre, radius, sweep_rad } = *self else { return bounds };
        // The poles that a counter-clockwise arc passes, by the quarters in which it begins and ends.
        let (from, to) = (start - centre, end - centre);
        let (from, to) = if sweep_rad > 0.0 { (from, to) } else { (to, from) };
        let small = sweep_rad.abs() <= std::f64::consts::PI;
        let passes =
            |after: bool, before: bool| if small { after && before } else { after || before };
        if passes(from.y <= 0.0, to.y >= 0.0) {
            bounds.max.x = bounds.max.x.max(centre.x + radius);
        }
        if passes(from.y >= 0.0, to.y <= 0.0) {
            bounds.min.x = bounds.min.x.min(centre.x - radius);
        }
        if passes(from.x >= 0.0, to.x <= 0.0) {
            bounds.max.y = bounds.max.y.max(centre.y + radius);
        }
        if passes(from.x <= 0.0, to.x >= 0.0) {
            bounds.min.y = bounds.min.y.min(centre.y - radius);
        }
        bounds
    }

    /// Tells whether a place, seen from the centre, lies in the direction of the arc. A counter-clockwise
    /// arc is the part of its circle right of its chord, whatever its sweep below a turn.
    pub(crate) fn faces(&self, place: Point2) -> bool {
        match *self {
            Self::Line { .. } => true,
            Self::Arc { start, end, centre, sweep_rad, .. } => {
                let (from, to, ray) = (start - centre, end - centre, place - centre);
                let (after_start, before_end) = if sweep_rad > 0.0 {
                    (from.cross(ray) >= 0.0, ray.cross(to) >= 0.0)
                } else {
                    (from.cross(ray) <= 0.0, ray.cross(to) <= 0.0)
                };
                if sweep_rad.abs() <= std::f64::consts::PI {
                    after_start && before_end
                } else {
                    after_start || before_end
                }
            }
        }
    }
}
