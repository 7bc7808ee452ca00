//! The card of a controller, whose files it runs by itself, as pages see and work it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// The card of the controller, as far as it is known.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ControllerCard {
    /// There is one.
    pub has: bool,
    /// Reason why there is none; empty of a machine without a controller.
    pub why: String,
    /// Its files as they were listed last; nothing before that.
    pub files: Option<Vec<CardFile>>,
    /// The task under way.
    pub task: Option<CardTask>,
    /// Reasons why the last task was not done, each with its place and how it is mended.
    pub refused: Vec<String>,
    /// Name of the file that the last task would have written over.
    pub replaces: Option<String>,
    /// Name of the file whose text the last task could not read back: it may be run unseen.
    pub unread: Option<String>,
    /// Name of the file of the part folder into which the last task has copied one.
    pub kept: Option<String>,
    /// Notes of the last task: what a conversion left out or made otherwise.
    pub notes: Vec<String>,
}

/// A file on the card.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct CardFile {
    /// Its name, with the folders before it.
    pub name: String,
    /// Its size, bytes.
    #[ts(type = "number")]
    pub bytes: u64,
    /// Outcome of the look through it; nothing where its text is not known.
    pub looked: Option<CardLook>,
}

/// Outcome of a look through a file of the card: it is within the limits of the controller.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct CardLook {
    /// Time that the controller is estimated to take, seconds.
    #[ts(type = "Seconds")]
    pub seconds: f64,
    /// Warnings: what it does otherwise than the file says.
    pub warnings: Vec<String>,
}

/// A task on the card.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct CardTask {
    /// Its kind.
    pub kind: CardTaskKind,
    /// The file that it is about; empty where it is none.
    pub name: String,
    /// Bytes that are there.
    #[ts(type = "number")]
    pub done: u64,
    /// Bytes in all; 0 where that is not known.
    #[ts(type = "number")]
    pub all: u64,
}

/// Kind of a task on the card.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum CardTaskKind {
    /// The files are listed.
    List,
    /// A file is looked through.
    Look,
    /// A file is put there.
    Upload,
    /// A file is begun.
    Run,
    /// A file is deleted.
    Delete,
    /// A file is copied into the part folder.
    Keep,
}

/// A request about the card.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "to", deny_unknown_fields)]
pub enum CardAct {
    /// List the files.
    List,
    /// Read a file back, hold it against the limits of the controller, and estimate its time.
    Look {
        /// Its name.
        name: String,
    },
    /// Put a file of the part folder there: G-code as it is, part files and jobs as G-code. It is looked through first.
    Upload {
        /// The file.
        file: String,
        /// A file of that name is written over.
        #[serde(default)]
        replaces: bool,
    },
    /// Have the controller run a file, and follow it.
    Run {
        /// Its name.
        name: String,
        /// Also where its text could not be read back.
        #[serde(default)]
        unseen: bool,
    },
    /// Delete a file.
    Delete {
        /// Its name.
        name: String,
    },
    /// Copy a file into the part folder.
    Keep {
        /// Its name.
        name: String,
        /// A file of that name is written over.
        #[serde(default)]
        replaces: bool,
    },
    /// Give the task under way up.
    Cancel,
}
