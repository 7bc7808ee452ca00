//! `kerf serve`: the web console.

mod together;

use super::receive;
use crate::args::PlaceArgs;
use crate::clock;
use crate::controller;
use crate::data_args::data_folder;
use crate::exit::{Exit, Usage};
use crate::machine_name::MachineName;
use crate::memory;
use crate::named_machine::{self, Named};
use crate::served::Served;
use crate::start_up::{OpenMethod, StartUp};
use crate::stop::Stop;
use crate::visit::Visit;
use crate::{given, out, setup};
use anyhow::{Context, Error, Result, anyhow, bail};
use clap::Args;
use kerf_control::controller::{Controller, First};
use kerf_files::versions::Versions;
use kerf_journal::machine_file::MachineFile;
use kerf_server::{Builders, Options, Server, Webhook, Workshop};
use kerf_workspace::Workspace;
use std::io::{self, ErrorKind};
use std::net::{SocketAddr, TcpListener};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

/// Serves the web console: run and watch part files, drive the machine, draw
///
/// Only this computer reaches it, unless --lan lets others in; those are paired by a code that is shown
/// here.
#[derive(Args, Clone)]
#[command(after_help = "Examples:\n  kerf serve\n  kerf serve box.sbp --parts ~/parts\n  \
    kerf serve --lan --listen 0.0.0.0:8710 --host router.local\n  \
    kerf serve --machine shop --also laser")]
pub struct ServeArgs {
    /// A file of the part folder that is open at the start
    file: Option<String>,
    /// Where to listen
    #[arg(long, value_name = "ADDR", default_value = "127.0.0.1:8710")]
    listen: SocketAddr,
    /// Serves another machine too, named as --machine names one, with an owner, a journal and a page of its own two ports
    /// on; may be repeated
    #[arg(long, value_name = "NAME", value_parser = MachineName::read)]
    also: Vec<MachineName>,
    /// Lets other computers in, after pairing
    #[arg(long)]
    lan: bool,
    /// A name by which other computers call this one; may be repeated
    #[arg(long = "host", value_name = "NAME", requires = "lan")]
    hosts: Vec<String>,
    /// Drawings only: the machine is left alone
    #[arg(long)]
    drawing_only: bool,
    /// Takes job files that come over the serial port of file sending (`kerf send FILE PORT`) into the part
    /// folder, while the machine stands
    #[arg(long)]
    receive: bool,
    /// EXIT SHOPBOT in a part file ends Kerf, not only the run
    #[arg(long)]
    exit_with_program: bool,
    /// Sends a message to this address when somebody is needed, and when a run is done or has failed: JSON with
    /// event, file and text
    #[arg(long, value_name = "URL", value_parser = Webhook::read)]
    webhook: Option<Webhook>,
    /// Seconds of machine time in a second, for tests
    #[arg(long, hide = true, default_value_t = 1.0)]
    rate: f64,
    #[command(flatten)]
    first: controller::First,
    #[command(flatten)]
    place: PlaceArgs,
    /// The start-up line that began it.
    #[arg(skip)]
    line: Option<StartUp>,
}

impl ServeArgs {
    /// The console for a start-up line whose file is at `path`.
    ///
    /// # Errors
    /// The file is not in the part folder that was named.
    pub fn of(
        line: &StartUp,
        path: &Path,
        listen: SocketAddr,
        rate: f64,
        place: &PlaceArgs,
    ) -> Result<Self> {
        let parts = place.parts.clone().or_else(|| path.parent().map(Path::to_owned));
        let file = below(parts.as_deref().unwrap_or(Path::new(".")), path)?;
        Ok(Self {
            file: Some(file),
            listen,
            also: Vec::new(),
            lan: false,
            hosts: Vec::new(),
            drawing_only: false,
            receive: false,
            exit_with_program: false,
            webhook: None,
            rate,
            first: controller::First::NONE,
            place: PlaceArgs { parts, ..place.clone() },
            line: Some(line.clone()),
        })
    }

    fn visit(&self) -> Visit {
        let opening = self.line.as_ref().map(|line| line.opening.clone()).unwrap_or_default();
        Visit { opening, ..Visit::default() }
    }

    /// Returns `true` if the visit begins in preview.
    fn draws(&self) -> bool {
        let open = self.line.as_ref().map(|line| line.open);
        matches!(open, Some(OpenMethod::Preview | OpenMethod::SheetInPreview))
    }

