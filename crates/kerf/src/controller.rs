//! The controller of a run: what `--driver` names, opened, looked at, and closed again.

use crate::args::RunArgs;
use crate::exit::{Exit, Usage};
use crate::report::Diagnostics;
use crate::setup;
use crate::stop::Stop;
use anyhow::{Result, anyhow, bail};
use kerf_control::answers::Answers;
use kerf_control::controller::{Connection, Lacks, Line, Shared};
use kerf_control::facts::Fact;
use kerf_control::{Company, Firmware, RunOptions, Session, Shelf, Sink, Work};
use kerf_driver_grbl::Grbl;
use kerf_machine::Machine;
use kerf_machine::driver::{Changed, Wired};
use kerf_program::{Axes, AxisSet, HostError};
use kerf_serial::{Port, SerialError};
use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;
use std::time::Duration;

/// The rate of grbl's own build.
const BAUD: u32 = 115_200;

/// Driver and port that `--driver` names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DriverName {
    words: String,
    path: String,
    baud: u32,
}

impl DriverName {
    /// Reads `grbl:/dev/ttyUSB0@115200`.
    pub fn read(words: &str) -> Result<Self, String> {
        let kind = "name a driver and its port: grbl:/dev/ttyUSB0, or grbl:/dev/ttyUSB0@250000";
        let (driver, port) = words.split_once(':').ok_or(kind)?;
        if driver != "grbl" {
            return Err(format!("there is no driver '{driver}', only grbl; {kind}"));
        }
        let (path, baud) = match port.rsplit_once('@') {
            Some((path, baud)) => {
                let wrong = || format!("'{baud}' is no rate in baud, as 115200 is");
                (path, baud.parse().ok().filter(|baud| *baud > 0).ok_or_else(wrong)?)
            }
            None => (port, BAUD),
        };
        if path.is_empty() {
            return Err(kind.into());
        }
        Ok(Self { words: words.to_owned(), path: path.to_owned(), baud })
    }
}

impl fmt::Display for DriverName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words)
    }
}

/// A serial port as the line of a driver.
struct Wire(Port);

impl Line for Wire {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, String> {
        self.0.read(into, wait).map_err(|error| error.to_string())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), String> {
        self.0.write(bytes).map_err(|error| error.to_string())
    }
}

/// A driver that knows nothing yet, with the port it speaks through.
type Ends = (Box<dyn Wired>, Box<dyn Line>);

fn ends(name: &DriverName) -> Result<Ends, SerialError> {
    let port = Port::open(&name.path, name.baud)?;
    Ok((Box::new(Grbl::new()), Box::new(Wire(port))))
}

/// Returns the loader of a controller's firmware (UI): it runs the command of the settings while the port is closed.
/// The firmware is loaded when the command says so and the controller answers again.
pub fn firmware(shared: &Shared, name: &DriverName, command: &str) -> Firmware {
    let (shared, name, command) = (shared.clone(), name.clone(), command.to_owned());
    Box::new(move |run| {
        if command.is_empty() {
            let why = "name the command that loads it: kerf machine set options.firmware 'avrdude … -P {port} …'";
            return Err(HostError::Refused(why.into()));
        }
        let line = command.replace("{port}", &name.path);
        let opens = || ends(&name).map_err(|why| why.to_string());
        let (done, again) = shared.borrow_mut().anew(|| run(&line), opens);
        done?;
        again.map_err(HostError::Refused)
    })
}

/// Opens the port and waits until the controller has told who it is; what goes on from a run that was abandoned is
/// stopped first.
fn connect(name: &DriverName, quiet: bool, abandoned: bool) -> Result<Connection> {
    let (driver, line) = ends(name)?;
    let open = if abandoned { Connection::open_stopped } else { Connection::open };
    let connection = open(&name.words, driver, line).map_err(|why| anyhow!(why))?;
    if !quiet {
        let facts = connection.facts();
        let axes: String = "XYZABC".chars().take(facts.axes).collect();
        eprintln!("kerf: {}: {}, axes {axes}", name.words, facts.name);
    }
    Ok(connection)
}

/// What is done before anything else.
#[derive(clap::Args, Clone, Copy, Debug)]
pub struct First {
    /// Has the controller go home first
    #[arg(long, requires = "driver")]
    home: bool,
    /// Unlocks the controller after an alarm, without homing it: look first why it stopped, and where it is
    #[arg(long, requires = "driver", conflicts_with = "home")]
    unlock: bool,
}

