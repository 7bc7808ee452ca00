//! Crossings of polyarcs with each other and with themselves.

use super::Polyarc;
use super::place::PolyarcPlace;
use crate::{Bounds2, BoxTree, Segment, tol};

/// A place that two polyarcs, or two parts of one, share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The place on the first.
    pub first: PolyarcPlace,
    /// The place on the second.
    pub second: PolyarcPlace,
    /// The two run along each other here; this is an end of the stretch they share.
    pub along: bool,
}

/// All places that two polyarcs share, in the order of travel along the first.
pub(super) fn crossings(first: &Polyarc, second: &Polyarc) -> Vec<Crossing> {
    let (mine, theirs) = (Listed::new(first), Listed::new(second));
    let mut found = Vec::new();
    mine.index.pairs(&theirs.index, |a, b| {
        add_contacts(&mine.segments, a, &theirs.segments, b, &mut found);
    });
    in_order(found, (mine.segments.len(), theirs.segments.len()))
}

/// All places where a polyarc crosses or touches itself, in the order of travel.
pub(super) fn self_crossings(path: &Polyarc) -> Vec<Crossing> {
    let mine = Listed::new(path);
    let count = mine.segments.len();
    let mut found = Vec::new();
    mine.index.own_pairs(|a, b| {
        add_contacts(&mine.segments, a, &mine.segments, b, &mut found);
    });
    found.retain(|c| !is_joint(path, c, count));
    in_order(found, (count, count))
}

/// One of these places, without a look for the others.
pub(super) fn crosses_itself(path: &Polyarc) -> Option<Crossing> {
    let mine = Listed::new(path);
    let (count, mut found) = (mine.segments.len(), Vec::new());
    mine.index.own_pairs_while(|a, b| {
        add_contacts(&mine.segments, a, &mine.segments, b, &mut found);
        found.retain(|c| !is_joint(path, c, count));
        found.is_empty()
    });
    found.pop()
}

/// Tells whether a crossing is only the joint between a segment and the next.
fn is_joint(path: &Polyarc, c: &Crossing, count: usize) -> bool {
    let near = |place: &PolyarcPlace, segment: usize, end: bool| {
        place.segment == segment && {
            let s = path.segment(segment);
            place.at.distance(if end { s.end() } else { s.start() }) <= tol::SAME_PLACE_MM
        }
    };
    let follows = |a: &PolyarcPlace, b: &PolyarcPlace| {
        let next = if path.closed { (a.segment + 1) % count } else { a.segment + 1 };
        next == b.segment && near(a, a.segment, true) && near(b, b.segment, false)
    };
    !c.along && (follows(&c.first, &c.second) || follows(&c.second, &c.first))
}

struct Listed {
    segments: Vec<Segment>,
    index: BoxTree,
}

impl Listed {
    fn new(polyarc: &Polyarc) -> Self {
        let segments: Vec<Segment> = polyarc.segments().collect();
        let boxes = segments.iter().map(|s| -> Bounds2 { s.bounds().grown(tol::CONTACT_MM) });
        let index = BoxTree::new(boxes);
        Self { segments, index }
    }
}

fn add_contacts(first: &[Segment], a: usize, second: &[Segment], b: usize, to: &mut Vec<Crossing>) {
    let contacts = first[a].meet(&second[b]);
    to.extend(contacts.iter().map(|c| Crossing {
        first: PolyarcPlace { segment: a, share: c.on_first, at: c.at },
        second: PolyarcPlace { segment: b, share: c.on_second, at: c.at },
        along: contacts.along,
    }));
}

/// Sorts crossings along the first polyarc and keeps one where several segments meet at their ends.
fn in_order(mut found: Vec<Crossing>, counts: (usize, usize)) -> Vec<Crossing> {
    let key = |c: &Crossing| (c.first.segment, c.first.share, c.second.segment, c.second.share);
    found.sort_by(|a, b| {
        let (a, b) = (key(a), key(b));
        (a.0.cmp(&b.0)).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)).then(a.3.total_cmp(&b.3))
    });
    let near = |a: &PolyarcPlace, b: &PolyarcPlace, count: usize| {
        let apart = a.segment.abs_diff(b.segment);
        a.at.distance(b.at) <= tol::SAME_PLACE_MM && (apart <= 1 || apart + 1 == count)
    };
    let same = |a: &Crossing, b: &Crossing| {
        near(&a.first, &b.first, counts.0) && near(&a.second, &b.second, counts.1)
    };
    let mut kept: Vec<Crossing> = Vec::with_capacity(found.len());
    for c in found {
        // Sorted along the first polyarc, the same place is among the last few or the first.
        let mut candidates = kept.iter().rev().take(4).chain(kept.iter().take(4));
        let seen = candidates.any(|k| same(k, &c));
        if !seen {
            kept.push(c);
        }
    }
    kept
}
