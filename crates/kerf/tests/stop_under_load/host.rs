//! A control thread: it has the priority of the machine's thread and does nothing but sleep for a millisecond at a
//! time. Where it sleeps longer, the host itself stood still.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// How long it sleeps at a time.
const STEP: Duration = Duration::from_millis(1);
/// Sleeping longer by so much is usual.
const USUAL: Duration = Duration::from_millis(1);

/// When the host stood still.
#[derive(Clone, Default)]
pub struct Host {
    stalls: Arc<Mutex<Vec<(Instant, Instant)>>>,
    over: Arc<AtomicBool>,
}

impl Host {
    /// Begins to look.
    pub fn watched() -> Self {
        let host = Self::default();
        let own = host.clone();
        thread::spawn(move || {
            while !own.over.load(Ordering::Relaxed) {
                let due = Instant::now() + STEP;
                thread::sleep(STEP);
                let woken = Instant::now();
                if woken - due > USUAL {
                    own.stalls.lock().unwrap().push((due, woken));
                }
            }
        });
        host
    }

    /// How long the host stood still between two moments.
    pub fn stood_still(&self, from: Instant, to: Instant) -> Duration {
        let overlap = |(begin, end): &(Instant, Instant)| {
            (*end).min(to).saturating_duration_since((*begin).max(from))
        };
        self.stalls.lock().unwrap().iter().map(overlap).sum()
    }

    /// The longest stall since a moment.
    pub fn longest(&self, from: Instant) -> Duration {
        let stalls = self.stalls.lock().unwrap();
        let since = stalls.iter().filter(|(begin, _)| *begin >= from);
        since.map(|(begin, end)| *end - *begin).max().unwrap_or_default()
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        // The thread holds the other one.
        if Arc::strong_count(&self.over) <= 2 {
            self.over.store(true, Ordering::Relaxed);
        }
    }
}
