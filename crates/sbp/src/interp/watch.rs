//! ON INPUT handlers.

use kerf_program::At;
use serde::{Deserialize, Serialize};

/// A change of an input that a program waits for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Watch {
    /// Input, 1 … 12.
    pub input: u8,
    /// Fires when the input changes to this state.
    pub on: bool,
    /// Motion ramps down first (conditions 2 and 3), else it stops at once.
    pub ramped: bool,
}

/// A handler: the change and the line whose action runs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Handler {
    pub(crate) watch: Watch,
    /// The line of the ON INPUT statement.
    pub(crate) at: At,
    /// How many files were open when it was armed; the last of them is the one of `at`.
    pub(crate) level: usize,
}
