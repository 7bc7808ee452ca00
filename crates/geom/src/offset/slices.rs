//! The raw offset cut where it crosses itself, and the parts that lie far enough from the source.
//!
//! Between two crossings a raw offset is either everywhere at its distance from the source or nowhere:
//! to come nearer to another segment it has to cross the parallel curve of that segment. So one place
//! of each slice decides about all of it.

use super::raw::Piece;
use super::source::Source;
use crate::{Bounds2, BoxTree, Point2, Segment, tol};

/// A slice that comes this much too near is certainly wrong. Rounding accounts for 1e-10 mm at most.
const TOO_NEAR_MM: f64 = 1e-8;
/// A slice nearer by less than this is certainly right; in between it is kept if its neighbours need it.
const SURE_MM: f64 = 1e-10;

/// A piece's number and the shares between which it belongs to something.
pub(super) type Stretch = (usize, f64, f64);

/// A stretch of consecutive pieces without crossings inside.
#[derive(Debug)]
pub(super) struct Slice {
    pub parts: Vec<Stretch>,
    pub sure: bool,
    /// It was cut nowhere and comes back to where it begins.
    pub ring: bool,
}

/// Where on pieces the raw offset is cut.
type Cuts = Vec<(usize, f64)>;

/// Drops pieces that lie wholly too near to one source segment: nothing of them can remain, and no cut
/// they make on others can matter. By the triangle inequality a piece of length l about a place m
/// comes nowhere farther away than m is, plus l/2.
pub(super) fn drop_buried(pieces: &mut Vec<Piece>, source: &Source, distance: f64) {
    let buried: Vec<bool> = pieces
        .iter()
        .map(|p| {
            let limit = distance.abs() - TOO_NEAR_MM - p.segment.length() * 0.5;
            limit > 0.0 && source.is_nearer(p.segment.at(0.5), limit)
        })
        .collect();
    let mut renumbered = Vec::with_capacity(pieces.len());
    let mut count = 0;
    for &gone in &buried {
        renumbered.push((!gone).then_some(count));
        count += usize::from(!gone);
    }
    let mut keep = buried.iter().map(|gone| !gone);
    pieces.retain(|_| keep.next().unwrap_or(true));
    for piece in pieces.iter_mut() {
        piece.next = piece.next.and_then(|n| renumbered[n]);
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
pub(super) fn index(pieces: &[Piece]) -> BoxTree {
    let margin = tol::CONTACT_MM;
    BoxTree::new(pieces.iter().map(|p| -> Bounds2 { p.segment.bounds().grown(margin) }))
}

/// Curves whose directions differ by less at their joint are tangent.
const TANGENT_RAD: f64 = 1e-9;

/// More cuts than this for each piece come only from a source that crosses itself all over.
const MOST_CUTS_EACH: usize = 200;

/// All cuts, sorted by piece and share; nothing when there are too many. `extra` are curves that cut but
/// are not cut.
fn cuts(pieces: &[Piece], tree: &BoxTree, extra: &[Segment]) -> Option<Cuts> {
    let mut cuts = Cuts::new();
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

/// Whether a piece goes on into another so that they share nothing but their joint: two lines, or curves
/// that are tangent there.
fn goes_on(pieces: &[Piece], from: usize, to: usize) -> bool {
    let (before, after) = (&pieces[from], &pieces[to]);
    if before.next != Some(to) || after.next == Some(from) {
        return false;
    }
    let (u, v) = (before.segment.direction(1.0), after.segment.direction(0.0));
    let lines =
        |a: &Segment, b: &Segment| matches!((a, b), (Segment::Line { .. }, Segment::Line { .. }));
    let onward = u.dot(v) > 0.0;
    onward && (lines(&before.segment, &after.segment) || u.cross(v).abs() < TANGENT_RAD)
}

fn at_end(segment: &Segment, share: f64) -> bool {
    (1.0 - share) * segment.length() <= tol::SAME_PLACE_MM
}

fn at_start(segment: &Segment, share: f64) -> bool {
    share * segment.length() <= tol::SAME_PLACE_MM
}

/// The slices that are at their distance from the source; nothing when there are too many cuts.
pub(super) fn valid_slices(
    pieces: &[Piece],
    tree: &BoxTree,
    extra: &[Segment],
    source: &Source,
    distance: f64,
) -> Option<Vec<Slice>> {
    let cuts = cuts(pieces, tree, extra)?;
    let mut slices = Vec::new();
    for (parts, ring) in sliced(pieces, &cuts) {
        let probe = probe(pieces, &parts);
        if source.is_nearer(probe, distance.abs() - TOO_NEAR_MM) {
            continue;
        }
        let sure = !source.is_nearer(probe, distance.abs() - SURE_MM);
        slices.push(Slice { parts, sure, ring });
    }
    Some(slices)
}

/// The middle of the longest part.
fn probe(pieces: &[Piece], parts: &[Stretch]) -> Point2 {
    let long = |p: &(usize, f64, f64)| pieces[p.0].segment.length() * (p.2 - p.1);
    let longest = parts.iter().max_by(|a, b| long(a).total_cmp(&long(b)));
    longest.map_or(Point2::default(), |&(k, from, to)| pieces[k].segment.at((from + to) * 0.5))
}

/// Cuts the chains of pieces; a chain without any cut is a closed slice of its own.
fn sliced(pieces: &[Piece], cuts: &Cuts) -> Vec<(Vec<Stretch>, bool)> {
    let mut first_cut = vec![0; pieces.len() + 1];
    cuts.iter().for_each(|c| first_cut[c.0 + 1] += 1);
    (0..pieces.len()).for_each(|k| first_cut[k + 1] += first_cut[k]);
    let cuts_of = |k: usize| &cuts[first_cut[k]..first_cut[k + 1]];
    let mut preceded = vec![false; pieces.len()];
    pieces.iter().filter_map(|p| p.next).for_each(|n| preceded[n] = true);
    let mut seen = vec![false; pieces.len()];
    let (mut slices, mut current) = (Vec::new(), Vec::new());
    // A chain begins where nothing precedes it; a ring anywhere, best where it is cut.
    let begins = |k: &usize| !preceded[*k];
    let cut = |k: &usize| !cuts_of(*k).is_empty();
    let order = (0..pieces.len()).filter(begins).chain((0..pieces.len()).filter(cut));
    for start in order.chain(0..pieces.len()) {
        if seen[start] {
            continue;
        }
        let begin = slices.len();
        let whole = chain(pieces, start, &cuts_of, &mut seen, &mut current);
        slices.extend(current.drain(..).map(|parts| (parts, false)));
        if let (true, [only]) = (whole, &mut slices[begin..]) {
            only.1 = true;
        }
    }
    slices
}

/// Cuts one chain into slices, of which there are none yet; whether it is a ring that was cut nowhere.
fn chain<'c>(
    pieces: &[Piece],
    start: usize,
    cuts_of: &impl Fn(usize) -> &'c [(usize, f64)],
    seen: &mut [bool],
    slices: &mut Vec<Vec<Stretch>>,
) -> bool {
    let mut current = Vec::new();
    let mut at = Some(start);
    let mut ring = false;
    while let Some(k) = at {
        if seen[k] {
            ring = k == start;
            break;
        }
        seen[k] = true;
        let long = pieces[k].segment.length();
        let mut from = 0.0;
        for &(_, share) in cuts_of(k) {
            if (share - from) * long > tol::SAME_PLACE_MM * 0.5 {
                current.push((k, from, share));
            }
            if !current.is_empty() {
                slices.push(std::mem::take(&mut current));
            } else if slices.is_empty() {
                // A cut at the very start: the ring begins here and must not be closed over it.
                slices.push(Vec::new());
            }
            from = share.max(from);
        }
        if (1.0 - from) * long > tol::SAME_PLACE_MM * 0.5 || cuts_of(k).is_empty() {
            current.push((k, from, 1.0));
        }
        at = pieces[k].next;
    }
    let whole = ring && slices.is_empty();
    if !current.is_empty() {
        if ring && !slices.is_empty() {
            // The last stretch of a ring runs on into the first.
            let head = std::mem::take(&mut slices[0]);
            current.extend(head);
        }
        slices.push(current);
    }
    // What stands in for a cut without length has done its work.
    slices.retain(|slice| !slice.is_empty());
    whole
}
