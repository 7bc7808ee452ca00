//! The names of lines: a serial port with its rate, or an address of the network.

use crate::{Line, LineError, Port, Tcp, WebSocket};
use std::fmt;
use std::path::Path;

/// The port of telnet.
const TELNET: u16 = 23;

/// The port at which controllers serve a WebSocket.
const WEB: u16 = 81;

/// The place where a line is found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Address {
    /// A serial port.
    Serial {
        /// Its device.
        path: String,
        /// Its rate, baud.
        baud: u32,
    },
    /// A TCP port.
    Tcp {
        /// Name or number of the host.
        host: String,
        /// The port.
        port: u16,
    },
    /// A WebSocket.
    WebSocket {
        /// Name or number of the host.
        host: String,
        /// The port.
        port: u16,
        /// The path of its address, with its slash.
        path: String,
    },
    /// A program that is started for it, of a Unix.
    Program {
        /// Its name in messages.
        name: String,
        /// Its path and arguments.
        words: Vec<String>,
    },
}

impl Address {
    /// The rate of a serial port where none is named, baud.
    pub const BAUD: u32 = 115_200;

    /// Reads `PORT[@BAUD]`, `tcp:HOST[:PORT]` or `ws:HOST[:PORT][/PATH]`.
    ///
    /// # Errors
    /// A rate or a port that is none, in words; an empty text where nothing is named.
    pub fn read(words: &str) -> Result<Self, String> {
        if let Some(rest) = words.strip_prefix("tcp:") {
            return Self::tcp(rest, TELNET);
        }
        if let Some(rest) = words.strip_prefix("ws:") {
            let rest = rest.trim_start_matches('/');
            let (named, path) = rest.split_once('/').unwrap_or((rest, ""));
            let (host, port) = host_port(named, WEB)?;
            return Ok(Self::WebSocket { host, port, path: format!("/{path}") });
        }
        let (path, baud) = match words.rsplit_once('@') {
            Some((path, baud)) => {
                let wrong = || format!("'{baud}' is no rate in baud, as 115200 is");
                (path, baud.parse().ok().filter(|baud| *baud > 0).ok_or_else(wrong)?)
            }
            None => (words, Self::BAUD),
        };
        if path.is_empty() {
            return Err(String::new());
        }
        Ok(Self::Serial { path: path.to_owned(), baud })
    }

    /// Reads `HOST[:PORT]` of the network.
    ///
    /// # Errors
    /// A port that is none, in words.
    pub fn tcp(words: &str, usual: u16) -> Result<Self, String> {
        let (host, port) = host_port(words, usual)?;
        Ok(Self::Tcp { host, port })
    }

    /// Opens the line.
    ///
    /// # Errors
    /// It is not there, or may not be used.
    pub fn open(&self) -> Result<Box<dyn Line + Send>, LineError> {
        Ok(match self {
            Self::Serial { path, baud } => Box::new(Port::open(path, *baud)?),
            Self::Tcp { host, port } => Box::new(Tcp::open(host, *port)?),
            Self::WebSocket { host, port, path } => Box::new(WebSocket::open(host, *port, path)?),
            #[cfg(unix)]
            Self::Program { name, words } => Box::new(crate::Child::open(name, words)?),
            #[cfg(not(unix))]
            Self::Program { name, .. } => {
                let (address, why) = (name.clone(), "no such program runs on this system".into());
                return Err(LineError::Unreachable { address, why });
            }
        })
    }

    /// Returns a name under which the same device comes back when it is plugged in once more, wherever that is: that of its
    /// serial number, where the system has one.
    #[must_use]
    pub fn steady(&self) -> Self {
        let Self::Serial { path, baud } = self else { return self.clone() };
        let named = by_id(Path::new(path)).unwrap_or_else(|| path.clone());
        Self::Serial { path: named, baud: *baud }
    }

    /// Returns the name by which it is known again, whatever its rate.
    pub fn key(&self) -> String {
        match self {
            Self::Serial { path, .. } => path.clone(),
            Self::Tcp { .. } | Self::WebSocket { .. } | Self::Program { .. } => self.to_string(),
        }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Serial { path, baud } => write!(f, "{path}@{baud}"),
            Self::Tcp { host, port } => write!(f, "tcp:{host}:{port}"),
            Self::WebSocket { host, port, path } => write!(f, "ws:{host}:{port}{path}"),
            Self::Program { name, .. } => f.write_str(name),
        }
    }
}

/// The folder in which Linux names serial devices by maker and serial number.
const BY_ID: &str = "/dev/serial/by-id";

fn by_id(port: &Path) -> Option<String> {
    let device = port.canonicalize().ok()?;
    let mut names: Vec<_> = std::fs::read_dir(BY_ID).ok()?.flatten().map(|it| it.path()).collect();
    names.sort();
    let named = names.into_iter().find(|name| name.canonicalize().is_ok_and(|it| it == device))?;
    named.to_str().map(String::from)
}

/// Reads `HOST[:PORT]`; an address of six parts stands in brackets.
fn host_port(words: &str, usual: u16) -> Result<(String, u16), String> {
    let behind = words.rfind(']').map_or(0, |at| at + 1);
    let (host, port) = match words[behind..].rfind(':') {
        None => (words, usual),
        Some(at) => {
            let port = &words[behind + at + 1..];
            let wrong = || format!("'{port}' is no port of the network, as 23 is");
            let port = port.parse().ok().filter(|port| *port > 0).ok_or_else(wrong)?;
            (&words[..behind + at], port)
        }
    };
    if host.is_empty() {
        return Err(String::new());
    }
    Ok((host.to_owned(), port))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_address_is_read() {
        let check = |words: &str, shown: &str, key: &str| {
            let address = Address::read(words).map(|it| (it.to_string(), it.key()));
            assert_eq!(address, Ok((shown.into(), key.into())), "{words}");
        };
        check("/dev/ttyUSB0", "/dev/ttyUSB0@115200", "/dev/ttyUSB0");
        check("COM3@250000", "COM3@250000", "COM3");
        check("tcp:10.0.0.2", "tcp:10.0.0.2:23", "tcp:10.0.0.2:23");
        check("tcp:[fe80::1]:8080", "tcp:[fe80::1]:8080", "tcp:[fe80::1]:8080");
        check("ws:router.local", "ws:router.local:81/", "ws:router.local:81/");
        check("ws://10.0.0.2:80/ws", "ws:10.0.0.2:80/ws", "ws:10.0.0.2:80/ws");
    }

    #[test]
    fn what_is_no_address_is_refused() {
        let check = |words: &str, why: &str| assert_eq!(Address::read(words), Err(why.into()));
        check("", "");
        check("@9600", "");
        check("tcp:", "");
        check("tcp::23", "");
        check("COM3@fast", "'fast' is no rate in baud, as 115200 is");
        check("tcp:router:x", "'x' is no port of the network, as 23 is");
        check("ws:router:0/x", "'0' is no port of the network, as 23 is");
    }
}
