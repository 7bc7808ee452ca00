//! The timing chart of a run, as pages draw it.

use super::{options, silently, unattended};
use kerf_control::timing::{Course, Lines, Track};
use kerf_control::{RunOptions, Session, Shelf, Work};
use kerf_sbp::FileParameters;
use kerf_sim::Change;
use kerf_wire::preview::{TIMING_POINTS, Timing, TimingKind, TimingLine};
use std::sync::atomic::AtomicBool;

/// Finer than any page draws: a tenth of a microsecond, a tenth of a micrometre.
const DIGITS: f64 = 1e7;

/// Makes the chart on a copy of a session, with these changes of the inputs; nothing when it was given up.
pub fn timing(
    work: Work,
    parameters: FileParameters,
    inputs: Vec<Change>,
    session: Session,
    shelf: &mut Shelf,
    given_up: &AtomicBool,
) -> Option<Timing> {
    let (work, machine) = unattended(work);
    // A job brings its own frame, and its heights are those of the machine.
    let zero =
        if machine.is_some() { [0.0; 3] } else { session.memory.frame.working_zero.first3() };
    let mut lines = Lines::bounded(TIMING_POINTS);
    let options = RunOptions { inputs, ..options(parameters) };
    silently(work, options, session, shelf, given_up, &mut lines)?;
    let whole = lines.is_whole();
    let timing = lines.timing(String::new());
    let lines = timing.tracks.into_iter().map(|track| line(track, zero)).collect();
    Some(Timing { seconds: rounded(timing.end_s), whole, lines })
}

fn line(Track { name, course, grain_s }: Track, zero: [f64; 3]) -> TimingLine {
    let bits = |edges: Vec<(f64, bool)>| edges.into_iter().map(|(t, on)| (t, f64::from(on)));
    let (kind, points): (_, Vec<(f64, f64)>) = match course {
        Course::Place(points) => {
            let from =
                ["x", "y", "z"].iter().position(|axis| *axis == name).map_or(0.0, |n| zero[n]);
            (TimingKind::Axis, points.into_iter().map(|(t, at)| (t, at - from)).collect())
        }
        Course::Value(points) => (TimingKind::Value, points),
        Course::Output(edges) => (TimingKind::Output, bits(edges).collect()),
        Course::Input(edges) => (TimingKind::Input, bits(edges).collect()),
    };
    let points = points.into_iter().map(|(t, value)| [rounded(t), rounded(value)]).collect();
    TimingLine { kind, name, grain: grain_s, points }
}

fn rounded(value: f64) -> f64 {
    (value * DIGITS).round() / DIGITS
}
