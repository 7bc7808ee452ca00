//! One machine and everything about it that stays between runs.

use crate::nudge::{Nudge, Outside};
use crate::own_pace::OwnPace;
use kerf_journal::{RunOptions, Work};
use kerf_machine::homing::bounds_by_hand;
use kerf_machine::{Configuration, Errand};
use kerf_model::{Change, Inputs, Model};
use kerf_program::{AXES, Axes, Axis, AxisSet, Frame, Interpreter as _};
use kerf_sequence::Sequence;
use kerf_sim::Simulation;
use std::sync::Arc;

/// A controller, as far as a session has to know it.
#[derive(Clone, Debug, PartialEq)]
pub struct DrivenBy {
    /// Its name, as people give it.
    pub name: String,
    /// The axes that it homes by itself.
    pub homes: AxisSet,
    /// The way in which it makes moves in a time of its own; nothing where it makes the plan in its time.
    pub pace: Option<OwnPace>,
}

/// One machine and everything about it that stays between runs.
#[derive(Clone, Debug, Default)]
pub struct Session {
    /// Settings, frames, position, variables.
    pub memory: kerf_sbp::Session,
    /// Memory of G-code: offsets, parameters, tools, modes.
    pub gcode: kerf_gcode::State,
    /// Configuration of the machine beside the settings of `memory`, which stand above those in here.
    pub machine_is: Arc<Configuration>,
    /// Axes that were homed since their location was lost last.
    pub homed: AxisSet,
    /// The controller that makes what is planned; nothing where the machine is simulated.
    pub driven_by: Option<DrivenBy>,
    /// Runs have begun since Kerf was started.
    pub(crate) begun: bool,
    /// The simulated machine as the last run left it.
    pub(crate) machine: Option<Simulation>,
}

impl Session {
    /// A session in the state of a program's memory.
    pub fn new(memory: kerf_sbp::Session) -> Self {
        Self { memory, ..Self::default() }
    }

    /// Returns the configuration of the machine, with the settings in force.
    pub fn configuration(&self) -> Configuration {
        Configuration { program: self.memory.settings.clone(), ..(*self.machine_is).clone() }
    }

    /// Has another configuration until Kerf ends: nothing of it is kept.
    pub fn hold(&mut self, wanted: Configuration) {
        self.memory.settings = wanted.program.clone();
        self.machine_is = Arc::new(wanted);
    }

    /// Returns `true` if what is typed is only drawn.
    pub const fn is_in_preview(&self) -> bool {
        self.memory.before_preview.is_some()
    }

    /// Returns the height to which a tool that stands lower is lifted after a stop, machine frame; nothing where it stands
    /// as high, or there is no Safe-Z.
    pub fn lift_mm(&self) -> Option<f64> {
        let kerf_sbp::Session { settings, frame, position, .. } = &self.memory;
        let up_mm = frame.working_zero[Axis::Z] + settings.cutter.safe_z_mm?;
        (position[Axis::Z] < up_mm).then_some(up_mm)
    }

    /// Axes that can be homed: those that a controller homes by itself, else those whose home switch is fitted.
    pub fn homes(&self, machine: &Configuration) -> AxisSet {
        if let Some(controller) = &self.driven_by {
            return controller.homes;
        }
        let all = AxisSet::first(AXES);
        let fitted = all.iter().filter(|axis| machine.homing.of(*axis).fitted);
        fitted.fold(AxisSet::EMPTY, AxisSet::with)
    }

    /// Those of the axes that can be homed.
    pub(crate) fn fitted(&self, machine: &Configuration, axes: AxisSet) -> AxisSet {
        let homes = self.homes(machine);
        axes.iter().filter(|axis| homes.contains(*axis)).fold(AxisSet::EMPTY, AxisSet::with)
    }

    /// Axes that can be homed and were not.
    pub fn not_homed(&self, machine: &Configuration) -> AxisSet {
        self.homes(machine).without(self.homed)
    }

    /// The errand that moves the tool a little, internal units (MN); [`Session::nudged`] ends it.
    ///
    /// # Errors
    /// [`Outside`] when the table limits are checked and do not allow it, or the axis has no room.
    pub fn nudge(&self, axis: Axis, distance: f64) -> Result<Errand, Outside> {
        let memory = &self.memory;
        let nudge = Nudge { axis, distance };
        nudge.check(&memory.settings, &memory.frame, memory.position)?;
        let room = bounds_by_hand(&self.machine_is, axis, self.homed.contains(axis));
        nudge.within(room, memory.position)?;
        let mut place = [None; AXES];
        place[axis.index()] = Some(distance);
        Ok(Errand::To { place, relative: true, flat: false })
    }

    /// The tool was nudged from a place on: working locations stay, so that what is cut next shifts, and table base
    /// coordinates follow, so that ST finds the true place again.
    pub fn nudged(&mut self, from: Axes) {
        let way = self.memory.position.minus(from);
        let zero = &mut self.memory.frame.working_zero;
        *zero = zero.plus(way);
    }

    /// Looks at the simulated machine as it stands.
    pub fn look<T>(&self, look: impl FnOnce(&Model) -> T) -> T {
        look(&self.machine(Vec::new()).model)
    }

    /// Switches of the simulated machine that somebody moved by hand, and where they were left.
    pub fn switches(&self) -> Vec<(u8, bool)> {
        self.machine(Vec::new()).switches()
    }

    /// Returns how far each motor's carriage is from where the controller believes it: what only the simulation knows.
    pub fn truth(&self) -> Vec<Vec<f64>> {
        self.machine(Vec::new()).truth()
    }

    /// The simulated machine as a run finds it.
    pub fn found_by(&self, work: &Work, options: &RunOptions) -> Model {
        let (mut found, inputs) = (self.clone(), options.inputs.clone());
        if let Work::Job(job, machine) = work {
            let sequence = Sequence::new(job.clone(), machine.clone(), self.memory.position);
            found.memory.settings = (**sequence.settings()).clone();
            found.memory.frame = Frame::default();
            return found.machine_like(machine, inputs, AxisSet::first(AXES)).model;
        }
        if options.program.preview && !self.memory.settings.view.start_actual {
            found.draw_from_zero();
        }
        found.machine(inputs).model
    }

    /// The simulated machine, ready for a run.
    pub(crate) fn machine(&self, inputs: Vec<Change>) -> Simulation {
        self.machine_like(&self.machine_is, inputs, self.homed)
    }

    /// The same with another configuration; its lengths bound these axes.
    pub(crate) fn machine_like(
        &self,
        machine_is: &Configuration,
        inputs: Vec<Change>,
        bounded: AxisSet,
    ) -> Simulation {
        let memory = &self.memory;
        let (settings, inputs) = (Arc::new(memory.settings.clone()), Inputs::new(inputs));
        let machine = self.machine.clone().unwrap_or_default();
        let machine = machine.again(memory.position, memory.frame, settings, inputs);
        let machine = machine.equipped(machine_is, bounded);
        match &memory.before_preview {
            Some(before) => machine.drawing_from(before.position),
            None => machine,
        }
    }

    /// A preview that does not start where the tool is starts at X 0, Y 0 (command reference, VP).
    pub(crate) fn draw_from_zero(&mut self) {
        for axis in [Axis::X, Axis::Y] {
            self.memory.position[axis] = self.memory.frame.working_zero[axis];
        }
    }
}
