//! Acts of pages besides driving: how a file is run, the folder it comes from, the recorder, what is
//! watched, switches of the simulated machine.

use crate::asker::Asker;
use crate::files::PartFolder;
use crate::gate::Demand;
use crate::machine::{Link, Order};
use crate::orders::Orders;
use crate::refusal::problem;
use kerf_journal::Press;
use kerf_machine::settings::io::IoMap;
use kerf_program::settings::LINES;
use kerf_wire::{Act, FileParameters, Problem, Why};

/// Variables that can be watched at most.
const MOST_WATCHED: usize = 50;

/// Longest line that is recorded, and longest name that is watched, characters.
const LONGEST: usize = 1000;

/// Checks that parameters make sense.
///
/// # Errors
/// Which of them does not.
pub fn check(parameters: &FileParameters) -> Result<(), Problem> {
    let refused = |text: &str| Err(problem(Why::Malformed, text));
    let FileParameters { proportion, repetitions, offset, plunge, .. } = parameters;
    if proportion.iter().any(|share| !share.is_finite() || *share == 0.0) {
        return refused("proportions are numbers other than 0");
    }
    if *repetitions == 0 {
        return refused("a file runs once at least");
    }
    if *offset > 2 {
        return refused("offset is 0 (none), 1 (X, Y and Z) or 2 (X and Y)");
    }
    if !plunge.is_finite() {
        return refused("plunge is a length");
    }
    Ok(())
}

/// The parameters as the language has them.
pub fn parameters(given: &FileParameters) -> kerf_sbp::FileParameters {
    let FileParameters { proportion, repetitions, offset, plunge, tabs, plunge_from_zero } = *given;
    kerf_sbp::FileParameters {
        proportion,
        repetitions,
        offset,
        plunge_mm: plunge,
        tabs,
        plunge_from_zero,
        ..kerf_sbp::FileParameters::default()
    }
}

/// Chooses the part folder, below the one that the server was given.
pub fn choose_folder(
    orders: &Orders,
    parts: &PartFolder,
    name: &str,
    mask: Option<String>,
) -> Result<(), Problem> {
    let path = match name {
        "" => parts.root().to_owned(),
        name => parts.find(name)?,
    };
    if !path.is_dir() {
        return Err(problem(Why::File, format!("{name} is no folder")));
    }
    orders.order(Order::Folder { path, mask })
}

/// Puts a line at the end of the recorder's list.
pub fn record(orders: &Orders, line: String) -> Result<(), Problem> {
    let read = kerf_sbp::read_typed("recorded".into(), &format!("{line}\n"));
    let single = line.trim().lines().count() == 1 && line.len() <= LONGEST;
    if !single || read.diagnostics.iter().any(kerf_diag::Diagnostic::is_error) {
        return Err(problem(Why::Mistake, "one command of OpenSBP can be recorded"));
    }
    orders.send(Order::Record(line))
}

/// Shows these variables while programs run.
pub fn watch(orders: &Orders, link: &Link, names: Vec<String>) -> Result<(), Problem> {
    let sensible = |name: &String| name.starts_with(['&', '$', '#']) && name.len() <= LONGEST;
    if names.len() > MOST_WATCHED || !names.iter().all(sensible) {
        let text = format!("{MOST_WATCHED} names at most, each with its &, $ or #");
        return Err(problem(Why::Malformed, text));
    }
    link.watch(names);
    orders.send(Order::Watched)
}

/// Moves a switch of a machine whose switches are moved here, whatever it does: what runs moves it, or the machine's thread. Its
/// input reads this from then on, at whatever level of its pin.
pub fn press(
    orders: &Orders,
    pins: &IoMap,
    asker: &Asker,
    (lease, number, on): (u32, u8, bool),
) -> Result<(), Problem> {
    if !(1..=LINES as u8).contains(&number) {
        return Err(problem(Why::Malformed, format!("inputs are 1 to {LINES}")));
    }
    let press = Press { number, on: pins.line_level(number, on) };
    let act = Act::Input { lease, number, on };
    orders.want_of(asker, Demand::Act(&act), |wanted| wanted.presses.push_back(press))?;
    orders.send(Order::Switches)
}
