//! Crossings of polyarcs with each other and with themselves.

use super::{Place, Polyarc};
use crate::{Bounds2, BoxTree, Segment, tol};

/// A place that two polyarcs, or two parts of one, share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The place on the first.
    pub first: Place,
    /// The place on the second.
    pub second: Place,
    /// The two run along each other here; this is an end of the stretch they share.
    pub along: bool,
}

impl Polyarc {
    /// The boxes of all segments, for finding them by place.
    pub fn index(&self) -> BoxTree {
        BoxTree::new(self.segments().map(|s| s.bounds().grown(tol::CONTACT_MM)))
    }

    /// All places shared with another polyarc, in the order of travel along this one. Touching counts.
    pub fn crossings(&self, other: &Self) -> Vec<Crossing> {
        let (mine, theirs) = (Listed::new(self), Listed::new(other));
        let mut found = Vec::new();
        mine.index.pairs(&theirs.index, |a, b| {
            add_contacts(&mine.segments, a, &theirs.segments, b, &mut found);
        });
        in_order(found, (mine.segments.len(), theirs.segments.len()))
    }

    /// All places where the polyarc crosses or touches itself, in the order of travel; the joints of
    /// neighbouring segments are none.
    pub fn self_crossings(&self) -> Vec<Crossing> {
        let mine = Listed::new(self);
        let count = mine.segments.len();
        let mut found = Vec::new();
        mine.index.own_pairs(|a, b| {
            add_contacts(&mine.segments, a, &mine.segments, b, &mut found);
        });
        found.retain(|c| !self.is_joint(c, count));
        in_order(found, (count, count))
    }

    /// One of the places where the polyarc crosses or touches itself; it does not look for the others.
    pub fn crosses_itself(&self) -> Option<Crossing> {
        let mine = Listed::new(self);
        let (count, mut found) = (mine.segments.len(), Vec::new());
        mine.index.own_pairs_while(|a, b| {
            add_contacts(&mine.segments, a, &mine.segments, b, &mut found);
            found.retain(|c| !self.is_joint(c, count));
            found.is_empty()
        });
        found.pop()
    }

    /// Returns `true` if the polyarc is closed and neither crosses nor touches itself.
    pub fn is_simple(&self) -> bool {
        self.closed && self.segment_count() > 1 && self.crosses_itself().is_none()
    }

    /// Tells whether a crossing is only the joint between a segment and the next.
    fn is_joint(&self, c: &Crossing, count: usize) -> bool {
        let near = |place: &Place, segment: usize, end: bool| {
            place.segment == segment && {
                let s = self.segment(segment);
                place.at.distance(if end { s.end() } else { s.start() }) <= tol::SAME_PLACE_MM
            }
        };
        let follows = |a: &Place, b: &Place| {
            let next = if self.closed { (a.segment + 1) % count } else { a.segment + 1 };
            next == b.segment && near(a, a.segment, true) && near(b, b.segment, false)
        };
        !c.along && (follows(&c.first, &c.second) || follows(&c.second, &c.first))
    }
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
        first: Place { segment: a, share: c.on_first, at: c.at },
        second: Place { segment: b, share: c.on_second, at: c.at },
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
    let near = |a: &Place, b: &Place, count: usize| {
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
