//! Things that a block began and a later step ends.

use super::hole::Hole;
use kerf_program::{Axes, SpindleTurn, Watch};
use serde::{Deserialize, Serialize};

/// Things that a block began and a later step ends.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct UnderWay {
    /// A probe move.
    pub(super) probing: Option<Probe>,
    /// A tool change has begun: the spindle was stopped, the operator is asked next.
    pub(super) changing: bool,
    /// The tool that whoever owns the run puts in, before the block begins again.
    #[serde(default)]
    pub(super) due_tool: Option<u32>,
    /// The block at hand was carried out, and holds the program with these words.
    pub(super) holding: Option<String>,
    /// The hole of G88 whose retract comes when somebody has answered, and how the spindle turns then.
    pub(super) retracting: Option<(Hole, SpindleTurn)>,
}

/// A probe move that is under way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Probe {
    pub(super) watch: Watch,
    /// Its code, in tenths.
    pub(super) code: i32,
    /// Its line, from 1.
    pub(super) line: u32,
    /// Place of the machine when the probe changed.
    pub(super) contact: Option<Axes>,
}

impl UnderWay {
    /// Nothing is under way any more but a tool change, which begins again with its block.
    pub(super) fn abandon(&mut self) {
        *self = Self { changing: self.changing, ..Self::default() };
    }
}
