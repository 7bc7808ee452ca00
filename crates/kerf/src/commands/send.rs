//! `kerf send`: commands to be carried out at once, or a job file to another computer.

use super::controller_settings;
use super::protect;
use super::run::{MachineArgs, on_machine};
use crate::accepted_options::AcceptedOptions;
use crate::args::RunArgs;
use crate::exit::{Exit, Usage};
use crate::given;
use crate::outputs::Outputs;
use crate::preview_mode;
use crate::remote::{OWN_MACHINE, Remote};
use crate::report::Talk;
use crate::sending::{Sent, Shown, To, ended, send_over_line, send_over_network};
use crate::setup;
use crate::stop::Stop;
use crate::summary::told_by_server;
use crate::transfer::Sender;
use anyhow::{Context, Result, anyhow, bail};
use clap::Args;
use kerf_control::controller::settings_in;
use kerf_formats::ending;
use kerf_transport::Port;
use kerf_workspace::Workspace;
use std::io::ErrorKind;
use std::path::Path;

/// Name under which the lines are kept in the part folder, as SI does.
const FILE: &str = "temp_code.sbp";

/// Carries out command lines at once, as if they were typed at the machine; or sends a file
///
/// A file goes to the computer at the machine: `kerf send FILE com2` over a serial line, where `kerf receive`
/// takes it, `kerf send FILE http://…` over the network into the part folder of `kerf serve`. The transfer waits while
/// the machine there moves. Ctrl-C stops it, and nothing of the file is kept.
///
/// A line `$120=500` writes a setting into the controller that --machine names, one of grbl's family, and is read back; such
/// lines stand by themselves.
///
/// Settings made by the lines stay. Several lines are a program and may contain jumps and conditions. A single line has
/// to be a command or an assignment. The lines are kept in temp_code.sbp in the part folder: the present folder, unless
/// --parts names another.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  kerf send 'MX,1' 'MY,2'\n  kerf send 'VC,.375'\n  kerf send UV \
    --quiet\n  kerf send '$120=500' --machine grbl:/dev/ttyUSB0\n  kerf send door.rsm com2\n  kerf send door.rsm com        at the port of options.send_port\n  \
    kerf send door.rsm http://192.168.1.20:8710"
)]
pub struct SendArgs {
    /// The lines
    #[arg(required_unless_present = "again", value_name = "LINE", allow_hyphen_values = false)]
    lines: Vec<String>,
    /// Sends them to a running `kerf serve` at this address [default: KERF_URL, where it is set]
    #[arg(long, value_name = "URL")]
    server: Option<String>,
    /// The rate at which a file is sent: 2400, 4800, 9600, 19200 or 38400 baud [default: options.send_baud]
    #[arg(long, value_name = "BAUD", value_parser = super::receive::baud)]
    baud: Option<u32>,
    /// Carries out the lines sent last, once more
    #[arg(long, conflicts_with = "lines")]
    again: bool,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Options that reach a server.
const REACHES_SERVERS: AcceptedOptions =
    AcceptedOptions { options: &["server", "folder", "password", "quiet"], instead: OWN_MACHINE };

impl SendArgs {
    /// The server that carries the lines out, where one does.
    pub fn server(&self) -> Option<String> {
        let named = || std::env::var("KERF_URL").ok().filter(|url| !url.is_empty());
        self.server.clone().or_else(named).filter(|_| !self.is_file())
    }

    /// The options that are heeded, where not all are.
    pub fn heeded(&self) -> Option<AcceptedOptions> {
        self.server().map(|_| REACHES_SERVERS)
    }

    /// The files that it writes.
    pub fn outputs(&self) -> Outputs {
        self.machine.outputs(&self.run.place.data)
    }

    /// The file that is sent, and where to.
    fn file(&self) -> Option<(&Path, To)> {
        let [file, to] = self.lines.as_slice() else { return None };
        Some((Path::new(file), To::of(to)?))
    }

