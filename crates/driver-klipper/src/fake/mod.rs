//! A board that is none, after the protocol's description. It shares no code with the crate: it has its own reader of
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
#[derive(Clone, Copy, Debug, Default)]
pub struct Pace {
    real_s: f64,
    own_s: f64,
}

impl Pace {
    /// The longest turn, seconds.
    const TURN_S: f64 = 0.002;

    /// Returns the board's time at a moment of the world, seconds.
    pub fn at(&mut self, real_s: f64) -> f64 {
        self.own_s += (real_s - self.real_s).clamp(0.0, Self::TURN_S);
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
