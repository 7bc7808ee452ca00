//! `kerf run`: a part file on a machine.

use crate::args::RunArgs;
use crate::exit::{Exit, Usage};
use crate::operator::{Clock, Person, RealPace};
use crate::out;
use crate::picture::{self, Format, Picture};
use crate::progress::Progress;
use crate::report::{Diagnostics, Talk};
use crate::setup::{self, Job};
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use kerf_control::{Company, Sink, Summary};
use kerf_program::settings::LinearUnit;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

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
    file: PathBuf,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// What everything that moves a machine can be told.
#[derive(Args)]
pub struct MachineArgs {
    /// The machine to run on
    #[arg(long, value_name = "NAME", default_value = "sim")]
    machine: String,
    /// How machine time passes
    #[arg(long, value_enum, default_value = "fast")]
    pace: PaceName,
    /// Draws the tool path as it was run: .svg, .png or .html
    #[arg(long, value_name = "OUT")]
    picture: Option<PathBuf>,
    /// No progress, no summary
    #[arg(short, long)]
    quiet: bool,
}

/// How machine time passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum PaceName {
    /// As fast as can be computed.
    Fast,
    /// A second of machine time takes a second.
    Real,
}

pub fn run(args: &RunCommand) -> Result<Exit> {
    args.machine.check()?;
    let mut run = args.run.clone();
    run.place.start_run();
    let job = setup::job(&args.file, &run, false)?;
    on_machine(job, &args.machine, &run, Talk::default())
}

/// Runs a job on the machine and keeps what stays.
pub fn on_machine(mut job: Job, args: &MachineArgs, run: &RunArgs, talk: Talk) -> Result<Exit> {
    let format = args.picture.as_deref().map(Format::of).transpose()?;
    let picture = format.map(|_| Picture::new(Path::new(&**job.program.name())));
    let progress = (!args.quiet && io::stderr().is_terminal()).then(|| Progress::new(&job.program));
    let mut sink = (talk, (Diagnostics::default(), (picture, progress)));
    let person = run.answers.is_none() && io::stdin().is_terminal();
    let clock = if args.pace == PaceName::Real { Clock::Real } else { Clock::Fast };
    let mut pace = RealPace::new(clock, run.operator.script())?;
    let mut operator = Person::new(job.answers, person, &pace);
    let company =
        Company { sink: &mut sink as &mut dyn Sink, operator: &mut operator, pace: &mut pace };
    job.memory.begin(&mut job.shelf, &job.session)?;
    let summary = job.session.run(job.program, job.options, &mut job.shelf, company);
    job.memory.end(&mut job.shelf, &job.session)?;
    let (_, (_, (picture, progress))) = sink;
    if let Some(progress) = progress {
        progress.finish();
    }
    if let (Some(picture), Some(format), Some(path)) = (picture, format, &args.picture) {
        picture::write(&picture.finish(&summary, &job.session), format, path)?;
    }
    if !args.quiet {
        out::print(&told(&summary));
    }
    Ok(summary.status.into())
}

impl MachineArgs {
    /// Refuses machines that are not there.
    pub fn check(&self) -> Result<()> {
        if self.machine != "sim" {
            let name = &self.machine;
            bail!(Usage(format!(
                "there is no machine '{name}'; only the simulated one, sim, so far"
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
