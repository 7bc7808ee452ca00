//! The time of a plan in a board's ticks, where several boards move one machine.
//!
//! Each board counts by its own crystal. A plan's time becomes ticks of each board by a line; the line of each is
//! bent a little now and then, so that it meets what the board's clock is seen to do. Only what is not planned yet
//! follows the bend: ticks that were handed out stay.
//!
//! ```text
//!  ticks │                  ╱ · estimate
//!        │            ╱──· ╱    bent: meets the estimate some seconds on
//!        │      ╱ ── ·
//!        │ ╱──       │ handed out up to here
//!        └───────────┴──────────► time of the plan
//! ```

use crate::clock::Clock;

/// Time in which a line that was bent meets the estimate, seconds.
const MEETS_S: f64 = 4.0;
/// Most that a bend changes the rate, as a share: an axis that moves with others on another board must not jerk.
const BEND: f64 = 20e-6;

/// The line of one board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timeline {
    /// Host's moment of the plan's beginning, seconds.
    begins_s: f64,
    /// Time of the plan from which the line holds, and the clock then.
    from: (f64, f64),
    /// Ticks a second of the plan.
    rate: f64,
}

impl Timeline {
    /// The line of a board, for a plan that begins at a moment of the host.
    pub fn new(clock: &Clock, begins_s: f64) -> Self {
        Self { begins_s, from: (0.0, clock.at(begins_s)), rate: clock.rate() }
    }

    /// Clock at a time of the plan.
    pub fn at(&self, t_s: f64) -> f64 {
        self.from.1 + (t_s - self.from.0) * self.rate
    }

    /// Bends the line from a time of the plan up to which clocks were handed out.
    pub fn bend(&mut self, from_s: f64, clock: &Clock) {
        let from = self.at(from_s);
        let meets = clock.at(self.begins_s + from_s + MEETS_S);
        let rate = (meets - from) / MEETS_S;
        let most = clock.rate() * BEND;
        self.from = (from_s, from);
        self.rate = rate.clamp(clock.rate() - most, clock.rate() + most);
    }
}
