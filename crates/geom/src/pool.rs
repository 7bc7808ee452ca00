//! Buffers that are used again.
//!
//! An offset needs a dozen lists for a moment. To ask the system for each of them anew takes as long as to fill
//! it: a sheet has a thousand small shapes, and the lists of a long contour are handed back page by page.
//! So lists that are done with wait here, by type and thread, until somebody needs one.

use std::cell::RefCell;
use std::ops::{Deref, DerefMut};
use std::thread::LocalKey;

/// So many lists of a type wait; more than are in use at once are not needed.
const MOST_WAITING: usize = 8;

/// Larger ones go back to the system.
const MOST_BYTES: usize = 1 << 24;

/// Lists of one type that wait.
pub(crate) type Shelf<T> = LocalKey<RefCell<Vec<Vec<T>>>>;

/// What lists are kept of.
pub(crate) trait Kept: Copy + 'static {
    /// Where they wait.
    fn shelf() -> &'static Shelf<Self>;
}

/// Lets lists of types be kept.
macro_rules! kept {
    ($($type:ty),+) => {$(
        impl $crate::pool::Kept for $type {
            fn shelf() -> &'static $crate::pool::Shelf<Self> {
                thread_local! {
                    static SHELF: std::cell::RefCell<Vec<Vec<$type>>> = const { std::cell::RefCell::new(Vec::new()) };
                }
                &SHELF
            }
        }
    )+};
}
pub(crate) use kept;

kept!(bool, usize, crate::Bounds2, crate::Segment, crate::Vertex);

/// An empty list, one that has waited if there is one.
pub(crate) fn take<T: Kept>() -> Vec<T> {
    let waiting = T::shelf().try_with(|shelf| shelf.try_borrow_mut().ok()?.pop());
    waiting.ok().flatten().unwrap_or_default()
}

/// Puts a list aside for the next who needs one.
pub(crate) fn give<T: Kept>(mut list: Vec<T>) {
    let bytes = list.capacity() * size_of::<T>();
    if bytes == 0 || bytes > MOST_BYTES {
        return;
    }
    list.clear();
    // At the end of a thread there is no shelf any more.
    let _ = T::shelf().try_with(|shelf| {
        if let Ok(mut shelf) = shelf.try_borrow_mut()
            && shelf.len() < MOST_WAITING
        {
            shelf.push(list);
        }
    });
}

/// A list that goes back to its shelf.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Buffer<T: Kept>(Vec<T>);

impl<T: Kept> Buffer<T> {
    /// As many times the same.
    pub fn filled(value: T, count: usize) -> Self {
        let mut buffer = Self::default();
        buffer.resize(count, value);
        buffer
    }
}

impl<T: Kept> Default for Buffer<T> {
    fn default() -> Self {
        Self(take())
    }
}

impl<T: Kept> Drop for Buffer<T> {
    fn drop(&mut self) {
        give(std::mem::take(&mut self.0));
    }
}

impl<T: Kept> Deref for Buffer<T> {
    type Target = Vec<T>;
    fn deref(&self) -> &Vec<T> {
        &self.0
    }
}

impl<T: Kept> DerefMut for Buffer<T> {
    fn deref_mut(&mut self) -> &mut Vec<T> {
        &mut self.0
    }
}

impl<T: Kept> FromIterator<T> for Buffer<T> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        let mut buffer = Self::default();
        buffer.extend(items);
        buffer
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_put_aside_comes_back_empty() {
        let mut buffer: Buffer<usize> = (0..1000).collect();
        let place = buffer.as_ptr();
        buffer[3] = 4;
        drop(buffer);
        let again: Buffer<usize> = Buffer::default();
        assert!(again.is_empty() && again.capacity() >= 1000 && again.as_ptr() == place);
    }

    #[test]
    fn no_more_wait_than_are_needed() {
        let many: Vec<Buffer<usize>> = (0..40).map(|_| Buffer::filled(1, 9)).collect();
        drop(many);
        let waiting = usize::shelf().with(|shelf| shelf.borrow().len());
        assert!((1..=MOST_WAITING).contains(&waiting), "{waiting}");
        give::<usize>(Vec::with_capacity(MOST_BYTES));
        let large =
            usize::shelf().with(|shelf| shelf.borrow().iter().any(|l| l.capacity() > 1 << 20));
        assert!(!large);
    }
}
