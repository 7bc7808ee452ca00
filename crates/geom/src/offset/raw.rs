//! The parallel curves of every segment, before anything is cut away.
//!
//! ```text
//!      ╭────────── right of travel, d ──────────       a corner that opens on this side
//!      │   ┌──────────────◄─────────────               gets an arc of radius |d| about it;
//!      │   │ source                                    one that closes is cut later
//! ```

use super::Origin;
use crate::segment::square;
use crate::{Point2, Polyarc, Segment, Vec2, tol};

/// A parallel line or arc, or the arc about a corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub segment: Segment,
    pub origin: Origin,
    /// The piece that starts where this one ends.
    pub next: Option<usize>,
}

/// Angles whose arc about a corner would be shorter than this are no corners.
const NO_CORNER_MM: f64 = tol::CONTACT_MM;

/// The raw offset of one contour, appended to `pieces`.
pub(super) fn append(
    contour: usize,
    (segments, closed): (&[Segment], bool),
    distance: f64,
    pieces: &mut Vec<Piece>,
) {
    let first = pieces.len();
    let count = segments.len();
    pieces.reserve(2 * count);
    for (number, segment) in segments.iter().enumerate() {
        let origin = Origin { contour, element: number, corner: false };
        if let Some(parallel) = parallel(segment, distance) {
            link_to_last(pieces, first, parallel.start());
            pieces.push(Piece { segment: parallel, origin, next: None });
        }
        if number + 1 < count || closed {
            let after = &segments[(number + 1) % count];
            if let Some(arc) = corner(segment, after, distance) {
                link_to_last(pieces, first, arc.start());
                let origin = Origin { contour, element: (number + 1) % count, corner: true };
                pieces.push(Piece { segment: arc, origin, next: None });
            }
        }
    }
    if closed && pieces.len() > first {
        let (start, end) = (pieces[first].segment.start(), pieces[pieces.len() - 1].segment.end());
        if is_near(start, end) {
            let last = pieces.len() - 1;
            pieces[last].next = Some(first);
        }
    }
    trim_closing_corners(closed, first, pieces);
}

fn is_near(a: Point2, b: Point2) -> bool {
    square(a - b) <= tol::SAME_PLACE_MM * tol::SAME_PLACE_MM
}

fn link_to_last(pieces: &mut [Piece], first: usize, start: Point2) {
    let next = pieces.len();
    if let Some(last) = pieces[first..].last_mut()
        && is_near(last.segment.end(), start)
    {
        last.next = Some(next);
    }
}

/// A segment moved sideways; nothing for an arc that shrinks to its centre or beyond: everything
/// there is nearer to other parts of the arc.
pub(crate) fn parallel(segment: &Segment, distance: f64) -> Option<Segment> {
    match *segment {
        Segment::Line { start, end } => {
            let way = end - start;
            let long = square(way).sqrt();
            if long == 0.0 {
                return None;
            }
            let right = -way.left() * (distance / long);
            Some(Segment::line(start + right, end + right))
        }
        Segment::Arc { start, end, centre, radius, sweep_rad } => {
            let wider = radius + distance * sweep_rad.signum();
            if wider <= tol::SAME_PLACE_MM {
                return None;
            }
            let grown = wider / radius;
            let (start, end) = (centre + (start - centre) * grown, centre + (end - centre) * grown);
            Some(Segment::Arc { start, end, centre, radius: wider, sweep_rad })
        }
    }
}

