//! The parallel curves of every segment, before anything is cut away.
//!
//! ```text
//!      ╭────────── right of travel, d ──────────       a corner that opens on this side
//!      │   ┌──────────────◄─────────────               gets an arc of radius |d| about it;
//!      │   │ source                                    one that closes is cut later
//! ```

use super::elements::{Piece, Trim, Ways};
use super::path::Origin;
use super::scratch::{Buffer, Scratch};
use crate::segment::square;
use crate::{Point2, Polyarc, Segment, Vec2, tol};
use std::f64::consts::PI;

/// Angles whose arc about a corner would be shorter than this are no corners.
const NO_CORNER_MM: f64 = tol::CONTACT_MM;

/// Difference from half a turn below which the bends of curves that turn back tell the side to which: at smaller
/// angles arcs that seem to cross right behind the corner do so by less than can be told.
///
/// ```text
///    ╲╱  bent to the left: a crack between them, so that       ╭╮╭╮  to the right: a needle,
///   ╭╯╰╮ travel turns to the right                              ╲╱   travel turns to the left
/// ```
const TURNED_BACK_RAD: f64 = 1e-4;

/// The raw offset of one contour, appended to `pieces`.
pub(super) fn append(
    scratch: &Scratch,
    contour: usize,
    (segments, ways, closed): (&[Segment], &[Ways], bool),
    distance: f64,
    pieces: &mut Vec<Piece>,
) {
    let first = pieces.len();
    let count = segments.len();
    pieces.reserve(2 * count);
    for (number, (segment, way)) in segments.iter().zip(ways).enumerate() {
        let origin = Origin { contour, element: number, corner: false };
        if let Some(parallel) = beside(segment, way, distance) {
            link_to_last(pieces, first, parallel.start());
            pieces.push(Piece { segment: parallel, origin, next: None });
        }
        if number + 1 < count || closed {
            let next = if number + 1 < count { number + 1 } else { 0 };
            if let Some(arc) =
                corner([segment, &segments[next]], [way.arrives, ways[next].leaves], distance)
            {
                link_to_last(pieces, first, arc.start());
                let origin = Origin { contour, element: next, corner: true };
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
    trim_closing_corners(scratch, closed, first, pieces);
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

/// As [`parallel`] for a segment with some extent, whose direction is known.
fn beside(segment: &Segment, ways: &Ways, distance: f64) -> Option<Segment> {
    match *segment {
        Segment::Line { start, end } => {
            let right = right_of(ways.leaves, distance);
            Some(Segment::line(start + right, end + right))
        }
        Segment::Arc { .. } => parallel(segment, distance),
    }
}

/// So far to the right of a unit direction.
pub(super) fn right_of(way: Vec2, distance: f64) -> Vec2 {
    way.left() * -distance
}

/// A segment moved sideways; nothing for an arc that shrinks to its centre or beyond: everything
/// there is nearer to other parts of the arc.
pub(crate) fn parallel(segment: &Segment, distance: f64) -> Option<Segment> {
    match *segment {
        Segment::Line { start, end } if start != end => {
            let right = right_of(Ways::of(segment).leaves, distance);
            Some(Segment::line(start + right, end + right))
        }
        Segment::Line { .. } => None,
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

/// Tells whether a corner may open on the side of an offset; it does not where travel goes on or closes.
pub(super) fn may_open([u, v]: [Vec2; 2], distance: f64) -> bool {
    u.dot(v) <= 0.0 || u.cross(v) * distance > 0.0
}

/// The arc about the corner where one direction goes over to another, when it opens on the side of the offset.
pub(super) fn corner(
    [before, after]: [&Segment; 2],
    ways: [Vec2; 2],
    distance: f64,
) -> Option<Segment> {
    if !may_open(ways, distance) {
        return None;
    }
    let centre = after.start();
    let [u, v] = ways;
    let mut turn_rad = turn(u, v);
    let (back_rad, bent) = (PI - turn_rad.abs(), bend(before) + bend(after));
    if back_rad < TURNED_BACK_RAD && bent != 0.0 {
        if turn_rad * bent > 0.0 {
            turn_rad = (turn_rad.abs() - 2.0 * PI) * bent.signum();
        }
    } else if back_rad < 1e-9 {
        // Lines that turn back on the spot open on both sides.
        turn_rad = PI * distance.signum();
    }
    if turn_rad * distance.signum() <= 0.0 || turn_rad.abs() * distance.abs() < NO_CORNER_MM {
        return None;
    }
    let (start, end) = (centre + right_of(u, distance), centre + right_of(v, distance));
    Some(Segment::Arc { start, end, centre, radius: distance.abs(), sweep_rad: turn_rad })
}

/// Returns the bend of a segment, 1/mm, to the left.
fn bend(segment: &Segment) -> f64 {
    match segment {
        Segment::Line { .. } => 0.0,
        Segment::Arc { radius, sweep_rad, .. } => sweep_rad.signum() / radius,
    }
}

/// The angle from one unit direction to another. Most corners of dense contours hardly bend: six terms of the
/// series of the arc sine are exact there.
fn turn(u: Vec2, v: Vec2) -> f64 {
    let (sine, cosine) = (u.cross(v), u.dot(v));
    if sine.abs() > 0.05 || cosine < 0.0 {
        return sine.atan2(cosine);
    }
    let s = sine * sine;
    let rest = 15.0 / 336.0 + s * (105.0 / 3456.0 + s * (945.0 / 42_240.0));
    sine * (1.0 + s * (1.0 / 6.0 + s * (3.0 / 40.0 + s * rest)))
}

/// Cuts neighbours that cross at a closing corner back to where they cross. What is cut off lies nearer
/// to the neighbour than the offset, so nothing is lost, and most crossings need not be looked for.
fn trim_closing_corners(scratch: &Scratch, closed: bool, first: usize, pieces: &mut [Piece]) {
    let count = pieces.len() - first;
    if count < 2 {
        return;
    }
    let own = &mut pieces[first..];
    let after = |k: usize| if k + 1 < count { k + 1 } else { 0 };
    let joints = if closed { count } else { count - 1 };
    if own[..joints].iter().all(|piece| piece.next.is_some()) {
        return;
    }
    let mut cuts: Buffer<Trim> = Buffer::filled(scratch, None, joints);
    for (k, cut) in cuts.iter_mut().enumerate() {
        let next = after(k);
        if own[k].next.is_none() && next != k {
            let (before, after) = (&own[k].segment, &own[next].segment);
            *cut = crossing_at_joint(before, after).or_else(|| overlap_at_joint(before, after));
        }
    }
    refuse_overlapping(&mut cuts, count, closed);
    let mut kept = Buffer::filled(scratch, [0.0, 1.0], count);
    for (k, cut) in cuts.iter().enumerate() {
        if let Some([end, start]) = *cut {
            kept[k][1] = end;
            kept[after(k)][0] = start;
            own[k].next = Some(first + after(k));
        }
    }
    let place = |(k, cut): (usize, &Trim)| cut.map(|[end, _]| own[k].segment.at(end));
    let places = Buffer::of(scratch, cuts.iter().enumerate().map(place));
    for (piece, [from, to]) in own.iter_mut().zip(kept.iter().copied()) {
        if (from, to) != (0.0, 1.0) {
            piece.segment = piece.segment.part(from, to);
        }
    }
    for (k, place) in places.iter().enumerate() {
        if let Some(place) = *place {
            own[after(k)].segment.move_start(place);
        }
    }
}

/// Shares on both pieces of their crossing nearest to the corner.
fn crossing_at_joint(before: &Segment, after: &Segment) -> Trim {
    let contacts = before.meet(after);
    if contacts.along {
        return None;
    }
    let last = contacts.iter().max_by(|a, b| a.on_first.total_cmp(&b.on_first))?;
    let earliest = contacts.iter().all(|c| last.on_second <= c.on_second);
    (earliest && last.on_first > 0.0 && last.on_second < 1.0)
        .then_some([last.on_first, last.on_second])
}

/// Neighbours that overlap by less than this to the side are one curve where they do.
const ONE_CURVE_MM: f64 = 1e-10;

/// Shares on both pieces of the middle of their overlap, where curves that all but go on into each other overlap
/// so little that their crossing cannot be told: by an angle a and so by d·a along the way, but by d·a²/2 to the side.
fn overlap_at_joint(before: &Segment, after: &Segment) -> Trim {
    let (way, back) = (before.direction(1.0), before.end() - after.start());
    let (long, aside) = (way.dot(back), way.cross(back).abs());
    let (first, second) = (0.5 * long / before.length(), 0.5 * long / after.length());
    let one = long > 0.0 && aside <= ONE_CURVE_MM && way.dot(after.direction(0.0)) > 0.0;
    (one && first < 1.0 && second < 1.0).then_some([1.0 - first, second])
}

/// A piece cut from both ends must keep something; otherwise neither cut is made, and the crossings
/// that remain are found like all others.
fn refuse_overlapping(cuts: &mut [Trim], count: usize, closed: bool) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_turns_are_exact() {
        for k in -200..=200 {
            let angle = f64::from(k) * 1e-3;
            let found = turn(Vec2::new(1.0, 0.0), Vec2::from_angle(angle));
            assert!((found - angle).abs() <= 2e-16, "{angle} {found}");
        }
    }
}
