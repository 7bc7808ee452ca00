//! A fake board, after the protocol's description. It shares no code with the crate: it has its own reader of
//! frames, its own numbers, and a dictionary of its own whose numbers differ from seed to seed.
//!
//! It stands in the library so that tests of the command and an example can use it.
#![allow(clippy::unwrap_used, missing_docs)]

pub mod board;
pub mod chip;
pub mod events;
pub mod input;
pub mod line;
pub mod output;
pub mod reader;
pub mod stepper;
pub mod switch;
pub mod wired;
pub mod words;

pub use board::Board;
pub use chip::Chip;
pub use line::{Faults, Line};
pub use wired::Wired;

/// Time of a board that shares its processor with others: where it is kept waiting its clock does too, so that it is late
/// for nothing, as no real one is.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    real_s: f64,
    own_s: f64,
    /// The longest turn, seconds: where it waits for longer its clock stops.
    turn_s: f64,
}

impl Default for Pace {
    fn default() -> Self {
        Self::of_turn(0.002)
    }
}

impl Pace {
    /// A board that catches up with turns of so many seconds; its host sends as far ahead at least.
    pub const fn of_turn(turn_s: f64) -> Self {
        Self { real_s: 0.0, own_s: 0.0, turn_s }
    }

    /// Returns the board's time at a moment of the world, seconds.
    pub fn at(&mut self, real_s: f64) -> f64 {
        self.own_s += (real_s - self.real_s).clamp(0.0, self.turn_s);
        self.real_s = real_s;
        self.own_s
    }
}

/// Numbers without order, the same for the same seed (SplitMix64).
#[derive(Clone, Debug)]
pub struct Dice(pub u64);

impl Dice {
    pub fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    pub fn below(&mut self, n: u64) -> u64 {
        self.roll() % n.max(1)
    }

    pub fn share(&mut self) -> f64 {
        (self.roll() >> 11) as f64 / (1_u64 << 53) as f64
    }
}