/// A controller that is ready for a run, with the session standing where it stands.
pub fn ready(
    name: &DriverName,
    first: First,
    quiet: bool,
    session: &mut Session,
    shelf: &mut Shelf,
) -> Result<Shared> {
    let abandoned = was_abandoned(name, shelf);
    let mut connection = connect(name, quiet, abandoned)?;
    keeps_changed(name, &mut connection, quiet, shelf);
    if first.unlock {
        connection.unlock().map_err(|why| anyhow!(why))?;
    }
    if first.home {
        let stop = Stop::listen()?;
        connection.home(|| stop.is_wanted()).map_err(|why| anyhow!(why))?;
    }
    if let Some(locked) = connection.locked() {
        bail!(locked);
    }
    if connection.facts().homes {
        let stands = connection.stands();
        takes_place(&connection, session, stands, quiet);
        let axes = AxisSet::first(connection.facts().axes);
        axes.iter().for_each(|axis| session.homed.insert(axis));
        if first.home {
            shelf.trusts_location(axes);
        }
    } else {
        let stands = connection.stands();
        match (left_at(name, stands, shelf), abandoned) {
            (Some(place), false) => takes_place(&connection, session, place, quiet),
            (None, false) => tell_believed(name, session.memory.position, quiet),
            (_, true) => {
                let counted = counted_on(name, stands, shelf);
                session.memory.position = counted.unwrap_or(session.memory.position);
                tell_abandoned(name, session.memory.position);
                shelf.doubts_location(AxisSet::first(connection.facts().axes));
            }
        }
        connection.is_at(session.memory.position);
    }
    Ok(Rc::new(RefCell::new(connection)))
}

/// The value that says where a controller without homing was left: its port, its own place, and that of the
/// machine. Runs on the simulated machine leave the location elsewhere.
const LEFT: &str = Fact::ControllerLeft.key();

/// Places closer than this are the same, mm: a controller tells thousandths.
const SAME_MM: f64 = 0.01;

/// Returns the kept place of the controller at this port, as it counts and as the machine does.
fn kept_at(name: &DriverName, shelf: &Shelf) -> Option<(Axes, Axes)> {
    let (path, own, place): (String, Axes, Axes) =
        serde_json::from_str(shelf.stored.get(LEFT)?).ok()?;
    (path == name.path).then_some((own, place))
}

/// Returns the place of the machine, when its controller was neither moved nor switched off since it was driven
/// last.
fn left_at(name: &DriverName, stands: Axes, shelf: &Shelf) -> Option<Axes> {
    let (own, place) = kept_at(name, shelf)?;
    same(own, stands).then_some(place)
}

/// Returns the place of the machine, when its controller has gone on counting since its run began. One that was
/// switched off, or reset when its port was opened, counts from zero.
fn counted_on(name: &DriverName, stands: Axes, shelf: &Shelf) -> Option<Axes> {
    let (own, place) = kept_at(name, shelf)?;
    (!same(stands, Axes::default())).then(|| place.plus(stands.minus(own)))
}

fn same(a: Axes, b: Axes) -> bool {
    a.minus(b).0.iter().all(|way| way.abs() < SAME_MM)
}

/// The value that names the port of a controller while it is driven.
const DRIVEN: &str = Fact::ControllerDriven.key();

/// Returns `true` if the last run on this controller has no end: the process was killed, or the power failed.
fn was_abandoned(name: &DriverName, shelf: &Shelf) -> bool {
    shelf.stored.get(DRIVEN) == Some(&*name.path)
}

/// A controller is driven from now on. That is on record until it is left.
pub fn begins(name: &DriverName, shared: &Shared, shelf: &mut Shelf) {
    stands(name, shared, shelf);
    shelf.stored.set(DRIVEN, Some(&name.path));
}

/// The value that says which setting of the controller at a port was changed: its port, the setting, its value before
/// and since.
const CHANGED: &str = Fact::ControllerChanged.key();

/// Keeps in mind, and tells, what was changed in the controller; what a run that has no end has left changed is put back
/// behind this one.
fn keeps_changed(name: &DriverName, connection: &mut Connection, quiet: bool, shelf: &mut Shelf) {
    let kept: Option<(String, u16, u32, u32)> =
        shelf.stored.get(CHANGED).and_then(|kept| serde_json::from_str(kept).ok());
    if let Some((_, number, was, is)) = kept.filter(|(path, ..)| *path == name.path) {
        connection.owes(Changed { number, was, is });
    }
    let Some(Changed { number, was, is }) = connection.changed() else { return };
    let kept = serde_json::to_string(&(&name.path, number, was, is)).ok();
    shelf.stored.set(CHANGED, kept.as_deref());
    if !quiet {
        eprintln!(
            "kerf: {}: ${number} is {is} while Kerf drives it, {was} again afterwards",
            name.words
        );
    }
}

