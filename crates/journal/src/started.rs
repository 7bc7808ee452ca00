//! Start of a run, as a person reads it.

use serde::{Deserialize, Serialize};

/// Time and date at which a run starts, as a person reads them: the clock belongs to the caller.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Started {
    /// `14:03:05`
    pub time: String,
    /// `2026-11-21`
    pub date: String,
}
