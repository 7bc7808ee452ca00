//! Counts of what a run has given and executed.

use serde::{Deserialize, Serialize};

/// What a run has given so far.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Given {
    /// Steps that had an effect.
    pub(crate) steps: u64,
    /// Lines executed.
    pub(crate) lines: u64,
    /// Motion commands.
    pub(crate) motions: u64,
    /// The step behind each motion command given in this one, while handlers are armed.
    pub(crate) given_by: Vec<u64>,
    /// Everything given has been carried out.
    pub(crate) settled: bool,
}

impl Default for Given {
    fn default() -> Self {
        Self { steps: 0, lines: 0, motions: 0, given_by: Vec::new(), settled: true }
    }
}
