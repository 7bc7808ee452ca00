//! The near end of the line: commands become frames, frames that are lost are sent again.
//!
//! A board runs frames in the order of their numbers and tells in each of its own frames the number that it expects
//! next. So each command that goes in here is run once and in order, however the line spoils bytes. Answers are not
//! assured: whoever asks asks again.
//!
//! ```text
//!  send ──► waiting ──► in flight (≤ 12 frames, ≤ the board's buffer) ──► acknowledged
//!                           ▲     │ nak, timeout
//!                           └─────┘ all of them again, unchanged, oldest first
//! ```
//!
//! Times are seconds on the owner's clock, which never goes back.

mod flight;
mod join;
mod round_trip;

pub use join::Join;

use crate::wire::frame::{CONTENT, Reader, SYNC};
use flight::Flight;
use round_trip::RoundTrip;
use std::collections::VecDeque;

/// Time for which commands of motion wait for others to fill their frame, seconds: longer than from one piece of motion to
/// the next.
pub const FILLS_S: f64 = 0.025;
/// Bits of a byte on a serial line: start, eight, stop.
const BITS: f64 = 10.0;

/// A command that is not in a frame yet.
#[derive(Clone, Debug)]
struct Command {
    bytes: Vec<u8>,
    mark: Option<u32>,
    /// Of no use once motion is dropped: the clock of its first step, or the end of all clocks where it makes none.
    motion: Option<u64>,
}

/// News of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Heard {
    /// The board has run a command that was sent with a mark. Comes before the answer to it.
    Delivered {
        /// The mark.
        mark: u32,
        /// Moment at which it was handed to the line.
        sent_s: f64,
        /// It was sent once, so that times measured by it are true.
        once: bool,
    },
    /// A message of the board, as bytes.
    Message(Vec<u8>),
    /// A message in a frame whose number is none that can come: one of long ago, or of a board that begins anew.
    OutOfTurn(Vec<u8>),
}

/// Bytes for the line.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outgoing {
    /// They are to be written now.
    pub bytes: Vec<u8>,
    /// They hold again all that the line has not sent yet: a serial port may drop that.
    pub replaces: bool,
}

/// A line to a board that has been joined.
#[derive(Clone, Debug)]
pub struct Link {
    reader: Reader,
    flight: Flight,
    round_trip: RoundTrip,
    urgent: VecDeque<Command>,
    waiting: VecDeque<Command>,
    /// Moment from which commands of motion wait for others to fill their frame.
    fills_s: Option<f64>,
    /// They do not wait.
    hurries: bool,
    /// Seconds a byte takes on the line.
    byte_s: f64,
    /// Moment from which the line is free.
    free_s: f64,
    /// Frames in flight go out again.
    again: bool,
    /// Frames that went out a second time.
    resent: u64,
    /// Moment at which the board was heard last.
    heard_s: f64,
}

impl Link {
    /// A line whose board expects a number next, as [`Join`] found it.
    pub fn new(expected: u8) -> Self {
        Self {
            reader: Reader::default(),
            flight: Flight::new(expected),
            round_trip: RoundTrip::default(),
            urgent: VecDeque::new(),
            waiting: VecDeque::new(),
            fills_s: None,
            hurries: false,
            byte_s: 0.0,
            free_s: f64::NEG_INFINITY,
            again: false,
            resent: 0,
            heard_s: f64::NEG_INFINITY,
        }
    }

    /// It is a serial line of so many bits a second: bytes need their time on it.
    pub fn paces(&mut self, baud: f64) {
        self.byte_s = BITS / baud.max(1.0);
    }

    /// The board's buffer holds so many bytes (its constant `RECEIVE_WINDOW`).
    pub fn limit(&mut self, window: usize) {
        self.flight.limit(window);
    }

    /// Sends a command behind all others. It has at most [`CONTENT`] bytes; a longer one is refused.
    #[must_use = "a command that is too long is not sent"]
    pub fn send(&mut self, bytes: Vec<u8>, mark: Option<u32>) -> bool {
        Self::queue(&mut self.waiting, Command { bytes, mark, motion: None })
    }

    /// Sends a command behind all others that is of no use once motion is dropped. It may wait for [`FILLS_S`] for others to
    /// fill its frame. One that is too long is refused.
    #[must_use = "a command that is too long is not sent"]
    pub fn send_motion(&mut self, bytes: Vec<u8>, clock: u64) -> bool {
        Self::queue(&mut self.waiting, Command { bytes, mark: None, motion: Some(clock) })
    }

    /// Clock of the first step that is in no frame yet.
    pub fn first_step(&self) -> Option<u64> {
        self.waiting.iter().filter_map(|command| command.motion).min()
    }

    /// Sends a command before those that wait. One that is too long is refused.
    #[must_use = "a command that is too long is not sent"]
    pub fn send_urgent(&mut self, bytes: Vec<u8>, mark: Option<u32>) -> bool {
        Self::queue(&mut self.urgent, Command { bytes, mark, motion: None })
    }

    fn queue(queue: &mut VecDeque<Command>, command: Command) -> bool {
        let fits = (1..=CONTENT).contains(&command.bytes.len());
        if fits {
            queue.push_back(command);
        }
        fits
    }

    /// What waits for its frame to be filled goes out now.
    pub const fn hurry(&mut self) {
        self.hurries = true;
    }

