//! A line between a host and a board, with a delay, and mistakes by dice.

use super::Dice;
use std::collections::VecDeque;

/// Shares of pieces (a frame, mostly) that a mistake befalls.
#[derive(Clone, Copy, Debug, Default)]
pub struct Faults {
    pub drop: f64,
    pub flip: f64,
    pub repeat: f64,
    pub swap: f64,
    pub cut: f64,
    pub delay: f64,
}

impl Faults {
    pub fn all(share: f64) -> Self {
        Self { drop: share, flip: share, repeat: share, swap: share, cut: share, delay: share }
    }
}

/// One way of a line.
#[derive(Clone, Debug)]
pub struct Line {
    dice: Dice,
    pub faults: Faults,
    /// Time that a piece needs, seconds.
    pub delay_s: f64,
    /// Moment of arrival, bytes.
    pieces: VecDeque<(f64, Vec<u8>)>,
    last_s: f64,
    /// Mistakes made.
    pub mistakes: u64,
    pub bytes: u64,
    pub frames: u64,
}

impl Line {
    pub fn new(seed: u64, faults: Faults, delay_s: f64) -> Self {
        Self {
            dice: Dice(seed),
            faults,
            delay_s,
            pieces: VecDeque::new(),
            last_s: 0.0,
            mistakes: 0,
            bytes: 0,
            frames: 0,
        }
    }

    /// Puts bytes on the line, cut into frames so that a mistake befalls one.
    pub fn put(&mut self, bytes: &[u8], now_s: f64) {
        self.bytes += bytes.len() as u64;
        let mut rest = bytes;
        while !rest.is_empty() {
            let length = usize::from(rest[0]);
            let length = if (5..=64).contains(&length) { length.min(rest.len()) } else { 1 };
            let (piece, after) = rest.split_at(length);
            self.frames += u64::from(length > 1);
            self.piece(piece.to_vec(), now_s);
            rest = after;
        }
    }

    fn hit(&mut self, share: f64) -> bool {
        let hit = share > 0.0 && self.dice.share() < share;
        self.mistakes += u64::from(hit);
        hit
    }

    fn piece(&mut self, mut piece: Vec<u8>, now_s: f64) {
        let Faults { drop, flip, repeat, swap, cut, delay } = self.faults;
        if self.hit(drop) {
            return;
        }
        if self.hit(flip) {
            let at = self.dice.below(piece.len() as u64 * 8) as usize;
            piece[at / 8] ^= 1 << (at % 8);
        }
        if self.hit(cut) {
            piece.truncate(self.dice.below(piece.len() as u64) as usize);
        }
        let late = if self.hit(delay) { self.dice.share() * 0.01 } else { 0.0 };
        self.last_s = self.last_s.max(now_s + self.delay_s + late);
        let twice = self.hit(repeat);
        self.pieces.push_back((self.last_s, piece.clone()));
        if twice {
            self.pieces.push_back((self.last_s, piece));
        }
        let many = self.pieces.len();
        if many > 1 && self.hit(swap) {
            let (a, b) = (self.pieces[many - 2].1.clone(), self.pieces[many - 1].1.clone());
            (self.pieces[many - 2].1, self.pieces[many - 1].1) = (b, a);
        }
    }

    /// Bytes that have arrived.
    pub fn take(&mut self, now_s: f64) -> Vec<u8> {
        let mut bytes = Vec::new();
        while self.pieces.front().is_some_and(|(at_s, _)| *at_s <= now_s) {
            bytes.extend(self.pieces.pop_front().unwrap().1);
        }
        bytes
    }

    pub fn next_s(&self) -> f64 {
        self.pieces.front().map_or(f64::INFINITY, |(at_s, _)| *at_s)
    }
}
