//! Runs that are over, and what is to be done.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A run of a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct RunRecord {
    /// Its name below the part folder.
    pub file: String,
    /// Time of its beginning: seconds since 1970.
    #[ts(type = "UnixSeconds")]
    pub begun: u64,
    /// Time that it took, seconds of whoever waited; 0 while it runs, or where it was cut short.
    #[ts(type = "Seconds")]
    pub seconds: f64,
    /// Word for its end, as that of a job, or `cut short` where Kerf ended first; nothing while it runs.
    pub ended: Option<String>,
    /// The line of the last move; the path of a job.
    pub line: u32,
    /// Name of the device of whoever drove; empty for a page on the machine itself.
    pub by: String,
}

/// A file that is to be run so many times.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ToDo {
    /// Its name below the part folder.
    pub file: String,
    /// Parts that are wanted, at least one.
    pub wanted: u32,
    /// Runs of it that came to their end since it stands here.
    pub made: u32,
}
