//! Frames that are on their way: their numbers, copies of them, and the room in the board's buffer.

use crate::wire::frame::{CONTENT, EMPTY, frame};
use std::collections::VecDeque;

/// Most frames on their way. Numbers of four bits would allow 15.
const MOST_FRAMES: usize = 12;

/// A frame on its way.
#[derive(Clone, Debug)]
pub struct Sent {
    bytes: Vec<u8>,
    /// Marks of its commands.
    pub marks: Vec<u32>,
    /// Moment at which it went out first, seconds.
    pub sent_s: f64,
    /// It went out more than once.
    pub resent: bool,
}

/// The meaning of a frame from the board for those on their way.
#[derive(Debug)]
pub struct Answer {
    /// Frames that it acknowledges, oldest first.
    pub acknowledged: Vec<Sent>,
    /// The board has seen a frame that it did not expect: one before it is missing.
    pub missed: bool,
}

/// Frames on their way, oldest first. Numbers count on without end here; four bits of them are on the line.
#[derive(Clone, Debug)]
pub struct Flight {
    frames: VecDeque<Sent>,
    /// Number of the next frame.
    next: u64,
    /// Highest number that an empty frame of the board told.
    emptied: u64,
    /// Numbers and lengths of frames that may still lie in the board's buffer.
    buffered: VecDeque<(u64, usize)>,
    /// Bytes of that buffer.
    window: usize,
}

impl Flight {
    /// Nothing is on its way, and the board expects that number.
    pub fn new(expected: u8) -> Self {
        let next = u64::from(expected);
        let (frames, buffered) = (VecDeque::new(), VecDeque::new());
        Self { frames, next, emptied: next, buffered, window: usize::MAX }
    }

    /// The board's buffer holds so many bytes.
    pub fn limit(&mut self, window: usize) {
        self.window = window;
    }

    /// Frames on their way.
    pub fn frames(&self) -> usize {
        self.frames.len()
    }

    /// Nothing is on its way, and the board's buffer is known to be empty.
    pub fn is_idle(&self) -> bool {
        self.frames.is_empty() && self.buffered.is_empty()
    }

    /// Moment at which the oldest frame went out first.
    pub fn oldest_s(&self) -> Option<f64> {
        self.frames.front().map(|sent| sent.sent_s)
    }

    /// Bytes of content that another frame may have; nothing where there may be none.
    pub fn room(&self) -> Option<usize> {
        if self.frames.len() >= MOST_FRAMES {
            return None;
        }
        let taken: usize = self.buffered.iter().map(|(_, length)| length).sum();
        let room = self.window.saturating_sub(taken).checked_sub(EMPTY)?;
        Some(room.min(CONTENT))
    }

    /// Puts a frame on its way, and returns its bytes.
    pub fn push(&mut self, content: &[u8], marks: Vec<u32>, sent_s: f64) -> Vec<u8> {
        let bytes = frame(self.next, content);
        self.buffered.push_back((self.next, bytes.len()));
        self.frames.push_back(Sent { bytes: bytes.clone(), marks, sent_s, resent: false });
        self.next += 1;
        bytes
    }

    /// Returns all frames once more.
    pub fn again(&mut self) -> Vec<u8> {
        self.frames.iter_mut().for_each(|sent| sent.resent = true);
        self.frames.iter().flat_map(|sent| sent.bytes.iter().copied()).collect()
    }

    /// The board's buffer has had time to be emptied.
    pub fn drained(&mut self) {
        self.buffered.clear();
    }

    /// Reads the number of a frame from the board; nothing where it cannot be one of this session.
    ///
    /// An empty frame that acknowledges nothing new is a nak, unless a message with the same number came before: then
    /// it is the acknowledgement that follows each frame's answers.
    pub fn heard(&mut self, number: u8, empty: bool) -> Option<Answer> {
        let oldest = self.next - self.frames.len() as u64;
        let behind = (u64::from(number).wrapping_sub(oldest) & 0xf) as usize;
        if behind > self.frames.len() {
            return None;
        }
        let expected = oldest + behind as u64;
        let acknowledged: Vec<Sent> = self.frames.drain(..behind).collect();
        let missed = empty && self.emptied == expected && !self.frames.is_empty();
        if empty {
            self.emptied = expected;
            self.buffered.retain(|(number, _)| *number >= expected);
        }
        Some(Answer { acknowledged, missed })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_acknowledgement_behind_an_answer_is_no_nak() {
        let mut flight = Flight::new(4);
        flight.push(&[1], vec![], 0.0);
        flight.push(&[2], vec![], 0.0);
        let told = |flight: &mut Flight, empty| {
            let answer = flight.heard(5, empty).map(|a| (a.acknowledged.len(), a.missed));
            answer.unwrap_or_else(|| panic!("5 fits"))
        };
        assert_eq!(told(&mut flight, false), (1, false));
        assert_eq!(told(&mut flight, true), (0, false));
        assert_eq!(told(&mut flight, true), (0, true));
    }

    #[test]
    fn numbers_of_another_session_are_not_believed() {
        let mut flight = Flight::new(15);
        flight.push(&[1], vec![], 0.0);
        assert!([1, 2, 14].iter().all(|n| flight.heard(*n, true).is_none()));
        assert_eq!(flight.heard(0, true).map(|answer| answer.acknowledged.len()), Some(1));
    }

    #[test]
    fn twelve_frames_are_on_their_way_at_most() {
        let mut flight = Flight::new(9);
        (0..12).for_each(|_| drop(flight.push(&[1], vec![], 0.0)));
        assert_eq!(flight.room(), None);
        flight.heard(10, true);
        assert_eq!(flight.room(), Some(CONTENT));
    }

    #[test]
    fn a_buffer_is_emptied_by_empty_frames_alone() {
        let mut flight = Flight::new(0);
        flight.limit(64);
        flight.push(&[0; 45], vec![], 0.0);
        assert_eq!(flight.room(), Some(9));
        flight.heard(1, false);
        assert_eq!(flight.room(), Some(9));
        flight.heard(1, true);
        assert_eq!(flight.room(), Some(59));
    }
}
