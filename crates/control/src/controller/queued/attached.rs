//! A board that a session drives from run to run: attached, held to the place that is on record, left again.

use super::machine::Queued;
use super::others;
use super::pins::FIRST;
use super::thread::{Greeted, OpensLine, Threaded};
use super::wiring::Wiring;
use crate::Session;
use crate::controller::{AttachReport, First};
use crate::session::DrivenBy;
use kerf_driver_klipper::board::Options;
use kerf_journal::facts::Fact;
use kerf_machine::{Configuration, Driven, Machine};
use kerf_program::{Axes, HostError};
use kerf_transport::{Address, Line};
use kerf_workspace::{Firmware, Workspace};
use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;
use std::sync::Arc;

/// The value that says where a board was left: its port, the places by its counts, and those of the machine.
const LEFT: &str = Fact::ControllerLeft.key();

/// The value that names the port of a board while it is driven.
const DRIVEN: &str = Fact::ControllerDriven.key();

/// The place where a board hangs.
#[derive(Clone)]
pub struct Socket {
    /// Its name, as people give it: `klipper:/dev/ttyACM0`.
    pub name: String,
    /// The port alone, by which it is known again.
    pub port: String,
    /// Opens the port.
    pub opens: OpensLine,
}

impl Socket {
    /// The place behind an address, with its name.
    pub fn of(name: String, address: Address) -> Self {
        let port = address.key();
        let opens: OpensLine = Arc::new(move || match address.open() {
            Ok(line) => Ok(line as Box<dyn Line>),
            Err(why) => Err(why.to_string()),
        });
        Self { name, port, opens }
    }

    /// Opens the port and waits until the board is ready; a shutdown is cleared where somebody has looked why.
    ///
    /// # Errors
    /// The machine's file names no motors, nobody answers, or a board that does not fit; in words.
    pub fn open(&self, machine: &Configuration, clears: bool) -> Result<Queued, String> {
        let named = |why: String| format!("{}: {why}", self.name);
        let wiring = Wiring::of(machine).map_err(named)?;
        let boards = self.boards(machine).map_err(named)?;
        let (deadline_s, error_s) = (machine.board.deadline_s, 1e-6 * machine.board.error_us);
        let options = Options { deadline_s, error_s, clears, ..Options::default() };
        let opened = Threaded::open(&wiring.setup, options, boards);
        let Greeted { port, version, counts, priority } = opened.map_err(named)?;
        let parts = (wiring, machine.program.resolution.steps_per_unit);
        let mut queued = Queued::new(&self.name, &version, parts, counts, Box::new(port));
        queued.priority = priority;
        Ok(queued)
    }

    /// All boards of a machine, this one first.
    fn boards(&self, machine: &Configuration) -> Result<Vec<(String, OpensLine)>, String> {
        let others = others::read(&machine.board.others)?;
        let ports = others.iter().map(|(name, address)| (name.clone(), address.key()));
        let first = (FIRST.to_owned(), self.port.clone());
        let all: Vec<_> = [first].into_iter().chain(ports).collect();
        others::refuse_twins(&all, kerf_transport::serial_number)?;
        let first = (FIRST.to_owned(), self.opens.clone());
        let open = |(name, address): (String, Address)| {
            let opens = Self::of(String::new(), address).opens;
            (name, opens)
        };
        Ok([first].into_iter().chain(others.into_iter().map(open)).collect())
    }
}

impl fmt::Debug for Socket {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}

/// A board that is attached.
#[derive(Clone)]
pub struct Attached {
    socket: Socket,
    /// It has kept count of its place since it was driven last.
    counts: bool,
    queued: Rc<RefCell<Queued>>,
}

impl Attached {
    /// Opens the port, waits until the board is ready, clearing a shutdown where somebody asked for that, and has the session stand where its counts say.
    ///
    /// # Errors
    /// The machine's file names no motors, nobody answers, or a board that does not fit; in words.
    pub fn attach(
        socket: Socket,
        first: First,
        session: &mut Session,
        workspace: &mut Workspace,
        is_stopped: impl Fn() -> bool,
    ) -> Result<(Self, AttachReport), String> {
        let named = |why: String| format!("{}: {why}", socket.name);
        let machine = session.configuration();
        let homes = Wiring::of(&machine).map_err(named)?.homing();
        if first.home && homes.is_empty() {
            return Err(named(
                "no axis has a home switch (homing.x.fitted, board.home_x): set its location by hand"
                    .into(),
            ));
        }
        let queued = socket.open(&machine, first.unlock)?;
        let (attached, told) = Self::of(socket, queued, session, workspace);
        if first.home {
            session.memory.position = attached.queued.borrow_mut().comes_home(is_stopped)?;
            homes.iter().for_each(|axis| session.homed.insert(axis));
            workspace.trusts_location(homes);
        }
        Ok((attached, told))
    }

