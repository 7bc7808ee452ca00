//! Times that other controllers take for the same moves.
//!
//! The same path takes quite different times on different machines, and not for the speed of the
//! axes: controllers differ in how they pass corners, how far they look ahead, and how fast they are
//! fed. Here are models of two families, from their documentation and formulas, checked against
//! measured times of the real ones. They give times and nothing else: no motion is run by them.
//!
//! A *run* is what is made from rest to rest: moves between two commands that wait for the machine
//! to stand.

mod block;
mod grbl;
mod link;
mod linuxcnc;
mod naive_cam;
mod own_planner;

pub use grbl::Grbl;
pub use link::Link;
pub use linuxcnc::{LinuxCnc, Release};
pub use own_planner::OwnPlanner;

use crate::moves::Move;

/// A controller that can say how long it takes.
pub trait Controller {
    /// Seconds for each move of a run.
    fn seconds(&self, run: &[Move]) -> Vec<f64>;
}
