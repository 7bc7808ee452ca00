//! State before a run, the basis of its diagram: by it a diagram of an earlier run is found still true.

use kerf_control::Session;
use kerf_machine::Configuration;
use kerf_program::{Axis, AxisSet, Independent};
use kerf_sim::Outputs;
use std::sync::Arc;

/// Everything of a session that a run of the simulated machine depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct Basis {
    memory: kerf_sbp::Session,
    gcode: kerf_gcode::State,
    machine_is: Arc<Configuration>,
    homed: AxisSet,
    outputs: Outputs,
    switches: Vec<(u8, bool)>,
    alone: Vec<(Axis, Independent)>,
}

impl Basis {
    /// As a session is now.
    pub fn of(session: &Session) -> Self {
        let Session { memory, gcode, machine_is, homed, .. } = session.clone();
        let look = |machine: &kerf_sim::Machine| (*machine.outputs(), machine.moving_alone());
        let ((outputs, alone), switches) = (session.look(look), session.switches());
        Self { memory, gcode, machine_is, homed, outputs, switches, alone }
    }
}
