//! The raw offset cut where it crosses itself, and the parts that lie far enough from the source.
//!
//! Between two crossings a raw offset is either everywhere at its distance from the source or nowhere:
//! to come nearer to another segment it has to cross the parallel curve of that segment. So one place
//! of each slice decides about all of it.

use super::cuts::cuts;
use super::elements::{Cut, Piece, Slice, Stretch};
use super::scratch::{Buffer, Scratch};
use super::source::Source;
use crate::{Bounds2, BoxTree, Point2, Segment, tol};

/// A slice that comes this much too near is certainly wrong. Rounding accounts for 1e-10 mm at most.
pub(super) const TOO_NEAR_MM: f64 = 1e-8;
/// A slice nearer by less than this is certainly right; in between it is kept if its neighbours need it.
const SURE_MM: f64 = 1e-10;

/// Slices, and the stretches of all of them.
pub(super) struct Slices<'a> {
    pub list: Buffer<'a, Slice>,
    parts: Buffer<'a, Stretch>,
}

impl Slices<'_> {
    /// The stretches of a slice.
    pub fn parts(&self, slice: &Slice) -> &[Stretch] {
        &self.parts[slice.from..slice.to]
    }

    /// Makes a slice of the stretches from one on.
    fn close(&mut self, from: usize) {
        self.list.push(Slice { from, to: self.parts.len(), sure: false, ring: false });
    }
}

/// The boxes of the pieces.
pub(super) fn index(scratch: &Scratch, pieces: &[Piece]) -> BoxTree {
    let margin = tol::CONTACT_MM;
    BoxTree::in_list(
        scratch.take(),
        pieces.iter().map(|p| -> Bounds2 { p.segment.bounds().grown(margin) }),
    )
}

/// The slices that are at their distance from the source; nothing when there are too many cuts.
pub(super) fn valid_slices<'a>(
    pieces: &[Piece],
    tree: &BoxTree,
    extra: &[Segment],
    source: &Source<'a>,
    distance: f64,
) -> Option<Slices<'a>> {
    let cuts = cuts(source.scratch, pieces, tree, extra)?;
    let Slices { mut list, parts } = sliced(source.scratch, pieces, &cuts);
    list.retain_mut(|slice| {
        let probe = probe(pieces, &parts[slice.from..slice.to]);
        slice.sure = !source.is_nearer(probe, distance.abs() - SURE_MM);
        slice.sure || !source.is_nearer(probe, distance.abs() - TOO_NEAR_MM)
    });
    Some(Slices { list, parts })
}

/// The middle of the longest part.
fn probe(pieces: &[Piece], parts: &[Stretch]) -> Point2 {
    let long = |p: &Stretch| pieces[p.0].segment.length() * (p.2 - p.1);
    let longest = parts.iter().max_by(|a, b| long(a).total_cmp(&long(b)));
    longest.map_or(Point2::default(), |&(k, from, to)| match (from, to) {
        (0.0, 1.0) => pieces[k].segment.middle(),
        _ => pieces[k].segment.at((from + to) * 0.5),
    })
}

/// Cuts the chains of pieces; a chain without any cut is a closed slice of its own.
fn sliced<'a>(scratch: &'a Scratch, pieces: &[Piece], cuts: &[Cut]) -> Slices<'a> {
    let mut slices = Slices { list: Buffer::new(scratch), parts: Buffer::new(scratch) };
    if cuts.is_empty() && is_one_ring(pieces) {
        slices.parts.extend((0..pieces.len()).map(|k| (k, 0.0, 1.0)));
        slices.list.push(Slice { from: 0, to: pieces.len(), sure: false, ring: true });
        return slices;
    }
    let mut first_cut = Buffer::new(scratch);
    if !cuts.is_empty() {
        first_cut.resize(pieces.len() + 1, 0);
        cuts.iter().for_each(|c| first_cut[c.0 + 1] += 1);
        (0..pieces.len()).for_each(|k| first_cut[k + 1] += first_cut[k]);
    }
    let cuts_of = |k: usize| match cuts {
        [] => &[][..],
        cuts => &cuts[first_cut[k]..first_cut[k + 1]],
    };
    let mut preceded = Buffer::filled(scratch, false, pieces.len());
    pieces.iter().filter_map(|p| p.next).for_each(|n| preceded[n] = true);
    let mut seen = Buffer::filled(scratch, false, pieces.len());
    // A chain begins where nothing precedes it; a ring anywhere, best where it is cut.
    let begins = |k: &usize| !preceded[*k];
    let cut = |k: &usize| !cuts_of(*k).is_empty();
    let order = (0..pieces.len()).filter(begins).chain((0..pieces.len()).filter(cut));
    for start in order.chain(0..pieces.len()) {
        if !seen[start] {
            chain(pieces, start, &cuts_of, &mut seen, &mut slices);
        }
    }
    // What stands in for a cut without length has done its work.
    slices.list.retain(|slice| slice.from < slice.to);
    slices
}

