//! Slices joined into rings, with their starts put where the source starts.

use super::elements::{Part, Piece, Slice, Stretch};
use super::path::{CHECK_MM, OffsetPath};
use super::raw;
use super::scratch::{Buffer, Scratch};
use super::slices::Slices;
use super::source::Source;
use crate::segment::square;
use crate::stitch::{Strand, Turn, stitch};
use crate::{Point2, Polyarc, Segment, Vec2, Vertex, tol};

/// Distance along a strand at which its direction is taken, as a share of the offset: tangent curves
/// have parted by then, and neighbouring corners are not yet reached.
const LOOK_AHEAD: f64 = 1e-3;

/// A ring is nothing when it encloses less than a strip of this width along its length.
const THIN_MM: f64 = tol::SAME_PLACE_MM;

pub(super) fn rings(
    source: &Source,
    distance: f64,
    pieces: &[Piece],
    slices: &Slices,
) -> Vec<OffsetPath> {
    let (mut found, scratch) = (Vec::new(), source.scratch);
    let whole = slices.list.iter().filter(|slice| slice.ring);
    for ring in whole {
        let part = |&(k, from, to): &Stretch| (pieces[k].segment.part(from, to), pieces[k].origin);
        let parts = Buffer::of(scratch, slices.parts(ring).iter().map(part));
        found.extend(path(parts, true).map(|path| started_like_source(source, distance, path)));
    }
    if slices.list.iter().all(|slice| slice.ring) {
        return found;
    }
    let cut = Buffer::of(scratch, slices.list.iter().filter(|slice| !slice.ring).copied());
    let look = LOOK_AHEAD * distance.abs();
    let of = |s: &Slice| strand(pieces, slices.parts(s), s.sure, look);
    let strands = Buffer::of(scratch, cut.iter().map(of));
    // The sharpest turn is the one away from the source: see the drawing in `stitch`.
    let turn = if distance > 0.0 { Turn::Right } else { Turn::Left };
    let open = source.contours.iter().any(|c| !c.closed);
    let stitched = stitch(&strands, turn, open);
    let collect = |way: &Vec<usize>| -> Buffer<Part> {
        parts_of(scratch, pieces, way.iter().flat_map(|&n| slices.parts(&cut[n])))
    };
    for way in &stitched.loops {
        let parts = collect(way);
        if let Some(path) = path(parts, true) {
            found.push(started_like_source(source, distance, path));
        }
    }
    if open {
        found.extend(stitched.open.iter().filter_map(|way| path(collect(way), false)));
    }
    found
}

fn strand(pieces: &[Piece], parts: &[Stretch], sure: bool, look: f64) -> Strand {
    let part = |&(k, from, to): &Stretch| pieces[k].segment.part(from, to);
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else { return Strand::default() };
    let (first, last) = (part(first), part(last));
    let long: f64 = parts.iter().map(|p| pieces[p.0].segment.length() * (p.2 - p.1)).sum();
    Strand {
        start: first.start(),
        end: last.end(),
        middle: middle(pieces, parts, long * 0.5),
        leaves: leaves(&first, look),
        arrives: last.direction(1.0),
        sure,
    }
}

/// The chord from the start to a little farther along.
fn leaves(first: &Segment, look: f64) -> Vec2 {
    let share = (look / first.length().max(f64::MIN_POSITIVE)).min(1.0);
    (first.at(share) - first.start()).normalized().unwrap_or_else(|| first.direction(0.0))
}

fn middle(pieces: &[Piece], parts: &[Stretch], mut left: f64) -> Point2 {
    for &(k, from, to) in parts {
        let long = pieces[k].segment.length() * (to - from);
        if left <= long && long > 0.0 {
            return pieces[k].segment.at(from + (to - from) * left / long);
        }
        left -= long;
    }
    Point2::default()
}

