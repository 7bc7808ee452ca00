//! Standing of a machine between two runs, as it goes on record.

use crate::Placed;
use kerf_machine::Configuration;
use kerf_program::AxisSet;

/// A machine that stands, and everything about it that goes on record.
#[derive(Debug)]
pub struct RestingMachine<'a> {
    /// Settings, frames, position.
    pub memory: &'a kerf_sbp::Session,
    /// Memory of G-code.
    pub gcode: &'a kerf_gcode::State,
    /// Configuration of the machine beside the settings of `memory`.
    pub machine: &'a Configuration,
    /// Axes that were homed.
    pub homed: AxisSet,
    /// Distances of the simulated machine from where it is believed to be, if one has run.
    pub truth: Option<Vec<Vec<f64>>>,
}

impl RestingMachine<'_> {
    /// The place of the tool, and the frames.
    pub(crate) fn place(&self) -> Placed {
        Placed { position: self.memory.position, frame: self.memory.frame }
    }
}
