//! `kerf run --server`: a file that a running server runs.

use super::RunCommand;
use crate::accepted_options::AcceptedOptions;
use crate::commands::protect;
use crate::drawings;
use crate::exit::{Exit, Usage};
use crate::job_options;
use crate::operator::{Clock, Person, Terminal};
use crate::out;
use crate::remote::{Along, How, OWN_MACHINE, Remote};
use crate::report::Diagnostics;
use crate::setup;
use crate::summary::told_by_server;
use anyhow::{Result, bail};
use kerf_diag::Diagnostic;
use std::io::{self, IsTerminal};
use std::path::Path;

/// Options that reach a server: the rest is refused, for nobody would heed it there.
pub const REACHES_SERVERS: AcceptedOptions = AcceptedOptions {
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

/// Has a server run a file of its part folder.
pub fn remotely(url: &str, file: &Path, args: &RunCommand) -> Result<Exit> {
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
    let (run, beside_mm) = (&args.run, args.offset_job);
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