    /// Returns `true` if a file is sent, and nothing carried out.
    pub fn is_file(&self) -> bool {
        self.file().is_some()
    }
}

/// Sends a file to another computer.
fn send_file(file: &Path, to: &To, args: &SendArgs) -> Result<Exit> {
    let bytes = given::bytes(file)?;
    let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let stop = Stop::listen()?;
    let stopped = || stop.is_wanted();
    let mut shown = Shown::new(args.machine.quiet());
    let state = match to {
        To::Server(url) => {
            let file = Sent { name: &name, bytes: &bytes, replaces: args.machine.replaces() };
            send_over_network(url, &file, &stopped, &mut shown)?
        }
        _ => {
            let place = &args.run.place;
            let machine = setup::machine(&place.machine, &place.data)?;
            let baud = args.baud.unwrap_or(machine.options.send_baud);
            let port = Port::open(&to.device(&machine)?, baud)?;
            let sender = Sender::new(&name, bytes, baud).map_err(|why| anyhow!(why))?;
            send_over_line(port, sender, &stopped, &mut shown)?
        }
    };
    Ok(ended(&name, &state))
}

/// Carries out lines that another command stands for.
pub fn carry_out(text: &str, machine: MachineArgs, run: RunArgs) -> Result<Exit> {
    machine.check(&run)?;
    let workspace = setup::workspace(Path::new(""), &run.place, false)?;
    typed(kerf_sbp::read_typed("typed".into(), text), workspace, &machine, &run)
}

/// Carries out what was typed. What changes settings needs the password, where there is one.
fn typed(
    program: kerf_sbp::Program,
    workspace: Workspace,
    machine: &MachineArgs,
    run: &RunArgs,
) -> Result<Exit> {
    let sets = program.sets_machine();
    let mut job = setup::job_of(program, workspace, run, false)?;
    if sets {
        protect::open(&job.session.machine_is, machine.password.as_deref())?;
        job.options.opened = true;
    }
    job.options.program.typed = true;
    if job.kept {
        preview_mode::go_on(&mut job.session, &job.workspace);
    }
    on_machine(job, machine, run, Talk::all())
}

/// Has a running server carry the lines out.
fn remotely(url: &str, lines: &str, args: &SendArgs) -> Result<Exit> {
    let server = Remote::new(url, &args.run.place.data)?;
    if let Some(password) = protect::of_option(args.machine.password.as_deref()) {
        server.unlock(&password)?;
    }
    let set = settings_in(lines).map_err(Usage)?;
    if !set.is_empty() {
        return controller_settings::written_by_server(&server, &set, args.machine.quiet());
    }
    Ok(told_by_server(&server.send(lines, false)?, args.machine.quiet()))
}

/// Tells whether a name ends as those of part files and jobs do.
fn is_part_file(name: &str) -> bool {
    let ending = ending(Path::new(name));
    ending == "rsm" || kerf_sbp::is_part_name(name) || kerf_sbp::is_gcode_name(name)
}

/// Refuses a file that was meant to be sent: it is no line, and where it goes is missing.
fn refuse_file(args: &SendArgs) -> Result<()> {
    let [file] = args.lines.as_slice() else { return Ok(()) };
    let is_line = !kerf_sbp::read_typed(FILE.into(), file).has_errors();
    if !is_line && !Path::new(file).is_file() && is_part_file(file) {
        let why = given::why(Path::new(file), &ErrorKind::NotFound.into());
        bail!(Usage(format!(
            "{file} is no line and no file: {why}; `kerf send MX,1` carries a line out"
        )));
    }
    if !is_line && Path::new(file).is_file() {
        bail!(Usage(format!(
            "{file} is a file: name a port or an address: kerf send {file} com2; `kerf run {file}` runs it"
        )));
    }
    Ok(())
}

pub fn run(args: &SendArgs) -> Result<Exit> {
    if let Some((file, to)) = args.file() {
        return send_file(file, &to, args);
    }
    args.machine.check(&args.run)?;
    refuse_file(args)?;
    if let Some(url) = args.server() {
        return remotely(&url, &args.lines.join("\n"), args);
    }
    let mut workspace = setup::workspace(Path::new(""), &args.run.place, false)?;
    let text = if args.again {
        workspace
            .text(FILE)
            .with_context(|| format!("nothing was sent before: there is no {FILE}"))?
    } else {
        args.lines.join("\n") + "\n"
    };
    let set = settings_in(&text).map_err(Usage)?;
    let program = kerf_sbp::read_typed(FILE.into(), &text);
    if !program.has_errors() || !set.is_empty() {
        workspace.put(FILE, text.as_bytes()).with_context(|| format!("cannot write {FILE}"))?;
    }
    if !set.is_empty() {
        return controller_settings::written(&set, workspace, &args.machine, &args.run);
    }
    typed(program, workspace, &args.machine, &args.run)
}
