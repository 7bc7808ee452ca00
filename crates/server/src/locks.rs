//! Locks, and their order.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// A mutex whose holder panicked still holds what it held.
pub fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
