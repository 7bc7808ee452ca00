//! No part of a parallel curve that has room is missing from a result.

use super::path::OffsetPath;
use super::raw;
use super::scratch::Buffer;
use super::wanted::{Checked, Wanted, unproved};
use crate::segment::square;
use crate::{BoxTree, Point2, Segment, Vec2};
use std::cell::OnceCell;

/// Parallels and arcs of corners are walked in steps of this share of the distance.
const SPACING: f64 = 0.5;
/// But not in more steps than this.
const MOST_PLACES: f64 = 64.0;

/// The number of no segment.
const NONE: usize = usize::MAX;

/// The segments of the result that belong to each element of the source.
pub(super) struct Coverage<'a> {
    segments: Buffer<'a, Segment>,
    /// The first segment of element e is `first[2e]`, that of the corner at its start `first[2e + 1]`.
    first: Buffer<'a, usize>,
    /// The next segment of the same.
    next: Buffer<'a, usize>,
    /// All of them by place; rarely needed.
    index: OnceCell<BoxTree>,
    within: f64,
    room: f64,
}

impl<'a> Coverage<'a> {
    pub fn new(wanted: &Wanted<'a>, found: &[OffsetPath], segments: Buffer<'a, Segment>) -> Self {
        let source = wanted.source;
        let mut first = Buffer::filled(source.scratch, NONE, 2 * source.segments().len());
        let mut next = Buffer::filled(source.scratch, NONE, segments.len());
        // From the last to the first, so that each stands before those after it.
        let origins = found.iter().rev().flat_map(|f| f.origins.iter().rev());
        for (number, o) in (0..segments.len()).rev().zip(origins) {
            let element = 2 * (source.first[o.contour] + o.element) + usize::from(o.corner);
            next[number] = std::mem::replace(&mut first[element], number);
        }
        let (within, room) = (wanted.within, wanted.room());
        Self { segments, first, next, index: OnceCell::new(), within, room }
    }

    /// Tells whether a place lies on the result, whatever element it came from, or so near that what lies
    /// between has no room. At corners that all but do not bend a parallel goes on beyond its end.
    fn is_near(&self, place: Point2) -> bool {
        let boxes = || BoxTree::new(self.segments.iter().map(Segment::bounds));
        let index = self.index.get_or_init(boxes);
        let distance = |k: usize| self.segments[k].distance(place);
        index.nearest(place, self.room, distance).is_some()
    }

    fn own(&self, element: usize, corner: bool) -> impl Iterator<Item = &Segment> {
        let some = |number: usize| (number != NONE).then_some(number);
        let first = some(self.first[2 * element + usize::from(corner)]);
        let numbers = std::iter::successors(first, move |number| some(self.next[*number]));
        numbers.map(|number| &self.segments[number])
    }

    fn covers(&self, element: usize, corner: bool, place: Point2) -> bool {
        self.own(element, corner).any(|s| s.distance(place) <= self.within)
    }

    /// Between which shares of a raw curve the first segment of the result that belongs to it lies. That it
    /// lies on the curve has been checked.
    fn shares(&self, element: usize, corner: bool, curve: &Segment) -> [f64; 2] {
        let mut own = self.own(element, corner);
        own.next().map_or([1.0, 0.0], |s| [curve.share_of(s.start()), curve.share_of(s.end())])
    }

    /// Tells whether one segment of the result is the whole of a raw curve between two places.
    fn covers_all(&self, element: usize, corner: bool, start: Point2, end: Point2) -> bool {
        let near = |a: Point2, b: Point2| square(a - b) <= self.within * self.within;
        self.own(element, corner).any(|s| near(s.start(), start) && near(s.end(), end))
    }
}

pub(super) fn complete(wanted: &Wanted, coverage: &Coverage) -> Checked {
    let Wanted { source, distance, .. } = *wanted;
    for (contour, first) in source.contours.iter().zip(source.first.iter().copied()) {
        let count = contour.segment_count();
        for k in first..first + count {
            parallel_present(wanted, coverage, k)?;
            let before =
                if k > first { Some(k - 1) } else { contour.closed.then_some(first + count - 1) };
            if let Some(before) = before {
                let ways = [source.ways()[before].arrives, source.ways()[k].leaves];
                if raw::may_open(ways, distance) {
                    corner_present(wanted, coverage, [before, k], ways)?;
                }
            }
        }
    }
    Ok(())
}

fn parallel_present(wanted: &Wanted, coverage: &Coverage, element: usize) -> Checked {
    let Wanted { source, distance, .. } = *wanted;
    let (segment, ways) = (&source.segments()[element], &source.ways()[element]);
    let beside = |at: Point2, way: Vec2| at + raw::right_of(way, distance);
    let ends = [beside(segment.start(), ways.leaves), beside(segment.end(), ways.arrives)];
    if coverage.covers_all(element, false, ends[0], ends[1]) {
        return Ok(());
    }
    let Some(parallel) = raw::parallel(segment, distance) else { return Ok(()) };
    let out = |share| -segment.direction(share).left() * distance.signum();
    present(wanted, coverage, (element, false), &parallel, out)
}

fn corner_present(
    wanted: &Wanted,
    coverage: &Coverage,
    [before, element]: [usize; 2],
    ways: [Vec2; 2],
) -> Checked {
    let Wanted { source, distance, .. } = *wanted;
    let sides = [&source.segments()[before], &source.segments()[element]];
    let centre = sides[1].start();
    let ends = ways.map(|way| centre + raw::right_of(way, distance));
    if coverage.covers_all(element, true, ends[0], ends[1]) {
        return Ok(());
    }
    let Some(arc) = raw::corner(sides, ways, distance) else { return Ok(()) };
    let out = |share| (arc.at(share) - centre) / distance.abs();
    present(wanted, coverage, (element, true), &arc, out)
}

/// Checks that every place of a raw curve that has room beyond it is on the result.
fn present(
    wanted: &Wanted,
    coverage: &Coverage,
    (element, corner): (usize, bool),
    curve: &Segment,
    out: impl Fn(f64) -> Vec2,
) -> Checked {
    let (source, size, room) = (wanted.source, wanted.distance.abs(), wanted.room());
    let count = (curve.length() / (size * SPACING)).ceil().clamp(1.0, MOST_PLACES);
    let [from, to] = coverage.shares(element, corner, curve);
    // What is known to be there is passed over.
    let (before, after) = match from <= to {
        true => (from * count - 0.5, (to * count - 0.5).floor() + 1.0),
        false => (count, count),
    };
    let places = (0..before.ceil().clamp(0.0, count) as usize)
        .chain(after.clamp(0.0, count) as usize..count as usize);
    for k in places {
        let share = (k as f64 + 0.5) / count;
        let at = curve.at(share);
        let beyond = at + out(share) * room;
        if source.neighbours_nearer(element, beyond, size + 0.5 * room)
            || coverage.covers(element, corner, at)
        {
            continue;
        }
        let has_room = !source.is_nearer(beyond, size + 0.5 * room);
        if has_room && !coverage.is_near(at) && !is_behind(wanted, element, at) {
            return unproved("a part is missing", at);
        }
    }
    Ok(())
}

/// Tells whether a place at its distance from an element is beyond another part of the source: nearer to it, or
/// behind a crack whose sides cannot be told apart.
fn is_behind(wanted: &Wanted, element: usize, place: Point2) -> bool {
    let Wanted { source, distance, within } = *wanted;
    source.is_nearer(place, distance.abs() - within)
        || source.winding_beside(element, distance).is_some_and(|own| source.winding(place) != own)
}
