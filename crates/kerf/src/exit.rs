//! Exit codes: what a script learns without reading.

use kerf_sbp::Status;
use std::process::ExitCode;

/// Result of the process, as its exit code tells it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// All went well.
    Good,
    /// The program failed, or errors were found.
    Failed,
    /// The command line was wrong.
    Usage,
    /// Stopped by the operator or by a limit.
    Stopped,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(match exit {
            Exit::Good => 0,
            Exit::Failed => 1,
            Exit::Usage => 2,
            Exit::Stopped => 3,
        })
    }
}

impl From<Status> for Exit {
    fn from(status: Status) -> Self {
        match status {
            Status::Ok | Status::Ended => Self::Good,
            Status::Failed => Self::Failed,
            Status::Stopped | Status::Limit => Self::Stopped,
        }
    }
}

/// The command line asks for something that cannot be.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct Usage(pub String);

/// The exit code of an error that reached the top.
pub fn of_error(error: &anyhow::Error) -> Exit {
    if error.is::<Usage>() { Exit::Usage } else { Exit::Failed }
}
