//! Exact bounds of a segment.

use super::Segment;
use crate::{Bounds2, Point2, Vec2};

impl Segment {
    /// The smallest upright rectangle around the path.
    pub fn bounds(&self) -> Bounds2 {
        let mut bounds = Bounds2::of(self.start(), self.end());
        if let Self::Arc { start, end, centre, radius, sweep_rad } = *self {
            // Within a quarter of the circle between two poles there is none.
            let (from, to) = (start - centre, end - centre);
            if sweep_rad.abs() < 3.0 && from.x * to.x > 0.0 && from.y * to.y > 0.0 {
                return bounds;
            }
            for (dx, dy) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)] {
                let pole = centre + Vec2::new(dx, dy) * radius;
                if self.faces(pole) {
                    bounds.add(pole);
                }
            }
        }
        bounds
    }

    /// Whether a place, seen from the centre, lies in the direction of the arc. A counter-clockwise
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
