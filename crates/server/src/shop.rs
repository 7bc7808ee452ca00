//! Acts of pages besides driving: how a file is run, the folder it comes from, the recorder, what is
//! watched, switches of the simulated machine.

use crate::app::App;
use crate::asker::Asker;
use crate::digested::hash;
use crate::gate::Way;
use crate::locks::lock;
use crate::machine::{Order, Planned};
use crate::refusal::problem;
use kerf_journal::Press;
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

/// The file that a typed line runs, where it does nothing else: FP with a name and no parameters.
fn runs_only(line: &str) -> Option<String> {
    let program = kerf_sbp::read_typed("command".into(), &format!("{}\n", line.trim()));
    let is_plain = line.trim().lines().count() == 1 && line.matches(',').count() <= 1;
    let fp = line.trim().get(..2).is_some_and(|letters| letters.eq_ignore_ascii_case("FP"));
    let named = program.named_files().into_iter().next()?;
    (is_plain && fp).then_some(named.request.name)
}

impl App {
    /// The file of the part folder that a typed line runs, by its hash, and the plan of the one that is open: how it ran
    /// is how that file stands.
    pub fn file_of_typed(&self, line: &str) -> Option<(String, Planned)> {
        let name = runs_only(line)?;
        let folder = self.hub.read(|now| now.folder.name.clone());
        let name = if folder.is_empty() { name } else { format!("{folder}/{name}") };
        let bytes = self.parts.read(&name).ok()?;
        let open = lock(&self.open).clone();
        let is_open = open.name == name && open.is_of(&bytes);
        if is_open && open.parameters == FileParameters::default() {
            let planned = open.preview.map(|preview| preview.planned.clone());
            return Some((open.hash, planned.unwrap_or_default()));
        }
        Some((hash(&bytes), Planned::default()))
    }

    /// Chooses the part folder, below the one that the server was given.
    pub fn choose_folder(&self, name: &str, mask: Option<String>) -> Result<(), Problem> {
        let path = match name {
            "" => self.parts.root().to_owned(),
            name => self.parts.find(name)?,
        };
        if !path.is_dir() {
            return Err(problem(Why::File, format!("{name} is no folder")));
        }
        self.order(Order::Folder { path, mask })
    }

    /// Puts a line at the end of the recorder's list.
    pub fn record(&self, line: String) -> Result<(), Problem> {
        let read = kerf_sbp::read_typed("recorded".into(), &format!("{line}\n"));
        let single = line.trim().lines().count() == 1 && line.len() <= LONGEST;
        if !single || read.diagnostics.iter().any(kerf_diag::Diagnostic::is_error) {
            return Err(problem(Why::Mistake, "one command of OpenSBP can be recorded"));
        }
        self.send(Order::Record(line))
    }

    /// Shows these variables while programs run.
    pub fn watch(&self, names: Vec<String>) -> Result<(), Problem> {
        let sensible = |name: &String| name.starts_with(['&', '$', '#']) && name.len() <= LONGEST;
        if names.len() > MOST_WATCHED || !names.iter().all(sensible) {
            let text = format!("{MOST_WATCHED} names at most, each with its &, $ or #");
            return Err(problem(Why::Malformed, text));
        }
        self.link.watch(names);
        self.send(Order::Watched)
    }

    /// Moves a switch of the simulated machine, whatever it does: what runs moves it, or the machine's thread. Its
    /// input reads this from then on, at whatever level of its pin.
    pub fn press(&self, asker: &Asker, lease: u32, number: u8, on: bool) -> Result<(), Problem> {
        if !(1..=LINES as u8).contains(&number) {
            return Err(problem(Why::Malformed, format!("inputs are 1 to {LINES}")));
        }
        let pins = lock(&self.left).session.machine_is.io;
        let press = Press { number, on: pins.line_level(number, on) };
        let act = Act::Input { lease, number, on };
        self.want_of(asker, Way::Act(&act), |wanted| wanted.presses.push_back(press))?;
        self.send(Order::Switches)
    }
}

#[cfg(test)]
mod tests {
    use super::runs_only;

    #[test]
    fn a_line_that_runs_a_file_and_nothing_else_is_that_file() {
        for (line, file) in [
            ("FP,a.sbp", Some("a.sbp")),
            (" fp, a.sbp ", Some("a.sbp")),
            ("FP,a.sbp,2", None),
            ("FP,a.sbp\nMX,1", None),
            ("IF 1=1 THEN FP,a.sbp", None),
            ("MX,1", None),
        ] {
            assert_eq!(runs_only(line).as_deref(), file, "{line}");
        }
    }
}
