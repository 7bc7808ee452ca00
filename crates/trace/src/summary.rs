//! Result of a run.

use crate::Tally;
use kerf_diag::Diagnostic;
use kerf_program::Status;
use kerf_program::settings::LinearUnit;

/// Result of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Outcome of the run.
    pub status: Status,
    /// Machine time of Kerf's own plan, seconds.
    pub seconds: f64,
    /// Seconds that a real machine took, with holds and questions; nothing for a simulated one, which takes its own.
    pub taken_s: Option<f64>,
    /// Lines executed.
    pub lines: u64,
    /// Lengths, bounds, times.
    pub tally: Tally,
    /// The unit the user reads at the end.
    pub unit: LinearUnit,
    /// The error that ended it.
    pub error: Option<Box<Diagnostic>>,
    /// The program asked that Kerf closes (EXIT SHOPBOT).
    pub closes: bool,
}

impl Summary {
    /// The summary of a run that was not begun because of an error.
    pub fn not_begun(unit: LinearUnit, error: Option<Box<Diagnostic>>) -> Self {
        let (status, tally) = (Status::Failed, Tally::default());
        Self { status, seconds: 0.0, taken_s: None, lines: 0, tally, unit, error, closes: false }
    }
}
