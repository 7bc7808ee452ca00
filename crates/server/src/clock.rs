//! The time since the server began: it goes on whatever the clock on the wall does, and a test moves it.

use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// A clock.
#[derive(Debug)]
pub struct Clock {
    began: Instant,
    /// So far a test has moved it.
    ahead: Mutex<Duration>,
}

impl Default for Clock {
    fn default() -> Self {
        Self { began: Instant::now(), ahead: Mutex::default() }
    }
}

impl Clock {
    /// The time since the server began.
    pub fn now(&self) -> Duration {
        self.began.elapsed() + *self.ahead.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// So much time has passed at once.
    #[cfg(test)]
    pub fn forward(&self, by: Duration) {
        *self.ahead.lock().unwrap_or_else(PoisonError::into_inner) += by;
    }
}
