//! Ellipses and parts of them.

use super::curve;
use crate::{Point2, Polyarc, Vec2, tol};
use std::f64::consts::TAU;

/// An ellipse, or the part of it between two parameters: centre + cos t·major + sin t·minor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// The centre.
    pub centre: Point2,
    /// From the centre to where t is 0.
    pub major: Vec2,
    /// From the centre to where t is a quarter turn.
    pub minor: Vec2,
    /// Parameter of the start, radians.
    pub from_rad: f64,
    /// Parameter of the end, radians; less than `from_rad` travels clockwise.
    pub to_rad: f64,
}

impl Ellipse {
    /// Place at a parameter, and which way it goes as the parameter grows.
    pub fn at(&self, t: f64) -> (Point2, Vec2) {
        let (sin, cos) = t.sin_cos();
        let along = self.minor * cos - self.major * sin;
        (self.centre + self.major * cos + self.minor * sin, along)
    }

    /// Arcs at most `tolerance` away; closed when the parameters span a full turn.
    pub fn polyarc(&self, tolerance: f64) -> Polyarc {
        let sweep = self.to_rad - self.from_rad;
        let breaks: Vec<f64> =
            (0..=4u32).map(|n| self.from_rad + sweep * f64::from(n) / 4.0).collect();
        let mut path = curve(&|t| self.at(t), &breaks, tolerance);
        let ends = path.start().zip(path.end());
        let meets = ends.is_some_and(|(start, end)| start.distance(end) <= tol::SAME_PLACE_MM);
        if (sweep.abs() - TAU).abs() < 1e-9 || meets && path.vertices.len() > 2 {
            path.vertices.pop();
            path.closed = true;
        }
        path
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ellipse(to_rad: f64) -> Ellipse {
        let (major, minor) = (Vec2::new(50.0, 0.0), Vec2::new(0.0, 25.0));
        Ellipse { centre: Point2::default(), major, minor, from_rad: 0.0, to_rad }
    }

    #[test]
    fn a_whole_ellipse_is_closed_and_has_its_area() {
        let path = ellipse(TAU).polyarc(0.01);
        assert!(path.closed);
        assert!((path.signed_area() - 3926.99).abs() < 0.5);
        let size = path.bounds().size();
        assert!((size.x - 100.0).abs() < 0.01 && (size.y - 50.0).abs() < 0.01);
        assert!(path.vertices.len() <= 64, "{} vertices", path.vertices.len());
    }

    #[test]
    fn a_part_that_travels_clockwise_is_the_other_one_backwards() {
        for (from_rad, to_rad) in [(0.3, -2.0), (TAU, 0.0), (1.0, 0.9)] {
            let back = Ellipse { from_rad, ..ellipse(to_rad) }.polyarc(0.01);
            let there = Ellipse { from_rad: to_rad, ..ellipse(from_rad) }.polyarc(0.01);
            assert_eq!(back.vertices.len(), there.vertices.len());
            assert!((back.length() - there.length()).abs() < 0.05, "{from_rad} to {to_rad}");
            let meets = |place: Point2| there.segments().any(|s| s.distance(place) < 0.03);
            assert!(back.segments().all(|s| meets(s.at(0.5))), "{from_rad} to {to_rad}");
        }
    }

    #[test]
    fn every_place_lies_within_the_tolerance() {
        for tolerance in [0.1, 0.01, 1e-4] {
            let path = ellipse(TAU).polyarc(tolerance);
            for segment in path.segments() {
                for share in 0..20 {
                    let place = segment.at(f64::from(share) / 20.0);
                    // Distance from the ellipse, to first order.
                    let (x, y) = (place.x / 2500.0, place.y / 625.0);
                    let value = place.x * x + place.y * y - 1.0;
                    assert!(value.abs() / (2.0 * x.hypot(y)) <= tolerance, "{place:?}");
                }
            }
        }
    }

    #[test]
    fn an_ellipse_beyond_all_tables_comes_to_an_end() {
        let (major, minor) = (Vec2::new(1e15, 0.0), Vec2::new(0.0, 1e14));
        let far =
            Ellipse { centre: Point2::new(1e16, 0.0), major, minor, from_rad: 0.0, to_rad: TAU };
        assert!(far.polyarc(1e-3).vertices.len() < 100_000);
    }

    #[test]
    fn a_half_ellipse_is_open() {
        let path = ellipse(TAU / 2.0).polyarc(0.01);
        assert!(!path.closed);
        let end = path.end().unwrap_or_default();
        assert!(end.distance(Point2::new(-50.0, 0.0)) < 1e-9);
        assert_eq!(path.start(), Some(Point2::new(50.0, 0.0)));
    }
}
