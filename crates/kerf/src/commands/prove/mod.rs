//! The list that every machine has to hold, run against a real board on the bench; a report that can be shown to others.

mod bench;
mod card;
mod outcome;
mod own;

use crate::args::Format;
use crate::exit::Exit;
use crate::machine_name::DriverName;
use crate::out;
use anyhow::{Context, Result};
pub use bench::OnBench;
use card::CARD;
use kerf_machine::Machine;
use kerf_machine::conformance::{self, Bench, CASES};
use kerf_machine::driver::Facts;
use kerf_trace::json;
use outcome::Outcome;
use own::{OWN, SETTINGS, homes};
use serde::Serialize;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

/// Runs the list and writes the report; the board goes home first where that is wanted.
pub fn prove(name: &DriverName, report: &Path, format: Format, home: bool) -> Result<Exit> {
    let facts = OnBench::as_it_stands(name)?.board.facts().clone();
    let mut told = Report::of(name, &facts, format);
    told.takes("it goes home", || homes(name, home));
    told.takes_list(
        || OnBench::open(name),
        |bench| {
            bench.board.close(false, || false);
            bench.lacks
        },
    );
    let settings = if name.is_linuxcnc() { &[] } else { SETTINGS };
    for case in OWN.iter().chain(CARD).chain(settings) {
        told.takes(case.name, || (case.check)(name));
    }
    told.write(report)
}

/// One thing that was looked at.
#[derive(Serialize)]
struct Check {
    name: String,
    ok: bool,
    saw: String,
}

/// The report as programs read it.
#[derive(Serialize)]
struct Checks<'a> {
    passed: usize,
    failed: usize,
    checks: &'a [Check],
}

/// The report so far.
pub struct Report {
    text: String,
    format: Format,
    checks: Vec<Check>,
    /// Cases that held.
    held: usize,
}

impl Report {
    /// A report that tells who a board is.
    pub fn of(name: &DriverName, facts: &Facts, format: Format) -> Self {
        Self { text: head(name, facts), format, checks: Vec::new(), held: 0 }
    }

    /// Adds figures that were measured, and whether each is as it has to be.
    pub fn figures(&mut self, figures: Vec<Figure>) {
        self.text += "\n";
        for Figure { name, ok, saw } in figures {
            let line = format!("- {name}: {saw}\n");
            self.say(&line);
            self.text += &line;
            self.held += usize::from(ok);
            self.checks.push(Check { name: name.to_owned(), ok, saw });
        }
    }

    fn say(&self, line: &str) {
        if self.format == Format::Text {
            out::print(line);
        }
    }

    /// Runs the list of every machine, each case on a board that is opened for it. What takes something that nobody does on
    /// a bench is not tried: `close` tells what that was.
    pub fn takes_list<B: Bench>(
        &mut self,
        open: impl Fn() -> Result<B>,
        close: impl Fn(&mut B) -> Option<&'static str>,
    ) {
        for case in CASES {
            self.takes(case.name, || {
                let mut bench = open()?;
                let ended = case.run(&mut bench);
                Ok(match (ended, close(&mut bench)) {
                    (Ok(conformance::Outcome::Held), Some(lacks)) => {
                        Outcome::NotTried(lacks.into())
                    }
                    (Ok(conformance::Outcome::Held), None) => Outcome::Held(String::new()),
                    (Ok(conformance::Outcome::Failed(fault)), _) => Outcome::NotHeld(fault.message),
                    (Err(why), _) => Outcome::Wrong(why),
                })
            });
        }
    }

    /// Writes the report, and tells where; returns whether everything held.
    pub fn write(&self, report: &Path) -> Result<Exit> {
        std::fs::write(report, &self.text)
            .with_context(|| format!("cannot write {}", report.display()))?;
        eprintln!("kerf: the report is in {}", report.display());
        let failed = self.checks.iter().filter(|check| !check.ok).count();
        if self.format == Format::Json {
            let checks = Checks { passed: self.held, failed, checks: &self.checks };
            out::print(&(json::to_string(&checks) + "\n"));
        }
        Ok(if failed > 0 { Exit::Failed } else { Exit::Good })
    }

    /// Runs a case and tells how it ended.
    fn takes(&mut self, case: &str, run: impl FnOnce() -> Result<Outcome>) {
        let begin = Instant::now();
        let outcome = run().unwrap_or_else(|why| Outcome::NotHeld(why.to_string()));
        self.held += usize::from(matches!(outcome, Outcome::Held(_)));
        let (name, ok, saw) = (case.to_owned(), !outcome.fails(), outcome.to_string());
        self.checks.push(Check { name, ok, saw });
        let seconds = begin.elapsed().as_secs_f64();
        self.say(&format!("{case}: {outcome}\n"));
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "| {case} | {outcome} | {seconds:.1} |");
    }
}

/// A figure that was measured.
pub struct Figure {
    /// The quantity.
    pub name: &'static str,
    /// It is as it has to be.
    pub ok: bool,
    /// Its value, in words.
    pub saw: String,
}

fn head(name: &DriverName, facts: &Facts) -> String {
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
