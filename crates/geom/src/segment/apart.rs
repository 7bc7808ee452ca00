//! Distance between two segments.

use super::Segment;
use crate::Point2;

impl Segment {
    /// The least distance of any two places of the paths; 0 when they meet.
    ///
    /// ```
    /// use kerf_geom::{Point2, Segment};
    /// let line = |y| Segment::line(Point2::new(0.0, y), Point2::new(9.0, y));
    /// assert_eq!(line(0.0).distance_to(&line(2.0)), 2.0);
    /// ```
    pub fn distance_to(&self, other: &Self) -> f64 {
        if !self.meet(other).is_empty() {
            return 0.0;
        }
        // What does not meet is nearest at an end of one, or where a common perpendicular stands:
        // on an arc that is the line from its centre.
        let ends = [(self, other), (other, self)].into_iter().flat_map(|(a, b)| {
            [a.start(), a.end()].map(|end| b.distance(end)).into_iter().chain(a.perpendiculars(b))
        });
        ends.fold(f64::INFINITY, f64::min)
    }

    /// Distances of another segment from the places of an arc on the line from its centre to that of
    /// the other, or at right angles to it.
    fn perpendiculars(&self, other: &Self) -> impl Iterator<Item = f64> {
        let places = match (*self, *other) {
            (Self::Line { .. }, _) => None,
            (Self::Arc { centre, radius, .. }, Self::Arc { centre: towards, .. }) => {
                Some((centre, radius, towards))
            }
            (Self::Arc { centre, radius, .. }, Self::Line { .. }) => {
                Some((centre, radius, other.nearest(centre).at))
            }
        };
        let sides =
            places.into_iter().flat_map(|(centre, radius, towards): (Point2, f64, Point2)| {
                let way = towards - centre;
                let long = way.length();
                let arm = if long > 0.0 { way * (radius / long) } else { way };
                [centre + arm, centre + arm * -1.0]
            });
        let (this, other) = (*self, *other);
        sides.filter(move |place| this.faces(*place)).map(move |place| other.distance(place))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    fn arc(centre: Point2, radius: f64, from: f64, sweep: f64) -> Segment {
        let at = |rad: f64| centre + crate::Vec2::new(rad.cos(), rad.sin()) * radius;
        Segment::bulged(at(from), at(from + sweep), (0.25 * sweep).tan())
    }

    #[test]
    fn as_near_as_many_places_of_both() {
        let all = [
            Segment::line(p(0., 0.), p(10., 0.)),
            Segment::line(p(3., 2.), p(12., 9.)),
            Segment::line(p(-4., 1.), p(-4., 30.)),
            arc(p(5., 12.), 4.0, 0.3, 2.5),
            arc(p(5., 12.), 4.0, 3.5, 2.5),
            arc(p(20., 3.), 6.0, -0.4, 2.0 * PI - 1.0),
            arc(p(20., 3.), 2.0, 1.0, -3.0),
            arc(p(5., 12.), 9.0, 2.0, 1.0),
        ];
        for (n, a) in all.iter().enumerate() {
            for b in &all[n..] {
                let sampled = (0..=2000)
                    .map(|k| b.distance(a.at(f64::from(k) / 2000.0)))
                    .fold(f64::INFINITY, f64::min);
                let found = a.distance_to(b);
                assert!(
                    found <= sampled + 1e-9 && sampled - found < 1e-2,
                    "{a:?} {b:?} {found} {sampled}"
                );
                assert!((found - b.distance_to(a)).abs() < 1e-12);
            }
        }
    }
}
