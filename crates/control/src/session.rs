//! The owner of one machine: what stays between runs, and how a run starts.

use crate::Requests;
use crate::answers::Operator;
use crate::before::Whole;
use crate::bound::Bound;
use crate::heights;
use crate::nudge::{Nudge, Outside};
use crate::part_log::PartLog;
use crate::password;
use crate::runner::{LINES, Runner};
use crate::trail::Trail;
use crate::world::World;
use kerf_geom::Bounds3;
use kerf_journal::{Door, Placed, RunOptions, Work};
use kerf_machine::homing::bounds_by_hand;
use kerf_machine::{Configuration, Driven};
use kerf_part::{Interpreter, Program};
use kerf_program::job::Job;
use kerf_program::settings::Mode;
use kerf_program::{AXES, Axis, AxisSet, Frame, Interpreter as _, Settings};
use kerf_sbp::{Dialect, Language, Status, Value};
use kerf_sequence::Sequence;
use kerf_sim::{Change, Inputs, Machine};
use kerf_trace::{
    Sink, Summary,
    event::{BoundsEvent, Corner, EndEvent, Event, Partial, VarValue},
};
use kerf_workspace::{Workspace, unverified};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Participants of a run beside program and machine.
pub struct Company<'a> {
    /// Takes the events.
    pub sink: &'a mut dyn Sink,
    /// Answers questions.
    pub operator: &'a mut dyn Operator,
    /// What the operator asks for meanwhile.
    pub requests: &'a mut dyn Requests,
    /// The machine that makes what is planned.
    pub machine: Driven,
}

impl Company<'_> {
    /// The same company for something that comes first.
    pub fn again(&mut self) -> Company<'_> {
        let Self { sink, operator, requests, machine } = self;
        Company {
            sink: &mut **sink,
            operator: &mut **operator,
            requests: &mut **requests,
            machine: machine.clone(),
        }
    }
}

/// A controller, as far as a session has to know it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DrivenBy {
    /// Its name, as people give it.
    pub name: String,
    /// The axes that it homes by itself.
    pub homes: AxisSet,
}

