//! The end of a run of a server, and what is wrong with a file, as the server tells it.

use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_program::settings::LinearUnit;
use kerf_sbp::Status;
use kerf_trace::{Summary, Tally};
use serde_json::Value;

/// End of a run.
pub struct Ended {
    /// Summary of the run.
    pub summary: Summary,
    /// The error that ended it, and what else is worth knowing of that.
    pub told: Vec<Diagnostic>,
}

impl Ended {
    /// The end of a run that began after another.
    pub(super) fn of(state: &Value, before: u64) -> Option<Self> {
        let ended = state["job"]["ended"].as_str().filter(|_| number_of_run(state) > before)?;
        let told = diagnostic(&state["job"]["error"]).into_iter().collect();
        Some(Self { summary: summary(status(ended), &state["job"]["summary"]), told })
    }
}

/// The number of the run that a state tells of.
pub(super) fn number_of_run(state: &Value) -> u64 {
    state["job"]["run"].as_u64().unwrap_or_default()
}

/// The words of the trace.
fn status(word: &str) -> Status {
    match word {
        "ok" => Status::Ok,
        "ended" => Status::Ended,
        "failed" => Status::Failed,
        "limit" => Status::Limit,
        _ => Status::Stopped,
    }
}

fn summary(status: Status, came: &Value) -> Summary {
    let real = |key: &str| came[key].as_f64().unwrap_or_default();
    let count = |key: &str| came[key].as_u64().unwrap_or_default();
    let mut tally = Tally::default();
    (tally.moves, tally.arcs) = (count("moves"), count("arcs"));
    (tally.cut_mm, tally.jog_mm) = (real("cutMm"), real("jogMm"));
    if let Ok([min, max]) = serde_json::from_value::<[[f64; 3]; 2]>(came["bounds"].clone()) {
        (tally.bounds.min, tally.bounds.max) = (min, max);
    }
    Summary {
        status,
        seconds: real("seconds"),
        taken_s: None,
        lines: count("lines"),
        tally,
        unit: if came["millimetres"] == true { LinearUnit::Mm } else { LinearUnit::Inch },
        error: None,
        closes: false,
    }
}

/// Returns the findings of the preview of the file that is open.
pub(super) fn findings(state: &Value) -> Vec<Diagnostic> {
    let found = state["opened"]["findings"].as_array();
    found.into_iter().flatten().filter_map(diagnostic).collect()
}

/// A finding as it is shown; nothing where there is none.
fn diagnostic(found: &Value) -> Option<Diagnostic> {
    let code: Code = serde_json::from_value(found["code"].clone()).ok()?;
    let text = |key: &str| found[key].as_str().unwrap_or_default();
    let number = |key: &str| found[key].as_u64().unwrap_or_default() as u32;
    let place = SourcePlace {
        column: number("column"),
        length: number("length"),
        ..SourcePlace::line(text("file").into(), number("line"))
    };
    let severity = match text("level") {
        "note" => Severity::Note,
        "warning" => Severity::Warning,
        _ => Severity::Error,
    };
    Some(Diagnostic::new(code, place, text("message")).hint(text("hint")).severity(severity))
}