/// The arc about the corner between two segments, when it opens on the side of the offset.
pub(super) fn corner(before: &Segment, after: &Segment, distance: f64) -> Option<Segment> {
    let (u, v) = (before.direction(1.0), after.direction(0.0));
    if u.dot(v) > 0.0 && u.cross(v) * distance <= 0.0 {
        return None;
    }
    let mut turn_rad = u.cross(v).atan2(u.dot(v));
    // A path that turns back on the spot opens on both sides.
    if std::f64::consts::PI - turn_rad.abs() < 1e-9 {
        turn_rad = std::f64::consts::PI * distance.signum();
    }
    if turn_rad * distance.signum() <= 0.0 || turn_rad.abs() * distance.abs() < NO_CORNER_MM {
        return None;
    }
    let centre = before.end();
    let right = |direction: Vec2| centre - direction.left() * distance;
    let (start, end) = (right(u), right(v));
    Some(Segment::Arc { start, end, centre, radius: distance.abs(), sweep_rad: turn_rad })
}

/// Cuts neighbours that cross at a closing corner back to where they cross. What is cut off lies nearer
/// to the neighbour than the offset, so nothing is lost, and most crossings need not be looked for.
fn trim_closing_corners(closed: bool, first: usize, pieces: &mut [Piece]) {
    let count = pieces.len() - first;
    if count < 2 {
        return;
    }
    let own = &mut pieces[first..];
    let joints = if closed { count } else { count - 1 };
    if own[..joints].iter().all(|piece| piece.next.is_some()) {
        return;
    }
    let mut cuts: Vec<Option<[f64; 2]>> = vec![None; joints];
    for (k, cut) in cuts.iter_mut().enumerate() {
        let next = (k + 1) % count;
        if own[k].next.is_none() && next != k {
            *cut = crossing_at_joint(&own[k].segment, &own[next].segment);
        }
    }
    refuse_overlapping(&mut cuts, count, closed);
    let mut kept: Vec<[f64; 2]> = vec![[0.0, 1.0]; count];
    for (k, cut) in cuts.iter().enumerate() {
        if let Some([end, start]) = *cut {
            kept[k][1] = end;
            kept[(k + 1) % count][0] = start;
            own[k].next = Some(first + (k + 1) % count);
        }
    }
    let places: Vec<Option<Point2>> = cuts
        .iter()
        .enumerate()
        .map(|(k, cut)| cut.map(|[end, _]| own[k].segment.at(end)))
        .collect();
    for (piece, [from, to]) in own.iter_mut().zip(kept) {
        if (from, to) != (0.0, 1.0) {
            piece.segment = piece.segment.part(from, to);
        }
    }
    for (k, place) in places.iter().enumerate() {
        if let Some(place) = *place {
            own[(k + 1) % count].segment.move_start(place);
        }
    }
}

/// Shares on both pieces of their crossing nearest to the corner.
fn crossing_at_joint(before: &Segment, after: &Segment) -> Option<[f64; 2]> {
    let contacts = before.meet(after);
    if contacts.along {
        return None;
    }
    let last = contacts.iter().max_by(|a, b| a.on_first.total_cmp(&b.on_first))?;
    let earliest = contacts.iter().all(|c| last.on_second <= c.on_second);
    (earliest && last.on_first > 0.0 && last.on_second < 1.0)
        .then_some([last.on_first, last.on_second])
}

/// A piece cut from both ends must keep something; otherwise neither cut is made, and the crossings
/// that remain are found like all others.
fn refuse_overlapping(cuts: &mut [Option<[f64; 2]>], count: usize, closed: bool) {
    for k in 0..count {
        let before = if k > 0 { Some(k - 1) } else { closed.then_some(count - 1) };
        let (Some(before), true) = (before, k < cuts.len()) else { continue };
        if let (Some([_, start]), Some([end, _])) = (cuts[before], cuts[k])
            && start >= end
        {
            cuts[before] = None;
            cuts[k] = None;
        }
    }
}

/// Circles about the ends of open contours: they cut what comes too near to an end.
pub(super) fn caps(contours: &[Polyarc], distance: f64) -> Vec<Segment> {
    let mut caps = Vec::new();
    for contour in contours.iter().filter(|c| !c.closed) {
        for centre in [contour.start(), contour.end()].into_iter().flatten() {
            caps.extend(Polyarc::circle(centre, distance.abs()).segments());
        }
    }
    caps
}
