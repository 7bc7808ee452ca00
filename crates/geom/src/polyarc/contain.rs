//! Inside, outside or on the edge.

use super::Polyarc;
use crate::{Point2, Segment, Vec2, tol};

/// Position of a place relative to a closed contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Position {
    /// The contour winds round it.
    Inside,
    /// The contour does not wind round it.
    Outside,
    /// It is on the contour, within [`tol::SAME_PLACE_MM`].
    OnEdge,
}

impl Polyarc {
    /// Counts how often the contour winds counter-clockwise round a place that is not on it. An open
    /// polyarc is closed by a straight line.
    ///
    /// Counts crossings of the ray from the place to the right: up +1, down −1. Each segment is cut
    /// where it turns from up to down, and counts its lower end but not its upper one, so that a
    /// vertex on the ray is counted once.
    pub fn winding(&self, place: Point2) -> i32 {
        let closing = match (self.closed, self.start(), self.vertices.last()) {
            (false, Some(start), Some(last)) => winding_of(&Segment::line(last.at, start), place),
            _ => 0,
        };
        self.segments().map(|s| winding_of(&s, place)).sum::<i32>() + closing
    }

    /// Returns the position of a place: inside if the contour winds round it, in either direction. For a contour that
    /// crosses itself, loops count as inside however they are turned.
    pub fn position(&self, place: Point2) -> Position {
        if self.segments().any(|s| s.distance(place) <= tol::SAME_PLACE_MM) {
            Position::OnEdge
        } else if self.winding(place) != 0 {
            Position::Inside
        } else {
            Position::Outside
        }
    }

    /// Tells whether another polyarc lies inside this closed one. The two may touch; they must not cross
    /// ([`Polyarc::crossings`] tells), as the contours of a part and its holes do not.
    pub fn contains(&self, other: &Self) -> bool {
        if !self.bounds().grown(tol::SAME_PLACE_MM).holds_box(&other.bounds()) {
            return false;
        }
        let middles = other.segments().map(|s| s.at(0.5));
        let places = middles.chain(other.vertices.iter().map(|v| v.at));
        let decided = places.map(|p| self.position(p)).find(|&p| p != Position::OnEdge);
        // Wholly on the edge: one is the other, or a part of it.
        decided.is_none_or(|p| p == Position::Inside)
    }
}

/// Returns what a segment adds to the winding number of a place: its chord's share, and one turn more when the
/// place lies in the cap between chord and arc.
pub(crate) fn winding_of(segment: &Segment, place: Point2) -> i32 {
    let (start, end) = (segment.start(), segment.end());
    let chord = end - start;
    // Both questions below are decided by this one number, so that they cannot disagree.
    let side = chord.cross(place - start);
    let of_chord = match (start.y <= place.y, end.y <= place.y) {
        (true, false) => i32::from(side > 0.0),
        (false, true) => -i32::from(side < 0.0),
        _ => 0,
    };
    of_chord + in_cap(segment, chord, side, place)
}

/// 1 in the cap of a counter-clockwise arc, −1 in that of a clockwise one, else 0. A place on the chord
/// counts as the chord counts it: as a little to the right (+X), and on a level chord as a little above.
fn in_cap(segment: &Segment, chord: Vec2, side: f64, place: Point2) -> i32 {
    let Segment::Arc { centre, radius, sweep_rad, .. } = *segment else { return 0 };
    let from_centre = place - centre;
    if from_centre.dot(from_centre) >= radius * radius {
        return 0;
    }
    let right = match side {
        s if s != 0.0 => s < 0.0,
        _ => chord.y > 0.0 || (chord.y == 0.0 && chord.x < 0.0),
    };
    match (sweep_rad > 0.0, right) {
        (true, true) => 1,
        (false, false) => -1,
        _ => 0,
    }
}
