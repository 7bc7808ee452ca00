//! Loops in which nothing changes.

use serde::{Deserialize, Serialize};

/// Lines that left everything as it was.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Idling {
    /// Such lines executed one after the other.
    lines: u64,
    /// The present line changes something, or looks at what may change by itself.
    #[serde(skip)]
    pub(crate) changes: bool,
}

impl Idling {
    /// Counts a line that was executed.
    pub(crate) fn count(&mut self, changed: bool) {
        self.lines = if changed { 0 } else { self.lines + 1 };
    }

    /// Returns `true` if more lines idled than a file has: one came again, and nothing has changed since.
    pub(crate) fn exceeds(&self, lines: usize) -> bool {
        self.lines > lines as u64
    }
}
