//! Nothing of a result lies nearer to the source than it should.
//!
//! Every segment of the result is held against every segment of the source that may be near. Most of
//! these are dismissed by a proof of a few products ([`Beyond`], [`Chains`]); only what is left is measured.

use super::beyond::Beyond;
use super::chains::Chains;
use super::elements::Range2;
use super::scratch::Buffer;
use super::source::Source;
use crate::segment::{comes_nearer, square};
use crate::{Bounds2, Point2, Segment};
use std::cell::OnceCell;

/// A segment shorter than this share of the distance is looked at in its middle only: a corner between
/// two such places is 0.1 % of the distance too near at most, and its neighbours show it.
const SHORT: f64 = 0.1;
/// So many neighbours are asked about together, as long as what is near to one of them is near to most.
const MOST_TOGETHER: usize = 8;
const TOGETHER: f64 = 8.0;

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
    let (limit, chains) = (distance.abs() - within, OnceCell::new());
    let short_squared = (SHORT * distance).powi(2);
    if source.is_small() {
        let runs = [(0, source.segments().len())];
        let near = Near { source, limit, short_squared, runs: &runs, chains: &chains };
        return segments.iter().find_map(|segment| near.look(segment, &segment.bounds()));
    }
    let mut runs: Buffer<Range2> = Buffer::new(source.scratch);
    let mut boxes = [Bounds2::default(); MOST_TOGETHER];
    let mut rest = segments;
    while !rest.is_empty() {
        let (count, whole) = group(rest, distance.abs(), &mut boxes);
        let (group, after) = rest.split_at(count);
        rest = after;
        runs.clear();
        source.runs_near(&whole, limit, &mut runs);
        let near = Near { source, limit, short_squared, runs: &runs, chains: &chains };
        let found = group.iter().zip(&boxes).find_map(|(segment, own)| near.look(segment, own));
        if found.is_some() {
            return found;
        }
    }
    None
}

/// Returns the number of first segments to look at together, and the box around them.
fn group(segments: &[Segment], size: f64, boxes: &mut [Bounds2]) -> (usize, Bounds2) {
    let extent = |b: &Bounds2| b.size().x + b.size().y;
    let (mut count, mut least, mut whole) = (0, f64::INFINITY, Bounds2::default());
    for (segment, own) in segments.iter().zip(boxes) {
        *own = segment.bounds();
        least = least.min(extent(own));
        let mut more = whole;
        more.merge(own);
        if count > 0 && extent(&more) > TOGETHER * least + 0.5 * size {
            break;
        }
        (whole, count) = (more, count + 1);
    }
    (count, whole)
}

/// Part of the source that may be nearer to some segments than a limit.
struct Near<'n, 's> {
    source: &'n Source<'s>,
    limit: f64,
    /// Square of the length below which a segment is looked at in its middle only.
    short_squared: f64,
    runs: &'n [Range2],
    chains: &'n OnceCell<Chains<'s>>,
}

impl Near<'_, '_> {
    /// A place of a segment that is too near. A short one has no room for anything between its middle and those of
    /// its neighbours.
    fn look(&self, segment: &Segment, bounds: &Bounds2) -> Option<Point2> {
        let short = square(segment.end() - segment.start()) < self.short_squared;
        if short { self.place(segment) } else { self.all(segment, bounds) }
    }

    /// The middle of a segment, if it is too near.
    fn place(&self, segment: &Segment) -> Option<Point2> {
        let at = segment.middle();
        let chains = self.chains.get_or_init(|| Chains::of(self.source, self.limit));
        let near = self.runs.iter().any(|run| chains.is_nearer(self.source, *run, at, self.limit));
        near.then_some(at)
    }

    /// The middle of a segment of which some place is too near. Where exactly does not matter much; that
    /// it is somewhere does.
    fn all(&self, segment: &Segment, bounds: &Bounds2) -> Option<Point2> {
        let area = bounds.grown(self.limit);
        let beyond = Beyond::of(segment, self.limit);
        let (boxes, segments, ways) =
            (self.source.boxes(), self.source.segments(), self.source.ways());
        let near = |k: usize| {
            boxes[k].meets(&area)
                && !beyond.has(&segments[k], ways[k].leaves)
                && comes_nearer(segment, &segments[k], self.limit)
        };
        let run_near = |&(from, to): &Range2| (from..to).any(near);
        self.runs.iter().any(run_near).then(|| segment.middle())
    }
}
