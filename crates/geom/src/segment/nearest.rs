//! The bounds of a segment, and how far it is from places and from other segments.

use super::Segment;
use crate::{Bounds2, Point2, Vec2};

/// The place of a curve nearest to a given one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// The nearest place.
    pub at: Point2,
    /// Share of the segment's path, 0 … 1.
    pub share: f64,
    /// Distance from the given place.
    pub distance: f64,
}

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

    /// The nearest place of the path. From the centre of an arc all are equally near: its start.
    pub fn nearest(&self, place: Point2) -> Foot {
        let share = match *self {
            Self::Line { .. } => self.share_of(place).clamp(0.0, 1.0),
            Self::Arc { centre, .. } if self.faces(place) && place != centre => {
                self.share_of(place).clamp(0.0, 1.0)
            }
            Self::Arc { start, end, .. } => {
                f64::from(u8::from(place.distance(end) < place.distance(start)))
            }
        };
        let at = self.at(share);
        Foot { at, share, distance: at.distance(place) }
    }

    /// Distance from a place, without finding where.
    pub fn distance(&self, place: Point2) -> f64 {
        match *self {
            Self::Line { .. } => self.line_distance_squared(place).sqrt(),
            Self::Arc { start, end, centre, radius, .. } => {
                if self.faces(place) {
                    (square(place - centre).sqrt() - radius).abs()
                } else {
                    square(place - start).min(square(place - end)).sqrt()
                }
            }
        }
    }

    /// Tells whether some place of the path lies nearer to a place than `limit`.
    pub(crate) fn is_nearer(&self, place: Point2, limit: f64) -> bool {
        match self {
            Self::Line { .. } => self.line_distance_squared(place) < limit * limit,
            Self::Arc { .. } => self.distance(place) < limit,
        }
    }

    fn line_distance_squared(&self, place: Point2) -> f64 {
        let (along, to) = (self.end() - self.start(), place - self.start());
        let (long, reach) = (square(along), to.dot(along));
        if reach <= 0.0 {
            square(to)
        } else if reach >= long {
            square(place - self.end())
        } else {
            let cross = along.cross(to);
            cross * cross / long
        }
    }

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

/// The length squared: `hypot` guards against overflow that checked coordinates cannot cause, and is
/// ten times as slow.
pub(crate) fn square(v: Vec2) -> f64 {
    v.dot(v)
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
