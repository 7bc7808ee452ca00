//! From options to a machine, its folders and its memory.

use crate::args::{FileArgs, MotionArgs, PlaceArgs, RunArgs};
use crate::clock;
use crate::data_args::{DataArgs, data_folder};
use crate::drawings;
use crate::exit::Usage;
use crate::given;
use crate::job_options;
use crate::machine_choice::MachineChoice;
use crate::machine_file;
use crate::memory;
use crate::named_machine::{self, Named};
use crate::script::Script;
use crate::visit::Visit;
use anyhow::{Result, bail};
use kerf_control::Session;
use kerf_control::answers::Answers;
use kerf_drawing::Drawing;
use kerf_files::{Folders, RealDisk};
use kerf_import::job_file;
use kerf_journal::{RunOptions, Shell, Work, machine_file::mistake_lines};
use kerf_machine::Configuration;
use kerf_part::Program;
use kerf_program::{Axes, Dynamics, GoTo, RampModel, Settings};
use kerf_sbp::{Dialect, FileParameters};
use kerf_sim::Push;
use kerf_toolpath::Shaping;
use kerf_workspace::{Workspace, stored::Stored};
use std::path::Path;
use std::sync::Arc;

/// A run that is ready to begin: all that it needs besides a sink.
pub struct PreparedRun {
    pub work: Work,
    pub session: Session,
    pub options: RunOptions,
    pub workspace: Workspace,
    pub answers: Answers,
    /// The state that the run leaves is kept.
    pub kept: bool,
    /// The settings that stay, where those of another machine hold for this run.
    pub replaced: Option<Settings>,
    /// Visit of Kerf: how it starts and closes.
    pub visit: Visit,
    /// The drawing that a job was made of, without its shapes.
    pub drawing: Option<Drawing>,
}

/// Reads the part file and prepares its run.
pub fn prepare(file: &Path, args: &RunArgs, preview: bool) -> Result<PreparedRun> {
    if let (true, Some(name)) = (preview, args.place.machine.named_controller()) {
        eprintln!(
            "kerf: {name} is not opened: what only looks begins with the machine as it was left"
        );
    }
    let parts = file.parent().unwrap_or(Path::new(""));
    let mut drawing = None;
    let work = if drawings::is_drawing(file) {
        let name = file.display().to_string().into();
        job_options::refuse_foreign(args)?;
        let machine = machine_of(&args.place, preview)?;
        let job = drawings::job(file, shaping(&machine, args))?;
        let work = job_file::work(&job, name, machine);
        drawing = Some(job.drawing);
        work
    } else {
        read_program(file, args.dialect.sbp)?.into()
    };
    let mut job = job_of(work, workspace(parts, &args.place, preview)?, args, preview)?;
    if preview && args.answers.is_none() {
        let beside = job.workspace.answers_beside(&job.work.name());
        job.answers = Answers::read(&beside.unwrap_or_default());
    }
    job.visit.opening.file = true;
    job.drawing = drawing;
    Ok(job)
}

/// Returns what is done to the shapes of a drawing before paths are made of them: as the machine is set, with what
/// the command line says of smoothing.
pub fn shaping(machine: &Configuration, args: &RunArgs) -> Shaping {
    let factor = args.motion.smoothing.unwrap_or(machine.program.smoothing.factor);
    Shaping { factor, filter_mm: machine.options.filter_mm }
}