/// Returns after how many lines commands are looked at; whoever looks where the run stands sees every line.
pub(crate) fn lines_at_once(options: &RunOptions, sink: &dyn Sink) -> u64 {
    match options.lines_at_once {
        0 if sink.looks_at_standing() => 1,
        0 => LINES,
        lines => lines,
    }
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
    pub(crate) machine: Option<Machine>,
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

    /// Runs a program or a job to its end.
    pub fn run(
        &mut self,
        work: impl Into<Work>,
        options: RunOptions,
        workspace: &mut Workspace,
        company: Company<'_>,
    ) -> Summary {
        let mut options = options;
        options.lines_at_once = lines_at_once(&options, &*company.sink);
        let (work, Company { sink, operator, requests, machine }) = (work.into(), company);
        let mut whole = Whole::new(sink);
        let mut company = Company { sink: &mut whole, operator, requests, machine };
        let summary = match self.before(&work, &mut options, workspace, company.again()) {
            Some(summary) => summary,
            None => self.go(work, options, workspace, company, None),
        };
        whole.ends();
        summary
    }

    /// Everything that comes before a run. Gives how that ended when the run is not to begin.
    fn before(
        &mut self,
        work: &Work,
        options: &mut RunOptions,
        workspace: &mut Workspace,
        mut company: Company<'_>,
    ) -> Option<Summary> {
        self.confirm_location(work, options, workspace, company.again())
            .or_else(|| self.before_run(work, options, workspace, company))
    }

    /// Runs a program or a job; one that is taken up by a machine that stands at a place.
    pub(crate) fn go(
        &mut self,
        work: Work,
        options: RunOptions,
        workspace: &mut Workspace,
        company: Company<'_>,
        stands: Option<Placed>,
    ) -> Summary {
        match work {
            Work::Part(program) => self.run_part(*program, options, workspace, company, stands),
            Work::Job(job, machine) => {
                self.run_job(job, &machine, options, workspace, company, stands)
            }
            Work::Hand(errand, machine) => {
                self.run_hand(errand, &machine, options, None, workspace, company)
            }
        }
    }

    /// Runs a program to its end. A program with errors does not start unless that is allowed.
    fn run_part(
        &mut self,
        program: Program,
        options: RunOptions,
        workspace: &mut Workspace,
        company: Company<'_>,
        stands: Option<Placed>,
    ) -> Summary {
        let Company { sink, operator, requests, machine: driven } = company;
        let (mut options, mut program) = (options, program);
        self.refuse_keys(&mut program);
        options.program.protected = self.machine_is.options.password.is_some() && !options.opened;
        let began = options.program.protected.then(|| self.memory.settings.clone());
        sink.event(&self.start_event(program.name(), program.language(), &options));
        for diagnostic in &program.diagnostics {
            sink.event(&Event::Diag(Box::new(diagnostic.clone())));
        }
        if program.has_errors() && !options.program.allow_errors {
            self.log_refused(&program, &options, workspace);
            return self.refused(&program, sink);
        }
        if options.program.preview && !self.memory.settings.view.start_actual {
            self.draw_from_zero();
        }
        self.tell_not_homed(&self.machine_is, &options, sink);
        let tally = options.before.tally();
        let log = PartLog::begin(self, &options.program, options.started);
        let depth = usize::from(options.program.typed);
        let machine = self
            .machine(options.inputs)
            .begun_at(options.before.ends_s)
            .with_touches(&options.touches)
            .pushed(options.pushes)
            .doubting(unverified(workspace));
        let memory = kerf_part::Session {
            sbp: std::mem::take(&mut self.memory),
            gcode: std::mem::take(&mut self.gcode),
        };
        let mut world = World::new(machine, workspace, sink, operator, driven);
        (world.previews, world.tally) = (options.program.preview, tally);
        world.silent = stands.is_some();
        (world.machine_is, world.homed) = (self.machine_is.clone(), self.homed);
        world.typed_files = depth;
        let read = kerf_part::Options { sbp: options.program, gcode: options.gcode };
        let interpreter = Interpreter::new(program, memory, read);
        let mut runner =
            Runner::new(interpreter, world, requests, options.limits, options.lines_at_once);
        runner.restore = options.restore.then_some(saved_and_restored);
        runner.trail = Trail::new(depth);
        runner.bound = Bound::of(options.most_commands);
        runner.reentry = stands;
        let over = runner.run();
        if let Some(log) = log {
            runner.write_log(&log, &over);
        }
        runner.write_system_log(&over);
        let (summary, memory, machine) = conclude(runner, over, options.tell_variables);
        machine.unverified().iter().for_each(|axis| self.homed.remove(axis));
        (self.memory, self.gcode, self.machine) = (memory.sbp, memory.gcode, Some(machine));
        if let Some(began) = began {
            self.give_back(&began);
        }
        summary
    }

    /// Has the settings again that it had before a run.
    fn give_back(&mut self, began: &Settings) {
        password::give_back(began, &mut self.memory.settings);
    }

    /// The system log tells of a file that was not even begun.
    fn log_refused(&self, program: &Program, options: &RunOptions, workspace: &mut Workspace) {
        let settings = &self.memory.settings;
        let draws = options.program.preview || settings.mode == Mode::Preview;
        let error = program.diagnostics.iter().find(|d| d.is_error()).map(|d| d.place.line);
        workspace.log_file(settings, program.name(), draws, 0.0, error);
    }

    /// Runs a job to its end. Settings and frames of part files stay what they were; the machine is
    /// left where the job leaves it.
    pub(crate) fn run_job(
        &mut self,
        job: Arc<Job>,
        machine: &Arc<Configuration>,
        options: RunOptions,
        workspace: &mut Workspace,
        company: Company<'_>,
        stands: Option<Placed>,
    ) -> Summary {
        let Company { sink, operator, requests, machine: driven } = company;
        let (preview, before) = (options.program.preview, options.before.clone());
        let (name, on_record) = (job.name.clone(), options.started.is_some() && !preview);
        sink.event(&job_starts(&job, preview));
        let sequence = Sequence::new(job, machine.clone(), self.memory.position);
        let sequence = match before.door {
            Door::Only => sequence.only_waits_for_door(),
            Door::Waits => sequence,
            Door::Shut => sequence.behind_door(),
        };
        if before.door != Door::Only {
            self.tell_not_homed(machine, &options, sink);
            heights::tell_no_sheet(&name, &sequence, &options, sink);
        }
        let sheet = options.sheet.or_else(|| heights::planned_sheet(&sequence, preview));
        let settings =
            std::mem::replace(&mut self.memory.settings, (**sequence.settings()).clone());
        let frame = std::mem::take(&mut self.memory.frame);
        let simulated = self
            .machine_like(machine, options.inputs, AxisSet::first(AXES))
            .begun_at(before.ends_s)
            .with_sheet(sheet)
            .with_touches(&options.touches)
            .pushed(options.pushes)
            .doubting(unverified(workspace));
        (self.memory.settings, self.memory.frame) = (settings, frame);
        let mut world = World::new(simulated, workspace, sink, operator, driven);
        (world.previews, world.silent, world.stays) = (preview, stands.is_some(), Some(frame));
        (world.machine_is, world.homed, world.tally) =
            (machine.clone(), self.homed, before.tally());
        let mut runner = Runner::new(sequence, world, requests, options.limits, 0);
        runner.reentry = stands;
        let over = runner.run();
        runner.stay_where_it_stands();
        let Runner { interpreter, mut world, last_move, .. } = runner;
        let summary = summary(&interpreter, &mut world, over);
        world.tell(&Event::End(end_event(&summary, &world.machine, None)));
        self.memory.position = world.machine.position();
        self.machine = Some(world.into_machine());
        if on_record {
            let well = matches!(summary.status, Status::Ok | Status::Ended);
            workspace.keep_last_shape((!well).then_some((&*name, last_move.line)));
        }
        summary
    }

    /// Moves the tool a little, internal units: working locations stay, so that what is cut next
    /// shifts, and table base coordinates follow, so that ST finds the true place again (MN).
    ///
    /// # Errors
    /// [`Outside`] when the table limits are checked and do not allow it; nothing has moved.
    pub fn nudge(&mut self, axis: Axis, distance: f64) -> Result<(), Outside> {
        let memory = &mut self.memory;
        let nudge = Nudge { axis, distance };
        nudge.check(&memory.settings, &memory.frame, memory.position)?;
        let room = bounds_by_hand(&self.machine_is, axis, self.homed.contains(axis));
        nudge.within(room, memory.position)?;
        memory.position[axis] += distance;
        memory.frame.working_zero[axis] += distance;
        Ok(())
    }

    /// The simulated machine as a run finds it.
    pub fn found_by(&self, work: &Work, options: &RunOptions) -> Machine {
        let (mut found, inputs) = (self.clone(), options.inputs.clone());
        if let Work::Job(job, machine) = work {
            let sequence = Sequence::new(job.clone(), machine.clone(), self.memory.position);
            found.memory.settings = (**sequence.settings()).clone();
            found.memory.frame = Frame::default();
            return found.machine_like(machine, inputs, AxisSet::first(AXES));
        }
        if options.program.preview && !self.memory.settings.view.start_actual {
            found.draw_from_zero();
        }
        found.machine(inputs)
    }

    /// The simulated machine, ready for a run.
    pub(crate) fn machine(&self, inputs: Vec<Change>) -> Machine {
        self.machine_like(&self.machine_is, inputs, self.homed)
    }

    /// The same with another configuration; its lengths bound these axes.
    pub(crate) fn machine_like(
        &self,
        machine_is: &Configuration,
        inputs: Vec<Change>,
        bounded: AxisSet,
    ) -> Machine {
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
    fn draw_from_zero(&mut self) {
        for axis in [Axis::X, Axis::Y] {
            self.memory.position[axis] = self.memory.frame.working_zero[axis];
        }
    }

    /// Returns the event with which a run begins, for whoever looks.
    pub(crate) fn begins(&self, work: &Work, options: &RunOptions) -> Event {
        match work {
            Work::Part(program) => self.start_event(program.name(), program.language(), options),
            Work::Job(job, _) => job_starts(job, options.program.preview),
            Work::Hand(errand, _) => Event::Start {
                file: errand.name().into(),
                units: "mm",
                mode: "move",
                dialect: "hand",
            },
        }
    }

    fn start_event(&self, name: &Arc<str>, language: Language, options: &RunOptions) -> Event {
        Event::Start {
            file: name.clone(),
            units: self.memory.settings.linear_unit.symbol(),
            mode: if options.program.preview { "preview" } else { "move" },
            dialect: match language {
                Language::Gcode => options.gcode.dialect.name(),
                _ => dialect_word(options.program.dialect),
            },
        }
    }

    /// The program has errors: it ends before it starts.
    fn refused(&mut self, program: &Program, sink: &mut dyn Sink) -> Summary {
        let error = program.diagnostics.iter().find(|d| d.is_error()).cloned().map(Box::new);
        let summary = Summary::not_begun(self.memory.settings.linear_unit, error);
        let machine = self.machine.get_or_insert_default();
        sink.event(&Event::End(end_event(&summary, machine, None)));
        summary
    }
}

fn job_starts(job: &Job, preview: bool) -> Event {
    let mode = if preview { "preview" } else { "move" };
    Event::Start { file: job.name.clone(), units: "mm", mode, dialect: "job" }
}

fn saved_and_restored(interpreter: &Interpreter) -> Result<Interpreter, String> {
    let saved = serde_json::to_vec(interpreter).map_err(|e| e.to_string())?;
    serde_json::from_slice(&saved).map_err(|e| e.to_string())
}

/// The word for a dialect.
pub const fn dialect_word(dialect: Dialect) -> &'static str {
    match dialect {
        Dialect::Sb3 => "sb3",
        Dialect::Fabmo => "fabmo",
        Dialect::Strict => "strict",
    }
}

