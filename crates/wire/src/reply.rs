//! Answers to requests.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// The answer to a request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Reply {
    /// Of the request.
    pub id: u32,
    /// Reason why nothing was done; nothing when it was.
    pub problem: Option<Problem>,
    /// Notes on an act that was done all the same: warnings of a drawing operation.
    pub notes: Vec<String>,
    /// The server's clock when it answered a ping, ms since it began.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[ts(optional)]
    pub clock_ms: Option<f64>,
}

/// Reason why something was not done.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Problem {
    /// The sort of reason, for programs.
    pub why: Why,
    /// The reason and what helps, for people.
    pub text: String,
}

/// The sort of reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum Why {
    /// The request makes no sense.
    Malformed,
    /// The role of the device does not allow it.
    Role,
    /// The settings are protected, and the password is missing or wrong.
    Password,
    /// Somebody else drives, or nobody.
    Lease,
    /// The machine is not armed.
    Disarmed,
    /// Not in the state the machine is in.
    State,
    /// The file is not there, or may not be used.
    File,
    /// The file is not the one that was previewed.
    Changed,
    /// A file is there already that nobody said may be replaced.
    Replaces,
    /// The program or the operation has mistakes.
    Mistake,
    /// It came too late to count.
    Late,
    /// Something went wrong in the server.
    Server,
    /// The disk is full; what was there is as it was.
    Full,
}
