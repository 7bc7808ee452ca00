//! The board's dictionary, asked for piece by piece.
//!
//! `identify offset=%u count=%c` is command 1 of every board, and `identify_response offset=%u data=%.*s` response 0:
//! the two messages that are known before all others. Pieces are asked for until one is empty.

use crate::dictionary::{Dictionary, DictionaryError};
use crate::wire::vlq;

/// Number of the command.
const IDENTIFY: u32 = 1;
/// Number of its answer.
const RESPONSE: u32 = 0;
/// Bytes asked for at a time: with more, an answer would not fit a frame and would not come.
const PIECE: u32 = 40;
/// Time after which an answer counts as lost, seconds.
const PATIENCE_S: f64 = 0.1;
/// Longest dictionary, bytes as it is sent.
const LONGEST: usize = 1 << 18;

/// Times that a piece is asked for.
const TRIES: u32 = 40;

/// The dictionary as far as it was told.
#[derive(Clone, Debug)]
pub struct Identify {
    told: Vec<u8>,
    /// Moment at which the next piece is asked for.
    ask_s: f64,
    /// Times that it was asked for.
    tries: u32,
}

impl Identify {
    /// Begins at a moment.
    pub const fn new(now_s: f64) -> Self {
        Self { told: Vec::new(), ask_s: now_s, tries: 0 }
    }

    /// Returns the question for the next piece, when it is due.
    pub fn ask(&mut self, now_s: f64) -> Option<Vec<u8>> {
        if now_s < self.ask_s {
            return None;
        }
        self.ask_s = now_s + PATIENCE_S;
        self.tries += 1;
        let mut command = Vec::new();
        for number in [IDENTIFY, self.told.len() as u32, PIECE] {
            vlq::put(number, &mut command);
        }
        Some(command)
    }

    /// Returns `true` when a piece was asked for again and again.
    pub const fn is_vain(&self) -> bool {
        self.tries > TRIES
    }

    /// Moment at which the next question is due.
    pub const fn due_s(&self) -> f64 {
        self.ask_s
    }

    /// Reads a message; returns the dictionary with its last piece. Other messages are left alone.
    ///
    /// # Errors
    ///
    /// The dictionary is not one.
    pub fn heard(&mut self, message: &[u8]) -> Result<Option<Dictionary>, DictionaryError> {
        let Some((offset, data)) = piece(message) else { return Ok(None) };
        if offset as usize != self.told.len() {
            return Ok(None);
        }
        if data.is_empty() {
            return Dictionary::read(&self.told).map(Some);
        }
        self.told.extend_from_slice(data);
        if self.told.len() > LONGEST {
            return Err(DictionaryError::TooLong);
        }
        (self.ask_s, self.tries) = (f64::NEG_INFINITY, 0);
        Ok(None)
    }
}

fn piece(mut message: &[u8]) -> Option<(u32, &[u8])> {
    let number = vlq::take(&mut message).filter(|number| *number == RESPONSE);
    let offset = number.and_then(|_| vlq::take(&mut message))?;
    let length = vlq::take(&mut message)? as usize;
    (message.len() == length).then_some((offset, message))
}
