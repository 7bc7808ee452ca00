//! The place where a controller hangs, and what opens its line.

use super::line_log::LineLog;
use kerf_machine::driver::Wired;
use kerf_transport::Line;
use std::fmt;
use std::sync::Arc;

/// Opens the line of a controller.
pub type Opens = Arc<dyn Fn() -> Result<Ends, String> + Send + Sync>;

/// A fresh driver, with the line it speaks through.
pub type Ends = (Box<dyn Wired>, Box<dyn Line + Send>);

/// The place where a controller hangs.
#[derive(Clone)]
pub struct Socket {
    /// Its name, as people give it: `grbl:/dev/ttyUSB0`.
    pub name: String,
    /// The port alone, by which it is known again whatever its rate.
    pub port: String,
    /// Opens the port.
    pub opens: Opens,
    /// Record of the lines that any connection to it sent, and of its answers.
    pub log: Arc<LineLog>,
}

impl fmt::Debug for Socket {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}
