//! The timing chart of a run, as pages draw it.

use super::{options, silently, unattended};
use kerf_control::Session;
use kerf_journal::{RunOptions, Work};
use kerf_model::Change;
use kerf_preview::timing::{Course, Track};
use kerf_program::rounded;
use kerf_sbp::{FileParameters, Status};
use kerf_trace::{Summary, switching::Lines};
use kerf_wire::preview::{TIMING_POINTS, Timing, TimingKind, TimingLine};
use kerf_workspace::Workspace;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Finer than any page draws: a tenth of a microsecond, a tenth of a micrometre.
const PLACES: i32 = 7;

/// Makes the chart on a copy of a session, with these changes of the inputs; nothing when it was given up.
pub fn timing(
    work: Work,
    parameters: FileParameters,
    inputs: Vec<Change>,
    session: Session,
    workspace: &mut Workspace,
    given_up: &Arc<AtomicBool>,
) -> Option<Timing> {
    let (work, _) = unattended(work);
    let options = RunOptions { inputs, ..options(parameters) };
    let lines = Lines::bounded(TIMING_POINTS).until(given_up.clone());
    let mut lines = lines.beginning(&session.found_by(&work, &options));
    let (summary, ..) = silently(work, options, session, workspace, given_up, &mut lines)?;
    Some(charted(lines, &summary))
}

fn charted(lines: Lines, summary: &Summary) -> Timing {
    let full = !lines.is_whole();
    let timing = lines.timing(String::new());
    Timing {
        seconds: rounded(timing.end_s, PLACES),
        whole: !full && matches!(summary.status, Status::Ok | Status::Ended),
        full,
        status: summary.status.word().into(),
        finding: summary.error.as_deref().map(kerf_language::finding),
        lines: timing.tracks.into_iter().map(line).collect(),
    }
}

fn line(Track { name, course, grain_s }: Track) -> TimingLine {
    let bits = |edges: Vec<(f64, bool)>| edges.into_iter().map(|(t, on)| (t, f64::from(on)));
    let (kind, points): (_, Vec<(f64, f64)>) = match course {
        Course::Place(points) => (TimingKind::Axis, points),
        Course::Value(points) => (TimingKind::Value, points),
        Course::Output(edges) => (TimingKind::Output, bits(edges).collect()),
        Course::Input(edges) => (TimingKind::Input, bits(edges).collect()),
    };
    let points =
        points.into_iter().map(|(t, value)| [rounded(t, PLACES), rounded(value, PLACES)]).collect();
    TimingLine { kind, name, grain: grain_s, points }
}
