//! A board with step queues: which of its pins does what.
//!
//! A pin is named as the board names it, `gpio17` or `PA3`; `!` before it turns its level round, `^` pulls an input up and
//! `~` pulls it down: `^!gpio10`.

use super::motors::MOTORS;
use kerf_program::AXES;

/// Pins of a board with step queues, and what its motor drivers need.
#[derive(Clone, Debug, PartialEq)]
pub struct Board {
    /// Boards beside the first, with their ports: `tools /dev/ttyACM1`. Their pins are named `tools:gpio4`.
    pub others: String,
    /// Pins of step and direction of each motor X, Y, Z, W, Q, R: `gpio0 gpio1`. Empty where there is none.
    pub motors: [String; MOTORS],
    /// Pins that give motors their current: `!PA1, !PA2`. Empty where they always have it.
    pub enable: String,
    /// Pin of the home switch of each axis X, Y, Z, A, B, C.
    pub homes: [String; AXES],
    /// Pin of the home switch of the second motor of X, and of Y.
    pub second_homes: [String; 2],
    /// Outputs of part files with their pins: `1 gpio20, 2 !gpio21`.
    pub outputs: String,
    /// Pin of the speed of the spindle, a share of time.
    pub spindle: String,
    /// Speed of the spindle at a share of all the time, revolutions a minute.
    pub spindle_rpm: f64,
    /// Cycles of that pin, Hz.
    pub spindle_hz: f64,
    /// PWM channels of part files with their pins, each a share of time: `1 gpio5`. The first is E0 of M67 and M68.
    pub pwm: String,
    /// Cycles of those pins, Hz.
    pub pwm_hz: f64,
    /// Pin that measures the height of a torch, the voltage of its arc behind a divider. Empty for none.
    pub height: String,
    /// Inputs of part files with their pins, at most eight: `3 ^gpio22`.
    pub inputs: String,
    /// Least width of a step pulse, microseconds.
    pub pulse_us: f64,
    /// Time that the drivers need between direction and step, microseconds.
    pub turn_us: f64,
    /// Each edge is a step, where board and drivers can.
    pub both_edges: bool,
    /// Farthest that a step is from its planned moment, microseconds: less asks more of the line.
    pub error_us: f64,
    /// Steps a second that a motor makes at most.
    pub steps_s: f64,
    /// Time without word from its host after which the board stops all motors, seconds.
    pub deadline_s: f64,
    /// Time for which an output stays on when its host falls silent, seconds.
    pub watch_s: f64,
}

impl Default for Board {
    fn default() -> Self {
        Self {
            others: String::new(),
            motors: Default::default(),
            enable: String::new(),
            homes: Default::default(),
            second_homes: Default::default(),
            outputs: String::new(),
            spindle: String::new(),
            spindle_rpm: 24_000.0,
            spindle_hz: 1000.0,
            pwm: String::new(),
            pwm_hz: 1000.0,
            height: String::new(),
            inputs: String::new(),
            pulse_us: 2.0,
            turn_us: 20.0,
            both_edges: false,
            error_us: 2.0,
            steps_s: 200_000.0,
            deadline_s: 0.1,
            watch_s: 0.5,
        }
    }
}