pub(crate) fn summary(
    interpreter: &impl kerf_program::Interpreter,
    world: &mut World<'_>,
    over: crate::runner::Over,
) -> Summary {
    Summary {
        status: over.status,
        seconds: world.now(),
        lines: interpreter.lines(),
        tally: std::mem::take(&mut world.tally),
        unit: interpreter.settings().linear_unit,
        error: over.diagnostic,
        closes: false,
    }
}

fn conclude(
    mut runner: Runner<'_, Interpreter>,
    over: crate::runner::Over,
    variables: bool,
) -> (Summary, kerf_part::Session, Machine) {
    runner.stay_where_it_stands();
    let Runner { interpreter, mut world, .. } = runner;
    let closes = interpreter.closes();
    let summary = Summary { closes, ..summary(&interpreter, &mut world, over) };
    let variables = variables.then(|| variables_told(&interpreter));
    let end = end_event(&summary, &world.machine, variables);
    world.tell(&Event::End(end));
    let position = world.machine.position();
    let independent = world.machine.spinning();
    let mut memory = interpreter.into_session();
    (memory.sbp.position, memory.sbp.independent) = (position, independent);
    (summary, memory, world.into_machine())
}

pub(crate) fn end_event(
    summary: &Summary,
    machine: &Machine,
    vars: Option<BTreeMap<String, VarValue>>,
) -> EndEvent {
    let mm = summary.unit.mm();
    EndEvent {
        status: summary.status,
        t: summary.seconds,
        lines: summary.lines,
        moves: summary.tally.moves,
        arcs: summary.tally.arcs,
        cut: summary.tally.cut_mm / mm,
        jog: summary.tally.jog_mm / mm,
        bounds: bounds_event(&summary.tally.bounds, mm),
        steps: machine.steps(),
        heater: (machine.settings().io.analog >= 3).then(|| machine.heater_degrees()),
        astray: astray(machine),
        verify: machine.unverified().iter().map(|axis| axis.letter()).collect(),
        vars,
    }
}

