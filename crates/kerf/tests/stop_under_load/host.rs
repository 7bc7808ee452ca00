//! Control threads, one on each core: they have the priority of the machine's thread and do nothing but sleep for a
//! millisecond at a time. Where one sleeps longer, its core stood still for the machine's thread as well.

use rustix::thread::{CpuSet, sched_setaffinity};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// Time that it sleeps at once.
const STEP: Duration = Duration::from_millis(1);
/// Sleeping longer by so much is usual.
const USUAL: Duration = Duration::from_millis(1);

/// Stretches of time in which the host stood still.
#[derive(Clone, Default)]
pub struct Host {
    stalls: Arc<Mutex<Vec<(Instant, Instant)>>>,
    over: Arc<AtomicBool>,
}

impl Host {
    /// Begins to look.
    pub fn watched() -> Self {
        let host = Self::default();
        let cores = thread::available_parallelism().map_or(1, usize::from);
        for core in 0..cores {
            let own = host.clone();
            thread::spawn(move || own.look(core));
        }
        host
    }

    fn look(&self, core: usize) {
        let mut one = CpuSet::new();
        one.set(core);
        // Where cores are dealt out otherwise the thread looks at whichever it is given.
        _ = sched_setaffinity(None, &one);
        while !self.over.load(Ordering::Relaxed) {
            let due = Instant::now() + STEP;
            thread::sleep(STEP);
            let woken = Instant::now();
            if woken - due > USUAL {
                self.stalls.lock().unwrap().push((due, woken));
            }
        }
    }

    /// Time that a core stood still between two moments, whichever it was.
    pub fn stood_still(&self, from: Instant, to: Instant) -> Duration {
        let part = |(begin, end): &(Instant, Instant)| ((*begin).max(from), (*end).min(to));
        let mut parts: Vec<_> = self.stalls.lock().unwrap().iter().map(part).collect();
        parts.retain(|(begin, end)| begin < end);
        parts.sort();
        let (mut sum, mut until) = (Duration::ZERO, from);
        for (begin, end) in parts {
            sum += end.saturating_duration_since(begin.max(until));
            until = until.max(end);
        }
        sum
    }

    /// The longest stall since a moment.
    pub fn longest(&self, from: Instant) -> Duration {
        let stalls = self.stalls.lock().unwrap();
        let since = stalls.iter().filter(|(begin, _)| *begin >= from);
        since.map(|(begin, end)| *end - *begin).max().unwrap_or_default()
    }

    /// Looks no longer.
    pub fn leave(&self) {
        self.over.store(true, Ordering::Relaxed);
    }
}
