//! Rational B-splines, the curves of drawing programs.

use super::curve;
use crate::{Point2, Polyarc, Vec2, tol};
use thiserror::Error;

/// The highest degree taken: drawing programs write 3, some up to 5.
const MOST_DEGREE: usize = 11;

/// Reason why a spline is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum NurbsError {
    /// No degree a curve has.
    #[error("a spline of degree {0}: 1 to 11 are known")]
    Degree(usize),
    /// Too few control points.
    #[error("a spline of degree {degree} with {points} control points: {} are needed", degree + 1)]
    Points {
        /// The degree.
        degree: usize,
        /// The points.
        points: usize,
    },
    /// Knots that do not fit the points.
    #[error("{knots} knots for {points} control points of degree {degree}: {} are needed", points + degree + 1)]
    Knots {
        /// The knots.
        knots: usize,
        /// The points.
        points: usize,
        /// The degree.
        degree: usize,
    },
    /// Knots that go back.
    #[error("knot {0} is less than the one before")]
    Backwards(usize),
    /// A weight that is not above zero.
    #[error("the weight of control point {0} is not above 0")]
    Weight(usize),
}

/// A rational B-spline in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Nurbs {
    degree: usize,
    knots: Vec<f64>,
    /// x·w, y·w, w of each control point.
    points: Vec<[f64; 3]>,
}

impl Nurbs {
    /// A spline from degree, knots, control points and their weights; no weights are all 1.
    ///
    /// # Errors
    /// What does not fit together.
    pub fn new(
        degree: usize,
        knots: Vec<f64>,
        points: &[Point2],
        weights: &[f64],
    ) -> Result<Self, NurbsError> {
        if !(1..=MOST_DEGREE).contains(&degree) {
            return Err(NurbsError::Degree(degree));
        }
        if points.len() <= degree {
            return Err(NurbsError::Points { degree, points: points.len() });
        }
        if knots.len() != points.len() + degree + 1 {
            let (knots, points) = (knots.len(), points.len());
            return Err(NurbsError::Knots { knots, points, degree });
        }
        let backwards = knots.windows(2).position(|pair| pair[0] > pair[1] || pair[0].is_nan());
        if let Some(n) = backwards {
            return Err(NurbsError::Backwards(n + 2));
        }
        let weight = |n: usize| weights.get(n).copied().unwrap_or(1.0);
        if let Some(n) = (0..points.len()).find(|n| weight(*n).is_nan() || weight(*n) <= 0.0) {
            return Err(NurbsError::Weight(n + 1));
        }
        let weighted = |(n, p): (usize, &Point2)| [p.x * weight(n), p.y * weight(n), weight(n)];
        let points = points.iter().enumerate().map(weighted).collect();
        Ok(Self { degree, knots, points })
    }

    /// The parameters between which the curve is smooth, from its start to its end.
    pub fn breaks(&self) -> Vec<f64> {
        let mut breaks = self.knots[self.degree..=self.points.len()].to_vec();
        breaks.dedup();
        breaks
    }

    /// Place and direction of travel at a parameter.
    pub fn at(&self, t: f64) -> (Point2, Vec2) {
        let span = self.span(t);
        let (place, slope) = self.de_boor(span, t);
        let [x, y, w] = place;
        let at = Point2::new(x / w, y / w);
        // (p/w)' = (p' − (p/w)·w') / w; the length does not matter, so that w > 0 may be left out.
        (at, Vec2::new(slope[0] - at.x * slope[2], slope[1] - at.y * slope[2]))
    }

    /// Number of the knot at or before a parameter, such that the next knot is larger.
    fn span(&self, t: f64) -> usize {
        let inner = &self.knots[self.degree..=self.points.len()];
        let after = inner.partition_point(|knot| *knot <= t).max(1);
        let mut span = self.degree + after - 1;
        while span > self.degree
            && (span >= self.points.len() || self.knots[span] >= self.knots[span + 1])
        {
            span -= 1;
        }
        span
    }

    /// De Boor's triangle in homogeneous coordinates: the last step gives the place, the difference
    /// of its two points the slope.
    fn de_boor(&self, span: usize, t: f64) -> ([f64; 3], [f64; 3]) {
        let p = self.degree;
        let mut d = [[0.0; 3]; MOST_DEGREE + 1];
        d[..=p].copy_from_slice(&self.points[span - p..=span]);
        let mut slope = [0.0; 3];
        for round in 1..=p {
            for j in (round..=p).rev() {
                let low = self.knots[j + span - p];
                let high = self.knots[j + 1 + span - round];
                let share = if high > low { (t - low) / (high - low) } else { 0.0 };
                if round == p {
                    slope = std::array::from_fn(|n| d[j][n] - d[j - 1][n]);
                }
                d[j] = std::array::from_fn(|n| d[j - 1][n] + share * (d[j][n] - d[j - 1][n]));
            }
        }
        (d[p], slope)
    }

