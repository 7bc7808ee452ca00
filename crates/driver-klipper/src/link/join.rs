//! The way into a session: any half frame of a former host is ended, and the board tells the number that it expects.
//!
//! An empty frame does nothing in a board, whichever number it has, and is answered with the number expected. A
//! number that happened to fit has been counted in by then, so the answer is right in each case.

use crate::wire::frame::{LONGEST, Reader, SYNC, frame};

/// Time in which bytes for a former host are thrown away, seconds.
const DRAIN_S: f64 = 0.1;
/// Time between two questions.
const ASK_S: f64 = 0.2;
/// Time after which there is no board: boot loaders take some seconds.
const GIVE_UP_S: f64 = 10.0;

/// A line whose board is asked for its number.
#[derive(Clone, Debug)]
pub struct Join {
    reader: Reader,
    since_s: f64,
    /// The bytes that end a half frame went out.
    flushed: bool,
    /// Moment of the next question.
    ask_s: f64,
}

impl Join {
    /// Begins at a moment.
    pub fn new(now_s: f64) -> Self {
        Self { reader: Reader::default(), since_s: now_s, flushed: false, ask_s: now_s + DRAIN_S }
    }

    /// Returns the bytes to be written now.
    pub fn transmit(&mut self, now_s: f64) -> Vec<u8> {
        if !self.flushed {
            self.flushed = true;
            return vec![SYNC; LONGEST];
        }
        if now_s < self.ask_s {
            return Vec::new();
        }
        self.ask_s = now_s + ASK_S;
        frame(0, &[])
    }

    /// Reads bytes; tells the number that the board expects once it answered.
    pub fn receive(&mut self, bytes: &[u8], now_s: f64) -> Option<u8> {
        let frames = self.reader.read(bytes);
        let asked = now_s >= self.since_s + DRAIN_S;
        let answer = frames.iter().rev().find(|frame| frame.content.is_empty()).filter(|_| asked);
        answer.map(|frame| frame.number)
    }

    /// Returns the moment at which there is something to write.
    pub fn due_s(&self) -> f64 {
        if self.flushed { self.ask_s } else { f64::NEG_INFINITY }
    }

    /// Nobody answers: a wrong port, a wrong rate, or another program in the board.
    pub fn is_vain(&self, now_s: f64) -> bool {
        now_s > self.since_s + GIVE_UP_S
    }
}
