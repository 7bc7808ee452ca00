//! The simulated machine: where its switches sit and how fast its outputs are.

use super::motors::MOTORS;
use kerf_program::AXES;

/// True places and delays of the simulated machine, whatever the controller believes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simulated {
    /// Place where each motor's homing switch turns on, in true coordinates of its axis, mm or degrees.
    /// Motors without a switch of their own have none.
    pub switch_at: [Option<f64>; MOTORS],
    /// Way from turning on to turning off again, mm or degrees.
    pub hysteresis: f64,
    /// True position of each axis when the program starts.
    pub start_at: [f64; AXES],
    /// Least time from one change of an output to the next, nanoseconds.
    pub output_delay_ns: u32,
}

impl Default for Simulated {
    fn default() -> Self {
        Self {
            switch_at: [None; MOTORS],
            hysteresis: 0.0,
            start_at: [0.0; AXES],
            output_delay_ns: 1000,
        }
    }
}