    /// Drops the commands of motion that are in no frame yet.
    pub fn forget(&mut self) {
        self.waiting.retain(|command| command.motion.is_none());
    }

    /// Reads bytes of the board.
    pub fn receive(&mut self, bytes: &[u8], now_s: f64) -> Vec<Heard> {
        let mut news = Vec::new();
        for frame in self.reader.read(bytes) {
            let empty = frame.content.is_empty();
            let Some(answer) = self.flight.heard(frame.number, empty) else {
                news.extend((!empty).then_some(Heard::OutOfTurn(frame.content)));
                continue;
            };
            self.heard_s = now_s;
            for sent in answer.acknowledged {
                let once = !sent.resent;
                if once {
                    self.round_trip.measured(now_s - sent.sent_s);
                }
                let delivered = |mark| Heard::Delivered { mark, sent_s: sent.sent_s, once };
                news.extend(sent.marks.into_iter().map(delivered));
                self.round_trip.progressed(self.free_s.max(now_s));
            }
            self.again |= answer.missed && self.round_trip.is_over_resend(now_s);
            if !empty {
                news.push(Heard::Message(frame.content));
            }
        }
        news
    }

    /// Returns the bytes to be written now.
    pub fn transmit(&mut self, now_s: f64) -> Outgoing {
        if now_s >= self.round_trip.due_s() {
            self.timed_out(now_s);
        }
        let mut out = Outgoing::default();
        if std::mem::take(&mut self.again) {
            out.replaces = true;
            out.bytes.push(SYNC);
            out.bytes.extend(self.flight.again());
            self.resent += self.flight.frames() as u64;
        }
        while let Some(bytes) = self.next_frame(now_s) {
            out.bytes.extend(bytes);
        }
        if !out.bytes.is_empty() {
            self.free_s = self.free_s.max(now_s) + self.byte_s * out.bytes.len() as f64;
            self.round_trip.start(self.free_s);
            if out.replaces {
                self.round_trip.resent(self.free_s);
            }
        }
        out
    }

    /// Returns the moment from which [`transmit`](Self::transmit) has something to do; infinite where nothing is due.
    pub fn due_s(&self) -> f64 {
        let first = self.urgent.front().or(self.waiting.front());
        let fits = |command: &Command| self.flight.room().is_some_and(|n| n >= command.bytes.len());
        if self.again || first.is_some_and(fits) && !self.may_fill() {
            return f64::NEG_INFINITY;
        }
        if self.may_fill() {
            return self.fills_s.map_or(f64::NEG_INFINITY, |since_s| since_s + FILLS_S);
        }
        if self.flight.is_idle() { f64::INFINITY } else { self.round_trip.due_s() }
    }

    /// Returns `true` when every command that was sent has been run.
    pub fn is_idle(&self) -> bool {
        self.flight.frames() == 0 && self.urgent.is_empty() && self.waiting.is_empty()
    }

    /// Bytes of commands that are in no frame yet.
    pub fn waiting(&self) -> usize {
        self.urgent.iter().chain(&self.waiting).map(|command| command.bytes.len()).sum()
    }

    /// Seconds for which the oldest frame in flight has not been acknowledged.
    pub fn silent_s(&self, now_s: f64) -> f64 {
        self.flight.oldest_s().map_or(0.0, |sent_s| now_s - sent_s)
    }

    /// Smoothed round trip and its deviation, seconds.
    pub const fn trip_s(&self) -> Option<[f64; 2]> {
        self.round_trip.smooth_s()
    }

    /// Moment at which the board was heard last.
    pub const fn heard_s(&self) -> f64 {
        self.heard_s
    }

    /// Frames that went out again so far, and damaged places in what came.
    pub const fn troubles(&self) -> [u64; 2] {
        [self.resent, self.reader.damaged()]
    }

    fn timed_out(&mut self, now_s: f64) {
        if self.flight.frames() == 0 {
            self.flight.drained();
            self.round_trip.stop();
            return;
        }
        self.round_trip.missed(now_s);
        self.again = true;
    }

    /// All that waits is motion that does not fill a frame.
    fn may_fill(&self) -> bool {
        let waits = self.urgent.is_empty() && !self.waiting.is_empty() && !self.hurries;
        waits
            && self.waiting.iter().all(|command| command.motion.is_some())
            && self.waiting() < CONTENT
    }

    /// Fills the next frame with whole commands, as far as the board has room.
    fn next_frame(&mut self, now_s: f64) -> Option<Vec<u8>> {
        if self.may_fill() && now_s < *self.fills_s.get_or_insert(now_s) + FILLS_S {
            return None;
        }
        let frame = self.fill(now_s);
        self.fills_s = None;
        self.hurries &= !self.waiting.is_empty();
        frame
    }

    fn fill(&mut self, now_s: f64) -> Option<Vec<u8>> {
        let room = self.flight.room()?;
        let (mut content, mut marks) = (Vec::new(), Vec::new());
        for queue in [&mut self.urgent, &mut self.waiting] {
            while let Some(command) = queue.front() {
                if content.len() + command.bytes.len() > room {
                    // Whatever is behind it waits for the next frame.
                    return (!content.is_empty()).then(|| self.flight.push(&content, marks, now_s));
                }
                content.extend_from_slice(&command.bytes);
                marks.extend(command.mark);
                queue.pop_front();
            }
        }
        (!content.is_empty()).then(|| self.flight.push(&content, marks, now_s))
    }
}
