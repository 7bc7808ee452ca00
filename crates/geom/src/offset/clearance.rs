//! Nothing of a result lies nearer to the source than it should.

use super::source::Source;
use crate::segment::square;
use crate::{Bounds2, Point2, Segment};

/// A segment shorter than this share of the distance is looked at in its middle only: a corner between
/// two such places is 0.1 % of the distance too near at most, and its neighbours show it.
const SHORT: f64 = 0.1;
/// So many neighbours are asked about together, as long as they keep within a share of the distance.
const MOST_TOGETHER: usize = 8;
const TOGETHER: f64 = 0.25;

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
    // Where exactly does not matter much; that it is somewhere does.
    near.iter().any(|s| segment.comes_nearer(s, limit)).then(|| segment.at(0.5))
}
