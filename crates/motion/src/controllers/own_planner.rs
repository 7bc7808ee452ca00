//! The planner of a controller that plans for itself.

use super::{Controller, Grbl, LinuxCnc};
use crate::moves::Move;

/// The planner of a controller that plans for itself, with its settings.
#[derive(Clone, Debug, PartialEq)]
pub enum OwnPlanner {
    /// One of the grbl family.
    Grbl(Grbl),
    /// LinuxCNC's.
    LinuxCnc(LinuxCnc),
}

impl Controller for OwnPlanner {
    fn seconds(&self, run: &[Move]) -> Vec<f64> {
        match self {
            Self::Grbl(grbl) => grbl.seconds(run),
            Self::LinuxCnc(linuxcnc) => linuxcnc.seconds(run),
        }
    }
}