/// The parts of a way, stretches of one piece in one.
fn parts_of<'b, 's>(
    scratch: &'b Scratch,
    pieces: &[Piece],
    way: impl IntoIterator<Item = &'s Stretch>,
) -> Buffer<'b, Part> {
    let mut merged: Buffer<Stretch> = Buffer::new(scratch);
    for &(k, from, to) in way {
        match merged.last_mut() {
            Some(last) if last.0 == k && (from - last.2).abs() < 1e-9 => last.2 = to,
            _ => merged.push((k, from, to)),
        }
    }
    if let (Some(&first), Some(&last)) = (merged.first(), merged.last())
        && merged.len() > 1
        && first.0 == last.0
        && (first.1 - last.2).abs() < 1e-9
    {
        merged[0].1 = last.1;
        merged.pop();
    }
    let part = |&(k, from, to): &Stretch| (pieces[k].segment.part(from, to), pieces[k].origin);
    Buffer::of(scratch, merged.iter().map(part))
}

/// A path of parts that are worth something, or nothing.
pub(super) fn path(mut parts: Buffer<'_, Part>, closed: bool) -> Option<OffsetPath> {
    parts.retain(|(s, _)| is_long(s));
    let path = Polyarc::from_parts(parts.iter().map(|p| &p.0), closed);
    if parts.is_empty() || (closed && is_thin(&path)) {
        return None;
    }
    let origins = parts.iter().map(|p| p.1).collect();
    Some(OffsetPath { path, origins, within_mm: CHECK_MM })
}

/// Tells whether a segment has some extent.
fn is_long(segment: &Segment) -> bool {
    match segment {
        Segment::Line { start, end } => {
            square(*end - *start) > tol::SAME_PLACE_MM * tol::SAME_PLACE_MM
        }
        arc => arc.length() > tol::SAME_PLACE_MM,
    }
}

/// Tells whether a ring encloses no more than a strip along itself, as where it goes there and back.
///
/// Most enclose so much that it is seen from the chords: an arc adds no more than the rectangle about it, c²·b/2,
/// to the area and is no longer than two chords, as none turns by more than half a circle.
fn is_thin(ring: &Polyarc) -> bool {
    let origin = ring.start().unwrap_or_default();
    let (mut twice, mut caps, mut long) = (0.0, 0.0, 0.0);
    let next = ring.vertices.iter().skip(1).chain(ring.vertices.first());
    for (from, to) in ring.vertices.iter().zip(next) {
        let chord = to.at - from.at;
        twice += (from.at - origin).cross(to.at - origin);
        caps += square(chord) * from.bulge.abs();
        long += chord.x.abs() + chord.y.abs();
    }
    let surely = f64::abs(twice) - caps > 4.0 * long * THIN_MM;
    !surely && ring.signed_area().abs() <= ring.length() * THIN_MM
}

/// The ring from the place nearest to the parallel of its source's start.
pub(super) fn started_like_source(source: &Source, distance: f64, ring: OffsetPath) -> OffsetPath {
    let Some(contour) = ring.origins.iter().map(|o| o.contour).min() else { return ring };
    let first = source.segments()[source.first[contour]];
    let wanted = raw::parallel(&first, distance)
        .map_or_else(|| first.start() - first.direction(0.0).left() * distance, |p| p.start());
    // Usually the very place is a vertex of the ring.
    let here = |v: &Vertex| square(v.at - wanted) <= tol::SAME_PLACE_MM * tol::SAME_PLACE_MM;
    if let Some(vertex) = ring.path.vertices.iter().position(here) {
        return turned(ring, vertex);
    }
    let Some((place, _)) = ring.path.nearest(wanted) else { return ring };
    let before = ring.path.vertices.len();
    let (path, vertex) = ring.path.with_vertex_at(&place);
    let mut origins = ring.origins;
    if path.vertices.len() > before {
        origins.insert(vertex, origins[vertex - 1]);
    }
    turned(OffsetPath { path, origins, ..ring }, vertex)
}

/// The ring from one of its vertices.
fn turned(mut ring: OffsetPath, vertex: usize) -> OffsetPath {
    ring.path.vertices.rotate_left(vertex);
    ring.origins.rotate_left(vertex);
    ring
}
