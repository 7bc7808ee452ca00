//! `kerf run`: a part file on a machine.

mod behind;

use crate::args::{DataArgs, PlaceArgs, RunArgs};
use crate::commands::protect;
use crate::controller::{self, DriverName, First};
use crate::drawings;
use crate::exit::{Exit, Usage};
use crate::heeded::Heeded;
use crate::job_options;
use crate::machine_file;
use crate::memory;
use crate::operator::{Clock, Person, Terminal};
use crate::out;
use crate::outputs::{ForceArgs, Outputs};
use crate::parse;
use crate::picture::{self, Format, Picture};
use crate::progress::Progress;
use crate::remote::{Along, Ended, How, OWN_MACHINE, Remote};
use crate::report::{Diagnostics, Talk};
use crate::setup::{self, Job as Prepared};
use crate::signals::{ReadingBytes, VcdArgs};
use crate::sources::FileLines;
use crate::stop::Stop;
use crate::visit::Visit;
use anyhow::{Context, Result, bail};
use behind::closes;
use clap::{Args, ValueEnum};
use kerf_control::answers::Answers;
use kerf_control::controller::Shared;
use kerf_control::journal::{JournalError, Whereabouts};
use kerf_control::json::JsonLines;
use kerf_control::{Company, Session, Shelf, Summary, Work};
use kerf_diag::Diagnostic;
use kerf_machine::Driven;
use kerf_machine::{Configuration, table};
use kerf_program::job::Job;
use kerf_program::settings::LinearUnit;
use std::fs::File;
use std::io::{self, IsTerminal, LineWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Runs a part file on a machine: the simulated one
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
    /// Takes up the run that was cut short, because Kerf was killed or the power failed: the tool
    /// lifts, the spindle starts, the tool goes over the place, plunges, and the cut goes on
    #[arg(long, conflicts_with = "file")]
    resume: bool,
    /// Runs it on a running `kerf serve` at this address: a file of its part folder. What it prints is
    /// printed, its questions are asked here and on every page, Ctrl-C stops it
    #[arg(long, value_name = "URL", conflicts_with = "resume")]
    server: Option<String>,
    /// Arms the machine of the server first
    #[arg(long, requires = "server")]
    arm: bool,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// The name of standard output where a file is asked for.
const STANDARD_OUTPUT: &str = "-";

/// What everything that moves a machine can be told.
#[derive(Args, Clone)]
pub struct MachineArgs {
    /// Cuts every path of a job so far beside itself, mm, to the right of travel; the file stays as it is
    #[arg(long, value_name = "MM", value_parser = parse::number)]
    offset_job: Option<f64>,
    /// The machine to run on: the simulated one, sim. --driver runs on a real controller, --config says what
    /// the machine is like
    #[arg(long, value_name = "NAME", default_value = "sim")]
    machine: String,
    /// Runs it on a real controller: grbl or grblHAL at a serial port, at 115200 baud unless another rate
    /// is named
    #[arg(long, value_name = "grbl:PORT[@BAUD]", value_parser = DriverName::read)]
    driver: Option<DriverName>,
    #[command(flatten)]
    first: First,
    /// How machine time passes
    #[arg(long, value_enum, default_value = "fast")]
    pace: PaceName,
    /// Draws the tool path as it was run: .svg, .png or .html
    #[arg(long, value_name = "OUT")]
    picture: Option<PathBuf>,
    /// Writes everything that the run does to a file, an event a line, as `kerf trace` prints it; with `-` to
    /// standard output, and nothing else there
    #[arg(long, value_name = "OUT")]
    trace: Option<PathBuf>,
    /// Writes every reading of the height sensor to a file or a device, a byte each, as a potentiometer sends
    /// them on its serial line
    #[arg(long, value_name = "FILE")]
    readings: Option<PathBuf>,
    #[command(flatten)]
    vcd: VcdArgs,
    /// The password of the settings, where they are protected [default: KERF_PASSWORD]: what the program
    /// sets stays
    #[arg(long, value_name = "WORD")]
    pub password: Option<String>,
    /// No progress, no summary
    #[arg(short, long)]
    quiet: bool,
    #[command(flatten)]
    force: ForceArgs,
}

/// How machine time passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum PaceName {
    /// As fast as can be computed.
    Fast,
    /// A second of machine time takes a second.
    Real,
}

/// Options that reach a server: the rest is refused, for nobody would heed it there.
const REACHES_SERVERS: Heeded = Heeded {
    options: &[
        "server",
        "folder",
        "arm",
        "password",
        "quiet",
        "answers",
        "proportion",
        "repeat",
        "offset",
        "plunge",
        "tabs",
        "plunge_from_zero",
        "step",
        "from_line",
        "offset_job",
    ],
    instead: OWN_MACHINE,
};

