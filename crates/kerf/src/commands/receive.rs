//! `kerf receive`: job files that come over a serial line.

use crate::args::PlaceArgs;
use crate::data_args::{DataArgs, data_folder};
use crate::exit::{Exit, Usage};
use crate::machine_choice::MachineChoice;
use crate::sending::{Folder, Shown, To, ended, receive_over_line};
use crate::setup;
use crate::stop::Stop;
use anyhow::{Result, bail};
use clap::Args;
use kerf_files::versions::Versions;
use kerf_journal::Journal;
use kerf_server::Server;
use kerf_trace::flag;
use kerf_transport::Port;
use std::cell::{Cell, RefCell};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Receives job files over a serial line, sent by `kerf send FILE PORT` on another computer
///
/// The transfer waits while the machine of the data folder moves. A file is kept when it is whole and its checksum is
/// right. Ctrl-C stops the transfer.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf receive\n  kerf receive com2 --into ~/jobs\n  \
    kerf receive /dev/ttyUSB0 --baud 9600 --once")]
pub struct ReceiveArgs {
    /// The port: com1 to com4 as the settings have them, or the path of a device
    /// [default: that of options.send_port]
    #[arg(value_name = "PORT")]
    port: Option<String>,
    /// The folder in which files are kept
    #[arg(long, value_name = "DIR", default_value = ".")]
    into: PathBuf,
    /// The rate: 2400, 4800, 9600, 19200 or 38400 baud [default: options.send_baud]
    #[arg(long, value_name = "BAUD", value_parser = baud)]
    baud: Option<u32>,
    /// Ends after one file
    #[arg(long)]
    once: bool,
    #[command(flatten)]
    machine: MachineChoice,
    #[command(flatten)]
    data: DataArgs,
    /// Prints nothing
    #[arg(short, long)]
    quiet: bool,
}

/// A rate of file sending.
pub fn baud(word: &str) -> Result<u32, String> {
    let rates = kerf_machine::settings::options::SEND_BAUDS;
    let rate = word.parse().ok().filter(|baud| rates.contains(baud));
    rate.ok_or_else(|| "file sending has the rates 2400, 4800, 9600, 19200 and 38400".into())
}

/// The port of file sending of the machine that is served.
pub fn port(place: &PlaceArgs) -> Result<Port> {
    let machine = setup::machine(&place.machine, &place.data)?;
    Ok(Port::open(&To::Port(None).device(&machine)?, machine.options.send_baud)?)
}

/// Receives files into a folder beside a server, until it is over or the port is gone.
pub fn beside(
    mut port: Port,
    parts: &Path,
    versions: &Versions,
    server: &Server,
    over: &AtomicBool,
) {
    let (moves, kept) = (|| server.moves(), || server.files_changed());
    let folder = Folder { path: parts, versions, moves: &moves, kept: &kept };
    let stopped = || over.load(Ordering::Relaxed);
    while !stopped() {
        match receive_over_line(&mut port, &folder, &stopped, &mut Shown::new(false)) {
            Ok((state, name)) => drop(ended(&name, &state)),
            Err(error) => return eprintln!("kerf: no more files are received: {error:#}"),
        }
    }
}

/// Interval at which it is looked whether the machine moves.
const LOOK: Duration = Duration::from_millis(100);

/// Watch over the machine of a data folder: does it move?
struct Watch {
    folder: PathBuf,
    /// Its journal, once there is one.
    journal: RefCell<Option<Journal>>,
    seen: Cell<Option<(Instant, bool)>>,
}

impl Watch {
    fn moves(&self) -> bool {
        if let Some((at, moves)) = self.seen.get()
            && at.elapsed() < LOOK
        {
            return moves;
        }
        let mut journal = self.journal.borrow_mut();
        if journal.is_none() {
            *journal = Journal::look(&self.folder).ok().flatten();
        }
        let live = journal.as_ref().and_then(|journal| journal.registry.live().ok());
        let moves = live.is_some_and(|live| live.status & flag::STACK_RUNNING != 0);
        self.seen.set(Some((Instant::now(), moves)));
        moves
    }
}

pub fn run(args: &ReceiveArgs) -> Result<Exit> {
    let machine = setup::machine(&args.machine, &args.data)?;
    let to = match &args.port {
        Some(word) => To::of(word)
            .ok_or_else(|| Usage(format!("{word} is no port: com1 to com4, or a path")))?,
        None => To::Port(None),
    };
    if !args.into.is_dir() {
        bail!(Usage(format!("{} is no folder", args.into.display())));
    }
    let stop = Stop::listen()?;
    let baud = args.baud.unwrap_or(machine.options.send_baud);
    let mut port = Port::open(&to.device(&machine)?, baud)?;
    if !args.quiet {
        eprintln!("kerf: receiving at {}, {baud} baud, into {}", port.path(), args.into.display());
    }
    let (journal, seen) = (RefCell::new(None), Cell::new(None));
    let data = data_folder(&args.data)?;
    let versions = Versions::in_data(&data);
    let watch = Watch { folder: data, journal, seen };
    let moves = || watch.moves();
    let path = Path::new(&args.into);
    let folder = Folder { path, versions: &versions, moves: &moves, kept: &|| {} };
    loop {
        let stopped = || stop.is_wanted();
        let (state, name) =
            receive_over_line(&mut port, &folder, &stopped, &mut Shown::new(args.quiet))?;
        let exit = ended(&name, &state);
        if args.once || stopped() {
            return Ok(exit);
        }
    }
}
