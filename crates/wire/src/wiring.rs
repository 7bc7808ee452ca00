//! Wiring of a board with step queues, question by question, as pages show it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// The question of the wizard that is open, or its end.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Wiring {
    /// Number of the question: an answer to an older one is refused.
    pub question: u32,
    /// The step whose words a page has: `motor`, `went` and so on. Nothing while the machine is at work, and at the end.
    pub step: Option<String>,
    /// Subject: the letter of an axis or a motor, the number of an output.
    pub about: String,
    /// The value that holds, or that was tried.
    pub value: String,
    /// Sentences that were told since the question before.
    pub told: Vec<String>,
    /// It is over: a sentence about what came of it.
    pub ended: Option<String>,
}
