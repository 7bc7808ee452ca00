//! Files of the part folder that are written: what would be lost, earlier contents, text that is not saved.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A file that would be replaced.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct FileAbout {
    /// Its name below the part folder.
    pub name: String,
    /// Description: `a part program of 412 lines`.
    pub what: String,
    /// Bytes.
    #[ts(type = "number")]
    pub bytes: u64,
    /// Time of its last change: seconds since 1970.
    #[ts(type = "UnixSeconds")]
    pub changed: u64,
    /// SHA-256 of its content, in hexadecimal digits: who saw it names it as what may be replaced.
    pub hash: String,
}

/// An earlier content of a file that Kerf wrote over.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct FileVersion {
    /// Grows with each save of the file, from 1.
    pub number: u32,
    /// The file had this content since then: seconds since 1970.
    #[ts(type = "UnixSeconds")]
    pub changed: u64,
    /// Bytes.
    #[ts(type = "number")]
    pub bytes: u64,
}

/// Lines of a text, and those that stand in their place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct TextEdit {
    /// The first line that is another, from 1.
    pub line: u32,
    /// Lines that are others.
    pub count: u32,
    /// The lines that stand there now.
    pub lines: Vec<String>,
}

/// Text of the editor that is not saved.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct TextDraft {
    /// The file below the part folder that it is of; empty for a new one.
    pub name: String,
    /// The text; its lines end with a line feed. Empty where its edits tell it.
    pub text: String,
    /// The changes to the file as it was read, in order of lines; nothing where the text is told as a whole.
    #[serde(default)]
    pub edits: Option<Vec<TextEdit>>,
    /// Line ending of the file.
    pub ends: String,
    /// SHA-256 of the file as it was read; empty for a new one.
    pub base: String,
    /// The file is another by now.
    #[serde(default)]
    pub changed_on_disk: bool,
    /// The page that typed it, by a name that it gives itself.
    #[serde(default)]
    pub page: String,
    /// Which text it is; of one that is to be kept, the draft from which the page went on. Empty for none.
    #[serde(default)]
    pub revision: String,
}
