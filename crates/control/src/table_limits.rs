//! Refusal of motion: moves that would leave the table, anything while a stop input is active or the
//! enclosure is open.

use crate::reentry::taken;
use crate::run_end::{Break, RunEnd};
use crate::stopping::RunStops;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_journal::LimitPolicy;
use kerf_machine::lines::Output;
use kerf_model::Violation;
use kerf_motion::{Move, Queue};
use kerf_program::{At, Command, Independent, Interpreter, SpindleTurn, Status, StoppedBy};

/// Tells whether an output turns a spindle: those of part files, or that of jobs.
const fn turns(output: u8) -> bool {
    matches!(output, 1 | 2) || output == Output::Router.number()
}

/// Refuses moves that would leave the table, and any while a stop input is active.
pub(crate) fn check<I: Interpreter>(
    stops: &mut RunStops<'_, I>,
    moves: &Queue,
) -> Result<(), RunEnd> {
    let Some(first) = moves.front() else { return Ok(()) };
    if lists_limits(stops) {
        moves.iter().for_each(|made| list_violation(stops, &made));
    } else if let Some((at, violation)) = first_outside(stops, moves) {
        stops.limited(at, Code::OutsideLimits, limit_message(stops, &violation))?;
    }
    let refused =
        moves.iter().find_map(|made| Some((made.at, stops.station.drive.refuses(&made)?)));
    if let Some((at, why)) = refused {
        return Err(stops.station.over(Status::Failed, Code::Controller, at, why));
    }
    may_move(stops, first.at)
}

/// A limit switch that is on already when a file begins to move, or whose wire is broken, stops it as one that comes
/// on the way. By hand the tool may be moved away from it.
pub(crate) fn heed_limit<I: Interpreter>(stops: &mut RunStops<'_, I>) -> Result<(), Break> {
    let by_hand = stops.station.world.typed_files > 0 || stops.station.is_open_for_take_up();
    let Some(input) = stops.station.world.model.limit_input().filter(|_| !by_hand) else {
        return Ok(());
    };
    if stops.station.interpreter.takes_stops() {
        let stood = stops.station.stood();
        return Err(taken(stops, StoppedBy::Limit(input), &stood));
    }
    let message = format!("limit input {input} is active before anything moves");
    stops.station.world.limit = Some(input);
    Ok(stops.limited(stops.station.last_move, Code::InputStop, message)?)
}

/// Refuses motion without a controller and while a stop input is active. A run that has not moved
/// yet does not begin; another waits until the input is released.
pub(crate) fn may_move<I: Interpreter>(stops: &mut RunStops<'_, I>, at: At) -> Result<(), RunEnd> {
    if stops.station.is_open_for_take_up() {
        return Ok(());
    }
    if !stops.station.world.model.is_connected() {
        return Err(stops.station.not_connected(at));
    }
    if stops.station.is_ended_by_press() {
        return Err(ended_by_press(stops, at));
    }
    let Some(input) = stops.station.world.model.stop_input() else { return Ok(()) };
    if stops.station.world.tally.moves > 0 && stops.station.cuts_power(input) {
        return Err(stops.power_is_cut());
    }
    if stops.station.world.tally.moves > 0 && !stops.station.interpreter.takes_stops() {
        stops.station.world.workspace.tape.stood(1.0);
        return stops.blocked(input);
    }
    Err(forbids(stops, input, at))
}

/// The emergency stop is pressed where something is about to move or to turn: a run that has not moved yet
/// does not begin.
fn ended_by_press<I: Interpreter>(stops: &mut RunStops<'_, I>, at: At) -> RunEnd {
    if stops.station.world.tally.moves > 0 {
        stops.station.world.workspace.tape.stood(1.0);
        return stops.emergency();
    }
    let message = "emergency stop".to_owned();
    let hint = "release it: nothing moves and nothing turns before";
    stops.station.over(Status::Stopped, Code::InputStop, at, message).hint(hint)
}