/// Prepares the run of a program or a job.
pub fn job_of(
    work: impl Into<Work>,
    mut workspace: Workspace,
    args: &RunArgs,
    preview: bool,
) -> Result<PreparedRun> {
    let mut work = work.into();
    let (mut session, kept) = session(&args.place, preview, &mut workspace)?;
    let replaced = args.place.machine.configuration().map(|_| session.memory.settings.clone());
    if replaced.is_some() {
        session.machine_is = machine(&args.place.machine, &args.place.data)?.into();
    }
    let mut settings = settings(&args.place, session.memory.settings.clone())?;
    if let Some(unit) = args.units {
        settings.use_linear_unit(unit);
    }
    choose_model(&args.motion, &mut settings, matches!(work, Work::Job(..)))?;
    let answers = answers(args)?;
    for (name, value) in &args.set {
        session.memory.variables.set(name, value.clone());
    }
    let mut options = run_options(args, &settings, preview);
    if let Some(path) = &args.script {
        let script = script(path)?;
        options.inputs.extend(script.changes);
        options.touches = script.touches;
    }
    match &mut work {
        Work::Part(program) => {
            if preview {
                options.most_commands = most_commands(args, program.line_count());
            }
            options.program.file.from = from_line(&args.file, program, &workspace)?;
        }
        // A job takes what the options say of motion from the settings, the rest from the machine.
        Work::Job(job, machine) => {
            Arc::make_mut(machine).program = settings.clone();
            job_options::of(args, Arc::make_mut(job), &workspace)?;
        }
        Work::Hand(..) => {}
    }
    let in_mm = |push: &Push| Push { by: push.by * settings.axis_scale(push.axis), ..*push };
    options.sheet = args.sheet;
    options.pushes = args.hand_move.iter().map(in_mm).collect();
    options.started = kept.then(clock::started);
    session.memory.settings = settings;
    let visit = Visit::default();
    Ok(PreparedRun {
        work,
        session,
        options,
        workspace,
        answers,
        kept,
        replaced,
        visit,
        drawing: None,
    })
}

/// A job whose paths are all cut beside themselves, right of travel.
pub fn beside(work: Work, by_mm: f64) -> Result<Work> {
    if !matches!(work, Work::Job(..)) {
        bail!(job_options::only_of_jobs())
    }
    let choice = job_file::Choice { offset_mm: by_mm, ..job_file::Choice::default() };
    Ok(choice.of(work).map_err(|why| Usage(why.to_string()))?)
}

/// The script of the inputs.
fn script(path: &Path) -> Result<Script> {
    let of = |wrong: Vec<String>| {
        let told = |line: &String| format!("{}, {line}", path.display());
        Usage(wrong.iter().map(told).collect::<Vec<_>>().join("\n"))
    };
    Ok(Script::read(&given::text(path)?).map_err(of)?)
}

/// The script of answers.
pub fn answers(args: &RunArgs) -> Result<Answers> {
    Ok(match &args.answers {
        Some(path) => Answers::read(&given::text(path)?),
        None => Answers::default(),
    })
}

/// The machine as it was left, or a new one; whether what a run leaves is kept.
pub fn session(
    place: &PlaceArgs,
    looks: bool,
    workspace: &mut Workspace,
) -> Result<(Session, bool)> {
    if !memory::is_kept(place, looks) {
        return Ok((Session::default(), false));
    }
    let journal = match workspace.journal() {
        Some(journal) => Some(journal.clone()),
        None => memory::journal(&data_folder(&place.data)?, true)?,
    };
    let session = journal.map(|journal| memory::recall(&journal, workspace, looks)).transpose()?;
    Ok((session.unwrap_or_default(), true))
}

/// Reads a part file; the name shown is the one the user gave.
fn read_program(file: &Path, dialect: Dialect) -> Result<Program> {
    let bytes = given::bytes(file)?;
    Ok(kerf_part::read_as(file.display().to_string().into(), bytes, dialect))
}

/// Chooses the model of motion, and what belongs to it. The paths of a job are made with the smoothing factor.
fn choose_model(motion: &MotionArgs, settings: &mut Settings, is_job: bool) -> Result<()> {
    settings.ramp_model = motion.ramps.or(settings.ramp_model);
    if settings.ramp_model.is_none() && motion.tells_limits() {
        settings.dynamics = Some(settings.axis_dynamics());
    }
    let model = settings.model();
    if let Some((name, models)) = foreign_option(motion, model, is_job) {
        let words: Vec<&str> = models.iter().map(|model| model.word()).collect();
        let (theirs, ours) = (words.join(" or "), model.word());
        bail!(Usage(format!("{name} belongs to --ramps {theirs}, not to --ramps {ours}")));
    }
    if model != RampModel::Shopbot {
        settings.dynamics = Some(with_options(settings.axis_dynamics(), motion));
    }
    let smoothing = &mut settings.smoothing;
    smoothing.factor = motion.smoothing.unwrap_or(smoothing.factor);
    smoothing.stop_angle_deg = motion.stop_angle.unwrap_or(smoothing.stop_angle_deg);
    smoothing.centripetal_percent = motion.centripetal.unwrap_or(smoothing.centripetal_percent);
    Ok(())
}

