//! A line through the network: TCP, as a telnet server of a controller speaks it.

use crate::line::STUCK;
use crate::port::is_nothing;
use crate::{Line, LineError};
use std::io::{self, ErrorKind, Read, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::time::Duration;

/// A controller in the workshop's network answers within this.
const REACH: Duration = Duration::from_secs(3);

/// The byte with which an order of telnet begins; two of them are one byte.
const COMMAND: u8 = 0xFF;

/// Orders from here on name an option: a third byte follows.
const WILL: u8 = 0xFB;

/// A connection to a controller.
#[derive(Debug)]
pub struct Tcp {
    address: String,
    stream: TcpStream,
    telnet: Telnet,
}

impl Tcp {
    /// Connects to a controller, trying every address that its host has.
    ///
    /// # Errors
    /// Nobody answers there.
    pub fn open(host: &str, port: u16) -> Result<Self, LineError> {
        let address = format!("{host}:{port}");
        let stream = connect(host, port).map_err(|error| unreachable(&address, &error))?;
        Ok(Self { address, stream, telnet: Telnet::Text })
    }

    fn broken(&self, error: &io::Error) -> LineError {
        LineError::Broken { address: self.address.clone(), why: error.to_string() }
    }
}

impl Line for Tcp {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        match waits(&self.stream, wait).and_then(|()| self.stream.read(into)) {
            Ok(0) if !into.is_empty() => Err(self.broken(&ErrorKind::UnexpectedEof.into())),
            Ok(count) => Ok(self.telnet.strip(&mut into[..count])),
            Err(error) if is_nothing(error.kind()) => Ok(0),
            Err(error) => Err(self.broken(&error)),
        }
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        let sent = waits(&self.stream, STUCK).and_then(|()| self.stream.write_all(bytes));
        sent.map_err(|error| self.broken(&error))
    }
}

/// Opens a connection without a delay for small packets.
pub(crate) fn connect(host: &str, port: u16) -> io::Result<TcpStream> {
    let mut last = io::Error::from(ErrorKind::AddrNotAvailable);
    for address in (host.trim_matches(['[', ']']), port).to_socket_addrs()? {
        match TcpStream::connect_timeout(&address, REACH) {
            Ok(stream) => {
                stream.set_nodelay(true)?;
                stream.set_write_timeout(Some(STUCK))?;
                return Ok(stream);
            }
            Err(error) => last = error,
        }
    }
    Err(last)
}

/// Has the next look at a connection take at most so long. No time at all is no time limit to the system.
pub(crate) fn waits(stream: &TcpStream, wait: Duration) -> io::Result<()> {
    stream.set_nonblocking(wait.is_zero())?;
    stream.set_read_timeout(Some(wait).filter(|wait| !wait.is_zero()))
}

pub(crate) fn unreachable(address: &str, error: &io::Error) -> LineError {
    LineError::Unreachable { address: address.to_owned(), why: error.to_string() }
}

/// Orders of a telnet server among the text (RFC 854). They are left out and not answered: then nothing is agreed on.
#[derive(Clone, Copy, Debug)]
enum Telnet {
    Text,
    Order,
    Option,
}

impl Telnet {
    /// Moves the text to the front and returns its length.
    fn strip(&mut self, bytes: &mut [u8]) -> usize {
        let mut kept = 0;
        for at in 0..bytes.len() {
            let byte = bytes[at];
            let (next, keeps) = match (*self, byte) {
                (Self::Text, COMMAND) => (Self::Order, false),
                (Self::Text, _) | (Self::Order, COMMAND) => (Self::Text, true),
                (Self::Order, WILL..) => (Self::Option, false),
                (Self::Order | Self::Option, _) => (Self::Text, false),
            };
            *self = next;
            if keeps {
                bytes[kept] = byte;
                kept += 1;
            }
        }
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_of_telnet_are_no_text() {
        let mut telnet = Telnet::Text;
        let mut text = |bytes: &[u8]| {
            let mut bytes = bytes.to_vec();
            let count = telnet.strip(&mut bytes);
            bytes.truncate(count);
            bytes
        };
        assert_eq!(text(b"ok\xFF\xFB\x01\xFF\xFD"), b"ok");
        assert_eq!(text(b"\x03\r\n<\xFF\xFFI>\xFF\xF1"), b"\r\n<\xFFI>");
    }
}
