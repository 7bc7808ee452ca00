//! Many short segments in a row, most of which a few sums show to be far from a place.

use super::chord::{BLOCK, Block, Chord};
use super::elements::Range2;
use super::scratch::Buffer;
use super::source::Source;
use crate::Point2;

/// All segments of a source, in blocks.
pub(super) struct Chains<'a> {
    chords: Buffer<'a, Chord>,
    blocks: Buffer<'a, Block>,
}

impl<'a> Chains<'a> {
    /// For limits of no more than a distance.
    pub fn of(source: &Source<'a>, most: f64) -> Self {
        let of = |s| Chord::of(s, most);
        let chords = Buffer::of(source.scratch, source.segments().iter().map(of));
        let blocks = Buffer::of(source.scratch, chords.chunks(BLOCK).map(Block::of));
        Self { chords, blocks }
    }

    /// Tells whether a segment of a run lies nearer to a place than a limit.
    pub fn is_nearer(
        &self,
        source: &Source,
        (from, to): Range2,
        place: Point2,
        limit: f64,
    ) -> bool {
        let square = limit * limit;
        let near = |k: usize| {
            self.chords[k].may_be_nearer(place, square)
                && source.segments()[k].is_nearer(place, limit)
        };
        let (first, last) = (from / BLOCK, to.div_ceil(BLOCK));
        self.blocks[first..last].iter().zip(first..).any(|(block, number)| {
            block.may_be_nearer(place, square)
                && (number * BLOCK..((number + 1) * BLOCK).min(to)).any(near)
        })
    }
}