/// Tells whether each piece goes on into the one after it, and the last into the first.
fn is_one_ring(pieces: &[Piece]) -> bool {
    let goes_on = |k: usize| if k + 1 < pieces.len() { k + 1 } else { 0 };
    !pieces.is_empty() && pieces.iter().enumerate().all(|(k, piece)| piece.next == Some(goes_on(k)))
}

/// Cuts one chain into slices.
fn chain<'c>(
    pieces: &[Piece],
    start: usize,
    cuts_of: &impl Fn(usize) -> &'c [Cut],
    seen: &mut [bool],
    slices: &mut Slices,
) {
    let first = slices.list.len();
    let mut begin = slices.parts.len();
    let mut at = Some(start);
    let mut ring = false;
    while let Some(k) = at {
        if seen[k] {
            ring = k == start;
            break;
        }
        seen[k] = true;
        let long = if cuts_of(k).is_empty() { 0.0 } else { pieces[k].segment.length() };
        let mut from = 0.0;
        for &(_, share) in cuts_of(k) {
            if (share - from) * long > tol::SAME_PLACE_MM * 0.5 {
                slices.parts.push((k, from, share));
            }
            // At the very start a slice of nothing stands for the cut: the ring begins here and must not be
            // closed over it.
            if slices.parts.len() > begin || slices.list.len() == first {
                slices.close(begin);
            }
            begin = slices.parts.len();
            from = share.max(from);
        }
        if (1.0 - from) * long > tol::SAME_PLACE_MM * 0.5 || cuts_of(k).is_empty() {
            slices.parts.push((k, from, 1.0));
        }
        at = pieces[k].next;
    }
    let was_cut = slices.list.len() > first;
    if slices.parts.len() == begin {
        return;
    }
    if ring && was_cut {
        // The last stretch of a ring runs on into the first.
        let head = slices.list[first];
        slices.parts.extend_from_within(head.from..head.to);
        slices.list[first].to = head.from;
    }
    slices.close(begin);
    if let (true, false, Some(only)) = (ring, was_cut, slices.list.last_mut()) {
        only.ring = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::offset::path::Origin;

    /// Pieces of two lines there and back that are not cut: as many slices as there are chains.
    fn check(next: [Option<usize>; 4], slices: usize, rings: usize) {
        let (here, there) = (Point2::new(0., 0.), Point2::new(9., 0.));
        let origin = Origin { contour: 0, element: 0, corner: false };
        let lines = [Segment::line(here, there), Segment::line(there, here)];
        let piece =
            |(k, next): (usize, Option<usize>)| Piece { segment: lines[k % 2], origin, next };
        let pieces: Vec<Piece> = next.into_iter().enumerate().map(piece).collect();
        let scratch = Scratch::default();
        let found = sliced(&scratch, &pieces, &[]);
        assert_eq!(found.list.len(), slices, "{next:?}");
        assert_eq!(found.list.iter().filter(|slice| slice.ring).count(), rings, "{next:?}");
    }

    #[test]
    fn what_is_not_cut_stays_in_its_rings() {
        check([Some(1), Some(2), Some(3), Some(0)], 1, 1);
        check([Some(1), Some(0), Some(3), Some(2)], 2, 2);
        check([Some(1), Some(2), Some(3), None], 1, 0);
        check([Some(1), None, Some(3), Some(2)], 2, 1);
    }
}
