//! State before a run, with which a chart of it begins.

use super::Lines;
use super::zero::Zero;
use crate::{RunOptions, Session, Work};
use kerf_machine::Configuration;
use kerf_machine::lines::{Input, Output};
use kerf_program::settings::LINES;
use kerf_program::{Axis, AxisSet, Independent};
use kerf_sim::Outputs;
use std::sync::Arc;

/// Everything of a session that a run of the simulated machine depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct Begun {
    memory: kerf_sbp::Session,
    gcode: kerf_gcode::State,
    machine_is: Arc<Configuration>,
    homed: AxisSet,
    outputs: Outputs,
    switches: Vec<(u8, bool)>,
    alone: Vec<(Axis, Independent)>,
}

impl Begun {
    /// As a session is now.
    pub fn of(session: &Session) -> Self {
        let Session { memory, gcode, machine_is, homed, .. } = session.clone();
        let look = |machine: &kerf_sim::Machine| {
            (*machine.outputs(), machine.switches(), machine.moving_alone())
        };
        let (outputs, switches, alone) = session.look(look);
        Self { memory, gcode, machine_is, homed, outputs, switches, alone }
    }
}

impl Lines {
    /// The lines of a run that begins like this: what is on before is on from the beginning, and courses are
    /// working locations; those of a job are the machine's.
    #[must_use]
    pub fn beginning(mut self, session: &Session, work: &Work, options: &RunOptions) -> Self {
        let machine = session.found_by(work, options);
        self.zero = Some(Zero::new(machine.position(), machine.frame()));
        for n in 1..=LINES as u8 {
            if machine.outputs().is_on(n) {
                self.switch(false, n, Output::of_number(n).map(Output::name), 0.0, true);
            }
            if machine.input(n) {
                self.switch(true, n, Input::of_number(n).map(Input::name), 0.0, true);
            }
        }
        self
    }
}
