//! The place of a segment nearest to another place.

use super::Segment;
use crate::{Point2, Vec2};

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
}

/// The length squared: `hypot` guards against overflow that checked coordinates cannot cause, and is
/// ten times as slow.
pub(crate) fn square(v: Vec2) -> f64 {
    v.dot(v)
}
