//! The machine's configuration as a form shows it, made from the one table of settings.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Settings that belong together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct SettingArea {
    /// Its name, as people say it.
    pub title: String,
    /// Manual and section that tell of it.
    pub manual: String,
    /// Its settings.
    pub settings: Vec<SettingEntry>,
}

/// A change of a setting that holds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct SettingChange {
    /// Seconds since 1970, UTC.
    #[ts(type = "UnixSeconds")]
    pub at: u64,
    /// The setting: `homing.x.fast_mm_s`.
    pub key: String,
    /// Its value before, as it is written.
    pub from: String,
    /// Its value since, as it is written.
    pub to: String,
    /// Name of the device of whoever changed it; empty for a page on the machine itself.
    #[serde(default)]
    pub by: String,
    /// The typed line, or the part file, that changed it; empty where a form did.
    #[serde(default)]
    pub through: String,
}

/// A setting of the machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct SettingEntry {
    /// Its name, dotted: `homing.x.fast_mm_s`.
    pub key: String,
    /// Kind of value that may be written.
    pub kind: SettingKind,
    /// `mm`, `s`, `%` … or nothing.
    pub unit: String,
    /// Bounds of its values beside their kind, in words; empty for anything of that kind.
    pub bound: String,
    /// Least value, included.
    pub least: Option<f64>,
    /// Greatest value, included.
    pub most: Option<f64>,
    /// Its value in a new configuration, as it is written.
    pub default: String,
    /// Its present value, as it is written.
    pub value: String,
    /// Its purpose.
    pub doc: String,
}

/// Kind of value that may be written for a setting.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "is")]
pub enum SettingKind {
    /// `true` or `false`.
    Flag,
    /// A number; where `none` is true, also the word `none`.
    Number {
        /// The setting may be absent.
        none: bool,
    },
    /// One of these words.
    Choice {
        /// As they are written.
        words: Vec<String>,
    },
    /// Any text.
    Text,
    /// Several values between brackets, with commas.
    List {
        /// Number of values.
        length: u32,
        /// The setting may be absent.
        none: bool,
    },
}
