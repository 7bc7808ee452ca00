//! Beliefs about a machine while a run drives it, whatever machine it is.
//!
//! A [`Model`] has a clock, six axes, the inputs as the machine told them, the outputs with their modes, a PWM channel, a
//! spindle and a warning light; it counts the steps of the motors. It learns what was made and what was told, and moves
//! nothing. Nothing in here waits: whoever owns it says how far the clock goes, and everything that follows meanwhile is
//! written to a [`Log`] with its time, in order.
//!
//! ```text
//!  inputs that were told ─┐
//!  motion that was made ──┼──► Model ──► Log: outputs, PWM, light … with their times
//!  commands ──────────────┘      └──► Halt: an input that stops motion
//! ```
//!
//! The model is a value: clone it and run a preview on the copy. Millimetres, degrees and seconds; positions in the
//! machine frame.

mod flips;
mod halt;
mod heater;
mod independent;
mod inputs;
mod laser;
pub mod limits;
mod log;
mod model;
mod motors;
mod outputs;
pub mod ports;
mod trigger;

pub use flips::flips;
pub use halt::{Halt, HaltCause, Watched};
pub use inputs::{
    CABLE, Change, Duty, Inputs, STALL, STOP_INPUT, contact, duty, input_number, pin, triggers,
};
pub use limits::Violation;
pub use log::{Happening, Log, What};
pub use model::{Model, WasOn};
pub use outputs::Outputs;
