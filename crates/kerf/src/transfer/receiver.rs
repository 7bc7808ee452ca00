//! The end that is sent a file.

use super::frame::{BLOCK, Frame, Reader};
use super::{HOLD_S, LARGEST, LOST_S, Progress, State};

/// Receives one file.
#[derive(Debug)]
pub struct Receiver {
    state: State,
    reader: Reader,
    name: String,
    size: usize,
    crc: u32,
    bytes: Vec<u8>,
    heard_s: f64,
    held_s: f64,
    out: Vec<u8>,
}

impl Default for Receiver {
    fn default() -> Self {
        Self {
            state: State::Waiting,
            reader: Reader::default(),
            name: String::new(),
            size: 0,
            crc: 0,
            bytes: Vec::new(),
            heard_s: 0.0,
            held_s: f64::NEG_INFINITY,
            out: Vec::new(),
        }
    }
}

impl Receiver {
    /// Returns its state.
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// Returns its progress.
    pub fn progress(&self) -> Progress {
        Progress { name: self.name.clone(), done: self.bytes.len(), total: self.size }
    }

    /// The file, once all of it is there.
    pub fn file(&self) -> Option<(&str, &[u8])> {
        (self.state == State::Done).then_some((&*self.name, &*self.bytes))
    }

    /// Somebody stops it here.
    pub fn stop(&mut self) {
        if !self.state.is_over() {
            self.end(State::Stopped, "");
        }
    }

    /// The file cannot be kept.
    pub fn refuse(&mut self, why: &str) {
        self.end(State::Failed(why.to_owned()), why);
    }

    fn end(&mut self, state: State, why: &str) {
        self.out.extend(Frame::Stop(why.to_owned()).bytes());
        self.bytes = Vec::new();
        self.state = state;
    }

    /// Bytes came. While the machine moves nothing is taken.
    pub fn hear(&mut self, bytes: &[u8], moving: bool, now_s: f64) {
        self.reader.hear(bytes);
        while let Some(frame) = self.reader.next() {
            self.heard_s = now_s;
            match frame {
                Frame::Stop(why) if !self.state.is_over() && self.state != State::Waiting => {
                    self.bytes = Vec::new();
                    self.state = if why.is_empty() { State::Stopped } else { State::Failed(why) };
                }
                _ if matches!(self.state, State::Stopped | State::Failed(_)) => {}
                Frame::Offer { size, crc, name } => self.offered(size as usize, crc, name, moving),
                Frame::Block { number, bytes } => self.block(number, &bytes, moving),
                Frame::Stop(_) | Frame::Next(_) | Frame::Hold => {}
            }
        }
        let waits = matches!(self.state, State::Sending | State::Held);
        if waits && now_s - self.heard_s > LOST_S {
            self.refuse("the line is dead: nothing came any more");
        }
        self.tell_hold(moving, now_s);
    }

    fn offered(&mut self, size: usize, crc: u32, name: String, moving: bool) {
        if self.state == State::Done {
            return;
        }
        if size > LARGEST || !is_name(&name) {
            return self.refuse(&format!("{name:?} cannot be taken: its name or its size"));
        }
        let same = (&self.name, self.size, self.crc) == (&name, size, crc);
        if !same {
            self.bytes = Vec::new();
        }
        (self.name, self.size, self.crc) = (name, size, crc);
        self.answer(moving);
    }

    fn block(&mut self, number: u32, bytes: &[u8], moving: bool) {
        let wanted = self.bytes.len().div_ceil(BLOCK);
        match self.state {
            State::Waiting => return,
            State::Done => return self.ask(),
            _ => {}
        }
        let fits = self.bytes.len() + bytes.len() <= self.size;
        if number as usize == wanted && !moving && fits {
            self.bytes.extend_from_slice(bytes);
        }
        self.answer(moving);
    }

    /// Says what it wants next, or that the machine moves.
    fn answer(&mut self, moving: bool) {
        if moving {
            self.state = State::Held;
            return self.out.extend(Frame::Hold.bytes());
        }
        self.state = State::Sending;
        if self.bytes.len() == self.size {
            if crc32fast::hash(&self.bytes) != self.crc {
                return self.refuse("the file is not what was offered: send it again");
            }
            self.state = State::Done;
            // It is told when it is kept.
            return;
        }
        self.ask();
    }

    fn ask(&mut self) {
        let next = self.bytes.len().div_ceil(BLOCK) as u32;
        self.out.extend(Frame::Next(next).bytes());
    }

    /// The file is kept.
    pub fn kept(&mut self) {
        self.ask();
    }

    /// The sender learns from time to time that the machine still moves, and when it stands.
    fn tell_hold(&mut self, moving: bool, now_s: f64) {
        if self.state != State::Held || now_s - self.held_s < HOLD_S {
            return;
        }
        self.held_s = now_s;
        self.heard_s = if moving { self.heard_s } else { now_s };
        self.answer(moving);
    }

    /// Returns the bytes that are to be sent now.
    pub fn speak(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.out)
    }
}

/// A plain file name: it lies in the folder and nowhere else.
fn is_name(name: &str) -> bool {
    let plain = !name.is_empty() && name.len() <= 200 && !name.starts_with('.');
    plain && !name.contains(['/', '\\', ':', '\0'])
}
