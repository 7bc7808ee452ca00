//! Runs of a session: a part file, a job, a movement by hand.

use crate::command_limit::CommandLimit;
use crate::homing::Found;
use crate::map_followed::{job_leaves_map, lowered, mapped, mapped_note, not_followed, top_mm};
use crate::mapped::Mapped;
use crate::preparation::{Preparation, axis_names};
use crate::run_context::RunContext;
use crate::run_end::RunEnd;
use crate::run_summary::{end_event, summary, variables_told};
use crate::runner::{LINES, Runner};
use crate::session::Session;
use crate::station::Station;
use crate::trail::Trail;
use crate::whole_run::WholeRun;
use crate::world::World;
use crate::{homing, told_heights, trail};
use kerf_diag::Diagnostic;
use kerf_journal::{Door, Placed, RunOptions, Work};
use kerf_machine::{Configuration, Errand, Hand};
use kerf_part::{Interpreter, Program};
use kerf_program::job::Job;
use kerf_program::settings::Mode;
use kerf_program::{AXES, Axis, AxisSet, Interpreter as _, Question, Settings, Status};
use kerf_sbp::{Dialect, Language};
use kerf_sequence::Sequence;
use kerf_sim::Simulation;
use kerf_trace::{Event, Sink, Summary};
use kerf_workspace::height_map::height_map;
use kerf_workspace::part_log::PartLog;
use kerf_workspace::{Workspace, unverified};
use std::sync::Arc;

impl Session {
    /// Runs a program or a job to its end.
    pub fn run(
        &mut self,
        work: impl Into<Work>,
        options: RunOptions,
        workspace: &mut Workspace,
        context: RunContext<'_>,
    ) -> Summary {
        let mut options = options;
        options.lines_at_once = lines_at_once(&options, &*context.sink);
        let (work, RunContext { sink, operator, requests, machine }) = (work.into(), context);
        if let Some(summary) = self.take_height_map(&work, &mut options, workspace, sink) {
            return summary;
        }
        let mut whole = WholeRun::new(sink);
        let mut context = RunContext { sink: &mut whole, operator, requests, machine };
        let summary = match Preparation::of(self, &work, &mut options, workspace, context.again())
            .prepare()
        {
            Some(summary) => summary,
            None => self.go(work, options, workspace, context, None),
        };
        whole.ends();
        summary
    }

    /// Runs a program or a job; one that is taken up by a machine that stands at a place.
    pub(crate) fn go(
        &mut self,
        work: Work,
        options: RunOptions,
        workspace: &mut Workspace,
        context: RunContext<'_>,
        stands: Option<Placed>,
    ) -> Summary {
        match work {
            Work::Part(program) => self.run_part(*program, options, workspace, context, stands),
            Work::Job(job, machine) => {
                self.run_job(job, &machine, options, workspace, context, stands)
            }
            Work::Hand(errand, machine) => {
                self.run_hand(errand, &machine, options, None, workspace, context)
            }
        }
    }

    /// Runs a program to its end. A program with errors does not start unless that is allowed.
    fn run_part(
        &mut self,
        program: Program,
        options: RunOptions,
        workspace: &mut Workspace,
        context: RunContext<'_>,
        stands: Option<Placed>,
    ) -> Summary {
        let RunContext { sink, operator, requests, machine: driven } = context;
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
        let log = PartLog::begin(&self.memory.settings, &options.program, options.started);
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
        let homed = self.homed.contains(Axis::Z);
        let top_mm = top_mm(&self.machine_is, homed, &memory.sbp.frame, &driven.machine);
        let mut world = World::new(machine, workspace, sink, operator, driven);
        (world.previews, world.tally) = (options.program.preview, tally);
        world.silent = stands.is_some();
        (world.machine_is, world.homed) = (self.machine_is.clone(), self.homed);
        world.typed_files = depth;
        let read = kerf_part::Options { sbp: options.program, gcode: options.gcode };
        if options.heights.is_some() {
            world.tell_diagnostic(mapped_note(program.name()));
        }
        let interpreter = mapped(program, memory, read, options.heights, top_mm);
        let mut runner =
            Runner::new(interpreter, world, requests, options.limits, options.lines_at_once);
        runner.restore = options.restore.then_some(saved_and_restored);
        runner.stops.station.trail = Trail::new(depth);
        runner.bound = CommandLimit::of(options.most_commands);
        runner.stops.station.reentry = stands;
        let over = runner.run();
        if let Some(log) = log {
            trail::write_log(&mut runner.stops.station, &log, &over);
        }
        trail::write_system_log(&mut runner.stops.station, &over);
        let (summary, memory, machine) = conclude(runner, over, options.tell_variables);
        machine.model.unverified().iter().for_each(|axis| self.homed.remove(axis));
        (self.memory, self.gcode, self.machine) = (memory.sbp, memory.gcode, Some(machine));
        if let Some(began) = began {
            give_back(&began, &mut self.memory.settings);
        }
        summary
    }

