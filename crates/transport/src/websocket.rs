//! A line through a WebSocket, as controllers with a page of their own have it.

use crate::line::STUCK;
use crate::port::is_nothing;
use crate::tcp::{connect, unreachable, waits};
use crate::{Line, LineError};
use std::collections::VecDeque;
use std::net::TcpStream;
use std::time::{Duration, Instant};
use tungstenite::protocol::Message;
use tungstenite::{Error, HandshakeError};

/// Beginnings of messages to the page that a controller serves: they are no answers to a line.
const TO_PAGES: [&str; 4] = ["CURRENT_ID:", "ACTIVE_ID:", "PING:", "currentID:"];

/// A connection to a controller. Bytes go in binary messages, and come in messages of either kind.
#[derive(Debug)]
pub struct WebSocket {
    address: String,
    socket: tungstenite::WebSocket<TcpStream>,
    came: VecDeque<u8>,
}

impl WebSocket {
    /// Connects to a controller.
    ///
    /// # Errors
    /// Nobody answers there, or something that speaks no WebSocket.
    pub fn open(host: &str, port: u16, path: &str) -> Result<Self, LineError> {
        let address = format!("ws://{host}:{port}{path}");
        let refused = |why: String| LineError::Unreachable { address: address.clone(), why };
        let stream = connect(host, port).map_err(|error| unreachable(&address, &error))?;
        // A server that never ends its greeting is none.
        waits(&stream, STUCK).map_err(|error| unreachable(&address, &error))?;
        let greeted = tungstenite::client(&address, stream);
        let (socket, _) = greeted.map_err(|why| match why {
            HandshakeError::Interrupted(_) => refused("it does not answer".into()),
            HandshakeError::Failure(why) => refused(why.to_string()),
        })?;
        Ok(Self { address, socket, came: VecDeque::new() })
    }

    fn broken(&self, why: impl ToString) -> LineError {
        LineError::Broken { address: self.address.clone(), why: why.to_string() }
    }

    /// Takes one message, waiting at most so long; returns `false` when none came.
    fn hear(&mut self, wait: Duration) -> Result<bool, LineError> {
        waits(self.socket.get_ref(), wait).map_err(|error| self.broken(error))?;
        match self.socket.read() {
            Ok(Message::Text(text)) if !TO_PAGES.iter().any(|word| text.starts_with(word)) => {
                self.came.extend(text.as_bytes());
            }
            Ok(Message::Binary(bytes)) => self.came.extend(&bytes[..]),
            Ok(_) => {}
            Err(error) if has_nothing(&error) => return Ok(false),
            Err(error) => return Err(self.broken(error)),
        }
        Ok(true)
    }
}

impl Line for WebSocket {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        let begin = Instant::now();
        // Messages to pages are no bytes: the rest of the time is waited for others.
        while self.came.is_empty() && self.hear(wait.saturating_sub(begin.elapsed()))? {}
        let count = into.len().min(self.came.len());
        self.came.drain(..count).zip(into).for_each(|(byte, to)| *to = byte);
        Ok(count)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        waits(self.socket.get_ref(), STUCK).map_err(|error| self.broken(error))?;
        let sent = self.socket.send(Message::binary(bytes.to_vec()));
        sent.map_err(|error| self.broken(error))
    }
}

fn has_nothing(error: &Error) -> bool {
    matches!(error, Error::Io(error) if is_nothing(error.kind()))
}