/// Keeps where a controller was left.
pub fn leaves(name: &DriverName, shared: &Shared, shelf: &mut Shelf) {
    stands(name, shared, shelf);
    if shared.borrow().changed().is_none() {
        shelf.stored.set(CHANGED, None);
    }
    shelf.stored.set(DRIVEN, None);
}

/// Keeps where a controller stands, as it counts and as the machine does.
fn stands(name: &DriverName, shared: &Shared, shelf: &mut Shelf) {
    let mut connection = shared.borrow_mut();
    let own = connection.stands();
    let left = (&name.path, own, own.plus(connection.offset()));
    shelf.stored.set(LEFT, serde_json::to_string(&left).ok().as_deref());
}

/// Nobody but Kerf remembers where the machine is.
fn tell_believed(name: &DriverName, place: Axes, quiet: bool) {
    if !quiet {
        let [x, y, z, ..] = place.0;
        eprintln!(
            "kerf: {} has not been driven before, or was moved or switched off since: the machine is believed to stand \
             at {x:.3}, {y:.3}, {z:.3}, where the last run ended; stop and set its location where that is wrong",
            name.words
        );
    }
}

/// Kerf has not seen the end of the last run.
fn tell_abandoned(name: &DriverName, place: Axes) {
    let [x, y, z, ..] = place.0;
    eprintln!(
        "kerf: the last run on {} has no end: Kerf was killed, or the power failed. What still moved is stopped; the \
         machine is believed to stand at {x:.3}, {y:.3}, {z:.3}",
        name.words
    );
}

/// The machine stands where its controller tells; Kerf believes it.
fn takes_place(connection: &Connection, session: &mut Session, stands: Axes, quiet: bool) {
    let axes = AxisSet::first(connection.facts().axes);
    let mut place = session.memory.position;
    for axis in axes.iter() {
        let apart = (place[axis] - stands[axis]).abs() > 0.01;
        if apart && !quiet {
            eprintln!(
                "kerf: {} stands at {:.3} and not at {:.3} of the machine, as the controller tells; \
                 zero points are where they were",
                axis.letter(),
                stands[axis],
                place[axis]
            );
        }
        place[axis] = stands[axis];
    }
    session.memory.position = place;
}

/// Looks at a dry run for what the controller does not have; nothing moves when something is missing.
pub fn look_through(
    shared: &Shared,
    work: &Work,
    session: &Session,
    options: &RunOptions,
    shelf: &Shelf,
    run: &RunArgs,
) -> Result<Option<Exit>> {
    let again = match work {
        Work::Part(program) => Work::Part(program.clone()),
        Work::Job(job, machine) => Work::Job(job.clone(), machine.clone()),
        Work::Hand(..) => return Ok(None),
    };
    let mut shelf = setup::shelf(shelf.part_folder(), &run.place, true)?;
    let connection = shared.borrow();
    let mut lacks = Lacks::new(connection.name(), connection.facts(), connection.offset());
    if let Work::Job(_, machine) = &again
        && (machine.plasma.use_sequence || machine.laser.use_laser)
    {
        lacks.burns();
    }
    let mut options = RunOptions { started: None, ..options.clone() };
    options.program.preview = true;
    let mut answers: Answers = setup::answers(run)?;
    let company = Company {
        sink: &mut lacks,
        operator: &mut answers,
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    drop(session.clone().run(again, options, &mut shelf, company));
    let found = lacks.found();
    let mut told = Diagnostics::default();
    for diagnostic in &found {
        told.event(&kerf_control::Event::Diag(Box::new(diagnostic.clone())));
    }
    Ok(found.iter().any(kerf_diag::Diagnostic::is_error).then_some(Exit::Failed))
}

/// Refuses options that cannot be had together with a controller.
pub fn check(run: &RunArgs) -> Result<()> {
    let scripted = !run.operator.feed.is_empty();
    if scripted {
        bail!(Usage(
            "--override is of the simulated machine: with --driver turn it at the controller"
                .into()
        ));
    }
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn drivers_are_named_with_port_and_rate() {
        let read = |words| DriverName::read(words).map(|name| (name.path, name.baud));
        assert_eq!(read("grbl:/dev/ttyUSB0").unwrap(), ("/dev/ttyUSB0".into(), 115_200));
        assert_eq!(read("grbl:COM3@250000").unwrap(), ("COM3".into(), 250_000));
        for wrong in ["grbl", "grbl:", "grbl:@9600", "grbl:COM3@fast", "grbl:COM3@0", "linuxcnc:x"]
        {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }
}
