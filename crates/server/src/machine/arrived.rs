//! Stops that have come, counted where nobody waits for anybody: who presses STOP takes no lock.

use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};
use tokio::sync::Notify;

/// Number of stops that had come at a moment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StopCount(u64);

impl StopCount {
    /// Returns the number of those that stop what runs; the others only keep from beginning what was asked for before.
    pub const fn halts(self) -> u64 {
        self.0 >> 32
    }
}

/// One that stops what runs counts in the upper half, and each in the lower.
const HALT: u64 = (1 << 32) + 1;

/// Stops that have come, and those that the machine's thread has heard.
#[derive(Debug, Default)]
pub struct Arrived {
    stops: AtomicU64,
    heard: AtomicU64,
    runs: AtomicBool,
    /// Disarms that have come and do not hold yet.
    disarms: AtomicU32,
    /// Wakes whoever waits until a stop is heard.
    changed: Notify,
}

impl Arrived {
    /// Those so far.
    pub fn stops(&self) -> StopCount {
        StopCount(self.stops.load(Ordering::SeqCst))
    }

    /// One has come that stops what runs.
    pub fn halt(&self) -> StopCount {
        StopCount(self.stops.fetch_add(HALT, Ordering::SeqCst).wrapping_add(HALT))
    }

    /// The machine is to be disarmed: until that holds nothing begins.
    pub fn disarm(&self) -> StopCount {
        self.disarms.fetch_add(1, Ordering::SeqCst);
        self.halt()
    }

    /// It is disarmed now.
    pub fn disarmed(&self) {
        self.disarms.fetch_sub(1, Ordering::SeqCst);
    }

    /// Returns `true` if it is about to be disarmed.
    pub fn disarms(&self) -> bool {
        self.disarms.load(Ordering::SeqCst) > 0
    }

    /// One has come that keeps from beginning what was asked for before.
    pub fn forestall(&self) {
        self.stops.fetch_add(1, Ordering::SeqCst);
    }

    /// The machine's thread has heard so many of those that stop what runs.
    pub fn hear(&self, halts: u64) {
        self.heard.store(halts, Ordering::SeqCst);
        self.changed.notify_waiters();
    }

    /// Something runs from now on, or nothing any more: then nobody is waited for.
    pub fn runs(&self, runs: bool) {
        self.runs.store(runs, Ordering::SeqCst);
        self.changed.notify_waiters();
    }

    /// Waits until the machine's thread has heard a stop. At once where nothing runs.
    pub async fn heard(&self, stop: StopCount) {
        loop {
            let changed = self.changed.notified();
            let runs = self.runs.load(Ordering::SeqCst);
            if !runs || self.heard.load(Ordering::SeqCst) >= stop.halts() {
                return;
            }
            changed.await;
        }
    }
}
