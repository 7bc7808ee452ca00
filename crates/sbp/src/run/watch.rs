//! ON INPUT handlers.

use kerf_program::{At, Watch};
use serde::{Deserialize, Serialize};

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
