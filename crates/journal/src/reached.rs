//! Progress of a run, as it goes on record.

use super::{Live, Placed};
use kerf_trace::flag;
use serde::{Deserialize, Serialize};

/// Name of the fact.
pub(super) const PROGRESS: &str = "progress";

/// Progress of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Reached {
    /// Moves made since it began.
    pub made: u64,
    /// Share of the move behind those that is made, 0 … 1.
    #[serde(default)]
    pub within: f64,
    /// The operator stopped it there and gave it up.
    #[serde(default)]
    pub stopped: bool,
    /// The machine moves: it is near `place`.
    pub moving: bool,
    /// Place where it was last.
    pub place: Placed,
    /// State that other programs see, but for the machine's motion.
    #[serde(default)]
    pub live: Live,
    /// The part file of the last move.
    pub file: String,
    /// Its line.
    pub line: u32,
}

impl Reached {
    /// Returns the state that other programs see.
    pub(super) fn live(&self) -> Live {
        let moves = if self.moving { flag::STACK_RUNNING } else { 0 };
        Live { status: self.live.status | moves, ..self.live }
    }
}
