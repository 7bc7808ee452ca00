//! Choices from a seed.

use kerf_sim::random::SeededRandom;

/// Throws dice.
#[derive(Clone, Debug)]
pub struct Dice(SeededRandom);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(SeededRandom::new(seed))
    }

    /// A whole number from 0 to below so many.
    pub fn below(&mut self, count: usize) -> usize {
        (self.0.next() % count.max(1) as u64) as usize
    }

    /// One of these.
    pub fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    /// A number between two, to a thousandth.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        ((low + (high - low) * self.0.share()) * 1e3).round() / 1e3
    }

    /// Tells whether something happens that does so in so many of a hundred cases.
    pub fn in_percent(&mut self, percent: u32) -> bool {
        self.0.in_percent(percent)
    }
}
