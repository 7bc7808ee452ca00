//! The board's dictionary, asked for piece by piece.
//!
//! `identify offset=%u count=%c` is command 1 of every board, and `identify_response offset=%u data=%.*s` response 0:
//! the two messages that are known before all others. Pieces are asked for until one is empty. On a line with a long round
//! trip several are on their way at once, a moment apart: a board has room for two answers that wait for the line, and drops
//! further ones.

use crate::dictionary::{Dictionary, DictionaryError};
use crate::wire::vlq;
use std::collections::BTreeMap;

/// Number of the command.
const IDENTIFY: u32 = 1;
/// Number of its answer.
const RESPONSE: u32 = 0;
/// Bytes asked for at a time: with more, an answer would not fit a frame and would not come.
const PIECE: u32 = 40;
/// Pieces that are on their way at once: their questions fit the smallest buffer of a board, 192 bytes.
const WINDOW: usize = 8;
/// Shortest and longest time between two questions, seconds: an answer of 48 bytes and its acknowledgement need 2.1 ms at
/// 250,000 baud. It is doubled at each loss.
const APART_S: [f64; 2] = [0.0025, 0.02];
/// Shortest and longest time after which an answer counts as lost, seconds. It is doubled at each loss.
const PATIENCE_S: [f64; 2] = [0.1, 1.6];
/// Round trips after which an answer counts as lost.
const TRIPS: f64 = 2.0;
/// Time without any answer after which none is waited for, seconds.
const SILENCE_S: f64 = 5.0;
/// Longest dictionary, bytes as it is sent.
const LONGEST: usize = 1 << 18;

/// The dictionary as far as it was told.
#[derive(Clone, Debug)]
pub struct Identify {
    told: Vec<u8>,
    /// Pieces that came before one in front of them, by their offset.
    ahead: BTreeMap<u32, Vec<u8>>,
    /// Moments at which pieces were asked for that have not come, by their offset.
    asked_s: BTreeMap<u32, f64>,
    /// Offset behind the end, as far as it is known.
    end: u32,
    patience_s: f64,
    apart_s: f64,
    /// Moment of the next question at the earliest.
    next_s: f64,
    /// Moment of the last piece that was new.
    heard_s: f64,
}

impl Identify {
    /// Begins at a moment.
    pub const fn new(now_s: f64) -> Self {
        Self {
            told: Vec::new(),
            ahead: BTreeMap::new(),
            asked_s: BTreeMap::new(),
            end: u32::MAX,
            patience_s: PATIENCE_S[0],
            apart_s: APART_S[0],
            next_s: now_s,
            heard_s: now_s,
        }
    }

    /// Returns the question for the next piece, when it is due.
    pub fn ask(&mut self, now_s: f64) -> Option<Vec<u8>> {
        let offset = self.wanted(now_s).filter(|_| now_s >= self.next_s)?;
        if self.asked_s.insert(offset, now_s).is_some() {
            self.patience_s = (2.0 * self.patience_s).min(PATIENCE_S[1]);
            self.apart_s = (2.0 * self.apart_s).min(APART_S[1]);
        }
        self.next_s = now_s + self.apart_s;
        let mut command = Vec::new();
        for number in [IDENTIFY, offset, PIECE] {
            vlq::put(number, &mut command);
        }
        Some(command)
    }

    /// The first piece that is missing and was not asked for, or long ago.
    fn wanted(&self, now_s: f64) -> Option<u32> {
        let is_due = |offset: &u32| {
            let asked_s = self.asked_s.get(offset);
            asked_s.is_none_or(|asked_s| now_s >= asked_s + self.patience_s)
        };
        self.missing().find(is_due)
    }

    /// The pieces of the window that have not come.
    fn missing(&self) -> impl Iterator<Item = u32> {
        let from = self.told.len() as u32;
        let window = (0..WINDOW as u32).map(move |n| from + n * PIECE);
        window.filter(move |offset| {
            !self.ahead.contains_key(offset) && (*offset == from || *offset < self.end)
        })
    }

    /// Returns `true` where nothing has come for long, however long the whole takes.
    pub fn is_vain(&self, now_s: f64) -> bool {
        now_s > self.heard_s + SILENCE_S
    }

    /// Moment at which the next question is due.
    pub fn due_s(&self) -> f64 {
        let due_s = |offset: u32| {
            let asked_s = self.asked_s.get(&offset);
            asked_s.map_or(f64::NEG_INFINITY, |asked_s| asked_s + self.patience_s)
        };
        self.missing().map(due_s).fold(f64::INFINITY, f64::min).max(self.next_s)
    }

    /// Reads a message; returns the dictionary with its last piece. Other messages are left alone.
    ///
    /// # Errors
    ///
    /// The dictionary is not one.
    pub fn heard(
        &mut self,
        message: &[u8],
        now_s: f64,
    ) -> Result<Option<Dictionary>, DictionaryError> {
        let Some((offset, data)) = piece(message) else { return Ok(None) };
        if let Some(asked_s) = self.asked_s.remove(&offset) {
            self.patience_s = (TRIPS * (now_s - asked_s)).clamp(PATIENCE_S[0], PATIENCE_S[1]);
        }
        let from = self.told.len() as u32;
        if data.is_empty() {
            self.end = self.end.min(offset);
        } else if (from..from + WINDOW as u32 * PIECE).contains(&offset)
            && self.ahead.insert(offset, data.to_vec()).is_none()
        {
            self.heard_s = now_s;
        }
        while let Some(data) = self.ahead.remove(&(self.told.len() as u32)) {
            self.told.extend(data);
        }
        if self.told.len() > LONGEST {
            return Err(DictionaryError::TooLong);
        }
        let is_whole = self.told.len() as u32 == self.end;
        if is_whole { Dictionary::read(&self.told).map(Some) } else { Ok(None) }
    }
}

fn piece(mut message: &[u8]) -> Option<(u32, &[u8])> {
    let number = vlq::take(&mut message).filter(|number| *number == RESPONSE);
    let offset = number.and_then(|_| vlq::take(&mut message))?;
    let length = vlq::take(&mut message)? as usize;
    (message.len() == length).then_some((offset, message))
}
