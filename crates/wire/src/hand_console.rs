//! The hand console as pages mimic it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// The screen of the hand console.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct HandConsole {
    /// Its lines, of 20 characters at most.
    pub lines: [String; 2],
    /// Number of beeps so far.
    pub beeps: u32,
    /// Its serial link, in a sentence: the port it is at, or why it is not. Empty where there is none.
    pub link: String,
}
