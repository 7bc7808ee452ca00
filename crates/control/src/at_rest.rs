//! Changes to a machine that stands, without a program.

use crate::happenings::actuator;
use crate::session::Session;
use kerf_journal::Press;
use kerf_machine::Driven;
use kerf_model::{Model, contact};
use kerf_program::OutputReason;
use kerf_sbp::SPINDLE_STATUS;
use kerf_workspace::Workspace;

/// The machine of a session that stands.
pub struct AtRest<'a>(pub &'a mut Session);

impl AtRest<'_> {
    /// Moves the switch of an input of the simulated machine, which stands; the switch stays there, also
    /// when Kerf is started anew.
    pub fn press(&mut self, press: Press, workspace: &mut Workspace) {
        let mut machine = self.0.machine(Vec::new());
        machine.press(press.number, press.on);
        self.0.machine = Some(machine);
        self.0.keep_switches(workspace);
    }

    /// Switches an output of the machine, which stands, by the number of its line.
    pub fn switch(&mut self, number: u8, on: bool, driven: &Driven) {
        let mut machine = self.0.machine(Vec::new());
        machine.model.output(number, on, OutputReason::Program);
        set_all(&mut machine.model, driven);
        self.0.machine = Some(machine);
    }

    /// Switches off what a stop switches off, on a machine that stands, unless the machine is set to
    /// leave it on. Returns `true` if anything went off.
    pub fn stop(&mut self, workspace: &mut Workspace, driven: &Driven) -> bool {
        let is_on = |machine: &Model| machine.turns() || machine.outputs().is_any_on();
        if self.0.machine_is.misc.outputs_stay_on
            || !self.0.machine.as_ref().is_some_and(|it| is_on(&it.model))
        {
            return false;
        }
        let mut machine = self.0.machine(Vec::new());
        let model = &mut machine.model;
        model.log().take().for_each(drop);
        model.stop_at_rest();
        let switched = set_all(model, driven) > 0;
        self.0.memory.independent = model.spinning();
        self.0.machine = Some(machine);
        if switched {
            workspace.set_value(SPINDLE_STATUS, Some("0"));
        }
        switched
    }

    /// The controller tells that an input changed while it stands.
    pub fn senses(&mut self, (number, active): (u8, bool)) {
        let on = contact(number, active, &self.0.memory.settings.io);
        let mut machine = self.0.machine(Vec::new());
        machine.press(number, on);
        self.0.machine = Some(machine);
    }
}

/// Has the machine that is driven set what was switched; tells how much happened.
fn set_all(machine: &mut Model, driven: &Driven) -> usize {
    let happened = machine.log().take();
    happened
        .inspect(|it| actuator(&it.what).iter().for_each(|set| driven.borrow_mut().set(set)))
        .count()
}