    /// Returns what pages show, and the lines that are carried out at once.
    fn start(&self) -> (Option<kerf_server::StartUp>, Vec<String>) {
        let Some(line) = &self.line else { return (None, Vec::new()) };
        let file = self.file.clone().unwrap_or_default();
        let sheet = matches!(line.open, OpenMethod::Sheet | OpenMethod::SheetInPreview);
        let named = if file.contains(',') { format!("\"{file}\"") } else { file.clone() };
        let run = format!("FP,{named},,,,,{}", line.offset);
        let lines = match line.open {
            OpenMethod::Run => vec![run],
            OpenMethod::Preview => vec!["SP".into(), run],
            OpenMethod::SheetInPreview => vec!["SP".into()],
            OpenMethod::Sheet | OpenMethod::Current => Vec::new(),
        };
        (Some(kerf_server::StartUp { file, sheet, display: line.display }), lines)
    }

    /// The same for drawings only, when that is wanted.
    pub fn drawing_only(self, wanted: bool) -> Self {
        Self { drawing_only: self.drawing_only || wanted, ..self }
    }
}

/// The name of the file that is open at the start: named from the part folder, or from here.
fn opened(parts: &Path, file: &str) -> Result<String> {
    let path = Some(parts.join(file)).filter(|it| it.exists()).unwrap_or_else(|| file.into());
    given::bytes(path.strip_prefix(".").unwrap_or(&path))?;
    below(parts, &path)
}

/// The name of a file below the part folder.
fn below(parts: &Path, file: &Path) -> Result<String> {
    let whole = |path: &Path| {
        path.canonicalize()
            .map_err(|error| Usage(format!("cannot read {}: {error}", path.display())))
    };
    let (folder, file) = (whole(parts)?, whole(file)?);
    let name = file.strip_prefix(&folder).map_err(|_| {
        let (file, folder) = (file.display(), folder.display());
        Usage(format!(
            "{file} is not in the part folder {folder}, and the console opens nothing else: copy it \
             there, or name its folder with --parts"
        ))
    })?;
    Ok(name.to_string_lossy().into_owned())
}

pub fn run(args: &ServeArgs) -> Result<Exit> {
    let stop = Stop::listen()?;
    let all = together::machines(args)?;
    let mut served = Vec::new();
    for (name, args) in &all {
        let begun = begin(args);
        served.push(if all.len() > 1 { begun.with_context(|| name.clone())? } else { begun? });
    }
    let servers: Vec<&Server> = served.iter().map(|(server, _)| server).collect();
    together::tell(&all, &servers);
    for ((name, args), server) in all.iter().zip(&servers) {
        tell_way_in(args, server, Some(name).filter(|_| all.len() > 1))?;
    }
    let port = args.receive.then(|| receive::port(&args.place)).transpose()?;
    let over = AtomicBool::new(false);
    let versions = Versions::in_data(&data_folder(&args.place.data)?);
    thread::scope(|scope| {
        if let (Some(port), [server, ..]) = (port, servers.as_slice()) {
            scope.spawn(|| receive::beside(port, &parts(args), &versions, server, &over));
        }
        // A part file that closes Kerf closes all of it.
        let wait = |server: &Server| {
            server.wait(|| stop.is_wanted() || over.load(Ordering::Relaxed));
            over.store(true, Ordering::Relaxed);
        };
        for server in servers.iter().copied() {
            scope.spawn(move || wait(server));
        }
    });
    Ok(Exit::Good)
}

/// Starts the server of a machine, and marks its data folder.
fn begin(args: &ServeArgs) -> Result<(Server, Option<Served>)> {
    let options = options(args)?;
    let server = Server::start(options, builders(args)).map_err(|why| cannot(args.listen, why))?;
    let mark = mark(args, &server)?;
    Ok((server, mark))
}

/// Prints how the page of a machine is reached; its name is told where there are several.
fn tell_way_in(args: &ServeArgs, server: &Server, name: Option<&String>) -> Result<()> {
    let which = name.map_or_else(String::new, |name| format!(" for {name}"));
    out::print(&format!("Kerf's console{which} is at {}\n", server.way_in()));
    if !args.lan {
        return Ok(());
    }
    let code = server.show_code(kerf_server::Role::Operator).context("no code can be made")?;
    out::print(&format!(
        "That is for this computer only. Other devices open http://ADDRESS:{}/ with the address of this computer. \
         To pair one as operator, enter the code {code} there within five minutes.\n",
        server.address.port()
    ));
    Ok(())
}

/// Marks the data folder, so that other commands leave its machine to the server.
fn mark(args: &ServeArgs, server: &Server) -> Result<Option<Served>> {
    let way_in = server.way_in();
    let address = way_in.split_once("/?").map_or(way_in.as_str(), |(address, _)| address);
    let folder = data_folder(&args.place.data)?;
    Served::begin(&folder, address).with_context(|| folder.display().to_string())
}

