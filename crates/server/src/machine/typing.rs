//! A typed line on the screen: what it draws, or the file that it runs (FP, FG).

use crate::files::PartFolder;
use kerf_program::FileCall;
use kerf_trace::{ExecutedMove, OpenFile};
use kerf_wire::FileParameters;
use std::fmt;
use std::sync::Arc;

/// A file that a typed line runs.
#[derive(Clone, Debug, PartialEq)]
pub struct CalledFile {
    /// Number of the run.
    pub run: u32,
    /// Its name below the part folder.
    pub name: String,
    /// Parameters with which it is run.
    pub parameters: FileParameters,
}

/// Has a file on the screen, as if somebody had opened it.
#[derive(Clone)]
pub struct Screen(pub Arc<dyn Fn(CalledFile) + Send + Sync>);

impl fmt::Debug for Screen {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Screen")
    }
}

/// A typed line that runs.
#[derive(Debug)]
pub struct Typing {
    run: u32,
    screen: Screen,
    /// All that it does is to run a file.
    calls: bool,
    /// That file is on the screen.
    shown: bool,
}

impl Typing {
    /// A line and the number of its run.
    pub fn of(line: &str, run: u32, screen: Screen) -> Self {
        Self { run, screen, calls: runs_a_file(line), shown: false }
    }

    /// The run stands in these files. The first that is called gets on the screen, where it lies in the part folder.
    pub fn stands(&mut self, files: &[OpenFile], parts: &PartFolder) {
        let Some(OpenFile { file, call: Some(call), .. }) = files.get(1) else { return };
        if !self.calls || self.shown {
            return;
        }
        let name = parts.name_of(file);
        if parts.find(&name).is_ok() {
            self.shown = true;
            let (run, parameters) = (self.run, parameters(*call));
            (self.screen.0)(CalledFile { run, name, parameters });
        }
    }

    /// Returns `true` if a move is drawn as typed: that of a file on the screen is part of its picture.
    pub const fn draws(&self, made: &ExecutedMove<'_>) -> bool {
        !made.beside && (!self.shown || made.span.made.at.file == 0)
    }
}

fn parameters(call: FileCall) -> FileParameters {
    let FileCall { proportion, offset, repetitions, plunge_mm, tabs, plunge_from_zero } = call;
    FileParameters { proportion, offset, repetitions, plunge: plunge_mm, tabs, plunge_from_zero }
}

/// Returns `true` if FP or FG is all that stands in a line.
fn runs_a_file(line: &str) -> bool {
    let line = line.trim();
    let letters = line.get(..2).map(str::to_ascii_uppercase);
    let ends = line.get(2..).is_some_and(|rest| rest.starts_with([',', ' ', '\t']));
    line.lines().count() == 1 && ends && matches!(letters.as_deref(), Some("FP" | "FG"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fp_and_fg_alone_run_a_file() {
        let check = |line: &str, expected: bool| {
            assert_eq!(runs_a_file(line), expected, "{line}");
        };
        check("FP,a.sbp", true);
        check("FP,a.sbp,2,2,1 'twice as wide", true);
        check(" fg a.sbp", true);
        check("FPX", false);
        check("C9", false);
        check("MX,1", false);
        check("MX,1\nFP,a.sbp", false);
        check("FP,a.sbp\nFP,b.sbp", false);
    }
}