    /// Arcs at most `tolerance` away; closed when the end is the start.
    pub fn polyarc(&self, tolerance: f64) -> Polyarc {
        let mut path = curve(&|t| self.at(t), &self.breaks(), tolerance);
        let ends = path.start().zip(path.end());
        let meets = ends.is_some_and(|(start, end)| start.distance(end) <= tol::SAME_PLACE_MM);
        if meets && path.vertices.len() > 2 {
            path.vertices.pop();
            path.closed = true;
        }
        path
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    /// A full circle of radius 10 as nine weighted points.
    fn circle() -> Nurbs {
        let r = 10.0;
        let corners = [
            (r, 0.0),
            (r, r),
            (0.0, r),
            (-r, r),
            (-r, 0.0),
            (-r, -r),
            (0.0, -r),
            (r, -r),
            (r, 0.0),
        ];
        let points: Vec<_> = corners.into_iter().map(|(x, y)| p(x, y)).collect();
        let w = std::f64::consts::FRAC_1_SQRT_2;
        let weights = [1.0, w, 1.0, w, 1.0, w, 1.0, w, 1.0];
        let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0];
        Nurbs::new(2, knots, &points, &weights).unwrap()
    }

    #[test]
    fn a_rational_circle_is_a_circle() {
        let circle = circle();
        for n in 0..=40 {
            let (at, along) = circle.at(f64::from(n) / 10.0);
            let out = at - Point2::default();
            assert!((out.length() - 10.0).abs() < 1e-12);
            assert!(out.cross(along) > 0.0 && out.dot(along).abs() < 1e-9 * along.length());
        }
        let path = circle.polyarc(1e-3);
        assert!(path.closed && path.vertices.len() == 8, "{path:?}");
        assert!((path.signed_area() - 314.159_265).abs() < 1e-3);
    }

    #[test]
    fn a_bezier_curve_begins_and_ends_at_its_points() {
        let points = [p(0.0, 0.0), p(0.0, 10.0), p(20.0, 10.0), p(20.0, 0.0)];
        let knots = vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
        let bezier = Nurbs::new(3, knots, &points, &[]).unwrap();
        let (middle, along) = bezier.at(0.5);
        assert!(middle.distance(p(10.0, 7.5)) < 1e-12 && along.y.abs() < 1e-12 && along.x > 0.0);
        let path = bezier.polyarc(1e-3);
        assert_eq!((path.start(), path.end()), (Some(points[0]), Some(points[3])));
        let near = |n: i32| path.nearest(bezier.at(f64::from(n) / 97.0).0).unwrap().1;
        assert!((0..=97).all(|n| near(n) <= 1e-3));
    }

    #[test]
    fn a_corner_in_a_spline_stays_a_corner() {
        let points = [p(0.0, 0.0), p(10.0, 0.0), p(10.0, 10.0)];
        let path =
            Nurbs::new(1, vec![0.0, 0.0, 1.0, 2.0, 2.0], &points, &[]).unwrap().polyarc(1e-3);
        let places: Vec<_> = path.vertices.iter().map(|v| v.at).collect();
        assert!(places.contains(&points[1]), "{places:?}");
        assert!((path.length() - 20.0).abs() < 1e-12);
    }

    #[test]
    fn splines_that_are_none_are_refused() {
        let points = [p(0.0, 0.0), p(1.0, 0.0)];
        let refused = |degree, knots: &[f64], weights: &[f64]| {
            Nurbs::new(degree, knots.to_vec(), &points, weights).unwrap_err().to_string()
        };
        assert_eq!(refused(0, &[], &[]), "a spline of degree 0: 1 to 11 are known");
        let told = "a spline of degree 3 with 2 control points: 4 are needed";
        assert_eq!(refused(3, &[0.0; 6], &[]), told);
        let told = "3 knots for 2 control points of degree 1: 4 are needed";
        assert_eq!(refused(1, &[0.0; 3], &[]), told);
        assert_eq!(refused(1, &[0.0, 1.0, 0.5, 1.0], &[]), "knot 3 is less than the one before");
        let told = "the weight of control point 2 is not above 0";
        assert_eq!(refused(1, &[0.0, 0.0, 1.0, 1.0], &[1.0, 0.0]), told);
    }
}
