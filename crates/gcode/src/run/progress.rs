//! How far a run has come, and way in which its lines are gone through.

use serde::{Deserialize, Serialize};

/// How far a run has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Progress {
    pub(super) started: bool,
    /// M2, M30 or the end of the file was reached: only what is under way is left to do.
    pub(super) over: bool,
    /// Lines executed.
    pub(super) lines: u64,
    /// Motion commands given so far.
    pub(super) motions: u64,
    /// Only the line of this index is executed.
    pub(super) only: Option<u32>,
    pub(super) stepping: Stepping,
}

/// Way in which a file is gone through.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Stepping {
    /// The operator is asked before each line.
    pub(super) asks: bool,
    /// The operator let the next line run.
    pub(super) granted: bool,
    /// Lines of the file before this index are passed over, but for what they set up.
    pub(super) skip_to: Option<u32>,
}

impl Progress {
    /// A run with so many lines behind it; it is stepped through when the operator is asked before each line.
    pub(super) fn new(lines: u64, stepped: bool) -> Self {
        let stepping = Stepping { asks: stepped, ..Stepping::default() };
        Self { started: false, over: false, lines, motions: 0, only: None, stepping }
    }

    /// Only the line of an index is executed next.
    pub(super) const fn enter_line(&mut self, index: u32) {
        (self.started, self.over, self.only) = (true, false, Some(index));
    }
}

impl Stepping {
    /// Returns `true` if lines run as in any file.
    pub(super) const fn is_off(&self) -> bool {
        !self.asks && self.skip_to.is_none()
    }
}
