//! Connected pages, their roles, and the lease of the driver.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Rights of a device. Each role may do what those before it may.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    TS,
    JsonSchema,
)]
#[serde(rename_all = "camelCase")]
pub enum Role {
    /// Looks; may stop and hold.
    #[default]
    Observer,
    /// Runs files, answers questions, drives the machine, draws.
    Operator,
    /// Changes settings of the machine and files.
    Setter,
    /// Pairs and revokes devices.
    Owner,
}

/// Identity of a page.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Who {
    /// Its number, as long as it is connected.
    pub client: u32,
    /// Its role.
    pub role: Role,
    /// Name of the device; empty for a page on the machine itself.
    pub device: String,
}

/// A page that is connected.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Client {
    /// Its number.
    pub client: u32,
    /// Its role.
    pub role: Role,
    /// Name of the device.
    pub device: String,
}

/// The turn at driving, one at a time. Every command that moves the machine carries the number.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Lease {
    /// Grows with every lease; a command with an old number is refused.
    pub number: u32,
    /// Number of the page or script that has it.
    pub client: u32,
    /// Name of the device.
    pub device: String,
}
