//! `kerf sb3`: the start-up line of the handbook.

use super::run::{MachineArgs, on_machine};
use super::serve::ServeArgs;
use crate::args::{PlaceArgs, RunArgs, Start};
use crate::exit::{Exit, Usage};
use crate::machine_file;
use crate::report::Talk;
use crate::setup;
use crate::start_up::{CloseMethod, OpenMethod, Port, StartUp};
use crate::summary;
use crate::visit::Visit;
use anyhow::Result;
use clap::Args;
use kerf_control::RunContext;
use std::io::{self, IsTerminal, Write};
use std::iter::once;
use std::net::SocketAddr;
use std::path::{Path, PathBuf};

/// Starts with the command line of the ShopBot software: "file, port, open, timing, close, display, offset"
///
/// open: 1 to 3 show the sheet of the file in the console and wait; 4 runs it at once; 5 draws it at
/// once; 6 only makes it the current file. close: 0 stays and serves the console, at a terminal or with
/// --console, 1 asks, 2 closes. display: 0 as last used, 1 console on, 2 off, 9 files only. offset: 0
/// none, 1 3D, 2 2D, where the file runs at once. Items may be left blank.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  kerf sb3 'a.sbp,,4,,2'\n  kerf sb3 '\"my part.sbp\",3,4,,2,0,2'"
)]
pub struct Sb3Args {
    /// The line
    line: String,
    /// Opens the console, also where nobody sits at a terminal
    #[arg(long)]
    console: bool,
    /// Where the console listens
    #[arg(long, value_name = "ADDR", default_value = "127.0.0.1:8710")]
    listen: SocketAddr,
    /// Seconds of machine time in a second, for tests
    #[arg(long, hide = true, default_value_t = 1.0)]
    rate: f64,
    /// Answers yes when it asks whether to close
    #[arg(long)]
    yes: bool,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    run: RunArgs,
}

pub fn run(args: &Sb3Args) -> Result<Exit> {
    args.machine.check(&args.run)?;
    let line = StartUp::read(&args.line).map_err(Usage)?;
    if line.close == CloseMethod::Stay && (args.console || io::stdin().is_terminal()) {
        return serves(args, &line);
    }
    match line.open {
        OpenMethod::Run => runs(args, &line),
        OpenMethod::Preview => draws(args, &line),
        OpenMethod::Current => becomes_current(args, &line),
        OpenMethod::Sheet | OpenMethod::SheetInPreview => {
            becomes_current(args, &line)?;
            eprintln!("kerf: the sheet of {} needs the console; nothing has moved", line.file);
            Ok(Exit::Stopped)
        }
    }
}

/// The console opens, and stays after the file.
fn serves(args: &Sb3Args, line: &StartUp) -> Result<Exit> {
    if let Some(Port::Number(port)) = line.port {
        keep_port(&args.run, port)?;
    }
    let place = &args.run.place;
    let path = found(line, place)?;
    let served = ServeArgs::of(line, &path, args.listen, args.rate, place)?;
    make_current(args, &path)?;
    super::serve::run(&served)
}

/// The file runs at once.
fn runs(args: &Sb3Args, line: &StartUp) -> Result<Exit> {
    let mut run = args.run.clone();
    run.place.start = run.place.start.or(Some(Start::Kept));
    run.file.offset = Some(line.offset);
    if let Some(Port::Number(port)) = line.port {
        keep_port(&run, port)?;
    }
    let mut job = setup::prepare(Path::new(&line.file), &run, false)?;
    job.visit = visit(line);
    let exit = on_machine(job, &args.machine, &run, Talk::default())?;
    if line.close == CloseMethod::Ask {
        confirmed(args);
    }
    Ok(exit)
}

/// The port is a setting of the machine: it goes where those are, and every later start finds it there.
fn keep_port(run: &RunArgs, port: u8) -> Result<()> {
    let kept = machine_file::of_data_to_change(&run.place.data)?;
    let began = kept.read(kept.text()?.as_deref().unwrap_or_default())?.program;
    let mut wanted = began.clone();
    wanted.driver.port = port;
    kept.keep(&began, &wanted)?;
    Ok(())
}

/// The file is drawn at once; the machine does not move.
fn draws(args: &Sb3Args, line: &StartUp) -> Result<Exit> {
    let mut run = args.run.clone();
    run.place.start = run.place.start.or(Some(Start::Kept));
    let log = logged(args, line, true)?;
    let mut job = setup::prepare(Path::new(&line.file), &run, true)?;
    let context = RunContext {
        sink: &mut (),
        operator: &mut job.answers,
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    let summary = job.session.run(job.work, job.options, &mut job.workspace, context);
    if !args.machine.quiet() {
        summary::tell(&summary);
    }
    log()?;
    Ok(summary.status.into())
}

/// The file is what FP and GetPartFileName mean from now on.
fn becomes_current(args: &Sb3Args, line: &StartUp) -> Result<Exit> {
    make_current(args, &found(line, &args.run.place)?)?;
    logged(args, line, line.open == OpenMethod::SheetInPreview)?()?;
    Ok(Exit::Good)
}

fn make_current(args: &Sb3Args, path: &Path) -> Result<()> {
    let mut workspace = setup::workspace(Path::new(""), &args.run.place, false)?;
    workspace.make_current(path);
    Ok(())
}

/// Finds the file of the line: as it is named here, or below the part folder.
fn found(line: &StartUp, place: &PlaceArgs) -> Result<PathBuf> {
    let below = place.parts.iter().map(|parts| parts.join(&line.file));
    let all: Vec<_> = once(PathBuf::from(&line.file)).chain(below).collect();
    let there = all.iter().find_map(|path| path.canonicalize().ok().filter(|it| it.is_file()));
    let names =
        || all.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(", nor ");
    there.ok_or_else(|| Usage(format!("there is no file {}", names())).into())
}

/// Begins a visit in the log; what comes back ends it.
fn logged(args: &Sb3Args, line: &StartUp, draws: bool) -> Result<impl FnOnce() -> Result<()>> {
    let mut place = args.run.place.clone();
    place.start = place.start.or(Some(Start::Kept));
    let mut workspace = setup::workspace(Path::new(""), &place, false)?;
    let (session, _) = setup::session(&place, false, &mut workspace)?;
    let visit = visit(line);
    visit.begins_drawing(&session, &mut workspace, draws)?;
    Ok(move || {
        visit.ends(&session, &mut workspace);
        Ok(())
    })
}

fn visit(line: &StartUp) -> Visit {
    let closing = match line.close {
        CloseMethod::Stay => "NORMAL",
        CloseMethod::Ask => "CLOSE1",
        CloseMethod::Close => "CLOSE2",
    };
    Visit { opening: line.opening.clone(), closing }
}

/// Asks whether to close. Without a person there is nothing that could stay.
fn confirmed(args: &Sb3Args) {
    let mut answer = String::new();
    while !args.yes && io::stdin().is_terminal() && !answer.trim().eq_ignore_ascii_case("y") {
        eprint!("? Close Kerf? (y): ");
        answer.clear();
        let gone = io::stderr().flush().is_err();
        if gone || io::stdin().read_line(&mut answer).unwrap_or_default() == 0 {
            break;
        }
    }
}
