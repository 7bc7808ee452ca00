//! The simulated machine: what a real one would do, computed instead of done.
//!
//! A [`Machine`] has a clock of its own, six axes, twelve inputs whose changes are known beforehand
//! (a script of [`Change`]s), twelve outputs with their modes, a PWM channel, a spindle and a
//! warning light; its motors count steps. Nothing in here waits: whoever owns it says how far the clock goes, and everything
//! that happens meanwhile is written to a [`Log`] with its time, in order.
//!
//! ```text
//!  script of inputs ─┐
//!  planned motion ───┼──► Machine ──► Log: outputs, PWM, light … with their times
//!  commands ─────────┘       └──► Halt: an input that stops motion
//! ```
//!
//! The machine is a value: clone it and run a preview on the copy. Millimetres, degrees and seconds;
//! positions in the machine frame.

mod carriages;
pub mod chance;
mod flips;
mod follower;
mod halt;
mod hand;
mod hands;
mod head;
mod heater;
mod independent;
mod inputs;
mod laser;
pub mod limits;
mod log;
mod machine;
mod motors;
mod outputs;
mod physics;
pub mod ports;
pub mod pulses;
mod scene;
mod sheet;
mod simulated;
mod simulation;
mod trigger;
pub mod vcd;

pub use halt::{Halt, HaltCause, Watched};
pub use hand::Push;
pub use hands::{Hands, Opened};
pub use inputs::{
    CABLE, Change, Duty, Inputs, STALL, STOP_INPUT, contact, duty, input_number, pin,
};
pub use kerf_machine::Lift;
pub use limits::Violation;
pub use log::{Happening, Log, What};
pub use machine::{Machine, WasOn};
pub use outputs::Outputs;
pub use physics::{Physics, untouched};
pub use scene::{Body, Touch};
pub use sheet::Sheet;
pub use simulated::{Clock, Simulated};
pub use simulation::Simulation;
