//! ON INPUT handlers.

use kerf_program::{At, Watch};
use serde::{Deserialize, Serialize};

/// The handlers of a run.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Handlers {
    /// Those that are armed.
    pub(crate) watches: Vec<Handler>,
    /// Those that fired and whose actions have not run yet.
    pub(crate) fired: Vec<Handler>,
    /// A timed pause was given while handlers are armed: nothing is read until it is over.
    pub(crate) pausing: bool,
}

impl Handlers {
    /// Disarms all of them.
    pub(crate) fn disarm(&mut self) {
        *self = Self::default();
    }
}

/// A handler: the change and the line whose action runs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Handler {
    pub(crate) watch: Watch,
    /// The line of the ON INPUT statement.
    pub(crate) at: At,
    /// Number of files that were open when it was armed; the last of them is the one of `at`.
    pub(crate) level: usize,
    /// Not a handler but a probe (FabMo): the move ends, nothing else happens.
    #[serde(default)]
    pub(crate) probe: bool,
}