    /// Takes a board that is ready, and has the session stand where its counts say.
    pub fn of(
        socket: Socket,
        mut queued: Queued,
        session: &mut Session,
        workspace: &mut Workspace,
    ) -> (Self, AttachReport) {
        let mut told = AttachReport::default();
        let (version, motors) = (&queued.facts().name, queued.wiring.motors.len());
        told.notes.push(format!("{}: {version}, motors: {motors}", socket.name));
        let priority = queued.priority.take();
        told.notes.extend(priority.map(|why| format!("{}: {why}", socket.name)));
        let abandoned = workspace.stored.get(DRIVEN) == Some(&*socket.port);
        let counts = find_place(&socket, &mut queued, abandoned, (session, workspace), &mut told);
        // Outputs and switches of the simulated machine are none of this one's.
        session.machine = None;
        let (name, homes) = (socket.name.clone(), queued.wiring.homing());
        session.driven_by = Some(DrivenBy { name, homes, pace: None });
        (Self { socket, counts, queued: Rc::new(RefCell::new(queued)) }, told)
    }

    /// Opens the port once more, after the board was lost or has shut down.
    ///
    /// # Errors
    /// As [`Attached::attach`].
    pub fn attach_again(
        &mut self,
        session: &mut Session,
        workspace: &mut Workspace,
    ) -> Result<AttachReport, String> {
        self.queued.borrow_mut().let_go();
        let (again, told) =
            Self::attach(self.socket.clone(), First::default(), session, workspace, || false)?;
        self.queued.swap(&again.queued);
        self.counts = again.counts;
        Ok(told)
    }

    /// Returns `true` if it has kept count of its place since it was driven last: a run can be taken up there.
    pub const fn knows_place(&self) -> bool {
        self.counts
    }

    /// The machine, for a run.
    pub fn driven(&self) -> Driven {
        self.queued.clone()
    }

    /// Its name, as people give it.
    pub fn name(&self) -> &str {
        &self.socket.name
    }

    /// The board as a machine.
    pub const fn queued(&self) -> &Rc<RefCell<Queued>> {
        &self.queued
    }

    /// Looks at it while nothing runs: inputs that changed, by number and whether active, and the place where it stands
    /// when that is not where it was led.
    pub fn attend(&self) -> (Vec<(u8, bool)>, Option<Axes>) {
        let mut queued = self.queued.borrow_mut();
        queued.look();
        (queued.take_inputs(), queued.place())
    }

    /// Returns the reason for which it does nothing more, in words.
    pub fn fault(&self) -> Option<String> {
        self.queued.borrow().fault().map(|fault| fault.message.clone())
    }

    /// It is driven from now on. That is on record until it is left.
    pub fn begins(&self, workspace: &mut Workspace) {
        self.keeps_place(workspace);
        workspace.stored.set(DRIVEN, Some(&self.socket.port));
    }

    /// The run is over; when it did not end well, everything is stopped and switched off. Keeps where it was left.
    pub fn ends(&self, well: bool, workspace: &mut Workspace, is_stopped: impl FnMut() -> bool) {
        self.queued.borrow_mut().close(well, is_stopped);
        self.keeps_place(workspace);
        workspace.stored.set(DRIVEN, None);
    }

    /// The loader of its firmware: a board is flashed by its own tools.
    pub fn firmware(&self) -> Firmware {
        Box::new(|_| {
            let why = "the program of a board with step queues is loaded by its own tools";
            Err(HostError::Refused(why.into()))
        })
    }

    /// Keeps where it stands, as its counts have it and as the machine does.
    fn keeps_place(&self, workspace: &mut Workspace) {
        let queued = self.queued.borrow();
        let left = (&self.socket.port, queued.by_counts(), queued.counted());
        workspace.stored.set(LEFT, serde_json::to_string(&left).ok().as_deref());
    }
}

/// Holds the counts of the board against those on record. A board that was not switched off has gone on counting, so the
/// place is known to the step, also where its host was killed. Tells whether it is known.
fn find_place(
    socket: &Socket,
    queued: &mut Queued,
    abandoned: bool,
    (session, workspace): (&mut Session, &mut Workspace),
    told: &mut AttachReport,
) -> bool {
    let own = queued.by_counts();
    let kept: Option<(String, Axes, Axes)> =
        workspace.stored.get(LEFT).and_then(|kept| serde_json::from_str(kept).ok());
    let kept = kept.filter(|(port, ..)| *port == socket.port);
    let is_fresh = queued.is_fresh();
    let place = &mut session.memory.position;
    let mut is_known = true;
    let words = |place: &Axes| format!("{:.3}, {:.3}, {:.3}", place.0[0], place.0[1], place.0[2]);
    match kept {
        Some((_, counts, left)) if counts == own && !(is_fresh && abandoned) => *place = left,
        Some((_, counts, left)) if !is_fresh => {
            *place = left.plus(own.minus(counts));
            let at = words(place);
            told.warnings.push(format!(
                "{}: the last run was cut short; the board has gone on counting, so the machine stands at {at}",
                socket.name
            ));
        }
        _ => {
            is_known = false;
            let at = words(place);
            let why = "the board was switched off, or has not been driven before";
            told.notes.push(format!(
                "{}: {why}: the machine is believed to stand at {at}; stop and set its location where that is wrong",
                socket.name
            ));
            if abandoned {
                workspace.doubts_location(queued.axes());
            }
        }
    }
    queued.is_at(session.memory.position);
    is_known
}
