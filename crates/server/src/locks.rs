//! Locks, and the order in which they may be held.
//!
//! Whoever holds a lock takes only locks that stand further right. A lock of one of these places carries it in its type
//! ([`Lock`]), and a debug build panics where the order is broken.
//!
//! ```text
//!  DESK ──► OPEN ──► TAKEN ──► snapshot of the Hub ──► leaves: Link, Turn, Pages, Typed, LastRuns
//!                          └─► Left
//! ```
//!
//! `LastState` is shared with the machine's thread: it is held for a copy and no longer, and nothing is taken under it. The
//! snapshot is shared with that thread too, which tells pages only when nobody holds it. Passwords are tried under a
//! lock that nobody waits for. STOP takes none of all these.

use std::ops::{Deref, DerefMut};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Place of the drawing on the desk.
pub const DESK: u8 = 1;
/// Place of the file that is open.
pub const OPEN: u8 = 2;
/// Place of the origin that the running job took.
pub const TAKEN: u8 = 3;

/// A mutex with its place in the order.
#[derive(Debug, Default)]
pub struct Lock<const PLACE: u8, T> {
    inner: Mutex<T>,
}

/// A lock that is held.
pub struct Held<'a, const PLACE: u8, T> {
    guard: MutexGuard<'a, T>,
}

impl<const PLACE: u8, T> Lock<PLACE, T> {
    /// Waits for the lock, and holds it. A debug build panics where this thread holds one of this place or a later one.
    pub fn lock(&self) -> Held<'_, PLACE, T> {
        order::takes(PLACE);
        Held { guard: lock(&self.inner) }
    }
}

impl<const PLACE: u8, T> Deref for Held<'_, PLACE, T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.guard
    }
}

impl<const PLACE: u8, T> DerefMut for Held<'_, PLACE, T> {
    fn deref_mut(&mut self) -> &mut T {
        &mut self.guard
    }
}

impl<const PLACE: u8, T> Drop for Held<'_, PLACE, T> {
    fn drop(&mut self) {
        order::releases(PLACE);
    }
}

/// The places of the locks that a thread holds, as debug builds follow them.
mod order {
    use std::cell::Cell;

    thread_local! {
        /// A bit for each place.
        static HELD: Cell<u32> = const { Cell::new(0) };
    }

    /// Notes a lock before it is waited for.
    pub fn takes(place: u8) {
        if cfg!(debug_assertions) {
            let held = HELD.get();
            debug_assert!(held >> place == 0, "lock {place} is taken under those of {held:b}");
            HELD.set(held | 1 << place);
        }
    }

    /// Notes that a lock is released.
    pub fn releases(place: u8) {
        if cfg!(debug_assertions) {
            HELD.set(HELD.get() & !(1 << place));
        }
    }
}

/// A mutex whose holder panicked still holds what it held.
pub fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes a lock of one place, then one of another.
    fn check<const FIRST: u8, const SECOND: u8>() {
        let (first, second) = (Lock::<FIRST, u8>::default(), Lock::<SECOND, u8>::default());
        let _first = first.lock();
        let _second = second.lock();
    }

    #[test]
    fn locks_in_their_order_are_taken_again_and_again() {
        check::<DESK, OPEN>();
        check::<OPEN, TAKEN>();
        check::<DESK, TAKEN>();
    }

    #[test]
    #[should_panic(expected = "lock 1 is taken under")]
    fn a_lock_under_a_later_one_is_seen() {
        check::<OPEN, DESK>();
    }

    #[test]
    #[should_panic(expected = "lock 2 is taken under")]
    fn a_lock_under_itself_is_seen() {
        check::<OPEN, OPEN>();
    }
}
