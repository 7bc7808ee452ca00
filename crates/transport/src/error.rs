//! Errors of a line, and what to do about them.

use std::io;

/// Reason why a line cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LineError {
    /// There is no such port.
    #[error("there is no serial port {path}: is it plugged in, and is this its name?")]
    Missing {
        /// Its path.
        path: String,
    },
    /// The person who runs Kerf may not use it.
    #[error(
        "the serial port {path} may not be opened: add yourself to its group (often \"dialout\") and log in again"
    )]
    Forbidden {
        /// Its path.
        path: String,
    },
    /// Another program has it open.
    #[error("the serial port {path} is used by another program: close that first")]
    Busy {
        /// Its path.
        path: String,
    },
    /// It is something else, or cannot be set as asked.
    #[error("the serial port {path} cannot be opened at {baud} baud: {why}")]
    Unfit {
        /// Its path.
        path: String,
        /// The rate asked for.
        baud: u32,
        /// Words of the system.
        why: String,
    },
    /// It was there and is gone.
    #[error("the serial port {path} is gone ({why}): is its cable still plugged in?")]
    Gone {
        /// Its path.
        path: String,
        /// Words of the system.
        why: String,
    },
    /// Nobody answers at an address of the network.
    #[error(
        "{address} cannot be reached ({why}): is it switched on, in this network, and is this its address?"
    )]
    Unreachable {
        /// The address.
        address: String,
        /// Words of the system.
        why: String,
    },
    /// A connection through the network has ended.
    #[error("the connection to {address} is gone ({why}): is it switched on, and the network up?")]
    Broken {
        /// The address.
        address: String,
        /// Words of the system.
        why: String,
    },
    /// Its owner has closed it.
    #[error("the line of the controller is closed")]
    Closed,
}

impl LineError {
    /// Returns the error for what the system said when a port was opened.
    pub(crate) fn opening(path: &str, baud: u32, error: &serialport::Error) -> Self {
        let path = path.to_owned();
        match error.kind {
            serialport::ErrorKind::Io(io::ErrorKind::NotFound) => Self::Missing { path },
            serialport::ErrorKind::Io(io::ErrorKind::PermissionDenied) => Self::Forbidden { path },
            serialport::ErrorKind::NoDevice => Self::Busy { path },
            _ => Self::Unfit { path, baud, why: error.description.clone() },
        }
    }

    /// Returns the error for what the system said while a port was in use.
    pub(crate) fn using(path: &str, error: &io::Error) -> Self {
        Self::Gone { path: path.to_owned(), why: error.to_string() }
    }
}
