//! Wiring of a board with step queues, question by question, as pages show it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A switch of a board that is being wired, as it is now.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct WiredSwitch {
    /// The letter of the axis whose home switch it is (X2 that of its second motor), or the number of an input.
    pub about: String,
    /// Its pin with its signs, as the machine's file has it.
    pub pin: String,
    /// It is pressed.
    pub on: bool,
}

/// A board with step queues that answers at a port.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct FoundBoard {
    /// Its chip, as rp2040.
    pub chip: String,
    /// Version of its firmware.
    pub firmware: String,
    /// It was configured since it was powered: it has to be reset before it is wired otherwise.
    pub is_configured: bool,
    /// It is shut down.
    pub is_shut_down: bool,
    /// Boards that are sold with this chip.
    pub may_be: Vec<SoldBoard>,
}

/// A board that is sold, whose pins are known.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct SoldBoard {
    /// Its name in Kerf, as skr-pico.
    pub name: String,
    /// Its maker's name for it.
    pub title: String,
}

/// A serial port, and who is at it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct FoundPort {
    /// Its path.
    pub port: String,
    /// Maker and product of the device, as it tells them.
    pub device: Option<String>,
    /// The board that answers.
    pub board: Option<FoundBoard>,
    /// The reason for which none does, in a sentence.
    pub trouble: Option<String>,
}

/// The question of the wizard that is open, or its end.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Wiring {
    /// A board is being wired.
    pub is_open: bool,
    /// Ports are being looked at for boards.
    pub is_looking: bool,
    /// Ports that were looked at, while none is being wired.
    pub found: Vec<FoundPort>,
    /// Switches of the board as they are now, once it is configured and while a question is open.
    pub switches: Vec<WiredSwitch>,
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
