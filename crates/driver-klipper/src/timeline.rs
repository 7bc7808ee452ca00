//! The clock of a board by that of the first one, where several boards move one machine.
//!
//! Each board counts by its own crystal. Motion is planned in ticks of the first board, and becomes ticks of another one
//! by a line; that line is bent a little with each piece of motion, so that it meets what the board's clock is seen to
//! do. Only what is not handed out yet follows the bend: ticks that were handed out stay.
//!
//! ```text
//!  own   │                  ╱ · estimate
//!  ticks │            ╱──· ╱    bent: meets the estimate some seconds on
//!        │      ╱ ── ·
//!        │ ╱──       │ handed out up to here
//!        └───────────┴──────────► ticks of the first board
//! ```

use crate::clock::Clock;

/// Time in which a line that was bent meets the estimate, seconds.
const MEETS_S: f64 = 2.0;
/// Most that a bend changes the rate, as a share: an axis that moves with others on another board must not jerk.
const BEND: f64 = 20e-6;

/// The line of one board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timeline {
    /// Clock of the first board from which the line holds, and the own clock then.
    from: (f64, f64),
    /// Own ticks for a tick of the first board.
    rate: f64,
}

impl Timeline {
    /// The line of a board from a clock of the first one on.
    pub fn new(first: &Clock, own: &Clock, from: f64) -> Self {
        Self { from: (from, own.at(first.moment_s(from))), rate: own.rate() / first.rate() }
    }

    /// Own clock at a clock of the first board.
    pub fn at(&self, clock: f64) -> f64 {
        self.from.1 + (clock - self.from.0) * self.rate
    }

    /// Clock of the first board at an own clock.
    pub fn back(&self, own: f64) -> f64 {
        self.from.0 + (own - self.from.1) / self.rate
    }

    /// Own ticks for a tick of the first board.
    pub const fn rate(&self) -> f64 {
        self.rate
    }

    /// Bends the line from a clock of the first board up to which clocks were handed out.
    pub fn bend(&mut self, first: &Clock, own: &Clock, from: f64) {
        let at = self.at(from);
        let on = from + MEETS_S * first.rate();
        let rate = (own.at(first.moment_s(on)) - at) / (on - from);
        let likely = own.rate() / first.rate();
        self.from = (from, at);
        self.rate = rate.clamp(likely * (1.0 - BEND), likely * (1.0 + BEND));
    }
}
