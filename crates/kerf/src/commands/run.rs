//! `kerf run`: a part file on a machine.

mod behind;
mod on_server;
mod options;

pub use options::MachineArgs;

use crate::accepted_options::AcceptedOptions;
use crate::args::{PlaceArgs, RunArgs};
use crate::commands::protect;
use crate::controller;
use crate::data_args::data_folder;
use crate::drawings;
use crate::exit::{Exit, Usage};
use crate::machine_file;
use crate::memory;
use crate::operator::{Clock, Person, Terminal};
use crate::out;
use crate::outputs::Outputs;
use crate::parse;
use crate::picture::{self, Picture};
use crate::preview_mode;
use crate::progress::Progress;
use crate::report::{Diagnostics, Talk};
use crate::setup::{self, PreparedRun};
use crate::sources::FileLines;
use crate::stop::Stop;
use crate::streamed::Streamed;
use crate::summary;
use crate::visit::Visit;
use crate::waveforms::{ReadingBytes, VcdArgs};
use anyhow::{Context, Result, bail};
use behind::closes;
use clap::Args;
use kerf_control::answers::Answers;
use kerf_control::controller::Controller;
use kerf_control::{RunContext, Session};
use kerf_journal::{JournalError, RunOptions, Whereabouts, Work};
use kerf_machine::{Configuration, table};
use kerf_program::job::Job;
use kerf_program::rounded;
use kerf_trace::{Summary, json::JsonLines};
use kerf_workspace::Workspace;
use on_server::{REACHES_SERVERS, remotely};
use options::{PaceName, STANDARD_OUTPUT};
use std::io::{self, IsTerminal, LineWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Runs a part file on a machine: the simulated one, or the one that --machine names
///
/// What the program prints and asks goes to the terminal; Ctrl-C stops the machine with a ramp and
/// lifts the tool. At the end a summary is told.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf run box.sbp\n  kerf run box.sbp --answers answers.txt \
    --input 3@2.5=1\n  kerf run box.sbp --pace real --picture box.svg\n\nExit codes: 0 ran to its \
    end, 1 the program failed, 2 the command line was wrong,\n3 stopped by the operator or a limit")]
pub struct RunCommand {
    /// The part file
    #[arg(required_unless_present = "resume")]
    file: Option<PathBuf>,
    /// Recovers the run that a kill of Kerf or a power cut interrupted: the tool lifts, the spindle starts, the tool
    /// goes above the place, plunges, and the cut goes on
    #[arg(long, conflicts_with = "file")]
    resume: bool,
    /// Runs it on a running `kerf serve` at this address: a file of its part folder. What it prints is
    /// printed, its questions are asked here and on every page, Ctrl-C stops it
    #[arg(long, value_name = "URL", conflicts_with = "resume")]
    server: Option<String>,
    /// Arms the machine of the server first
    #[arg(long, requires = "server")]
    arm: bool,
    /// Offsets every path of a job by this distance, mm, to the right of travel; the file stays as it is
    #[arg(long, value_name = "MM", value_parser = parse::number)]
    offset_job: Option<f64>,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Options that are heeded when a run is taken up.
const TAKES_UP: AcceptedOptions = AcceptedOptions {
    options: &[
        "resume",
        "folder",
        "start",
        "machine",
        "home",
        "unlock",
        "controller_log",
        "password",
        "answers",
        "quiet",
        "pace",
        "picture",
        "trace",
        "readings",
        "vcd",
        "stop_at",
        "hold_at",
        "resume_at",
        "feed",
    ],
    instead: "when a run is taken up: it goes on with the options, folders, inputs and settings with which it was \
              begun. Leave it out",
};

impl RunCommand {
    /// The options that are heeded, where not all are.
    pub const fn heeded(&self) -> Option<AcceptedOptions> {
        match (self.server.is_some(), self.resume) {
            (true, _) => Some(REACHES_SERVERS),
            (_, true) => Some(TAKES_UP),
            _ => None,
        }
    }
}

pub fn run(args: &RunCommand) -> Result<Exit> {
    args.machine.check(&args.run)?;
    if let (Some(url), Some(file)) = (&args.server, &args.file) {
        return remotely(url, file, args);
    }
    let mut run = args.run.clone();
    run.place.start_run();
    match &args.file {
        Some(file) => {
            if args.run.place.start.is_none() && !args.machine.quiet() {
                tell_fresh(&run.place);
            }
            let mut job = setup::prepare(file, &run, false)?;
            if let Some(by_mm) = args.offset_job {
                job.work = setup::beside(job.work, by_mm)?;
            }
            if let (Work::Job(job, machine), false) = (&job.work, args.machine.quiet()) {
                out::print(&format!("{}\n", in_force(job, machine)));
            }
            let talk = Talk::of(matches!(job.work, Work::Job(..)));
            on_machine(job, &args.machine, &run, talk)
        }
        None => resume(&args.machine, &run),
    }
}

/// Tells a user with a machine of his own when a run does not take it.
fn tell_fresh(place: &PlaceArgs) {
    let fresh = place.machine.configuration().is_none() && !memory::is_kept(place, false);
    let Ok(kept) = machine_file::of_data(&place.data) else { return };
    if fresh && kept.text().is_ok_and(|text| text.is_some()) {
        eprintln!(
            "kerf: a fresh machine, none of the settings in {}: --start kept has them",
            kept.name()
        );
    }
}

/// Describes what a job is cut with: to be looked at before the start.
fn in_force(job: &Job, machine: &Configuration) -> String {
    let speeds = &machine.program.speeds;
    let cut = machine.program.smoothing.cut_speed_mm_s.unwrap_or(speeds.cut.xy);
    let mm_min = |mm_s: f64| kerf_program::decimal(mm_s * 60.0, 1);
    let (z, [origin, _]) = (machine.zpos, kerf_sequence::lies(job, machine));
    let origin = match machine.job.change_origin_at_start {
        true => "where the tool is".to_owned(),
        false => format!("{},{}", origin.x, origin.y),
    };
    format!(
        "cutting at {} mm/min, plunging at {} mm/min; Z top {}, surface {}, bottom {} mm; origin {origin}",
        mm_min(cut),
        mm_min(machine.speeds.plunge_mm_s),
        z.top_mm,
        z.surface_mm,
        z.bottom_mm
    )
}

/// Takes up the run that was cut short.
fn resume(args: &MachineArgs, run: &RunArgs) -> Result<Exit> {
    if let Some(name) = run.place.machine.configuration() {
        bail!(Usage(format!(
            "a run is taken up on the machine on which it was begun: leave --machine {} out",
            name.display()
        )));
    }
    let mut workspace = setup::workspace(Path::new(""), &run.place, false)?;
    let nothing = || JournalError::NothingToResume { folder: workspace.app_path().into() };
    let journal = workspace.journal().cloned().ok_or_else(nothing)?;
    let cut = journal.runs.cut_short()?.ok_or_else(nothing)?;
    let (mut session, whereabouts) = Session::recall(&journal, &mut workspace)?;
    if !args.quiet {
        eprintln!("kerf: {}", cut.sentence());
    }
    if whereabouts == Whereabouts::Moving {
        eprintln!(
            "kerf: the machine was moving when Kerf ended; unless it was zeroed since, it goes on from \
             where it was believed to be"
        );
    }
    let answers = setup::answers(run)?;
    let machine = journal.runs.machine_of(&cut)?;
    let show = Show {
        name: cut.file().into(),
        lines: 0,
        talk: Talk::of(drawings::is_drawing(Path::new(cut.file()))),
        source: FileLines::default(),
        machine,
        editor: editor(&workspace),
    };
    // A board is wired as the run began with it, whatever the machine's own file says.
    session.hold(cut.began_with());
    let controller = controller_of(args, run, &mut session, &mut workspace)?;
    let visit = Visit::default();
    visit.begins(&session, &mut workspace)?;
    let stop = Stop::listen()?;
    let exit = attended(args, run, show, answers, controller.as_ref(), |context| {
        let (summary, unkept) = over(session.resume(&cut, &mut workspace, context))?;
        if let Some(controller) = &controller {
            let well = summary.status == kerf_sbp::Status::Ok;
            controller.ends(well, &mut workspace, || stop.is_wanted());
            controller.detach(&mut workspace);
        }
        Ok((summary, &session, unkept))
    })?;
    closes(exit, &visit, (&mut session, &mut workspace), args, run)
}

/// The controller on which a run is taken up, ready at a place that is known.
fn controller_of(
    args: &MachineArgs,
    run: &RunArgs,
    session: &mut Session,
    workspace: &mut Workspace,
) -> Result<Option<Controller>> {
    let Some(name) = run.place.machine.controller() else { return Ok(None) };
    let ready = controller::ready(name, args.beginning(), session, workspace)?;
    if let Some(why) = ready.doubts_place() {
        ready.detach(workspace);
        bail!(
            "{why}. Home the controller (--home) where it can be, or set its location and begin at a line with --from-line"
        );
    }
    ready.begins(workspace);
    Ok(Some(ready))
}

/// Runs a job on the machine and keeps what stays.
pub fn on_machine(job: PreparedRun, args: &MachineArgs, run: &RunArgs, talk: Talk) -> Result<Exit> {
    args.spare(Path::new(&*job.work.name()), run)?;
    let PreparedRun {
        work,
        mut session,
        mut options,
        mut workspace,
        answers,
        kept,
        replaced,
        visit,
        ..
    } = job;
    options.opened |= protect::given(&session.machine_is, args.password.as_deref())?;
    let (mut controller, name) = (None, run.place.machine.controller());
    if let Some(name) = name {
        let ready = controller::ready(name, args.beginning(), &mut session, &mut workspace)?;
        if let Some(exit) = lacks(&ready, &work, &session, &options, &workspace, run)? {
            ready.detach(&mut workspace);
            return Ok(exit);
        }
        workspace = workspace.with_firmware(ready.firmware(&session.machine_is.options.firmware));
        options.controller = Some(name.to_string());
        ready.begins(&mut workspace);
        controller = Some(ready);
    }
    if !kept && name.is_none() {
        workspace.has_fresh_machine();
    }
    let machine = VcdArgs::machine(&work, &session);
    let show = Show {
        name: work.name(),
        lines: work.line_count(),
        talk,
        source: FileLines::of(&work),
        machine,
        editor: editor(&workspace),
    };
    if kept {
        visit.begins(&session, &mut workspace)?;
    }
    let takes = work.takes_origin(session.memory.position);
    let own = name.is_none() && run.place.machine.configuration().is_none();
    let takes = takes.filter(|_| kept && own);
    let (mut moved, typed) = (false, options.program.typed);
    let stop = Stop::listen()?;
    let exit = attended(args, run, show, answers, controller.as_ref(), |context| {
        let workspace = &mut workspace;
        let (summary, unkept) = over(match kept {
            true => session.run_on_record(work, options, replaced, workspace, context),
            false => Ok(session.run(work, options, workspace, context)),
        })?;
        moved = summary.tally.moves > 0;
        leave(controller.as_ref(), &summary, workspace, &stop);
        Ok((summary, &session, unkept))
    })?;
    if let Some(at) = takes.filter(|_| moved) {
        keep_origin(at, &session, &run.place)?;
    }
    if kept && typed {
        tell_preview(&session, &mut workspace, args.quiet());
    }
    match kept {
        true => closes(exit, &visit, (&mut session, &mut workspace), args, run),
        false => Ok(exit),
    }
}

/// Looks through a run for what its controller lacks, before anything moves.
fn lacks(
    controller: &Controller,
    work: &Work,
    session: &Session,
    options: &RunOptions,
    workspace: &Workspace,
    run: &RunArgs,
) -> Result<Option<Exit>> {
    let files = setup::workspace(workspace.part_folder(), &run.place, true)?;
    let answers = setup::answers(run)?;
    Ok(controller::look_through(controller, work, session, options, files, answers))
}

/// The run is over: the controller that made it, if one did, is left as it was found.
fn leave(
    controller: Option<&Controller>,
    summary: &Summary,
    workspace: &mut Workspace,
    stop: &Stop,
) {
    if let Some(controller) = controller {
        controller.ends(summary.status == kerf_sbp::Status::Ok, workspace, || stop.is_wanted());
        controller.detach(workspace);
    }
}

/// Preview mode holds for what is typed next, and whoever types knows.
fn tell_preview(session: &Session, workspace: &mut Workspace, quiet: bool) {
    preview_mode::keep(session, workspace);
    if session.is_in_preview() && !quiet {
        eprintln!("kerf: in preview: what is sent is only drawn, until `kerf send SM`");
    }
}

/// The job origin of the machine is there from now on.
fn keep_origin(at: [f64; 2], session: &Session, place: &PlaceArgs) -> Result<()> {
    let Some(setting) = table::setting("job.origin_mm") else { bail!("no setting job.origin_mm") };
    let mut machine = session.configuration();
    machine.job.origin_mm = at.map(|mm| rounded(mm, 6));
    Ok(machine_file::of_data_to_change(&place.data)?.keep_one(setting, &machine)?)
}

/// Data from which a run is shown.
struct Show {
    name: Arc<str>,
    /// Lines of the part file; 0 where nobody counts them.
    lines: usize,
    talk: Talk,
    /// Lines of the files, shown where something is wrong.
    source: FileLines,
    /// Whose signals are traced.
    machine: Configuration,
    /// The program that shows files, and the folder they lie in.
    editor: Option<(String, PathBuf)>,
}

/// The program that UN named.
fn editor(workspace: &Workspace) -> Option<(String, PathBuf)> {
    let program = workspace.stored.get(kerf_sbp::EDITOR)?;
    Some((program.to_owned(), workspace.part_folder().to_owned()))
}

/// Something runs, with whoever sits at the terminal.
fn attended<'a>(
    args: &MachineArgs,
    run: &RunArgs,
    show: Show,
    answers: Answers,
    controller: Option<&Controller>,
    runs: impl FnOnce(RunContext<'_>) -> Result<(Summary, &'a Session, Option<JournalError>)>,
) -> Result<Exit> {
    let format = args.picture.as_deref().map(picture::format_of).transpose()?;
    let picture = format.map(|_| Picture::new(Path::new(&*show.name)));
    let progress = (!args.quiet && io::stderr().is_terminal()).then(|| Progress::new(show.lines));
    let data = data_folder(&run.place.data).ok();
    let data = data.as_deref();
    let trace = args.trace.as_deref().map(|path| trace(path, data)).transpose()?;
    let signals = args.vcd.sink(show.machine, data)?;
    let readings = args.readings.as_deref().map(|path| ReadingBytes::to(path, data)).transpose()?;
    let talk = (!args.traces_out()).then_some(show.talk);
    let mut told = (
        (talk, (trace, (signals, readings))),
        (Diagnostics::with(show.source), (picture, progress)),
    );
    let person = run.answers.is_none() && io::stdin().is_terminal();
    let real = args.pace == PaceName::Real && controller.is_none();
    let clock = if real { Clock::Real } else { Clock::Fast };
    let mut terminal = Terminal::new(clock, run.operator.script())?;
    let mut person_at_it = Person::new(answers, person, &terminal).with_editor(show.editor);
    let machine = controller.map_or_else(|| terminal.simulated(), |it| it.driven().into());
    if controller.is_some() {
        terminal.follows(&machine.machine);
        person_at_it.follows(&machine.machine);
    }
    let context = RunContext {
        sink: &mut told,
        operator: &mut person_at_it,
        requests: &mut terminal,
        machine,
    };
    let (summary, session, unkept) = runs(context)?;
    let ((_, (trace, (signals, readings))), (_, (picture, progress))) = told;
    readings.map_or(Ok(()), ReadingBytes::finish)?;
    args.vcd.finish(signals)?;
    if let Some(trace) = trace {
        out::unless_gone(trace.finish()).context("cannot write the trace")?;
    }
    if let Some(progress) = progress {
        progress.finish();
    }
    if let (Some(picture), Some(format), Some(path)) = (picture, format, &args.picture) {
        picture::write(&picture.finish(&summary, session), format, path)?;
    }
    if !args.quiet() {
        summary::tell(&summary);
    }
    match unkept {
        Some(why) => Err(why.into()),
        None => Ok(summary.status.into()),
    }
}

/// A run that is over, and why what it left is not kept.
fn over(ran: Result<Summary, JournalError>) -> Result<(Summary, Option<JournalError>)> {
    match ran {
        Err(JournalError::NotKept { ref summary, .. }) => Ok(((**summary).clone(), ran.err())),
        ran => Ok((ran?, None)),
    }
}

/// A file that takes the trace of a run; the data folder keeps the note of it.
fn trace(path: &Path, data: Option<&Path>) -> Result<JsonLines<LineWriter<Box<dyn Write>>>> {
    let cannot = |e: io::Error| Usage(format!("cannot write {}: {e}", path.display()));
    let to: Box<dyn Write> = match path == Path::new(STANDARD_OUTPUT) {
        true => Box::new(io::stdout()),
        false => Box::new(Streamed::create(path, data).map_err(cannot)?),
    };
    Ok(JsonLines::new(LineWriter::new(to)))
}

impl RunCommand {
    /// Refuses to write over what is run, or what the run reads, whatever leave there is to replace files.
    pub fn spare_what_it_reads(&self) -> Result<()> {
        self.file.as_deref().map_or(Ok(()), |file| self.machine.spare(file, &self.run))
    }

    /// The files that it writes.
    pub fn outputs(&self) -> Outputs {
        self.machine.outputs(&self.run.place.data)
    }
}