    /// Adds errors to a part file that sets what cannot be on this machine: it is not begun.
    fn refuse_keys(&self, program: &mut Program) {
        let keys: Vec<u8> = self.machine_is.pendant.inputs().collect();
        let present = self.memory.settings.display.has_pendant();
        program.diagnostics.extend(kerf_sbp::stops_on_keys(&program.sbp, &keys, present));
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
        context: RunContext<'_>,
        stands: Option<Placed>,
    ) -> Summary {
        let RunContext { sink, operator, requests, machine: driven } = context;
        let homed = self.homed.contains(Axis::Z);
        let top_mm = top_mm(machine, homed, &self.memory.frame, &driven.machine);
        let (preview, before) = (options.program.preview, options.before.clone());
        let (name, on_record) = (job.name.clone(), options.started.is_some() && !preview);
        sink.event(&job_starts(&job, preview));
        let zero = self.memory.frame.working_zero;
        let stood = lowered(options.heights.as_deref(), zero, self.memory.position);
        let sequence = Sequence::new(job, machine.clone(), stood);
        if let Some(why) = job_leaves_map(&sequence, options.heights.as_deref(), zero) {
            return self.not_begun_told(why, sink);
        }
        let sequence = match before.door {
            Door::Only => sequence.only_waits_for_door(),
            Door::Waits => sequence,
            Door::Shut => sequence.behind_door(),
        };
        if before.door != Door::Only {
            self.tell_not_homed(machine, &options, sink);
            let law = sequence.follows_sheet();
            if law.is_none_or(|law| !driven.machine.borrow().facts().follows(&law)) {
                told_heights::tell_no_sheet(&name, &sequence, &options, sink);
            }
        }
        let sheet = options.sheet.or_else(|| told_heights::planned_sheet(&sequence, preview));
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
        if options.heights.is_some() {
            world.tell_diagnostic(mapped_note(&name));
        }
        let mapped = Mapped::new(sequence, options.heights).lying_at(zero).below(top_mm);
        let mut runner = Runner::new(mapped, world, requests, options.limits, 0);
        runner.stops.station.reentry = stands;
        let over = runner.run();
        runner.stops.station.stay_where_it_stands();
        let Station { interpreter, mut world, drive, last_move, .. } = runner.stops.station;
        let summary = summary(&interpreter, &mut world, drive.taken_s(), over);
        world.tell(&Event::End(end_event(&summary, &world.model, world.hands.astray(), None)));
        self.memory.position = world.model.position();
        self.machine = Some(world.into_simulation());
        if on_record {
            let well = matches!(summary.status, Status::Ok | Status::Ended);
            workspace.keep_last_shape((!well).then_some((&*name, last_move.line)));
        }
        summary
    }

    /// Does an errand to its end. Settings of part files stay what they were.
    pub(crate) fn run_hand(
        &mut self,
        errand: Errand,
        machine: &Arc<Configuration>,
        options: RunOptions,
        asks: Option<Question>,
        workspace: &mut Workspace,
        context: RunContext<'_>,
    ) -> Summary {
        let RunContext { sink, operator, requests, machine: driven } = context;
        let mode = if options.program.preview { "preview" } else { "move" };
        let file = errand.name().into();
        let hand =
            Hand::new(errand.clone(), machine.clone(), self.memory.position, self.memory.frame);
        let hand = hand.reaching(Axis::ALL.map(|axis| driven.machine.borrow().reach(axis)));
        let hand = hand.turning(driven.machine.borrow().facts());
        let before = options.before;
        let hand = before.unit.into_iter().fold(hand, Hand::told_in);
        let units = hand.settings().linear_unit.symbol();
        sink.event(&Event::Start { file, units, mode, dialect: "hand" });
        let settings = std::mem::replace(&mut self.memory.settings, (**hand.settings()).clone());
        let simulated = self.machine_like(machine, options.inputs, AxisSet::first(AXES));
        let simulated = simulated.begun_at(before.ends_s).pushed(options.pushes);
        let simulated = simulated.doubting(unverified(workspace));
        self.memory.settings = settings;
        let mut world = World::new(simulated, workspace, sink, operator, driven);
        (world.previews, world.machine_is) = (options.program.preview, machine.clone());
        (world.homed, world.homes) = (self.homed, self.homes(machine));
        world.tally = before.tally();
        // No file begins or ends: outputs stay as they are.
        world.typed_files = 1;
        let mut runner = Runner::new(hand, world, requests, options.limits, 0);
        let over = match errand {
            Errand::FindHome(axes) => {
                let over = match homing::asked(&mut runner.stops, asks) {
                    Ok(()) => {
                        self.learn_homes(homing::find_home(&mut runner.stops, axes, self.homed))
                    }
                    Err(over) => over,
                };
                homing::tell_end(&mut runner.stops, over)
            }
            _ => runner.run(),
        };
        let Station { interpreter, mut world, drive, .. } = runner.stops.station;
        let summary = summary(&interpreter, &mut world, drive.taken_s(), over);
        world.tell(&Event::End(end_event(&summary, &world.model, world.hands.astray(), None)));
        (self.memory.position, self.memory.frame) = (world.model.position(), *world.model.frame());
        self.machine = Some(world.into_simulation());
        summary
    }

