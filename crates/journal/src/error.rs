//! Reasons for which the journal cannot be used, in words that say what to do.

use kerf_trace::Summary;
use std::io;
use std::path::{Path, PathBuf};

/// Reason for which the journal cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// The folder or the file cannot be written.
    #[error(
        "the data folder cannot be written ({}): {why}; give another with --data, or run with \
         --start fresh, which keeps nothing",
        path.display()
    )]
    ReadOnly {
        /// The file or folder.
        path: PathBuf,
        /// Words of the system.
        why: String,
    },
    /// There is no room.
    #[error(
        "the disk of the data folder is full ({}); make room: what was kept before is still there",
        path.display()
    )]
    Full {
        /// The file.
        path: PathBuf,
    },
    /// The file is no sound database.
    #[error("{} is damaged: {what}", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// Damage that was found.
        what: String,
    },
    /// A later version wrote it.
    #[error("{} was written by a later version of Kerf", path.display())]
    Newer {
        /// The file.
        path: PathBuf,
    },
    /// Another process runs the machine.
    #[error("another Kerf runs the machine of {}; wait until it is done", folder.display())]
    Owned {
        /// The data folder.
        folder: PathBuf,
    },
    /// The run is over, and what it left cannot be kept.
    #[error("what the run left is not kept: {why}")]
    NotKept {
        /// Outcome of the run.
        summary: Box<Summary>,
        /// Reason.
        why: Box<JournalError>,
    },
    /// No run was cut short.
    #[error("no run was cut short: there is nothing to take up in {}", folder.display())]
    NothingToResume {
        /// The data folder.
        folder: PathBuf,
    },
    /// The record does not lead where the run was.
    #[error("the run cannot be taken up: {0}")]
    Unfit(String),
    /// The settings of the machine have a mistake.
    #[error(
        "the machine's settings cannot be used: {0}; `kerf machine check` shows all mistakes, \
             --start fresh runs without them"
    )]
    Settings(String),
    /// Anything else that the database says.
    #[error("{}: {why}", path.display())]
    Other {
        /// The file.
        path: PathBuf,
        /// Words of the database.
        why: String,
    },
}

impl JournalError {
    /// Of an error of the disk.
    pub(crate) fn of_disk(path: &Path, error: &io::Error) -> Self {
        let path = path.to_owned();
        match error.kind() {
            io::ErrorKind::StorageFull | io::ErrorKind::FileTooLarge => Self::Full { path },
            _ => Self::ReadOnly { path, why: error.to_string() },
        }
    }
}
