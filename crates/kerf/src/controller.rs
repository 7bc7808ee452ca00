//! The controller that `--machine` names: its port opened, and what is wrong with a run on it.

use crate::exit::{Exit, Usage};
use crate::machine_name::DriverName;
use crate::report::Diagnostics;
use crate::stop::Stop;
use anyhow::{Context, Result, anyhow, bail};
use kerf_control::Session;
use kerf_control::answers::Answers;
use kerf_control::controller::{Controller, Place, Socket, queued};
use kerf_driver_grbl::Grbl;
use kerf_driver_linuxcnc::LinuxCnc;
use kerf_journal::{RunOptions, Work};
use kerf_machine::driver::Wired;
use kerf_trace::Sink;
use kerf_transport::Address;
use kerf_workspace::Workspace;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Returns the place where a controller hangs.
pub fn socket(name: &DriverName) -> Place {
    if name.is_board() { Place::Queued(board(name)) } else { Place::Followed(followed(name)) }
}

fn board(name: &DriverName) -> queued::Socket {
    let DriverName { words, address } = name.clone();
    queued::Socket::of(words, address)
}

fn followed(name: &DriverName) -> Socket {
    let (words, address, is_linuxcnc) =
        (name.words.clone(), name.address.clone(), name.is_linuxcnc());
    let port = address.key();
    let known: Mutex<Option<Address>> = Mutex::default();
    let opens = Arc::new(move || {
        // Another board at the same port is not the one that was there.
        let mut known = known.lock().unwrap_or_else(PoisonError::into_inner);
        let line = known.as_ref().unwrap_or(&address).open().map_err(|why| why.to_string())?;
        let _ = known.get_or_insert_with(|| address.steady());
        let driver: Box<dyn Wired> =
            if is_linuxcnc { Box::new(LinuxCnc::new()) } else { Box::new(Grbl::new()) };
        Ok((driver, line))
    });
    Socket { name: words, port, opens, log: Arc::default() }
}

/// Steps that come before anything else.
#[derive(clap::Args, Clone, Copy, Debug)]
pub struct First {
    /// Has the controller go home first
    #[arg(long)]
    home: bool,
    /// Unlocks the controller after an alarm, without homing it: look first why it stopped, and where it is
    #[arg(long, conflicts_with = "home")]
    unlock: bool,
    /// It is only looked at: it may be locked.
    #[arg(skip)]
    looks: bool,
}

impl First {
    /// No steps.
    pub const NONE: Self = Self { home: false, unlock: false, looks: false };

    /// It is only looked at.
    pub const LOOK: Self = Self { looks: true, ..Self::NONE };

    /// It goes home, and is unlocked before where that is wanted.
    pub const fn going_home(unlock: bool) -> Self {
        Self { home: true, unlock, looks: false }
    }

    /// The same for whoever attaches the controller.
    pub fn steps(self) -> kerf_control::controller::First {
        let Self { home, unlock, looks } = self;
        kerf_control::controller::First { home, unlock, may_be_locked: looks, beside_card: false }
    }

    /// Returns the option that was given.
    pub const fn option(self) -> Option<&'static str> {
        match (self.home, self.unlock) {
            (true, _) => Some("--home"),
            (_, true) => Some("--unlock"),
            _ => None,
        }
    }
}

/// Steps with which a controller is begun.
#[derive(Clone, Copy, Debug)]
pub struct Beginning<'a> {
    /// Steps that come before anything else.
    pub first: First,
    /// Nothing is told that nobody has to act on.
    pub quiet: bool,
    /// The file into which goes what is sent to it and what it answers.
    pub log: Option<&'a Path>,
}

/// The place where a controller hangs, whose lines go into a file where that is wanted.
fn logged_socket(name: &DriverName, log: Option<&Path>) -> Result<Place> {
    let place = socket(name);
    match (&place, log) {
        (Place::Followed(socket), Some(file)) => {
            let written = socket.log.writes_to(file);
            written.with_context(|| format!("cannot write {}", file.display()))?;
        }
        (Place::Queued(_), Some(_)) => bail!(Usage(format!(
            "--controller-log is for controllers that speak in lines, and {name} is told each step"
        ))),
        (_, None) => {}
    }
    Ok(place)
}

/// A controller that is ready for a run, with the session standing where it stands.
pub fn ready(
    name: &DriverName,
    beginning: Beginning<'_>,
    session: &mut Session,
    workspace: &mut Workspace,
) -> Result<Controller> {
    let Beginning { first, quiet, log } = beginning;
    let stop = Stop::listen()?;
    let (place, steps) = (logged_socket(name, log)?, first.steps());
    let attached = Controller::attach(place, steps, session, workspace, || stop.is_wanted());
    let (controller, told) = attached.map_err(|why| anyhow!(why))?;
    let notes = told.notes.iter().filter(|_| !quiet);
    notes.chain(&told.warnings).for_each(|line| eprintln!("kerf: {line}"));
    Ok(controller)
}

/// Looks at a dry run, in files that it does not change, for what the controller does not have; nothing moves when
/// something is missing.
pub fn look_through(
    controller: &Controller,
    work: &Work,
    session: &Session,
    options: &RunOptions,
    mut workspace: Workspace,
    mut answers: Answers,
) -> Option<Exit> {
    let found = controller.lacks(work, session, options, &mut workspace, &mut answers);
    let mut told = Diagnostics::default();
    for diagnostic in &found {
        told.event(&kerf_trace::Event::Diag(Box::new(diagnostic.clone())));
    }
    found.iter().any(kerf_diag::Diagnostic::is_error).then_some(Exit::Failed)
}
