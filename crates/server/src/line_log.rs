//! The record of a controller's lines, for pages and for requests for help.

use crate::app::App;
use crate::refusal::problem;
use kerf_control::controller::{HEAD, LineLog, LoggedLine};
use kerf_machine::driver::LineKind;
use kerf_wire::{ControllerLine, ControllerLines, Problem, Why};

/// Lines that a request for help shows.
const SHOWN: usize = 200;

/// The kind of a line as pages name it.
const fn kind_shown(kind: LineKind) -> kerf_wire::LineKind {
    match kind {
        LineKind::Line => kerf_wire::LineKind::Line,
        LineKind::AtOnce => kerf_wire::LineKind::AtOnce,
        LineKind::Ask => kerf_wire::LineKind::Ask,
        LineKind::Report => kerf_wire::LineKind::Report,
        LineKind::Ok => kerf_wire::LineKind::Ok,
        LineKind::Error => kerf_wire::LineKind::Error,
        LineKind::Alarm => kerf_wire::LineKind::Alarm,
        LineKind::Message => kerf_wire::LineKind::Message,
        LineKind::Welcome => kerf_wire::LineKind::Welcome,
        LineKind::Link => kerf_wire::LineKind::Link,
    }
}

/// Returns `true` for what passes all the time while nothing happens.
const fn is_routine(kind: LineKind) -> bool {
    matches!(kind, LineKind::Ask | LineKind::Report | LineKind::Ok)
}

fn log(app: &App) -> Result<&LineLog, Problem> {
    let text = "nothing is sent in lines here: the machine is simulated, or a board that is told each step";
    app.log.as_deref().ok_or_else(|| problem(Why::State, text))
}

/// Returns lines from a number on; reports and `ok`s only where they are wanted.
///
/// # Errors
/// The machine has no controller that speaks in lines.
pub fn since(app: &App, number: u64, routine: bool) -> Result<ControllerLines, Problem> {
    let portion = log(app)?.since(number, |kind| routine || !is_routine(kind));
    Ok(ControllerLines {
        lines: portion.lines.into_iter().map(shown).collect(),
        next: portion.next as u32,
        more: portion.is_cut,
        gone: portion.gone as u32,
    })
}

fn shown(line: LoggedLine) -> ControllerLine {
    ControllerLine {
        number: line.number as u32,
        at: line.at_ms as f64 / 1000.0,
        sent: line.is_sent,
        kind: kind_shown(line.kind),
        text: line.text,
        words: line.words,
    }
}

/// Returns all that is kept as text.
///
/// # Errors
/// As [`since`].
pub fn text(app: &App) -> Result<String, Problem> {
    Ok(as_text(&log(app)?.last(usize::MAX, |_| true)))
}

/// Returns the last lines as text, without what passes all the time; empty where no controller speaks in lines.
pub fn for_help(app: &App) -> String {
    let last = |log: &LineLog| as_text(&log.last(SHOWN, |kind| !is_routine(kind)));
    app.log.as_deref().map(last).unwrap_or_default()
}

fn as_text(lines: &[LoggedLine]) -> String {
    let mut text = HEAD.to_owned();
    text.extend(lines.iter().map(|line| line.shown() + "\n"));
    text
}
