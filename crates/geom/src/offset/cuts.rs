//! Crossings of the raw offset with itself.

use super::elements::{Cut, Piece};
use super::scratch::{Buffer, Scratch};
use crate::segment::square;
use crate::{BoxTree, Point2, Segment, Vec2, tol};

/// All cuts, by piece and share.
pub(super) type Cuts<'a> = Buffer<'a, Cut>;

/// Curves whose directions differ by less at their joint are tangent.
const TANGENT_RAD: f64 = 1e-9;

/// A crossing of a line this many lengths after its start is none.
const BEYOND: f64 = 1.001;

/// More cuts than this for each piece come only from a source that crosses itself all over.
const MOST_CUTS_EACH: usize = 200;

/// All cuts, sorted by piece and share; nothing when there are too many. `extra` are curves that cut but
/// are not cut.
pub(super) fn cuts<'a>(
    scratch: &'a Scratch,
    pieces: &[Piece],
    tree: &BoxTree,
    extra: &[Segment],
) -> Option<Cuts<'a>> {
    let mut cuts = Cuts::new(scratch);
    let most = MOST_CUTS_EACH * (pieces.len() + 100);
    let all = tree.own_pairs_while(|a, b| {
        if goes_on(pieces, a, b) || goes_on(pieces, b, a) {
            return true;
        }
        let contacts = pieces[a].segment.meet(&pieces[b].segment);
        for c in contacts.iter() {
            let joint = |from: usize, to: usize, end: f64, start: f64| {
                pieces[from].next == Some(to)
                    && at_end(&pieces[from].segment, end)
                    && at_start(&pieces[to].segment, start)
            };
            if contacts.along
                || !(joint(a, b, c.on_first, c.on_second) || joint(b, a, c.on_second, c.on_first))
            {
                cuts.push((a, c.on_first));
                cuts.push((b, c.on_second));
            }
        }
        cuts.len() < most
    });
    if !all {
        return None;
    }
    for cutter in extra {
        tree.meeting(&cutter.bounds().grown(tol::CONTACT_MM), |k| {
            cuts.extend(pieces[k].segment.meet(cutter).iter().map(|c| (k, c.on_first)));
        });
    }
    cuts.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    Some(cuts)
}

/// Tells whether a piece goes on into another so that they share nothing but their joint: two lines, curves that
/// are tangent there, and a line that leaves a circle and does not come back to it.
fn goes_on(pieces: &[Piece], from: usize, to: usize) -> bool {
    if pieces[from].next != Some(to) {
        return false;
    }
    let (before, after) = (&pieces[from].segment, &pieces[to].segment);
    if pieces[to].next == Some(from) {
        // Two arcs that are a circle.
        let arcs = matches!((before, after), (Segment::Arc { .. }, Segment::Arc { .. }));
        return arcs && is_tangent(before, after) && is_tangent(after, before);
    }
    match (before, after) {
        (Segment::Line { .. }, Segment::Line { .. }) => {
            way_at(before, before.end()).dot(way_at(after, after.start())) > 0.0
        }
        (Segment::Line { start, end }, arc) => {
            is_tangent(before, after) || leaves_for_good(arc, after.start(), *start - *end)
        }
        (arc, Segment::Line { start, end }) => {
            is_tangent(before, after) || leaves_for_good(arc, before.end(), *end - *start)
        }
        (Segment::Arc { .. }, Segment::Arc { .. }) => is_tangent(before, after),
    }
}

/// Tells whether travel goes straight on from one segment into another.
fn is_tangent(before: &Segment, after: &Segment) -> bool {
    let (u, v) = (way_at(before, before.end()), way_at(after, after.start()));
    u.dot(v) > 0.0 && u.cross(v).powi(2) < TANGENT_RAD * TANGENT_RAD * square(u) * square(v)
}

/// The way along a segment at one of its ends, of any length; that of a line is the whole line.
fn way_at(segment: &Segment, end: Point2) -> Vec2 {
    match *segment {
        Segment::Line { start, end } => end - start,
        Segment::Arc { centre, sweep_rad, .. } => (end - centre).left() * sweep_rad.signum(),
    }
}

/// Tells whether a line from a place of a circle does not come to its other crossing with the circle, after
/// −2 w·ρ / w² of it, where ρ is the radius at the place and w the line.
fn leaves_for_good(arc: &Segment, place: Point2, line: Vec2) -> bool {
    let Segment::Arc { centre, .. } = *arc else { return false };
    -2.0 * line.dot(place - centre) > BEYOND * square(line) || line.dot(place - centre) >= 0.0
}

fn at_end(segment: &Segment, share: f64) -> bool {
    (1.0 - share) * segment.length() <= tol::SAME_PLACE_MM
}

fn at_start(segment: &Segment, share: f64) -> bool {
    share * segment.length() <= tol::SAME_PLACE_MM
}