/// Returns the error of a server that cannot serve, with the mend.
fn cannot(address: SocketAddr, why: io::Error) -> Error {
    let mend = match why.kind() {
        ErrorKind::AddrInUse => {
            let next =
                free_beside(address).map_or_else(String::new, |it| format!(": --listen {it}"));
            format!("{address} is in use, perhaps by another kerf serve{next}")
        }
        ErrorKind::AddrNotAvailable => {
            let here = if address.ip().is_loopback() { "127.0.0.1" } else { "0.0.0.0" };
            let port = address.port();
            format!("{address}: this computer has no such address: --listen {here}:{port}")
        }
        ErrorKind::PermissionDenied if address.port() < OF_ALL && why.raw_os_error().is_some() => {
            let all = SocketAddr::new(address.ip(), USUAL_PORT);
            format!("{address}: ports below {OF_ALL} are not everybody's: --listen {all}")
        }
        _ => return Error::new(why).context("cannot serve"),
    };
    anyhow!("cannot serve: {mend}")
}

/// From here on ports may be listened at by everybody.
const OF_ALL: u16 = 1024;

/// The port of the console.
const USUAL_PORT: u16 = 8710;

/// The next port that is free.
fn free_beside(address: SocketAddr) -> Option<SocketAddr> {
    let at = |port| SocketAddr::new(address.ip(), port);
    let later = address.port().checked_add(1)?..=u16::MAX;
    later.take(100).map(at).find(|it| TcpListener::bind(it).is_ok())
}

fn options(args: &ServeArgs) -> Result<Options> {
    let parts = parts(args);
    if let Err(why) = std::fs::read_dir(&parts) {
        let folder = parts.display();
        bail!(Usage(format!(
            "cannot read {folder}: {why}; --parts names the folder of part files"
        )));
    }
    let name = args.place.machine.configuration();
    name.map(|_| setup::machine(&args.place.machine, &args.place.data)).transpose()?;
    let open = args.file.as_deref().map(|file| opened(&parts, file)).transpose()?;
    let (start, begin_with) = args.start();
    Ok(Options {
        start,
        begin_with,
        listen: args.listen,
        lan: args.lan,
        names: args.hosts.clone(),
        parts,
        data: data_folder(&args.place.data)?,
        drawing_only: args.drawing_only,
        open,
        closes_with_program: args.exit_with_program,
        webhook: args.webhook.clone(),
        rate: args.rate,
    })
}

fn parts(args: &ServeArgs) -> PathBuf {
    args.place.parts.clone().unwrap_or_else(|| ".".into())
}

fn builders(args: &ServeArgs) -> Builders {
    let (machine, previews) = (args.clone(), args.clone());
    let told = |error: anyhow::Error| io::Error::other(format!("{error:#}"));
    Builders {
        workshop: Arc::new(move || workshop(&machine).map_err(told)),
        preview: Arc::new(move || workspace(&previews, true).map_err(told)),
    }
}

/// Files below the part folder, named in full: that is how they are told apart in logs and messages.
fn workspace(args: &ServeArgs, preview: bool) -> Result<Workspace> {
    let parts = parts(args);
    let folder = parts.canonicalize().with_context(|| parts.display().to_string())?;
    let place = PlaceArgs { parts: Some(folder), ..args.place.clone() };
    setup::workspace(Path::new(""), &place, preview)
}

/// The machine as it was left, and its files.
fn workshop(args: &ServeArgs) -> Result<Workshop> {
    memory::sweep(&parts(args));
    let mut workspace = workspace(args, false)?;
    let name = args.place.machine.configuration();
    let named = name.map(|name| named_machine::named(name, &args.place.data)).transpose()?;
    // A file that is named leads, and takes what is changed here.
    if let (Some(journal), Some(Named::File(file))) = (workspace.journal(), &named) {
        journal.settings.use_file(MachineFile::at(file));
    }
    let (mut session, kept) = setup::session(&args.place, false, &mut workspace)?;
    if named.is_some() {
        session.machine_is = setup::machine(&args.place.machine, &args.place.data)?.into();
        session.memory.settings = session.machine_is.program.clone();
    }
    if kept {
        // The log begins, and a command that was passed in before is forgotten.
        args.visit().begins_drawing(&session, &mut workspace, args.draws())?;
    }
    let attached = args.place.machine.controller().map(|name| {
        let first = First { may_be_locked: true, beside_card: true, ..args.first.steps() };
        Controller::attach(controller::socket(name), first, &mut session, &mut workspace, || false)
    });
    let (controller, told) = attached.transpose().map_err(|why| anyhow!(why))?.unzip();
    if let Some(controller) = &controller {
        workspace =
            workspace.with_firmware(controller.firmware(&session.machine_is.options.firmware));
    }
    let (told, started) = (told.unwrap_or_default(), || Some(clock::started()));
    Ok(Workshop { session, workspace, controller, told, kept, started })
}