fn astray(machine: &Machine) -> Partial {
    let user = machine.settings().to_user(machine.astray());
    let axes = Axis::ALL.into_iter().filter(|axis| user[*axis] != 0.0);
    axes.map(|axis| (axis.letter().to_ascii_lowercase(), user[axis])).collect()
}

fn bounds_event(bounds: &Bounds3, mm: f64) -> Option<BoundsEvent> {
    let corner = |[x, y, z]: [f64; 3]| Corner { x: x / mm, y: y / mm, z: z / mm };
    (!bounds.is_empty()).then(|| BoundsEvent { min: corner(bounds.min), max: corner(bounds.max) })
}

fn variables_told(interpreter: &Interpreter) -> BTreeMap<String, VarValue> {
    let told = |value: Value| match value.number() {
        // As the language shows it: seven digits, not the noise of single precision.
        Some(number) => {
            let shown = kerf_sbp::format_number(number).parse();
            VarValue::Number(shown.unwrap_or(number))
        }
        None => VarValue::Text(value.display()),
    };
    let named = interpreter.sbp_variables().list().into_iter();
    let parameters = interpreter.gcode_parameters().into_iter();
    let parameters = parameters.map(|(name, value)| (name, VarValue::Number(value)));
    named.map(|(name, value)| (name, told(value))).chain(parameters).collect()
}
