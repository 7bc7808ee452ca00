//! A board that is asked who it is, and is not configured.

use super::attached::Socket;
use kerf_driver_klipper::board::{Introduced, Introduction};
use std::time::{Duration, Instant};

/// A board that has not told who it is by then is none.
const GREETING: Duration = Duration::from_secs(12);
/// One look at a line.
const NAP: Duration = Duration::from_millis(5);

/// Asks a board who it is. Nothing of it changes.
///
/// # Errors
/// Nobody answers, or something that is no board; in words.
pub fn introduced(socket: &Socket) -> Result<Introduced, String> {
    let mut line = (socket.opens)()?;
    let (since, mut board) = (Instant::now(), Introduction::new(0.0));
    let mut bytes = [0; 1024];
    while since.elapsed() < GREETING {
        let out = board.transmit(since.elapsed().as_secs_f64());
        if !out.bytes.is_empty() {
            line.write(&out.bytes).map_err(|why| why.to_string())?;
        }
        let count = line.read(&mut bytes, NAP).map_err(|why| why.to_string())?;
        board.receive(&bytes[..count], since.elapsed().as_secs_f64());
        if let Some(told) = board.take() {
            return told.map_err(|why| why.to_string());
        }
    }
    Err("no board answers: is this its port and its rate?".into())
}
