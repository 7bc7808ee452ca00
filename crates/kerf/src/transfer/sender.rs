//! The end that has the file.

use super::frame::{AROUND, BLOCK, Frame, Reader};
use super::{HOLD_S, LARGEST, LOST_S, Progress, State};

/// Bits that a byte takes on the line.
const BITS: f64 = 10.0;

/// An answer is waited for so long after the last byte has gone, seconds.
const PATIENCE_S: f64 = 0.5;

/// Sends one file.
#[derive(Debug)]
pub struct Sender {
    name: String,
    bytes: Vec<u8>,
    baud: u32,
    state: State,
    reader: Reader,
    /// The block that the other end wants; nothing until it has answered the offer.
    next: Option<u32>,
    /// Time at which the frame at hand is sent or sent again, s.
    due_s: f64,
    heard_s: Option<f64>,
    last: Option<Frame>,
}

impl Sender {
    /// Offers a file over a line of a rate in baud.
    ///
    /// # Errors
    /// It is too large.
    pub fn new(name: &str, bytes: Vec<u8>, baud: u32) -> Result<Self, String> {
        if bytes.len() > LARGEST {
            return Err(format!("{name} is larger than {LARGEST} bytes: send it over the network"));
        }
        Ok(Self {
            name: name.to_owned(),
            bytes,
            baud,
            state: State::Waiting,
            reader: Reader::default(),
            next: None,
            due_s: 0.0,
            heard_s: None,
            last: None,
        })
    }

    /// Returns its state.
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// Returns its progress.
    pub fn progress(&self) -> Progress {
        let done = (self.next.unwrap_or(0) as usize * BLOCK).min(self.bytes.len());
        Progress { name: self.name.clone(), done, total: self.bytes.len() }
    }

    /// Somebody stops it here.
    pub fn stop(&mut self) {
        if !self.state.is_over() {
            (self.state, self.last) = (State::Stopped, Some(Frame::Stop(String::new())));
        }
    }

    /// Bytes came.
    pub fn hear(&mut self, bytes: &[u8], now_s: f64) {
        self.reader.hear(bytes);
        while let Some(frame) = self.reader.next() {
            if self.state.is_over() {
                return;
            }
            self.heard_s = Some(now_s);
            match frame {
                Frame::Next(number) => self.goes_on(number, now_s),
                Frame::Hold => (self.state, self.due_s) = (State::Held, now_s + HOLD_S),
                Frame::Stop(why) if why.is_empty() => self.state = State::Stopped,
                Frame::Stop(why) => self.state = State::Failed(why),
                Frame::Offer { .. } | Frame::Block { .. } => {}
            }
        }
    }

    fn goes_on(&mut self, number: u32, now_s: f64) {
        let held = std::mem::replace(&mut self.state, State::Sending) == State::Held;
        // An answer that comes twice asks for nothing new.
        if held || self.next.is_none_or(|next| number > next) {
            (self.next, self.due_s) = (Some(self.next.unwrap_or(0).max(number)), now_s);
        }
        if number as usize * BLOCK >= self.bytes.len() {
            self.state = State::Done;
        }
    }

    /// Returns the bytes that are to be sent now.
    pub fn speak(&mut self, now_s: f64) -> Vec<u8> {
        if let Some(last) = self.last.take() {
            return last.bytes();
        }
        let heard_s = *self.heard_s.get_or_insert(now_s);
        if self.state.is_over() || now_s < self.due_s {
            return Vec::new();
        }
        if now_s - heard_s > LOST_S {
            let why = "the other end does not answer: is it receiving, at this rate, and is the cable whole?";
            self.state = State::Failed(why.into());
            return Frame::Stop("the sender heard nothing more".into()).bytes();
        }
        let frame = self.frame().bytes();
        let line_s = (frame.len() + AROUND) as f64 * BITS / f64::from(self.baud);
        self.due_s = now_s + line_s + PATIENCE_S;
        frame
    }

    fn frame(&self) -> Frame {
        let Some(number) = self.next else {
            let crc = crc32fast::hash(&self.bytes);
            return Frame::Offer { size: self.bytes.len() as u32, crc, name: self.name.clone() };
        };
        let begin = number as usize * BLOCK;
        let end = (begin + BLOCK).min(self.bytes.len());
        Frame::Block { number, bytes: self.bytes[begin.min(end)..end].to_vec() }
    }
}