/// A file whose outputs come on when it starts does not start while a stop is active.
pub(crate) fn may_begin<I: Interpreter>(stops: &mut RunStops<'_, I>) -> Result<(), RunEnd> {
    stops.station.world.model.begin_lines();
    if !stops.station.world.model.switches_on_at_start() || stops.station.interpreter.takes_stops()
    {
        return Ok(());
    }
    if stops.station.is_ended_by_press() {
        return Err(ended_by_press(stops, At::default()));
    }
    let input = stops.station.world.model.stop_input();
    input.map_or(Ok(()), |input| Err(forbids(stops, input, At::default())))
}

fn forbids<I: Interpreter>(stops: &RunStops<'_, I>, input: u8, at: At) -> RunEnd {
    let active = format!("stop input {input} is active: stop circuit open, nothing may move");
    let message = stops.station.stop_input_message(active);
    stops.station.over(Status::Stopped, Code::InputStop, at, message)
}

/// Tells whether a move of a stack that moves already would leave the table: whatever comes before it is
/// made first, and then it is a stack of its own, about which the operator is asked.
pub(crate) fn leaves_table<I: Interpreter>(stops: &mut RunStops<'_, I>, made: &Move) -> bool {
    if stops.station.stack.running.is_none() {
        return false;
    }
    if lists_limits(stops) {
        list_violation(stops, made);
        return false;
    }
    stops.station.world.model.first_outside(std::slice::from_ref(made)).is_some()
}

/// Tells whether moves beyond the table are listed without a question, as in a preview.
fn lists_limits<I: Interpreter>(stops: &RunStops<'_, I>) -> bool {
    stops.limits == LimitPolicy::List || stops.station.world.model.draws()
}

fn list_violation<I: Interpreter>(stops: &mut RunStops<'_, I>, made: &Move) {
    if let Some(violation) = stops.station.world.model.first_outside(std::slice::from_ref(made)) {
        let message = limit_message(stops, &violation);
        let place = SourcePlace::line(stops.station.world.file(made.at), made.at.line);
        let diagnostic = Diagnostic::new(Code::OutsideLimits, place, message);
        stops.station.world.tell_diagnostic(diagnostic);
    }
}

fn first_outside<I: Interpreter>(
    stops: &RunStops<'_, I>,
    moves: &Queue,
) -> Option<(At, Violation)> {
    let machine = &stops.station.world.model;
    moves.iter().find_map(|made| Some((made.at, machine.first_outside(&[made])?)))
}

fn limit_message<I: Interpreter>(stops: &RunStops<'_, I>, violation: &Violation) -> String {
    let scale = stops.station.world.scale(violation.axis);
    let [reached, limit] =
        [violation.reached, violation.limit].map(|v| kerf_sbp::format_number(v / scale));
    let letter = violation.axis.letter();
    if violation.soft {
        return format!(
            "Out of bounds: {letter} would reach {reached}, it ends at {limit} (from home)"
        );
    }
    format!("{letter} would reach {reached}, the table limit is {limit} (table base coordinates)")
}

/// No spindle and no axis of its own (MI) starts where nothing may move: in an open enclosure, while a stop is
/// pressed.
pub(crate) fn may_turn<I: Interpreter>(
    stops: &mut RunStops<'_, I>,
    command: &Command,
    at: At,
) -> Result<(), RunEnd> {
    let starts = match command {
        Command::Output { number, on } => *on && turns(*number),
        Command::Independent { motion, .. } => *motion != Independent::Off,
        Command::SpindleTurn { turn, .. } => *turn != SpindleTurn::Off,
        Command::Pwm { percent, .. } => *percent > 0.0,
        _ => false,
    };
    let stopped =
        stops.station.world.model.stop_input().is_some() || stops.station.world.is_pressed();
    if starts && stopped { may_move(stops, at) } else { Ok(()) }
}
