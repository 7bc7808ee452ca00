//! Buffers that are used again.
//!
//! An offset needs a dozen lists for a moment. To ask the system for each of them anew takes as long as to fill
//! it: a sheet has a thousand small shapes, and the lists of a long contour are handed back page by page.
//! So lists that are done with wait in a [`Scratch`], by type, until the next step or the next shape needs one.

use super::chord::{Block, Chord};
use super::elements::{Cut, Part, Piece, Range2, Slice, Stretch, Trim, Ways};
use crate::stitch::Strand;
use crate::{Bounds2, Point2, Segment, Vertex};
use std::cell::RefCell;
use std::ops::{Deref, DerefMut};

/// So many lists of a type wait; more than are in use at once are not needed.
const MOST_WAITING: usize = 8;

/// Larger ones go back to the system.
const MOST_BYTES: usize = 1 << 24;

/// Lists of one type that wait.
type WaitingLists<T> = RefCell<Vec<Vec<T>>>;

/// Type of the elements of lists that are kept.
pub(super) trait Kept: Copy {
    /// Returns the shelf on which its lists wait.
    fn shelf(scratch: &Scratch) -> &WaitingLists<Self>;
}

/// A shelf for each type.
macro_rules! shelves {
    ($($name:ident: $type:ty),+ $(,)?) => {
        /// Lists of all types that an offset needs.
        #[derive(Default)]
        pub(super) struct Scratch {
            $($name: WaitingLists<$type>),+
        }
        $(impl Kept for $type {
            fn shelf(scratch: &Scratch) -> &WaitingLists<Self> {
                &scratch.$name
            }
        })+
    };
}

shelves! {
    flags: bool,
    numbers: usize,
    boxes: Bounds2,
    segments: Segment,
    vertices: Vertex,
    ways: Ways,
    ranges: Range2,
    chords: Chord,
    blocks: Block,
    pieces: Piece,
    trims: Trim,
    shares: [f64; 2],
    places: Option<Point2>,
    slices: Slice,
    stretches: Stretch,
    cuts: Cut,
    parts: Part,
    strands: Strand,
}

impl Scratch {
    /// An empty list, one that has waited if there is one.
    pub fn take<T: Kept>(&self) -> Vec<T> {
        T::shelf(self).borrow_mut().pop().unwrap_or_default()
    }

    /// Puts a list aside for the next who needs one.
    pub fn give<T: Kept>(&self, mut list: Vec<T>) {
        let bytes = list.capacity() * size_of::<T>();
        let mut shelf = T::shelf(self).borrow_mut();
        if bytes > 0 && bytes <= MOST_BYTES && shelf.len() < MOST_WAITING {
            list.clear();
            shelf.push(list);
        }
    }
}

/// A list that goes back to its shelf.
pub(super) struct Buffer<'s, T: Kept> {
    list: Vec<T>,
    scratch: &'s Scratch,
}

impl<'s, T: Kept> Buffer<'s, T> {
    /// An empty one.
    pub fn new(scratch: &'s Scratch) -> Self {
        Self { list: scratch.take(), scratch }
    }

    /// As many times the same.
    pub fn filled(scratch: &'s Scratch, value: T, count: usize) -> Self {
        let mut buffer = Self::new(scratch);
        buffer.resize(count, value);
        buffer
    }

    /// One with items.
    pub fn of(scratch: &'s Scratch, items: impl IntoIterator<Item = T>) -> Self {
        let mut buffer = Self::new(scratch);
        buffer.extend(items);
        buffer
    }
}

impl<T: Kept> Drop for Buffer<'_, T> {
    fn drop(&mut self) {
        self.scratch.give(std::mem::take(&mut self.list));
    }
}

impl<T: Kept> Deref for Buffer<'_, T> {
    type Target = Vec<T>;
    fn deref(&self) -> &Vec<T> {
        &self.list
    }
}

impl<T: Kept> DerefMut for Buffer<'_, T> {
    fn deref_mut(&mut self) -> &mut Vec<T> {
        &mut self.list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_put_aside_comes_back_empty() {
        let scratch = Scratch::default();
        let mut buffer: Buffer<usize> = Buffer::of(&scratch, 0..1000);
        let place = buffer.as_ptr();
        buffer[3] = 4;
        drop(buffer);
        let again: Buffer<usize> = Buffer::new(&scratch);
        assert!(again.is_empty() && again.capacity() >= 1000 && again.as_ptr() == place);
    }

    #[test]
    fn no_more_wait_than_are_needed() {
        let scratch = Scratch::default();
        let many: Vec<Buffer<usize>> = (0..40).map(|_| Buffer::filled(&scratch, 1, 9)).collect();
        drop(many);
        assert_eq!(scratch.numbers.borrow().len(), MOST_WAITING);
        scratch.give::<bool>(Vec::with_capacity(MOST_BYTES + 1));
        assert!(scratch.flags.borrow().is_empty());
    }
}
