//! Parts of the raw offset that certainly lie too near to the source, dropped before crossings are looked for.
//!
//! Where a contour is dense and the distance large, most of the raw offset is of this kind, and it crosses itself
//! all over.

use super::elements::Piece;
use super::scratch::Buffer;
use super::slices::TOO_NEAR_MM;
use super::source::Source;
use crate::{BoxTree, Segment};

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

/// Finder of parts that lie too near to the source.
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

    /// Finds the beginning of the first part, or the end of the last one, of which something may remain.
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

/// Tells whether pieces crowd together, so that most of them must be buried. A quick look at a part of the path
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
