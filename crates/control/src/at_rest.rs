//! Looks at a machine that stands, and changes to it, without a program.

use crate::session::{Company, Session};
use crate::world::{World, actuator};
use kerf_journal::{
    Journal, Press, RunOptions, machine_file::MachineFileError, switches, switches::SWITCHES,
};
use kerf_machine::{Configuration, Driven, Setting};
use kerf_part::Program;
use kerf_program::OutputReason;
use kerf_sbp::{SPINDLE_STATUS, SystemVariable, Value};
use kerf_sim::{Change, Machine, contact};
use kerf_trace::Event;
use kerf_workspace::Workspace;
use std::sync::Arc;

impl Session {
    /// Looks at the simulated machine as it stands.
    pub fn look<T>(&self, look: impl FnOnce(&Machine) -> T) -> T {
        look(&self.machine(Vec::new()))
    }

    /// Moves the switch of an input of the simulated machine, which stands; the switch stays there, also
    /// when Kerf is started anew.
    pub fn press(&mut self, press: Press, workspace: &mut Workspace) {
        let mut machine = self.machine(Vec::new());
        machine.press(Change { input: press.number, on: press.on, at_s: 0.0 });
        machine.log().take().for_each(drop);
        self.machine = Some(machine);
        self.keep_switches(workspace);
    }

    /// Switches an output of the machine, which stands, by the number of its line.
    pub fn switch_at_rest(&mut self, number: u8, on: bool, driven: &Driven) {
        let mut machine = self.machine(Vec::new());
        machine.output(number, on, OutputReason::Program);
        set_all(&mut machine, driven);
        self.machine = Some(machine);
    }

    /// Somebody stops the machine, which stands: what a stop switches off goes off, unless the machine is set to
    /// leave it on. Whether anything did.
    pub fn stop_at_rest(&mut self, workspace: &mut Workspace, driven: &Driven) -> bool {
        let is_on = |machine: &Machine| machine.turns() || machine.outputs().is_any_on();
        if self.machine_is.misc.outputs_stay_on || !self.machine.as_ref().is_some_and(is_on) {
            return false;
        }
        let mut machine = self.machine(Vec::new());
        machine.log().take().for_each(drop);
        machine.stop_at_rest();
        let switched = set_all(&mut machine, driven) > 0;
        self.memory.independent = machine.spinning();
        self.machine = Some(machine);
        if switched {
            workspace.set_value(SPINDLE_STATUS, Some("0"));
        }
        switched
    }

    /// The controller tells that an input changed while it stands.
    pub fn senses(&mut self, (number, active): (u8, bool)) {
        let on = contact(number, active, &self.memory.settings.io);
        let mut machine = self.machine(Vec::new());
        machine.press(Change { input: number, on, at_s: 0.0 });
        machine.log().take().for_each(drop);
        self.machine = Some(machine);
    }

    /// Puts on record where somebody left the switches of the simulated machine.
    pub(crate) fn keep_switches(&self, workspace: &mut Workspace) {
        let moved = self.machine.as_ref().map(Machine::switches).unwrap_or_default();
        let kept = switches::write(&moved);
        if workspace.stored.get(SWITCHES) != kept.as_deref() {
            workspace.stored.set(SWITCHES, kept.as_deref());
            workspace.stored.keep(SWITCHES);
        }
    }

    /// Lists labels and values that help to find a fault (UD), and leaves nothing behind.
    pub fn diagnostics(&self, workspace: &mut Workspace) -> Vec<(String, String)> {
        let program = kerf_sbp::read_typed("UD".into(), "UD\n");
        let mut options = RunOptions::default();
        options.program.typed = true;
        let mut events: Vec<Event> = Vec::new();
        let company = Company {
            sink: &mut events,
            operator: &mut (),
            requests: &mut (),
            machine: crate::simulated(),
        };
        self.clone().run(Program::from(program), options, workspace, company);
        let told = events.iter().find_map(|event| match event {
            Event::Message { text, .. } => Some(text.clone()),
            _ => None,
        });
        let parted = |line: &str| line.split_once(": ").map(|(a, b)| (a.to_owned(), b.to_owned()));
        told.as_deref().unwrap_or_default().lines().filter_map(parted).collect()
    }

    /// Has another configuration from now on, and keeps a setting of it where that is kept.
    ///
    /// # Errors
    /// It holds, but cannot be kept.
    pub fn configure(
        &mut self,
        setting: &'static Setting,
        wanted: Configuration,
        workspace: &Workspace,
    ) -> Result<(), MachineFileError> {
        let kept = |journal: &Journal| journal.settings.file().keep_one(setting, &wanted);
        let told = workspace.journal().map_or(Ok(()), kept);
        self.hold(wanted);
        told
    }

    /// Has another configuration until Kerf ends: nothing of it is kept.
    pub fn hold(&mut self, wanted: Configuration) {
        self.memory.settings = wanted.program.clone();
        self.machine_is = Arc::new(wanted);
    }

    /// Keeps the configuration that holds, where settings are kept. Gives how many of them were not yet.
    ///
    /// # Errors
    /// As it cannot be kept.
    pub fn keep_configuration(&self, workspace: &Workspace) -> Result<usize, MachineFileError> {
        let kept = |journal: &Journal| journal.settings.file().keep_all(&self.configuration());
        workspace.journal().map_or(Ok(0), kept)
    }

    /// Reads every system variable as it is now, in order of numbers.
    pub fn system_variables(&self, workspace: &mut Workspace) -> Vec<(SystemVariable, Value)> {
        let (mut sink, mut operator) = ((), ());
        let mut world = World::new(
            self.machine(Vec::new()),
            workspace,
            &mut sink,
            &mut operator,
            crate::simulated(),
        );
        let options = kerf_sbp::Options::default();
        let program = kerf_sbp::Program::default();
        let mut reader = kerf_sbp::Interpreter::new(program, self.memory.clone(), options);
        let read = |variable: SystemVariable| {
            world.settled = true;
            let value = reader.system_variable(&mut world, variable.number);
            (variable, value.unwrap_or(Value::Empty))
        };
        kerf_sbp::system_variables().map(read).collect()
    }
}

/// Has the machine that is driven set what was switched; tells how much happened.
fn set_all(machine: &mut Machine, driven: &Driven) -> usize {
    let happened = machine.log().take();
    happened
        .inspect(|it| actuator(&it.what).iter().for_each(|set| driven.borrow_mut().set(set)))
        .count()
}
