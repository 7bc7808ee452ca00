//! Simple pieces that together are everything within a distance of the source.
//!
//! ```text
//!     ┌───────────┐╮
//!     │  beside   │ ╮ about the corner
//!     ●───────────●──       the place nearest to any covered place lies on a segment, then the
//!       segment             segment's piece covers it, or it is a corner, then the corner's does
//! ```
//!
//! Pieces about corners reach a little over their neighbours, so that rounding opens no crack between
//! them. That covers nothing that is not covered: they stay within the circle about the corner.

use super::super::raw;
use super::super::source::Source;
use crate::{Point2, Polyarc, Segment, Vec2};
use std::f64::consts::PI;

/// Chords lie no farther than this from their arcs.
pub(super) const CHORD_MM: f64 = 1e-4;

/// Corners of a polygon.
pub(super) type Polygon = Vec<[f64; 2]>;

/// Angle by which pieces about corners reach over their neighbours.
const OVER_RAD: f64 = 1e-3;

/// Corners that close by more than this need no piece: those of the segments overlap.
const CLOSING_RAD: f64 = 1e-2;

/// Arcs have no more chords than this.
const MOST_CHORDS: f64 = 10_000.0;

/// A contour as a polygon.
pub(super) fn flattened(contour: &Polyarc) -> Polygon {
    contour.segments().flat_map(|s| chords(&s, false)).map(|p| [p.x, p.y]).collect()
}

/// Returns pieces that cover what lies within the distance on the side of the offset.
pub(super) fn one_side(source: &Source, distance: f64) -> Vec<Polygon> {
    let mut pieces = Vec::new();
    for contour in source.contours {
        let segments: Vec<Segment> = contour.segments().collect();
        add_side(&segments, contour.closed, distance, &mut pieces);
    }
    pieces
}

/// Returns pieces that cover what lies within the distance on both sides and about the ends.
pub(super) fn both_sides(source: &Source, distance: f64) -> Vec<Polygon> {
    let mut pieces = one_side(source, distance);
    pieces.extend(one_side(source, -distance));
    let ends = source.contours.iter().flat_map(|c| [c.start(), c.end()]).flatten();
    pieces.extend(ends.map(|at| disc(at, distance.abs())));
    pieces
}

fn add_side(segments: &[Segment], closed: bool, distance: f64, pieces: &mut Vec<Polygon>) {
    let count = segments.len();
    for (n, segment) in segments.iter().enumerate() {
        pieces.push(beside(segment, distance));
        if n + 1 < count || closed {
            pieces.extend(about(segment, &segments[(n + 1) % count], distance));
        }
    }
}

/// Covers what lies within the distance of a segment, square to it.
fn beside(segment: &Segment, distance: f64) -> Polygon {
    let mut places = chords(segment, true);
    match (raw::parallel(segment, distance), segment) {
        (Some(parallel), _) => places.extend(chords(&parallel, true).into_iter().rev()),
        (None, Segment::Arc { centre, .. }) => places.push(*centre),
        (None, Segment::Line { .. }) => {}
    }
    counter_clockwise(places)
}

/// Covers what lies within the distance of a corner.
fn about(before: &Segment, after: &Segment, distance: f64) -> Option<Polygon> {
    let (u, v) = (before.direction(1.0), after.direction(0.0));
    let side = distance.signum();
    let mut turn = u.cross(v).atan2(u.dot(v)) * side;
    if PI - turn.abs() < 1e-6 {
        turn = PI;
    }
    if turn < -CLOSING_RAD {
        return None;
    }
    let from = (-u.left() * side).angle();
    let (low, high) = if turn < 0.0 { (turn, 0.0) } else { (0.0, turn) };
    let (low, high) =
        if side > 0.0 { (from + low, from + high) } else { (from - high, from - low) };
    Some(pie(before.end(), distance.abs(), low, high))
}

/// A part of a disc, a little more at both ends. The ends themselves are corners: there the curves meet.
fn pie(centre: Point2, radius: f64, from: f64, to: f64) -> Polygon {
    let count = chord_count(radius, to - from);
    let rim = (0..=count).map(|k| from + (to - from) * k as f64 / count as f64);
    let turns = [from - OVER_RAD].into_iter().chain(rim).chain([to + OVER_RAD]);
    let places = turns.map(|turn| centre + Vec2::from_angle(turn) * radius);
    counter_clockwise([centre].into_iter().chain(places).collect())
}

fn disc(centre: Point2, radius: f64) -> Polygon {
    flattened(&Polyarc::circle(centre, radius))
}

/// The ends of the chords of a segment, the last one only if it is wanted.
fn chords(segment: &Segment, with_end: bool) -> Vec<Point2> {
    let count = match *segment {
        Segment::Line { .. } => 1,
        Segment::Arc { radius, sweep_rad, .. } => chord_count(radius, sweep_rad.abs()),
    };
    let at = |k: usize| segment.at(k as f64 / count as f64);
    (0..count + usize::from(with_end)).map(at).collect()
}

/// A chord over an angle u lies r(1 − cos(u/2)) off its arc.
fn chord_count(radius: f64, sweep: f64) -> usize {
    let step = 2.0 * (1.0 - (CHORD_MM / radius).min(1.0)).acos();
    (sweep / step).ceil().clamp(1.0, MOST_CHORDS) as usize
}

fn counter_clockwise(mut places: Vec<Point2>) -> Polygon {
    let origin = places.first().copied().unwrap_or_default();
    let twice = |pair: &[Point2]| (pair[0] - origin).cross(pair[1] - origin);
    if places.windows(2).map(twice).sum::<f64>() < 0.0 {
        places.reverse();
    }
    places.into_iter().map(|p| [p.x, p.y]).collect()
}
