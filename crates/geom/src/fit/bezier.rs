//! Bézier curves.

use super::curve;
use crate::{Point2, Polyarc, Vec2};

/// A cubic Bézier curve. [`Bezier::quadratic`] makes one of a curve with one control point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bezier {
    /// Start, two control points, end.
    pub points: [Point2; 4],
}

impl Bezier {
    /// The cubic curve that is a quadratic one.
    pub fn quadratic(start: Point2, control: Point2, end: Point2) -> Self {
        let toward = |p: Point2| p + (control - p) * (2.0 / 3.0);
        Self { points: [start, toward(start), toward(end), end] }
    }

    /// Place and direction of travel at a parameter of 0 … 1.
    pub fn at(&self, t: f64) -> (Point2, Vec2) {
        let [a, b, c, d] = self.points;
        let s = 1.0 - t;
        let way = (b - a) * (3.0 * s * s * t) + (c - a) * (3.0 * s * t * t) + (d - a) * (t * t * t);
        let along = (b - a) * (3.0 * s * s) + (c - b) * (6.0 * s * t) + (d - c) * (3.0 * t * t);
        (a + way, along)
    }

    /// Arcs at most `tolerance` away, open.
    pub fn polyarc(&self, tolerance: f64) -> Polyarc {
        // Two parts at least, so that no symmetry hides what lies between the ends.
        curve(&|t| self.at(t), &[0.0, 0.5, 1.0], tolerance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_with_cusps_and_loops_are_followed() {
        for [x1, y1, x2, y2] in [
            [0., 10., 10., 10.],
            [30., 20., -20., 20.],
            [10., 10., 0., 10.],
            [0., 0., 10., 10.],
            [5., 0., 7., 0.],
        ] {
            let points = [(0., 0.), (x1, y1), (x2, y2), (10., 0.)].map(|(x, y)| Point2::new(x, y));
            let b = Bezier { points };
            let path = b.polyarc(1e-3);
            let far = |t: i32| path.nearest(b.at(f64::from(t) / 797.0).0).map_or(f64::MAX, |n| n.1);
            assert!((0..=797).all(|t| far(t) <= 1e-3), "{points:?}");
            assert!(path.vertices.len() < 100, "{}", path.vertices.len());
        }
    }

    #[test]
    fn numbers_that_are_none_come_to_an_end() {
        let far = Point2::new(f64::NAN, 0.0);
        let path = Bezier { points: [far; 4] }.polyarc(1e-3);
        assert!(path.vertices.len() < 4);
    }
}
