//! Answers for an editor of part files and a fill-in sheet.

use crate::Folder;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum Level {
    /// The program cannot run.
    Error,
    /// A person should look.
    Warning,
    /// Worth knowing.
    Note,
}

/// Something a person should know about a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Finding {
    /// Severity.
    pub level: Level,
    /// Its code.
    pub code: String,
    /// The file.
    pub file: String,
    /// Line, from 1; 0 for the whole file.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// Characters.
    pub length: u32,
    /// Description of what is wrong.
    pub message: String,
    /// Advice how to mend it.
    pub hint: String,
}

/// Findings about a text that is being edited.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Checked {
    /// The findings.
    pub findings: Vec<Finding>,
}

/// A word that could stand here.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Completion {
    /// The word.
    pub label: String,
    /// `command`, `statement`, `function`, `variable`, `label`, `value`, `code`.
    pub kind: String,
    /// A few words beside it.
    pub detail: String,
    /// Description of its effect.
    pub doc: String,
}

/// Explanation of the word at a place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Hover {
    /// The text.
    pub text: String,
    /// First column of the word, from 1.
    pub from: u32,
    /// The column behind it.
    pub to: u32,
}

/// Which parameter of a command is being written.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Hint {
    /// The command's letters.
    pub letters: String,
    /// Its name.
    pub name: String,
    /// Names of its parameters.
    pub parameters: Vec<String>,
    /// The place of the one that is being written.
    pub at: u32,
    /// Explanation.
    pub doc: String,
}

/// A command of OpenSBP: what its fill-in sheet is made of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct CommandEntry {
    /// Its two letters.
    pub letters: String,
    /// Its name, as a menu shows it.
    pub name: String,
    /// The menu it belongs to: `move`, `jog`, `cut`, `file`, `settings`, `values`, `zero`, `record`,
    /// `tools`, `utilities`, `help`.
    pub group: String,
    /// Description of its effect.
    pub doc: String,
    /// It moves the machine.
    pub moves: bool,
    /// Its parameters, in order.
    pub parameters: Vec<Parameter>,
}

/// A parameter.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Kind of value that may be written.
    pub kind: ParameterKind,
    /// `in`, `mm`, `in/s`, `deg` … or nothing.
    pub unit: String,
    /// It has to be given.
    pub required: bool,
    /// Value that counts when it is left blank, as it would be written; nothing when the present value stays.
    pub default: Option<String>,
    /// The present value, for one that shows a setting.
    pub present: Option<String>,
    /// The values it accepts, in words; empty for any.
    pub bound: String,
    /// Least value, included.
    pub least: Option<f64>,
    /// Greatest value, included.
    pub most: Option<f64>,
    /// Its purpose.
    pub doc: String,
}

/// Kind of value that may be written for a parameter.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "is")]
pub enum ParameterKind {
    /// A number.
    #[default]
    Number,
    /// A whole number.
    Whole,
    /// One of these.
    Choice {
        /// As they are written.
        words: Vec<String>,
    },
    /// A number, or OFF.
    NumberOrOff,
    /// Text.
    Text,
    /// A file.
    File,
    /// The letter of an axis.
    Axis,
    /// Accepted and ignored.
    Obsolete,
}

/// Values that the machine remembers, to be looked at.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Values {
    /// System variables, by number.
    pub system: Vec<SystemValue>,
    /// User variables, by name.
    pub variables: Vec<NamedValue>,
    /// The lines of OpenSBP that set what is set now.
    pub settings: Vec<String>,
    /// Facts that help to find a fault (UD): versions, places, switches, the last error.
    pub diagnostics: Vec<NamedValue>,
    /// The folder of part files and which of them lists show (FS).
    pub folder: Folder,
    /// The part file that ran last: its name below the part folder; empty before the first.
    pub part_file: String,
    /// The folder of part files from the root on.
    pub parts: String,
    /// The folder of settings and logs.
    pub data: String,
}

/// A system variable and its value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct SystemValue {
    /// The number in its brackets.
    pub number: u8,
    /// Meaning of its value.
    pub name: String,
    /// Its unit; empty for none.
    pub unit: String,
    /// Its value.
    pub value: String,
}

/// A variable.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct NamedValue {
    /// Its name with `&` or `$`.
    pub name: String,
    /// Its value.
    pub value: String,
}
