//! Nothing of a result lies nearer to the source than it should.

use super::source::Source;
use crate::segment::square;
use crate::{Bounds2, Point2, Segment};

/// Places on each segment are looked at this densely, as a share of the distance. Between two of them a
/// corner of the source could reach 3 % too near; corners are therefore held against segments as well.
const SPACING: f64 = 0.5;
/// But not more places than this on one segment.
const MOST_PLACES: usize = 64;
/// A segment shorter than this share of the distance is looked at in its middle only: a corner between
/// two such places is 0.1 % of the distance too near at most, and its neighbours' places show it.
const SHORT: f64 = 0.1;
/// So many neighbours are asked about together, as long as they keep within a share of the distance.
const MOST_TOGETHER: usize = 8;
const TOGETHER: f64 = 0.25;

/// How many places of a curve are looked at.
pub(super) fn places(length: f64, distance: f64) -> usize {
    (length / (distance.abs() * SPACING)).ceil().clamp(1.0, MOST_PLACES as f64) as usize
}

/// A place of the segments that lies too near to the source, if one is found.
///
/// Neighbours on the result have the same neighbours in the source, so these are looked up once for
/// several.
pub(super) fn too_near(
    source: &Source,
    distance: f64,
    within: f64,
    segments: &[Segment],
) -> Option<Point2> {
    let limit = distance.abs() - within;
    let mut near = Vec::new();
    let mut rest = segments;
    while let Some((group, after)) = split_group(rest, TOGETHER * distance.abs()) {
        rest = after;
        let bounds = group.iter().fold(Bounds2::default(), |mut all, s| {
            all.merge(&s.bounds());
            all
        });
        near.clear();
        source.near(&bounds, limit, &mut near);
        let found = group.iter().find_map(|s| near_one(s, limit, distance, &near));
        if found.is_some() {
            return found;
        }
    }
    None
}

/// The first segments that lie close together, and the rest.
fn split_group(segments: &[Segment], size: f64) -> Option<(&[Segment], &[Segment])> {
    let first = segments.first()?.start();
    let close = |s: &Segment| {
        let reach = s.end() - first;
        reach.x.abs().max(reach.y.abs()) <= size
    };
    let count = segments.iter().take(MOST_TOGETHER).take_while(|s| close(s)).count().max(1);
    Some(segments.split_at(count))
}

fn near_one(segment: &Segment, limit: f64, distance: f64, near: &[Segment]) -> Option<Point2> {
    let too_near = |at: &Point2| near.iter().any(|s| s.is_nearer(*at, limit));
    // A segment this short has no room for anything between its middle and those of its neighbours.
    if square(segment.end() - segment.start()) < (SHORT * distance).powi(2) {
        return Some(segment.at(0.5)).filter(too_near);
    }
    let count = places(segment.length(), distance);
    let inner = (0..count).map(|k| segment.at((k as f64 + 0.5) / count as f64));
    let place = inner.chain([segment.end()]).find(too_near);
    place.or_else(|| near.iter().map(Segment::start).find(|at| segment.is_nearer(*at, limit)))
}