/// An option that says nothing to the model in force, and the models to which it does.
fn foreign_option(
    motion: &MotionArgs,
    model: RampModel,
    is_job: bool,
) -> Option<(&'static str, &'static [RampModel])> {
    const OPTIMAL: &[RampModel] = &[RampModel::Optimal];
    const PROFILER: &[RampModel] = &[RampModel::Profiler];
    const BOTH: &[RampModel] = &[RampModel::Optimal, RampModel::Profiler];
    let options = [
        ("--tolerance", motion.tolerance.is_some(), OPTIMAL),
        ("--axis-speed", motion.axis_speed.is_some(), BOTH),
        ("--accel", motion.accel.is_some(), BOTH),
        ("--jerk", motion.jerk.is_some(), OPTIMAL),
        ("--smoothing", motion.smoothing.is_some() && !is_job, PROFILER),
        ("--stop-angle", motion.stop_angle.is_some(), PROFILER),
        ("--centripetal", motion.centripetal.is_some(), PROFILER),
    ];
    let foreign = options.into_iter().find(|(_, given, models)| *given && !models.contains(&model));
    foreign.map(|(name, _, models)| (name, models))
}

fn with_options(mut dynamics: Dynamics, motion: &MotionArgs) -> Dynamics {
    if let Some(speed) = motion.axis_speed {
        dynamics.speed_mm_s.0[..3].copy_from_slice(&speed);
    }
    if let Some(accel) = motion.accel {
        dynamics.accel_mm_s2.0[..3].copy_from_slice(&accel);
    }
    if let Some(jerk) = motion.jerk {
        let free = |j: f64| if j > 0.0 { j } else { f64::INFINITY };
        let mut all = dynamics.jerk_mm_s3.unwrap_or(Axes::splat(f64::INFINITY));
        all.0[..3].copy_from_slice(&jerk.map(free));
        dynamics.jerk_mm_s3 = all.0.iter().any(|j| j.is_finite()).then_some(all);
    }
    dynamics.tolerance_mm = motion.tolerance.unwrap_or(dynamics.tolerance_mm);
    dynamics
}

/// The machine of a run: that which `--machine` describes; else that of the data folder, whole, for a run that goes on from there,
/// and for one that begins fresh the machine as Kerf comes with it.
pub fn machine_of(place: &PlaceArgs, looks: bool) -> Result<Configuration> {
    if place.machine.configuration().is_none() && !memory::is_kept(place, looks) {
        return Ok(Configuration::default());
    }
    machine(&place.machine, &place.data)
}

/// The configuration of a machine: the one that was named; else that of the data folder; else the usual one.
pub fn machine(choice: &MachineChoice, data: &DataArgs) -> Result<Configuration> {
    let Some(name) = choice.configuration() else {
        let kept = machine_file::of_data(data)?;
        return read_machine(kept.name(), &kept.text()?.unwrap_or_default());
    };
    match named_machine::named(name, data)? {
        Named::Ready(ready) => read_machine(ready.name.into(), ready.text),
        Named::File(path) => read_machine(path.display().to_string(), &given::text(&path)?),
    }
}

fn read_machine(name: String, text: &str) -> Result<Configuration> {
    let read = kerf_machine::file::read(&name.into(), text);
    read.map_err(|found| Usage(mistake_lines(&found)).into())
}

/// Settings at the start: those of a configuration, or the present ones.
pub fn settings(place: &PlaceArgs, present: Settings) -> Result<Settings> {
    match place.machine.configuration() {
        Some(_) => Ok(machine(&place.machine, &place.data)?.program),
        None => Ok(present),
    }
}

