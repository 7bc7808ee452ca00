//! Each segment of a result lies at its distance from what it says it is parallel to, on its side.

use super::path::Origin;
use super::wanted::{Checked, Wanted, unproved};
use crate::segment::square;
use crate::{Point2, Segment, Vec2};

/// At the distance from what the segment says it is parallel to, on the right side, in its direction.
pub(super) fn follows_origin(wanted: &Wanted, segment: &Segment, origin: &Origin) -> Checked {
    let Wanted { source, distance, within } = *wanted;
    let number = source.first[origin.contour] + origin.element;
    let of = &source.segments()[number];
    let seen = match (segment, of) {
        (Segment::Line { .. }, Segment::Line { .. }) if !origin.corner => {
            goes_beside(wanted, segment, of, source.ways()[number].leaves)
        }
        (Segment::Arc { .. }, _) => turns_about(wanted, segment, of, origin.corner),
        _ => false,
    };
    if seen {
        return Ok(());
    }
    let middle = segment.middle();
    // What holds at both ends of a line beside a line holds between them.
    let lines = matches!((segment, of), (Segment::Line { .. }, Segment::Line { .. }));
    let places = [segment.start(), segment.end(), middle];
    for at in places.into_iter().take(if lines && !origin.corner { 2 } else { 3 }) {
        if !at.x.is_finite() || !at.y.is_finite() {
            return unproved("a place that is no number", at);
        }
        let off = if origin.corner {
            square(at - of.start()).sqrt() - distance.abs()
        } else {
            right_of(of, at, within) - distance
        };
        if off.abs().is_nan() || off.abs() > within {
            return unproved("not at its distance", at);
        }
    }
    // Lines are at their distance between their ends as well, arcs when they turn about the same centre:
    // that is what the middle shows. It remains that travel goes the way of the source. In the middle of
    // an arc it is that of its chord.
    let along = segment.end() - segment.start();
    let forward = if origin.corner {
        (middle - of.start()).cross(along) * distance > 0.0
    } else {
        let (onward, way) = (beside(of, middle), along);
        let reach = onward.dot(way);
        reach > 0.0 && reach * reach > 0.81 * square(onward) * square(way)
    };
    let short = || square(along) <= (100.0 * within).powi(2);
    if forward || short() { Ok(()) } else { unproved("on the wrong side", middle) }
}

/// Returns `true` if a line certainly goes beside another one: both its ends do, and it goes the same way.
fn goes_beside(wanted: &Wanted, segment: &Segment, of: &Segment, way: Vec2) -> bool {
    let Wanted { distance, within, .. } = *wanted;
    let long = (of.end() - of.start()).dot(way);
    let beside = |at: Point2| {
        let to = at - of.start();
        let (reach, off) = (to.dot(way), to.cross(way) - distance);
        reach >= -within && reach <= long + within && off.abs() <= within
    };
    let along = segment.end() - segment.start();
    let reach = along.dot(way);
    let forward = reach > 0.0 && reach * reach > 0.81 * square(along);
    forward && beside(segment.start()) && beside(segment.end())
}

/// Returns `true` if an arc certainly turns about a corner, or beside an arc: its centre and radius are those that
/// it should have, it turns the same way, and it faces the other one.
fn turns_about(wanted: &Wanted, segment: &Segment, of: &Segment, corner: bool) -> bool {
    let Wanted { distance, within, .. } = *wanted;
    let Segment::Arc { start, end, centre, radius, sweep_rad } = *segment else { return false };
    let (about, wide, way) = match *of {
        _ if corner => (of.start(), distance.abs(), distance),
        Segment::Arc { centre, radius, sweep_rad, .. } => {
            (centre, radius + distance * sweep_rad.signum(), sweep_rad)
        }
        Segment::Line { .. } => return false,
    };
    let apart = centre - about;
    let off = apart.x.abs() + apart.y.abs() + (radius - wide).abs();
    let faces = || [start, segment.middle(), end].into_iter().all(|at| of.faces(at));
    off <= 0.5 * within && sweep_rad * way > 0.0 && (corner || faces())
}

/// The way along a segment where a place lies beside it, of any length.
fn beside(of: &Segment, place: Point2) -> Vec2 {
    match *of {
        Segment::Line { start, end } => end - start,
        Segment::Arc { centre, sweep_rad, .. } => (place - centre).left() * sweep_rad.signum(),
    }
}

/// Returns how far a place lies to the right of a segment's line or circle, if its foot lies on the segment; else
/// not a number, which is no distance at all.
fn right_of(of: &Segment, place: Point2, within: f64) -> f64 {
    match *of {
        Segment::Line { start, end } => {
            let (along, to) = (end - start, place - start);
            let long = square(along).sqrt();
            let reach = to.dot(along) / long;
            let beside = reach >= -within && reach <= long + within;
            if beside { to.cross(along) / long } else { f64::NAN }
        }
        Segment::Arc { centre, radius, sweep_rad, .. } => {
            // The foot may miss the end by rounding.
            let near = |end: Point2| (end - centre).cross(place - centre).abs() <= within * radius;
            let beside = of.faces(place) || near(of.start()) || near(of.end());
            let off = square(place - centre).sqrt() - radius;
            if beside { off * sweep_rad.signum() } else { f64::NAN }
        }
    }
}
