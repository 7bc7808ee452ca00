//! The place of a segment nearest to another place.

use super::Segment;
use crate::Point2;

/// The place of a curve nearest to a given one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// The nearest place.
    pub at: Point2,
    /// Share of the segment's path, 0 … 1.
    pub share: f64,
    /// How far away it is.
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
            Self::Line { start, end } => {
                let along = end - start;
                let to = place - start;
                let square = along.dot(along);
                let reach = to.dot(along);
                if reach <= 0.0 {
                    to.length()
                } else if reach >= square {
                    (place - end).length()
                } else {
                    along.cross(to).abs() / square.sqrt()
                }
            }
            Self::Arc { start, end, centre, radius, .. } => {
                if self.faces(place) {
                    (place.distance(centre) - radius).abs()
                } else {
                    place.distance(start).min(place.distance(end))
                }
            }
        }
    }
}
