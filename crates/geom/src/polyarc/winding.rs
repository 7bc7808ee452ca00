//! Number of times that a segment goes round a place.

use crate::{Point2, Segment, Vec2};

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