/// Options that are heeded when a run is taken up; on a controller nothing is taken up, which is told by itself.
const TAKES_UP: Heeded = Heeded {
    options: &[
        "resume",
        "data",
        "start",
        "machine",
        "driver",
        "home",
        "unlock",
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
    pub const fn heeded(&self) -> Option<Heeded> {
        match (self.server.is_some(), self.resume) {
            (true, _) => Some(REACHES_SERVERS),
            (_, true) => Some(TAKES_UP),
            _ => None,
        }
    }
}

/// Has a server run a file of its part folder.
fn remotely(url: &str, file: &Path, args: &RunCommand) -> Result<Exit> {
    let how = how_remotely(file, args)?;
    let server = Remote::new(url, &args.run.place.data)?;
    if let Some(password) = protect::of_option(args.machine.password.as_deref()) {
        server.unlock(&password)?;
    }
    let terminal = Terminal::new(Clock::Fast, args.run.operator.script())?;
    let person = args.run.answers.is_none() && io::stdin().is_terminal();
    let mut operator = Person::new(setup::answers(&args.run)?, person, &terminal);
    let mut print = |line: &str| out::print(&format!("{line}\n"));
    let stopped = || terminal.is_stopped();
    let diagnostics = Diagnostics::default();
    let show = |found: &Diagnostic| diagnostics.show(found);
    let along =
        Along { operator: &mut operator, stopped: &stopped, print: &mut print, show: &show };
    let ended = server.run(&file.display().to_string(), &how, args.arm, along)?;
    Ok(told_by_server(&ended, args.machine.quiet()))
}

/// Returns the way in which a server runs the file, as the options say.
fn how_remotely(file: &Path, args: &RunCommand) -> Result<How> {
    let (run, beside_mm) = (&args.run, args.machine.offset_job);
    match drawings::is_drawing(file) {
        true => job_options::remotely(run, beside_mm).map(How::Job),
        false if beside_mm.is_some() => Err(job_options::only_of_jobs().into()),
        false if run.file.from_line.is_some() => bail!(Usage(
            "--from-line begins a part file only here: on a server go through it with --step, and answer the number \
             of the line"
                .into()
        )),
        false => Ok(How::Part(run.file.clone())),
    }
}

/// Tells how a server's run ended.
pub fn told_by_server(ended: &Ended, quiet: bool) -> Exit {
    let diagnostics = Diagnostics::default();
    ended.told.iter().for_each(|found| diagnostics.show(found));
    if !quiet {
        tell(&ended.summary);
    }
    ended.summary.status.into()
}

pub fn run(args: &RunCommand) -> Result<Exit> {
    args.machine.check()?;
    if let (Some(url), Some(file)) = (&args.server, &args.file) {
        return remotely(url, file, args);
    }
    let mut run = args.run.clone();
    run.place.start_run(args.machine.driver.is_some());
    match &args.file {
        Some(file) => {
            if args.run.place.start.is_none() && !args.machine.quiet() {
                tell_fresh(&run.place);
            }
            let mut job = setup::job(file, &run, false)?;
            if let Some(by_mm) = args.machine.offset_job {
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
    let fresh = place.config.is_none() && !memory::is_kept(place, false);
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
    let mm_min = |mm_s: f64| out::number(mm_s * 60.0, 1);
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
    if args.driver.is_some() {
        bail!(Usage(
            "a run on a controller is not taken up with --resume: home it or set its location, and begin at \
             a line of the file with --from-line"
                .into()
        ));
    }
    let mut shelf = setup::shelf(Path::new(""), &run.place, false)?;
    let nothing = || JournalError::NothingToResume { folder: shelf.app_path().into() };
    let journal = shelf.journal().cloned().ok_or_else(nothing)?;
    let cut = journal.cut_short()?.ok_or_else(nothing)?;
    let (mut session, whereabouts) = Session::recall(&journal, &mut shelf)?;
    if !args.quiet {
        eprintln!("kerf: {}", cut.told());
    }
    if whereabouts == Whereabouts::Moving {
        eprintln!(
            "kerf: the machine was moving when Kerf ended; unless it was zeroed since, it goes on from \
             where it was believed to be"
        );
    }
    let answers = setup::answers(run)?;
    let machine = journal.machine_of(&cut)?;
    let show = Show {
        name: cut.file().into(),
        lines: 0,
        talk: Talk::of(drawings::is_drawing(Path::new(cut.file()))),
        source: FileLines::default(),
        machine,
        editor: editor(&shelf),
    };
    let visit = Visit::default();
    visit.begins(&session, &mut shelf)?;
    let exit = attended(args, run, show, answers, None, |company| {
        let (summary, unkept) = over(session.resume(&cut, &mut shelf, company))?;
        Ok((summary, &session, unkept))
    })?;
    closes(exit, &visit, (&mut session, &mut shelf), args, run)
}

/// Runs a job on the machine and keeps what stays.
pub fn on_machine(job: Prepared, args: &MachineArgs, run: &RunArgs, talk: Talk) -> Result<Exit> {
    args.spare(Path::new(&*job.work.name()), run)?;
    let Prepared {
        work, mut session, mut options, mut shelf, answers, kept, replaced, visit, ..
    } = job;
    options.opened |= protect::given(&session.machine_is, args.password.as_deref())?;
    let mut controller = None;
    if let Some(name) = &args.driver {
        controller::check(run)?;
        let shared = controller::ready(name, args.first, args.quiet(), &mut session, &mut shelf)?;
        if let Some(exit) =
            controller::look_through(&shared, &work, &session, &options, &shelf, run)?
        {
            return Ok(exit);
        }
        let command = &session.machine_is.options.firmware;
        shelf = shelf.with_firmware(controller::firmware(&shared, name, command));
        options.controller = Some(name.to_string());
        controller::begins(name, &shared, &mut shelf);
        controller = Some(shared);
    }
    if !kept && args.driver.is_none() {
        shelf.has_fresh_machine();
    }
    let machine = VcdArgs::machine(&work, &session);
    let show = Show {
        name: work.name(),
        lines: work.line_count(),
        talk,
        source: FileLines::of(&work),
        machine,
        editor: editor(&shelf),
    };
    if kept {
        visit.begins(&session, &mut shelf)?;
    }
    let takes = work.takes_origin(session.memory.position);
    let takes = takes.filter(|_| kept && args.driver.is_none() && run.place.config.is_none());
    let (mut moved, typed) = (false, options.program.typed);
    let exit = attended(args, run, show, answers, controller.clone(), |company| {
        let shelf = &mut shelf;
        let (summary, unkept) = over(match kept {
            true => session.run_on_record(work, options, replaced, shelf, company),
            false => Ok(session.run(work, options, shelf, company)),
        })?;
        moved = summary.tally.moves > 0;
        Ok((summary, &session, unkept))
    })?;
    if let Some(at) = takes.filter(|_| moved) {
        keep_origin(at, &session, &run.place)?;
    }
    if kept && typed {
        tell_preview(&session, &mut shelf, args.quiet());
    }
    if let Some((name, shared)) = args.driver.as_ref().zip(controller) {
        controller::leaves(name, &shared, &mut shelf);
    }
    match kept {
        true => closes(exit, &visit, (&mut session, &mut shelf), args, run),
        false => Ok(exit),
    }
}

/// Preview mode holds for what is typed next, and whoever types knows.
fn tell_preview(session: &Session, shelf: &mut Shelf, quiet: bool) {
    session.keep_preview(shelf);
    if session.is_in_preview() && !quiet {
        eprintln!("kerf: in preview: what is sent is only drawn, until `kerf send SM`");
    }
}

/// The job origin of the machine is there from now on.
fn keep_origin(at: [f64; 2], session: &Session, place: &PlaceArgs) -> Result<()> {
    let Some(setting) = table::setting("job.origin_mm") else { bail!("no setting job.origin_mm") };
    let mut machine = session.configuration();
    machine.job.origin_mm = at.map(out::tidy);
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
fn editor(shelf: &Shelf) -> Option<(String, PathBuf)> {
    let program = shelf.stored.get(kerf_sbp::EDITOR)?;
    Some((program.to_owned(), shelf.part_folder().to_owned()))
}

/// Something runs, with whoever sits at the terminal.
fn attended<'a>(
    args: &MachineArgs,
    run: &RunArgs,
    show: Show,
    answers: Answers,
    controller: Option<Shared>,
    runs: impl FnOnce(Company<'_>) -> Result<(Summary, &'a Session, Option<JournalError>)>,
) -> Result<Exit> {
    let format = args.picture.as_deref().map(Format::of).transpose()?;
    let picture = format.map(|_| Picture::new(Path::new(&*show.name)));
    let progress = (!args.quiet && io::stderr().is_terminal()).then(|| Progress::new(show.lines));
    let trace = args.trace.as_deref().map(trace).transpose()?;
    let signals = args.vcd.sink(show.machine)?;
    let readings = args.readings.as_deref().map(ReadingBytes::to).transpose()?;
    let talk = (!args.traces_out()).then_some(show.talk);
    let mut told = (
        (talk, (trace, (signals, readings))),
        (Diagnostics::with(show.source), (picture, progress)),
    );
    let driven = controller.clone().map(|shared| -> Driven { shared });
    let person = run.answers.is_none() && io::stdin().is_terminal();
    let real = args.pace == PaceName::Real && controller.is_none();
    let clock = if real { Clock::Real } else { Clock::Fast };
    let mut terminal = Terminal::new(clock, run.operator.script())?;
    let stop = Stop::listen()?;
    let mut person_at_it = Person::new(answers, person, &terminal).with_editor(show.editor);
    let machine = driven.unwrap_or_else(|| terminal.simulated());
    let company =
        Company { sink: &mut told, operator: &mut person_at_it, requests: &mut terminal, machine };
    let (summary, session, unkept) = runs(company)?;
    if let Some(shared) = controller {
        shared.borrow_mut().close(summary.status == kerf_sbp::Status::Ok, || stop.is_wanted());
    }
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
        tell(&summary);
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

/// Prints the summary of a run.
pub fn tell(summary: &Summary) {
    out::print(&told(summary));
}

/// A file that takes the trace of a run.
fn trace(path: &Path) -> Result<JsonLines<LineWriter<Box<dyn Write>>>> {
    let cannot = |e: io::Error| Usage(format!("cannot write {}: {e}", path.display()));
    let to: Box<dyn Write> = match path == Path::new(STANDARD_OUTPUT) {
        true => Box::new(io::stdout()),
        false => Box::new(File::create(path).map_err(cannot)?),
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

impl MachineArgs {
    /// The files that the run writes besides those of the program.
    pub fn outputs(&self, data: &DataArgs) -> Outputs {
        let files = self.written().into_iter().filter_map(|(_, file)| file);
        Outputs::of(files, self.force.force, Some(data))
    }

    /// Files are replaced without a question.
    pub fn replaces(&self) -> bool {
        self.force.force
    }

    /// Every option that names a file to be written.
    fn written(&self) -> [(&'static str, Option<&Path>); 4] {
        [
            ("--trace", self.trace.as_deref().filter(|_| !self.traces_out())),
            ("--picture", self.picture.as_deref()),
            ("--readings", self.readings.as_deref()),
            ("--vcd", self.vcd.path()),
        ]
    }

    /// No summary is wanted.
    pub fn quiet(&self) -> bool {
        self.quiet || self.traces_out()
    }

    /// Refuses to write over what is run, or what the run reads.
    fn spare(&self, file: &Path, run: &RunArgs) -> Result<()> {
        let written = self.written();
        let read = [
            Some(file),
            run.answers.as_deref(),
            run.script.as_deref(),
            run.place.config.as_deref(),
        ];
        let whole: Vec<PathBuf> =
            read.into_iter().flatten().filter_map(|path| path.canonicalize().ok()).collect();
        for (option, path) in written {
            let there = path.and_then(|path| path.canonicalize().ok());
            if let Some(there) = there.filter(|there| whole.contains(there)) {
                let name = there.display();
                bail!(Usage(format!(
                    "{option} would write over {name}, which the run reads: name another file"
                )));
            }
        }
        Ok(())
    }

    /// Standard output belongs to the trace.
    fn traces_out(&self) -> bool {
        self.trace.as_deref() == Some(Path::new(STANDARD_OUTPUT))
    }

    /// Refuses machines that are not there.
    pub fn check(&self) -> Result<()> {
        if self.machine != "sim" {
            let name = &self.machine;
            bail!(Usage(format!(
                "there is no machine '{name}': runs are on the simulated one, sim; --driver grbl:PORT runs on a \
                 real controller, --config {name} says what the machine is like"
            )));
        }
        Ok(())
    }
}

/// The summary of a run.
fn told(summary: &Summary) -> String {
    let tally = &summary.tally;
    let (mm, unit) = (summary.unit.mm(), summary.unit.symbol());
    let decimals = if summary.unit == LinearUnit::Mm { 1 } else { 2 };
    let length = |v: f64| format!("{} {unit}", out::number(v / mm, decimals));
    let status = match summary.status {
        kerf_sbp::Status::Ok => "ran to its end",
        kerf_sbp::Status::Ended => "ended by the program",
        kerf_sbp::Status::Failed => "FAILED",
        kerf_sbp::Status::Stopped => "STOPPED",
        kerf_sbp::Status::Limit => "STOPPED BY A LIMIT",
    };
    let mut text = format!("{status} after {}\n", out::duration(summary.seconds));
    text += &format!(
        "  {}, {}, {}\n  cut {}, jogged {}\n",
        out::count(summary.lines, "line"),
        out::count(tally.moves, "move"),
        out::count(tally.arcs, "arc"),
        length(tally.cut_mm),
        length(tally.jog_mm)
    );
    if let Some(bounds) = out::bounds(summary) {
        text += &format!("  cutting {bounds}\n");
    }
    text
}
