//! The raw offset cut where it crosses itself, and the parts that lie far enough from the source.
//!
//! Between two crossings a raw offset is either everywhere at its distance from the source or nowhere:
//! to come nearer to another segment it has to cross the parallel curve of that segment. So one place
//! of each slice decides about all of it.

use super::raw::Piece;
use super::scratch::{Buffer, Scratch};
use super::source::Source;
use crate::segment::square;
use crate::{Bounds2, BoxTree, Point2, Segment, Vec2, tol};

/// A slice that comes this much too near is certainly wrong. Rounding accounts for 1e-10 mm at most.
const TOO_NEAR_MM: f64 = 1e-8;
/// A slice nearer by less than this is certainly right; in between it is kept if its neighbours need it.
const SURE_MM: f64 = 1e-10;

/// A piece's number and the shares between which it belongs to something.
pub(super) type Stretch = (usize, f64, f64);

/// A stretch of consecutive pieces without crossings inside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slice {
    /// Its stretches are these of the list of all.
    from: usize,
    to: usize,
    pub sure: bool,
    /// It was cut nowhere and comes back to where it begins.
    pub ring: bool,
}

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

/// Where on a piece the raw offset is cut.
pub(super) type Cut = (usize, f64);

/// All cuts, by piece and share.
type Cuts<'a> = Buffer<'a, Cut>;

/// Drops pieces, and ends of pieces, that lie wholly too near to one source segment: nothing of them can remain,
/// and no cut they make on others can matter. By the triangle inequality a part of length l about a place m
/// comes nowhere farther away than m is, plus l/2.
pub(super) fn drop_buried(pieces: &mut Vec<Piece>, source: &Source, distance: f64) {
    let buried = Buried { source, distance };
    let shown = Buffer::of(source.scratch, pieces.iter().map(|p| buried.shown(&p.segment)));
    let gone = |shares: &[f64; 2]| shares[0] >= shares[1];
    let mut renumbered: Buffer<usize> = Buffer::new(source.scratch);
    let mut count = 0;
    for shares in shown.iter() {
        renumbered.push(count);
        count += usize::from(!gone(shares));
    }
    let goes_on =
        |from: usize, to: usize| shown[from][1] == 1.0 && shown[to][0] == 0.0 && !gone(&shown[to]);
    for (n, piece) in pieces.iter_mut().enumerate() {
        piece.segment = piece.segment.part(shown[n][0], shown[n][1]);
        piece.next = piece.next.filter(|next| goes_on(n, *next)).map(|next| renumbered[next]);
    }
    let mut keep = shown.iter().map(|shares| !gone(shares));
    pieces.retain(|_| keep.next().unwrap_or(true));
}

/// Ends of pieces are dropped in parts no shorter than this share of the distance.
const LEAST_PART: f64 = 1.0 / 64.0;

/// What lies too near to the source.
struct Buried<'a, 's> {
    source: &'a Source<'s>,
    distance: f64,
}

impl Buried<'_, '_> {
    /// Between which shares of a segment something may remain; the first is no less than the second when nothing
    /// does.
    fn shown(&self, segment: &Segment) -> [f64; 2] {
        let parts = segment.length() / (LEAST_PART * self.distance.abs());
        let halvings = parts.log2().floor().clamp(0.0, 16.0) as u32;
        let from = self.first(segment, [0.0, 1.0], halvings, false);
        let to = from.and_then(|_| self.first(segment, [0.0, 1.0], halvings, true));
        from.zip(to).map_or([1.0, 0.0], |(from, to)| [from, to])
    }

    /// Where the first part begins, or the last one ends, of which something may remain.
    fn first(
        &self,
        segment: &Segment,
        [from, to]: [f64; 2],
        halvings: u32,
        back: bool,
    ) -> Option<f64> {
        let middle = 0.5 * (from + to);
        let limit = self.distance.abs() - TOO_NEAR_MM - 0.5 * (to - from) * segment.length();
        if limit > 0.0 && self.source.is_nearer(segment.at(middle), limit) {
            return None;
        }
        if halvings == 0 {
            return Some(if back { to } else { from });
        }
        let halves =
            if back { [[middle, to], [from, middle]] } else { [[from, middle], [middle, to]] };
        halves.into_iter().find_map(|half| self.first(segment, half, halvings - 1, back))
    }
}

/// Fewer pieces than this are never many too many.
const FEW: usize = 200;

/// Whether pieces crowd together, so that most of them must be buried. A quick look at a part of the path
/// tells enough.
pub(super) fn is_crowded(tree: &BoxTree) -> bool {
    if tree.len() < FEW {
        return false;
    }
    let step = tree.len() / 32 + 1;
    let (mut asked, mut pairs) = (0usize, 0usize);
    for k in (0..tree.len()).step_by(step) {
        asked += 1;
        tree.meeting(tree.leaf(k), |_| pairs += 1);
    }
    pairs > asked * 8
}

/// The boxes of the pieces.
pub(super) fn index(scratch: &Scratch, pieces: &[Piece]) -> BoxTree {
    let margin = tol::CONTACT_MM;
    BoxTree::in_list(
        scratch.take(),
        pieces.iter().map(|p| -> Bounds2 { p.segment.bounds().grown(margin) }),
    )
}

/// Curves whose directions differ by less at their joint are tangent.
const TANGENT_RAD: f64 = 1e-9;

/// A crossing of a line this many lengths after its start is none.
const BEYOND: f64 = 1.001;

/// More cuts than this for each piece come only from a source that crosses itself all over.
const MOST_CUTS_EACH: usize = 200;

/// All cuts, sorted by piece and share; nothing when there are too many. `extra` are curves that cut but
/// are not cut.
fn cuts<'a>(
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

/// Whether a piece goes on into another so that they share nothing but their joint: two lines, curves that
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

/// Whether travel goes straight on from one segment into another.
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

/// Whether a line from a place of a circle does not come to its other crossing with the circle, after
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

/// Whether each piece goes on into the one after it, and the last into the first.
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
