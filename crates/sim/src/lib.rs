//! The simulated machine: what a real one would do, computed instead of done.
//!
//! [`Simulated`] makes a plan in the time of a [`Clock`] and tells what its switches and sensors feel; [`Physics`] works
//! that out. [`Hands`] press its switches and push its axes while a run drives it. A [`Simulation`] is all of it between
//! two runs, with what is believed of the machine.
//!
//! ```text
//!  plan, settings ──► Simulated ──► News: an input changed      told like the inputs of any machine
//!                        │
//!                     Physics: carriages, home switches, things on the table, the head over its sheet
//!                        │
//!  script, keys ─────► Hands
//! ```
//!
//! Millimetres, degrees and seconds; positions in the machine frame.

mod carriages;
mod hands;
mod head;
mod physics;
mod pushes;
pub mod random;
mod scene;
mod sheet;
mod simulated;
mod simulation;

pub use hands::{Hands, Opened};
pub use physics::{Physics, untouched};
pub use pushes::Push;
pub use scene::{Body, Touch};
pub use sheet::Sheet;
pub use simulated::{Clock, Simulated};
pub use simulation::Simulation;
