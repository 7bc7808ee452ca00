//! The list that every machine has to hold, run against a real board on the bench; a report that can be shown to others.

use crate::controller;
use crate::exit::Exit;
use crate::machine_name::DriverName;
use crate::out;
use anyhow::{Context, Result, anyhow, bail};
use kerf_control::controller::{Connection, Place};
use kerf_machine::Machine;
use kerf_machine::conformance::{Bench, CASES, Outcome, Seen};
use kerf_machine::driver::Facts;
use kerf_program::Axes;
use std::fmt::Write;
use std::path::Path;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A case takes no longer than this.
const PATIENCE: Duration = Duration::from_secs(60);

/// Between two looks at the board.
const GLANCE: Duration = Duration::from_millis(1);

/// The room that the list needs in plus X, mm.
const ROOM_MM: f64 = 50.0;

/// A board on the bench.
struct OnBench {
    connection: Connection,
    begin: Instant,
}

impl Bench for OnBench {
    fn machine(&mut self) -> &mut dyn Machine {
        &mut self.connection
    }

    fn waits(&mut self) -> bool {
        self.connection.look();
        sleep(GLANCE);
        self.begin.elapsed() < PATIENCE
    }

    fn seen(&mut self) -> Option<Seen> {
        None
    }

    fn breaks(&mut self) -> bool {
        false
    }
}

impl OnBench {
    /// A board that stands, at what is called zero from here on.
    fn open(name: &DriverName) -> Result<Self> {
        let Place::Followed(socket) = controller::socket(name) else {
            bail!("{name}: a board with step queues is proved by itself");
        };
        let (driver, line) = (socket.opens)().map_err(|why| anyhow!(why))?;
        let opened = Connection::open(&socket.name, driver, line);
        let mut connection = opened.map_err(|why| anyhow!(why))?;
        if let Some(locked) = connection.locked() {
            bail!(locked);
        }
        let x_mm = connection.stands().0[0];
        let most_mm = connection.facts().travel_mm[0].map(|(_, most_mm)| most_mm);
        if most_mm.is_some_and(|most_mm| x_mm + ROOM_MM > most_mm) {
            bail!("{name}: X needs {ROOM_MM} mm of room in plus: move it away from its end first");
        }
        connection.is_at(Axes::default());
        Ok(Self { connection, begin: Instant::now() })
    }
}

/// Runs the list and writes the report.
pub fn prove(name: &DriverName, report: &Path) -> Result<Exit> {
    let facts = OnBench::open(name)?.connection.facts().clone();
    let mut text = head(name, &facts);
    let open = || OnBench::open(name);
    let all_hold = cases(open, &mut text, |bench| bench.connection.close(false, || false))?;
    write(report, &text)?;
    Ok(if all_hold { Exit::Good } else { Exit::Failed })
}

/// Runs the list, each case on a board that is opened for it, and adds a row each to the report; tells whether all hold.
pub fn cases<B: Bench>(
    open: impl Fn() -> Result<B>,
    text: &mut String,
    close: impl Fn(&mut B),
) -> Result<bool> {
    let mut all_hold = true;
    for case in CASES {
        let mut bench = open()?;
        let begin = Instant::now();
        let outcome = match case.run(&mut bench) {
            Ok(Outcome::Held) => "held".to_owned(),
            Ok(Outcome::Failed(fault)) => format!("not held: {}", fault.message),
            Err(why) => format!("WRONG: {why}"),
        };
        all_hold &= outcome == "held";
        let seconds = begin.elapsed().as_secs_f64();
        out::print(&format!("{}: {outcome}\n", case.name));
        let _ = writeln!(text, "| {} | {outcome} | {seconds:.1} |", case.name);
        close(&mut bench);
    }
    Ok(all_hold)
}

/// Writes the report, and tells where.
pub fn write(report: &Path, text: &str) -> Result<()> {
    std::fs::write(report, text).with_context(|| format!("cannot write {}", report.display()))?;
    eprintln!("kerf: the report is in {}", report.display());
    Ok(())
}

/// The head of a report: what the board is.
pub fn head(name: &DriverName, facts: &Facts) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let mut text = format!("# {} on {name}\n\nKerf {version}.\n\n", facts.name);
    let _ = writeln!(text, "- axes: {}", facts.axes);
    for (letter, axis) in "XYZABC".chars().zip(0..facts.axes) {
        let speed = facts.speed_mm_s[axis].map_or("unknown".into(), |v| format!("{v:.1} mm/s"));
        let travel = facts.travel_mm[axis];
        let travel = travel.map_or("not checked".into(), |(a, b)| format!("{a} to {b} mm"));
        let _ = writeln!(text, "- {letter}: at most {speed}, travel {travel}");
    }
    let outputs: Vec<_> = (1..=32).filter(|n| facts.outputs >> (n - 1) & 1 == 1).collect();
    let _ = writeln!(text, "- outputs: {outputs:?}");
    let _ = writeln!(text, "- probe: {}, homes: {}", facts.probe.is_some(), facts.homes);
    text + "\n| what has to hold | outcome | seconds |\n|---|---|---|\n"
}