/// The bound on executed lines.
const MOST_LINES: u64 = 50_000_000;

/// Commands that are looked at, at the least; the picture of so many takes 400 MB.
const MOST_COMMANDS: u64 = 2_000_000;

/// Commands of one line, at the most, in a file that is long: a hole that is drilled in 20 pecks is 60 moves.
const MOST_OF_A_LINE: u64 = 64;

/// The bound on commands of what only looks at a program of so many lines. A long file without loops ends before.
pub fn most_commands(args: &RunArgs, lines: usize) -> u64 {
    args.max_lines.unwrap_or_else(|| MOST_COMMANDS.max(MOST_OF_A_LINE * lines as u64))
}

/// Returns the options with which the program is run.
pub fn run_options(args: &RunArgs, settings: &Settings, preview: bool) -> RunOptions {
    let file = &args.file;
    let parameters = FileParameters {
        proportion: file.proportion.unwrap_or([1.0; 3]),
        repetitions: file.repeat,
        offset: file.offset.unwrap_or(0),
        plunge_mm: file.plunge.unwrap_or(0.0) * settings.linear_unit.mm(),
        tabs: file.tabs,
        plunge_from_zero: file.plunge_from_zero,
        stepped: file.step,
        from: None,
    };
    let program = kerf_sbp::Options {
        dialect: args.dialect.sbp,
        max_lines: args.max_lines.unwrap_or(MOST_LINES),
        seed: args.seed,
        file: parameters,
        allow_errors: args.allow_errors,
        preview,
        ..kerf_sbp::Options::default()
    };
    let gcode = kerf_gcode::Options { dialect: args.dialect.gcode, ..Default::default() };
    RunOptions { program, gcode, inputs: args.input.clone(), ..RunOptions::default() }
}

/// The line at which the file begins.
fn from_line(args: &FileArgs, program: &Program, workspace: &Workspace) -> Result<Option<GoTo>> {
    let Some(words) = &args.from_line else { return Ok(None) };
    let name = program.name();
    let (last, lines) = (workspace.last_line(name), program.line_count());
    match GoTo::read(words, last) {
        None => bail!(Usage(format!("no run of {name} that ended early is in its log"))),
        Some(to) if to.line as usize > lines => {
            bail!(Usage(format!("{name} has {lines} lines, there is no line {}", to.line)))
        }
        to => Ok(to),
    }
}

/// The folders and values that a program reaches; its part folder unless an option names another.
pub fn workspace(parts: &Path, place: &PlaceArgs, preview: bool) -> Result<Workspace> {
    let data = data_folder(&place.data)?;
    let parts = place.parts.clone().unwrap_or_else(|| parts.into());
    let custom = place.custom.clone().unwrap_or_else(|| data.join("custom"));
    if let Some(missing) = place.allow_path.iter().find(|folder| !folder.is_dir()) {
        bail!(Usage(format!(
            "{} is no folder: --allow-path names one that is there",
            missing.display()
        )));
    }
    let folders = Folders::new(parts, vec![custom], place.allow_path.clone());
    let stored = stored(&data, place, preview)?;
    let workspace = if preview {
        let shell = if place.allow_shell { Shell::Skipped } else { Shell::Refused };
        Workspace::preview(RealDisk, folders, &stored, data).with_shell(shell)
    } else {
        let shell = if place.allow_shell { Shell::Started } else { Shell::Refused };
        Workspace::new(Box::new(RealDisk), folders, stored, data).with_shell(shell)
    };
    Ok(workspace)
}

/// The values that survive. A run that leaves nothing else goes on where they cannot be kept.
fn stored(data: &Path, place: &PlaceArgs, looks: bool) -> Result<Stored> {
    let opened = memory::journal(data, looks);
    let journal = match opened {
        Err(error) if !memory::is_kept(place, looks) => {
            eprintln!("kerf: values are not kept: {error:#}");
            None
        }
        opened => opened?,
    };
    Ok(journal.map(Stored::of).transpose()?.unwrap_or_default())
}
