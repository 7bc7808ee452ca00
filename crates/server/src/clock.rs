//! The time since the server began. Every timeout is measured by it: a held key, a turn at driving, a code, a password
//! that was given. The clock on the wall does not change it, it goes on while the computer sleeps, and a test moves it.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// A clock. Clones are the same clock.
#[derive(Clone, Debug)]
pub struct Clock {
    began: Moment,
    /// Time by which a test has moved it.
    ahead: Arc<Mutex<Duration>>,
}

impl Default for Clock {
    fn default() -> Self {
        Self { began: Moment::now(), ahead: Arc::default() }
    }
}

impl Clock {
    /// The time since the server began.
    pub fn now(&self) -> Duration {
        self.began.elapsed() + *self.ahead.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The same in milliseconds, for pages that reckon with it.
    pub fn ms(&self) -> f64 {
        self.now().as_secs_f64() * 1e3
    }

    /// So much time has passed at once: the computer slept.
    #[cfg(test)]
    pub fn forward(&self, by: Duration) {
        *self.ahead.lock().unwrap_or_else(PoisonError::into_inner) += by;
    }
}

/// A moment of the computer's own clock. The usual one stands still while a computer with Linux sleeps.
#[cfg(target_os = "linux")]
#[derive(Clone, Copy, Debug)]
struct Moment(Duration);

#[cfg(target_os = "linux")]
impl Moment {
    fn now() -> Self {
        let since = rustix::time::clock_gettime(rustix::time::ClockId::Boottime);
        // It counts from the start of the computer, and never below.
        let seconds = since.tv_sec.try_into().unwrap_or_default();
        Self(Duration::new(seconds, since.tv_nsec.try_into().unwrap_or_default()))
    }

    fn elapsed(self) -> Duration {
        Self::now().0.saturating_sub(self.0)
    }
}

#[cfg(not(target_os = "linux"))]
use std::time::Instant as Moment;

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Instant;

    #[test]
    fn a_clock_goes_as_the_world_does_and_its_clones_with_it() {
        let (begun, clock) = (Instant::now(), Clock::default());
        let same = clock.clone();
        std::thread::sleep(Duration::from_millis(20));
        let passed = clock.now();
        assert!(passed >= Duration::from_millis(20) && passed <= begun.elapsed(), "{passed:?}");
        clock.forward(Duration::from_secs(3600));
        assert!(same.now() >= Duration::from_secs(3600));
    }
}
