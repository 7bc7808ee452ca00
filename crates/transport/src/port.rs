//! A port: opened by its path, bytes in, bytes out.

use crate::LineError;
use crate::line::STUCK;
use serialport::{ClearBuffer, SerialPort};
use std::io::{ErrorKind, Read, Write};
use std::path::Path;
use std::time::Duration;

/// The folder in which Linux keeps a link to each port by the serial number of its device.
const BY_ID: &str = "/dev/serial/by-id";

/// Bytes handed to the system at a time, so that it never has to wait for room in the middle.
const MOUTHFUL: usize = 64;

/// Returns the names of the serial ports that there are.
pub fn ports() -> Vec<String> {
    let found = serialport::available_ports().unwrap_or_default();
    let mut names: Vec<String> = found.into_iter().map(|port| port.port_name).collect();
    names.sort();
    names
}

/// A serial port of this computer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ListedPort {
    /// The path that stays with its device where the system has one (`/dev/serial/by-id/…`), else its name.
    pub path: String,
    /// Maker and product, as the device tells them.
    pub device: Option<String>,
}

/// Returns the serial ports that there are, with the devices at them.
pub fn listed_ports() -> Vec<ListedPort> {
    let found = serialport::available_ports().unwrap_or_default();
    let listed = found.into_iter().map(|port| {
        let path = lasting(Path::new(BY_ID), &port.port_name).unwrap_or(port.port_name);
        let serialport::SerialPortType::UsbPort(usb) = port.port_type else {
            return ListedPort { path, device: None };
        };
        let words: Vec<String> = [usb.manufacturer, usb.product].into_iter().flatten().collect();
        ListedPort { path, device: Some(words.join(" ")).filter(|words| !words.is_empty()) }
    });
    let mut listed: Vec<ListedPort> = listed.collect();
    listed.sort_by(|a, b| a.path.cmp(&b.path));
    listed
}

/// The link in a folder that leads to a device.
fn lasting(folder: &Path, device: &str) -> Option<String> {
    let links = std::fs::read_dir(folder).ok()?.flatten();
    let device = std::fs::canonicalize(device).ok()?;
    let leads = |link: &Path| std::fs::canonicalize(link).is_ok_and(|to| to == device);
    let link = links.map(|link| link.path()).find(|link| leads(link))?;
    Some(link.display().to_string())
}

/// Returns the serial number that a device at a port tells of itself, with its maker and its kind; nothing where it tells
/// none.
pub fn serial_number(port: &str) -> Option<String> {
    let device = std::fs::canonicalize(port).ok()?;
    let found = serialport::available_ports().unwrap_or_default();
    let found = found.into_iter().find(|it| it.port_name == device.display().to_string())?;
    let serialport::SerialPortType::UsbPort(usb) = found.port_type else { return None };
    let number = usb.serial_number.filter(|number| !number.is_empty())?;
    Some(format!("{:04x}:{:04x} {number}", usb.vid, usb.pid))
}

/// An open serial port: 8 data bits, no parity, 1 stop bit, no flow control.
pub struct Port {
    path: String,
    line: Box<dyn SerialPort>,
}

impl Port {
    /// Opens a port at a rate in baud. Nobody else can open it meanwhile; what came before is dropped.
    pub fn open(path: &str, baud: u32) -> Result<Self, LineError> {
        let line = serialport::new(path, baud).timeout(STUCK).open();
        let line = line.map_err(|error| LineError::opening(path, baud, &error))?;
        let cleared = line.clear(ClearBuffer::Input);
        cleared.map_err(|error| LineError::opening(path, baud, &error))?;
        Ok(Self::of(path, line))
    }

    /// A port that is open already.
    pub(crate) fn of(path: &str, line: Box<dyn SerialPort>) -> Self {
        Self { path: path.to_owned(), line }
    }

    /// Returns the path by which it was opened.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Returns its rate, baud; nothing where it is the port of a board on USB itself, which takes bytes as fast as it reads
    /// them, whatever rate is named.
    pub fn rate(&self) -> Option<u32> {
        let device = std::fs::canonicalize(&self.path).unwrap_or_else(|_| (&self.path).into());
        let on_usb =
            device.file_name().is_some_and(|name| name.to_string_lossy().starts_with("ttyACM"));
        if on_usb { None } else { self.baud().ok() }
    }

    /// The bytes that came, waiting for the first of them at most `wait`; 0 when none did.
    pub fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        let outcome = self.line.set_timeout(wait).map_err(std::io::Error::from);
        match outcome.and_then(|()| self.line.read(into)) {
            Ok(0) if !into.is_empty() => {
                Err(LineError::using(&self.path, &ErrorKind::UnexpectedEof.into()))
            }
            Ok(count) => Ok(count),
            Err(error) if is_nothing(error.kind()) => Ok(0),
            Err(error) => Err(LineError::using(&self.path, &error)),
        }
    }

    /// Writes all bytes; they may be still on their way when it returns.
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        let outcome = self.line.set_timeout(STUCK).map_err(std::io::Error::from);
        let written = outcome.and_then(|()| {
            bytes.chunks(MOUTHFUL).try_for_each(|mouthful| self.line.write_all(mouthful))
        });
        written.map_err(|error| LineError::using(&self.path, &error))
    }

    /// The rate in baud.
    pub fn baud(&self) -> Result<u32, LineError> {
        self.line.baud_rate().map_err(|error| LineError::using(&self.path, &error.into()))
    }
}

/// Tells whether a line has nothing to say, and is no worse for it.
pub(crate) fn is_nothing(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::TimedOut | ErrorKind::WouldBlock | ErrorKind::Interrupted)
}

impl std::fmt::Debug for Port {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Port").field("path", &self.path).finish_non_exhaustive()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn a_port_has_the_name_that_stays_with_its_device() {
        let plug = crate::pretend::Plug::new().unwrap();
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(lasting(folder.path(), plug.path()), None);
        let link = folder.path().join("usb-Klipper_rp2040_E66-if00");
        std::os::unix::fs::symlink(plug.path(), &link).unwrap();
        assert_eq!(lasting(folder.path(), plug.path()), Some(link.display().to_string()));
    }
}