    /// Takes over the axes that are homed, however homing ended.
    fn learn_homes(&mut self, found: Found) -> RunEnd {
        self.homed = self.homed.without(found.lost).union(found.done);
        found.over.unwrap_or(RunEnd::of(Status::Ok))
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
        let error = program.diagnostics.iter().find(|d| d.is_error()).cloned();
        self.not_begun_for(error, sink)
    }

    /// The end of a run that was not begun, for this reason.
    fn not_begun_for(&mut self, why: Option<Diagnostic>, sink: &mut dyn Sink) -> Summary {
        let summary = Summary::not_begun(self.memory.settings.linear_unit, why.map(Box::new));
        let machine = self.machine.get_or_insert_default();
        sink.event(&Event::End(end_event(&summary, &machine.model, machine.astray(), None)));
        summary
    }

    /// Has a program or a job follow the height map in force. Gives the end of a run that is not begun because nobody
    /// can follow the map.
    pub(crate) fn take_height_map(
        &mut self,
        work: &Work,
        options: &mut RunOptions,
        workspace: &Workspace,
        sink: &mut dyn Sink,
    ) -> Option<Summary> {
        if matches!(work, Work::Hand(..)) {
            return None;
        }
        match height_map(workspace) {
            Ok(map) => {
                options.heights = map.map(Arc::new);
                None
            }
            Err(why) => Some(self.not_begun_told(not_followed(&work.name(), why), sink)),
        }
    }

    /// Tells the reason for which a run is not begun, and gives its end.
    fn not_begun_told(&mut self, why: Diagnostic, sink: &mut dyn Sink) -> Summary {
        sink.event(&Event::Diag(Box::new(why.clone())));
        self.not_begun_for(Some(why), sink)
    }

    /// Tells which axes are not homed, where the machine has switches for them.
    pub(crate) fn tell_not_homed(
        &self,
        machine: &Configuration,
        options: &RunOptions,
        sink: &mut dyn Sink,
    ) {
        let missing = self.not_homed(machine);
        if !missing.is_empty() && !options.program.preview && !options.program.typed {
            let text = format!("not homed: {}", axis_names(machine, missing));
            sink.event(&Event::Message { text: text.into(), t: options.before.ends_s });
        }
    }
}

/// Returns after how many lines commands are looked at; whoever looks where the run stands sees every line.
pub(crate) fn lines_at_once(options: &RunOptions, sink: &dyn Sink) -> u64 {
    match options.lines_at_once {
        0 if sink.looks_at_status() => 1,
        0 => LINES,
        lines => lines,
    }
}

/// Gives settings back as they were before something ran to which they are protected. What is to be made of the next
/// lines is none of them: preview or moves, distances or places.
fn give_back(began: &Settings, settings: &mut Settings) {
    let (mode, distance) = (settings.mode, settings.distance);
    *settings = Settings { mode, distance, ..began.clone() };
}

fn job_starts(job: &Job, preview: bool) -> Event {
    let mode = if preview { "preview" } else { "move" };
    Event::Start { file: job.name.clone(), units: "mm", mode, dialect: "job" }
}

fn saved_and_restored(interpreter: &Mapped<Interpreter>) -> Result<Mapped<Interpreter>, String> {
    let saved = serde_json::to_vec(&interpreter.inner).map_err(|e| e.to_string())?;
    let inner = serde_json::from_slice(&saved).map_err(|e| e.to_string())?;
    Ok(interpreter.with(inner))
}

/// The word for a dialect.
pub const fn dialect_word(dialect: Dialect) -> &'static str {
    match dialect {
        Dialect::Sb3 => "sb3",
        Dialect::Fabmo => "fabmo",
        Dialect::Strict => "strict",
    }
}

fn conclude(
    mut runner: Runner<'_, Mapped<Interpreter>>,
    over: RunEnd,
    variables: bool,
) -> (Summary, kerf_part::Session, Simulation) {
    runner.stops.station.stay_where_it_stands();
    let Station { interpreter, mut world, drive, .. } = runner.stops.station;
    let closes = interpreter.inner.closes();
    let summary = Summary { closes, ..summary(&interpreter, &mut world, drive.taken_s(), over) };
    let variables = variables.then(|| variables_told(&interpreter.inner));
    let end = end_event(&summary, &world.model, world.hands.astray(), variables);
    world.tell(&Event::End(end));
    let position = world.model.position();
    let independent = world.model.spinning();
    let mut memory = interpreter.inner.into_session();
    (memory.sbp.position, memory.sbp.independent) = (position, independent);
    (summary, memory, world.into_simulation())
}
