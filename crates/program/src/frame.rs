//! The chain of frames from the machine to what the display shows.
//!
//! ```text
//!  machine ──base_zero──► table base ──► working ──file offset, proportion──► what the file says
//!     └────────────────working_zero──────────┘        (file frames belong to the interpreter)
//! ```
//!
//! The machine frame is where the motors are; nothing moves it. ZT and VA move the table base's
//! zero, ZX…Z5, VA and ST the working zero.

use crate::{Axes, Axis};
use serde::{Deserialize, Serialize};

/// Zero points of the table base and of the working locations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Frame {
    /// Machine position of working zero.
    pub working_zero: Axes,
    /// Machine position of table base zero.
    pub base_zero: Axes,
}

impl Frame {
    /// Working location of a machine position.
    pub fn working(&self, machine: Axes) -> Axes {
        machine.minus(self.working_zero)
    }

    /// Table base coordinates of a machine position.
    pub fn base(&self, machine: Axes) -> Axes {
        machine.minus(self.base_zero)
    }

    /// Machine position of a working location.
    pub fn machine(&self, working: Axes) -> Axes {
        working.plus(self.working_zero)
    }

    /// Makes the working location of one axis read `value` at a machine position.
    pub fn set_working(&mut self, axis: Axis, machine: Axes, value: f64) {
        self.working_zero[axis] = machine[axis] - value;
    }

    /// Makes the table base coordinate of one axis read `value` at a machine position.
    pub fn set_base(&mut self, axis: Axis, machine: Axes, value: f64) {
        self.base_zero[axis] = machine[axis] - value;
    }
}
