//! The definition of an offset, checked on a result. Nothing here knows how the result was made.
//!
//! - *At its distance, on its side*: each segment says what it is parallel to; that is held against the
//!   source.
//! - *Nowhere nearer*: each segment is held against all of the source that is near. Two strands that cross would
//!   each come too near to the other's source just behind the crossing, so rings that pass are simple.
//! - *Complete*: the parallel of each source segment and the arc of each corner is walked; where it has
//!   room on its far side it must belong to the result.

use super::clearance::too_near;
use super::scratch::Buffer;
use super::source::Source;
use super::{OffsetPath, Origin, raw};
use crate::segment::square;
use crate::{BoxTree, GeomError, Point2, Polyarc, Segment, Vec2};
use std::cell::OnceCell;

/// How exactly a result has to be at its distance. A hundredth of the 1e-4 mm that is promised, a
/// thousand times what rounding accounts for.
pub const CHECK_MM: f64 = 1e-6;

/// A place is wrongly missing only if there is so many times the tolerance of room beyond it. A slot exactly
/// as wide as the tool has no room: its offset may come or go.
const ROOM: f64 = 10.0;

/// Parallels and arcs of corners are walked in steps of this share of the distance.
const SPACING: f64 = 0.5;
/// But not in more steps than this.
const MOST_PLACES: f64 = 64.0;

type Checked = Result<(), GeomError>;

/// What is checked: against which source, at which distance, how exactly.
#[derive(Clone, Copy)]
struct Wanted<'a> {
    source: &'a Source<'a>,
    distance: f64,
    within: f64,
}

impl Wanted<'_> {
    fn room(&self) -> f64 {
        ROOM * self.within
    }
}

/// Whether `found` is the offset of the source within a tolerance, usually [`CHECK_MM`].
pub(super) fn validate(
    source: &Source,
    distance: f64,
    found: &[OffsetPath],
    within: f64,
) -> Checked {
    let wanted = Wanted { source, distance, within };
    let mut segments: Buffer<Segment> = Buffer::new(source.scratch);
    found.iter().for_each(|f| segments.extend(f.path.segments()));
    if let Some(odd) = found.iter().find(|f| f.origins.len() != f.path.segment_count()) {
        return unproved("a piece without extent", odd.path.start().unwrap_or_default());
    }
    let origins = found.iter().flat_map(|f| &f.origins);
    for (segment, origin) in segments.iter().zip(origins) {
        let known = |contour: &Polyarc| origin.element < contour.segment_count();
        if !source.contours.get(origin.contour).is_some_and(known) {
            return unproved("parallel to nothing", segment.start());
        }
        follows_origin(&wanted, segment, origin)?;
    }
    if let Some(at) = too_near(source, distance, within, &segments) {
        return unproved("nearer to another part of the source", at);
    }
    complete(&wanted, &Coverage::new(&wanted, found, segments))
}

fn unproved(why: &'static str, at: Point2) -> Checked {
    Err(GeomError::Unproved { why, at })
}

/// At the distance from what the segment says it is parallel to, on the right side, in its direction.
fn follows_origin(wanted: &Wanted, segment: &Segment, origin: &Origin) -> Checked {
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

/// Whether a line certainly goes beside another one: both its ends do, and it goes the same way.
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

/// Whether an arc certainly turns about a corner, or beside an arc: its centre and radius are those that
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

/// How far a place lies to the right of a segment's line or circle, if its foot lies on the segment; else
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

/// The number of no segment.
const NONE: usize = usize::MAX;

/// The segments of the result that belong to each element of the source.
struct Coverage<'a> {
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
    fn new(wanted: &Wanted<'a>, found: &[OffsetPath], segments: Buffer<'a, Segment>) -> Self {
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

    /// Whether a place lies on the result, whatever element it came from, or so near that what lies
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

    /// Whether one segment of the result is the whole of a raw curve between two places.
    fn covers_all(&self, element: usize, corner: bool, start: Point2, end: Point2) -> bool {
        let near = |a: Point2, b: Point2| square(a - b) <= self.within * self.within;
        self.own(element, corner).any(|s| near(s.start(), start) && near(s.end(), end))
    }
}

fn complete(wanted: &Wanted, coverage: &Coverage) -> Checked {
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

/// Whether every place of a raw curve that has room beyond it is on the result.
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

/// Whether a place at its distance from an element is beyond another part of the source: nearer to it, or
/// behind a crack whose sides cannot be told apart.
fn is_behind(wanted: &Wanted, element: usize, place: Point2) -> bool {
    let Wanted { source, distance, within } = *wanted;
    source.is_nearer(place, distance.abs() - within)
        || source.winding_beside(element, distance).is_some_and(|own| source.winding(place) != own)
}
