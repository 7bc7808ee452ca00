//! The definition of an offset, checked on a result. Nothing here knows how the result was made.
//!
//! - *At its distance, on its side*: each segment says what it is parallel to; that is held against the
//!   source.
//! - *Nowhere nearer*: places of each segment are looked up in the source. Two strands that cross would
//!   each come too near to the other's source just behind the crossing, so rings that pass are simple.
//! - *Complete*: the parallel of each source segment and the arc of each corner is walked; where it has
//!   room on its far side it must belong to the result.

use super::source::Source;
use super::{OffsetPath, Origin, raw};
use crate::{BoxTree, GeomError, Point2, Segment, Vec2};
use std::cell::OnceCell;

/// How exactly a result has to be at its distance. A hundredth of the 1e-4 mm that is promised, a
/// thousand times what rounding accounts for.
pub const CHECK_MM: f64 = 1e-6;

/// A place is wrongly missing only if there is this much room beyond it. A slot exactly as wide as the
/// tool has no room: its offset may come or go.
const ROOM_MM: f64 = 1e-5;

/// Checks places on each segment at least this densely, as a share of the distance.
const SPACING: f64 = 0.25;
/// But not more of them on one segment.
const MOST_PLACES: usize = 64;

type Checked = Result<(), GeomError>;

/// Whether `found` is the offset of the source.
pub(super) fn validate(source: &Source, distance: f64, found: &[OffsetPath]) -> Checked {
    for offset in found {
        for (segment, origin) in offset.path.segments().zip(&offset.origins) {
            follows_origin(source, distance, &segment, origin)?;
            nowhere_nearer(source, distance, &segment)?;
        }
    }
    complete(source, distance, found)
}

fn unproved(why: &'static str, at: Point2) -> Checked {
    Err(GeomError::Unproved { why, at })
}

/// Start, middle and end at the distance from what the segment says it is parallel to, to the right.
fn follows_origin(source: &Source, distance: f64, segment: &Segment, origin: &Origin) -> Checked {
    let of = &source.segments()[source.first[origin.contour] + origin.element];
    for share in [0.0, 0.5, 1.0] {
        let at = segment.at(share);
        if !at.x.is_finite() || !at.y.is_finite() {
            return unproved("a place that is no number", at);
        }
        let foot = if origin.corner { of.start() } else { of.nearest(at).at };
        let out = at - foot;
        if (out.length() - distance.abs()).abs() > CHECK_MM {
            return unproved("not at its distance", at);
        }
        let right = -segment.direction(share).left() * distance.signum();
        // Right of travel: the way from the foot is the normal, up to what short segments blur.
        if out.dot(right) < 0.9 * distance.abs() && segment.length() > 100.0 * CHECK_MM {
            return unproved("on the wrong side", at);
        }
    }
    Ok(())
}

fn places(length: f64, distance: f64) -> usize {
    (length / (distance.abs() * SPACING)).ceil().clamp(1.0, MOST_PLACES as f64) as usize
}

fn nowhere_nearer(source: &Source, distance: f64, segment: &Segment) -> Checked {
    let count = places(segment.length(), distance);
    let limit = distance.abs() - CHECK_MM;
    for k in 0..count {
        let at = segment.at((k as f64 + 0.5) / count as f64);
        if source.is_nearer(at, limit) {
            return unproved("nearer to another part of the source", at);
        }
    }
    if source.is_nearer(segment.end(), limit) {
        return unproved("nearer to another part of the source", segment.end());
    }
    Ok(())
}

/// The segments of the result that belong to each element of the source.
struct Coverage {
    /// Sorted by element: number, whether a corner, segment.
    list: Vec<(usize, bool, Segment)>,
    /// All of them by place; rarely needed.
    index: OnceCell<BoxTree>,
}

impl Coverage {
    fn new(source: &Source, found: &[OffsetPath]) -> Self {
        let mut list = Vec::with_capacity(found.iter().map(|f| f.origins.len()).sum());
        for offset in found {
            let named = offset.path.segments().zip(&offset.origins);
            list.extend(named.map(|(s, o)| (source.first[o.contour] + o.element, o.corner, s)));
        }
        list.sort_by_key(|a| (a.0, a.1));
        Self { list, index: OnceCell::new() }
    }

    /// Whether a place lies on the result, whatever element it came from, or so near that what lies
    /// between has no room. At corners that all but do not bend a parallel goes on beyond its end.
    fn is_near(&self, place: Point2) -> bool {
        let boxes = || BoxTree::new(self.list.iter().map(|c| c.2.bounds()));
        let index = self.index.get_or_init(boxes);
        let distance = |k: usize| self.list[k].2.distance(place);
        index.nearest(place, ROOM_MM, distance).is_some()
    }

    fn covers(&self, element: usize, corner: bool, place: Point2) -> bool {
        let from = self.list.partition_point(|c| (c.0, c.1) < (element, corner));
        let own = self.list[from..].iter().take_while(|c| (c.0, c.1) == (element, corner));
        own.into_iter().any(|(_, _, s)| s.distance(place) <= CHECK_MM)
    }
}

fn complete(source: &Source, distance: f64, found: &[OffsetPath]) -> Checked {
    let coverage = Coverage::new(source, found);
    for (contour, first) in source.contours.iter().zip(&source.first) {
        let count = contour.segment_count();
        for k in 0..count {
            let segment = &source.segments()[first + k];
            if let Some(parallel) = raw::parallel(segment, distance) {
                let out = |share| -segment.direction(share).left() * distance.signum();
                present(source, distance, &coverage, (first + k, false), &parallel, out)?;
            }
            let before = if k > 0 { Some(k - 1) } else { contour.closed.then_some(count - 1) };
            let before = before.map(|b| &source.segments()[first + b]);
            if let Some(arc) = before.and_then(|b| raw::corner(b, segment, distance)) {
                let centre = segment.start();
                let out = |share| (arc.at(share) - centre) / distance.abs();
                present(source, distance, &coverage, (first + k, true), &arc, out)?;
            }
        }
    }
    Ok(())
}

/// Whether every place of a raw curve that has room beyond it is on the result.
fn present(
    source: &Source,
    distance: f64,
    coverage: &Coverage,
    (element, corner): (usize, bool),
    curve: &Segment,
    out: impl Fn(f64) -> Vec2,
) -> Checked {
    let count = places(curve.length(), distance);
    for k in 0..count {
        let share = (k as f64 + 0.5) / count as f64;
        let at = curve.at(share);
        if coverage.covers(element, corner, at) {
            continue;
        }
        let beyond = at + out(share) * ROOM_MM;
        let room = !source.is_nearer(beyond, distance.abs() + 0.5 * ROOM_MM);
        if room && !coverage.is_near(at) {
            return unproved("a part is missing", at);
        }
    }
    Ok(())
}
