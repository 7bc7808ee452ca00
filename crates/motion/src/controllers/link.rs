//! The serial line to a controller that is fed while it runs: so many bytes a second, and a buffer
//! that takes so many before the first of them is read ("character counting" in grbl's description
//! of its interface).

use std::collections::VecDeque;

/// A serial line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// Bits a second; a byte takes ten.
    pub baud: f64,
    /// Bytes of the receive buffer, of which one stays free.
    pub buffer: usize,
}

impl Default for Link {
    /// grbl's.
    fn default() -> Self {
        Self { baud: 115_200.0, buffer: 128 }
    }
}

/// Traffic on a serial line, from which the arrival of lines is computed.
#[derive(Debug)]
pub(super) struct Line {
    link: Option<Link>,
    /// Lines on their way or in the buffer: bytes, and when they were read.
    sent: VecDeque<(usize, f64)>,
    in_flight: usize,
    free_s: f64,
}

impl Line {
    pub const fn new(link: Option<Link>) -> Self {
        Self { link, sent: VecDeque::new(), in_flight: 0, free_s: 0.0 }
    }

    /// Computes the time at which the next line has arrived, seconds. Every line before has been read.
    pub fn arrival_s(&mut self, bytes: usize) -> f64 {
        let Some(link) = self.link else { return 0.0 };
        let room = link.buffer.saturating_sub(1).max(bytes);
        while self.in_flight + bytes > room {
            let Some((gone, read_s)) = self.sent.pop_front() else { break };
            self.in_flight -= gone;
            self.free_s = self.free_s.max(read_s);
        }
        self.free_s += bytes as f64 * 10.0 / link.baud;
        self.free_s
    }

    /// The line that arrived last has been read.
    pub fn read(&mut self, bytes: usize, at_s: f64) {
        if self.link.is_some() {
            self.sent.push_back((bytes, at_s));
            self.in_flight += bytes;
        }
    }
}
