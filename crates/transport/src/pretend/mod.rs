//! Ports without hardware: pseudo terminals of the system.
//!
//! ```text
//!  Port ── path ~~~ Plug ── a program that pretends to be a device
//!  Port ── path ~~~ Plug ── Cable ── Plug ~~~ path ── Port
//! ```

mod cable;

pub use cable::Cable;

use crate::{LineError, Port};
use serialport::{SerialPort, TTYPort};
use std::fs::File;
use std::os::unix::fs::OpenOptionsExt;
use std::time::Duration;

/// The far end of a port that does not exist: what is written here is read from [`Plug::path`]. When it
/// is dropped the port is gone, as if unplugged.
#[derive(Debug)]
pub struct Plug {
    far: Port,
    path: String,
    /// Kept open, so that a far end that nobody listens to is silent and not gone.
    _near: File,
}

impl Plug {
    /// A new port with this as its far end.
    pub fn new() -> Result<Self, LineError> {
        Self::make().map_err(|error| LineError::opening("(pretended)", 0, &error))
    }

    fn make() -> serialport::Result<Self> {
        // The library's own near end is locked against others.
        let (open, locked) = TTYPort::pair()?;
        // The copy is closed in programs that are started meanwhile: one that held it would keep the port alive.
        let far = open.try_clone_native()?;
        let path = locked.name().unwrap_or_default();
        let mut options = File::options();
        options.read(true).write(true).custom_flags(nix::libc::O_NOCTTY);
        let near = options.open(&path)?;
        Ok(Self { far: Port::of(&path, Box::new(far)), path, _near: near })
    }

    /// Returns the path by which the near end is opened.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// As [`Port::read`].
    pub fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        self.far.read(into, wait)
    }

    /// As [`Port::write`].
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        self.far.write(bytes)
    }

    /// The rate that the near end was opened at.
    pub fn baud(&self) -> Result<u32, LineError> {
        self.far.baud()
    }
}
