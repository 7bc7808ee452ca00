//! Taking up a run that was cut short: up to where it was it runs in silence, the world's part
//! played from the [tape](kerf_journal); then the machine goes back to where the cut ended.
//!
//! ```text
//!           lift ┌─ ask ───── approach ──────┐
//!                │   spindle, outputs        │ plunge
//!   stands here ─┘                           └─► on along the path
//! ```
//!
//! Of the move that was under way the rest is made, along the same path: an arc is still part of the
//! same circle. A job knows its own way back, that from a pause, lift and all: it is asked first, and
//! told where it was.

use crate::run_end::{Break, RunEnd};
use crate::stopping::RunStops;
use kerf_machine::lines::Output;
use kerf_model::WasOn;
use kerf_program::{
    Axes, Axis, Button, Interpreter, MoveKind, OutputReason, Question, QuestionKind, StoppedBy,
};
use kerf_trace::Event;
use std::sync::Arc;

/// Largest share of a move that counts as made: what is left of it always has a length.
const LAST_SHARE: f64 = 1.0 - 1e-9;

/// Brings the machine back to where the run was, before the rest that was not made; or lets the
/// program do it.
pub(crate) fn take_up<I: Interpreter>(stops: &mut RunStops<'_, I>) -> Result<(), Break> {
    if !stops.station.is_taken_up() {
        return Ok(());
    }
    // It may have been taken up here before, and cut short again.
    let told = stops.station.world.workspace.tape.reentered().unwrap_or_else(|| {
        let stands = stops.station.stands_at();
        stops.station.reentry = None;
        stops.station.world.workspace.tape.reenter(stands)
    });
    skip(stops, told.within);
    for (input, on) in told.moved {
        stops.station.world.tracked().press(input, on);
    }
    if stops.station.interpreter.takes_stops() {
        return Err(hand_over(stops, told.place.position)?);
    }
    Ok(go_back(stops, told.place.position)?)
}

/// The program finds its way back from where the machine stands.
fn hand_over<I: Interpreter>(stops: &mut RunStops<'_, I>, from: Axes) -> Result<Break, RunEnd> {
    let began = stops.station.world.model.position();
    let motion = stops.station.stack.next_number();
    // What was on comes on by the program's own way back.
    drop(stops.station.world.tracked().restart(from));
    tell_taken_up(stops);
    let at = kerf_program::Halted { motion, began, stands: from };
    let outputs = stops.station.interpreter.comes_on(&at);
    whether_ready(stops, &WasOn { outputs, pwm: Vec::new() }).0?;
    let stands = stops.station.world.model.position();
    stops.station.world.tell(&Event::Resume { t: stops.station.world.now() });
    let at = kerf_program::Halted { stands, ..at };
    Ok(taken(stops, StoppedBy::PowerCut, &at))
}

/// Asks the operator before anything turns or goes back. The question carries how far he has nudged
/// the workpiece.
fn whether_ready<I: Interpreter>(
    stops: &mut RunStops<'_, I>,
    was_on: &WasOn,
) -> (Result<(), RunEnd>, Axes) {
    let (ready, nudged) = stops.until_resumed(&ready_question(was_on));
    match ready {
        Ok(()) => stops.station.world.workspace.tape.goes_back(),
        Err(_) => {
            stops.station.shift(nudged);
            stops.station.world.workspace.tape.given_up(stops.station.world.placed());
        }
    }
    (ready, nudged)
}

/// Leaves out what was made of the first move that waits.
fn skip<I: Interpreter>(stops: &mut RunStops<'_, I>, share: f64) {
    let waiting = &mut stops.station.stack.waiting;
    let Some(first) = (share > 0.0).then(|| waiting.pop_front()).flatten() else { return };
    let (made, rest) = first.split(share.min(LAST_SHARE));
    stops.station.world.tally.made(&made, 0.0, stops.station.world.model.frame());
    waiting.push_front(rest);
    stops.station.world.model.put(rest.from);
}

fn go_back<I: Interpreter>(stops: &mut RunStops<'_, I>, from: Axes) -> Result<(), RunEnd> {
    let ahead = stops.station.mover.position();
    let to = stops.station.world.model.position();
    let was_on = stops.station.world.tracked().restart(from);
    tell_taken_up(stops);
    may_go_back(stops)?;
    stops.station.world.tracked().begin_motion();
    stops.lift();
    stops.heeded()?;
    let (ready, nudged) = whether_ready(stops, &was_on);
    ready?;
    let before = stops.station.nudged.unwrap_or_default();
    switch_on(stops, &was_on);
    let meanwhile = stops.station.nudged.unwrap_or_default().minus(before);
    approach(stops, to.plus(nudged).plus(meanwhile));
    let on_the_way = stops.station.nudged.unwrap_or_default().minus(before);
    stops.go(MoveKind::Cut, to.plus(nudged).plus(on_the_way));
    stops.heeded()?;
    let on_the_way = stops.station.nudged.unwrap_or_default().minus(before);
    stops.station.mover.set_position(ahead.plus(nudged).plus(on_the_way));
    stops.station.shift(nudged);
    stops.station.world.tell(&Event::Resume { t: stops.station.world.now() });
    Ok(())
}

/// Waits until every stop input is released.
fn may_go_back<I: Interpreter>(stops: &mut RunStops<'_, I>) -> Result<(), RunEnd> {
    stops.heed_emergency()?;
    let released = match stops.station.world.model.stop_input() {
        Some(n) if stops.station.cuts_power(n) => Err(stops.power_is_cut()),
        Some(n) => stops.stopped_again(n),
        None => Ok(()),
    };
    if released.is_err() {
        stops.station.world.workspace.tape.given_up(stops.station.world.placed());
    }
    released
}

/// Outputs come on again, and have the time that the machine gives a spindle to come to speed.
fn switch_on<I: Interpreter>(stops: &mut RunStops<'_, I>, was_on: &WasOn) {
    for number in &was_on.outputs {
        stops.station.world.model.output(*number, true, OutputReason::Program);
    }
    for (channel, percent) in &was_on.pwm {
        stops.station.world.model.pwm(*channel, *percent);
    }
    stops.station.world.tell_log();
    if was_on.turns() {
        stops.come_to_speed();
    }
}

fn tell_taken_up<I: Interpreter>(stops: &mut RunStops<'_, I>) {
    let (file, line) =
        (stops.station.world.file(stops.station.last_move), stops.station.last_move.line);
    let text = match line {
        0 => "taken up before the first move".to_owned(),
        line => format!("taken up behind line {line} of {file}"),
    };
    stops
        .station
        .world
        .tell(&Event::Message { text: Arc::from(text), t: stops.station.world.now() });
    stops.station.world.tell_log();
}

/// Goes above the place, no lower than the tool is now.
fn approach<I: Interpreter>(stops: &mut RunStops<'_, I>, to: Axes) {
    let mut over = to;
    over[Axis::Z] = to[Axis::Z].max(stops.station.world.model.position()[Axis::Z]);
    stops.go(MoveKind::Jog, over);
}

/// The machine was stopped, and the program says what follows.
pub(crate) fn taken<I: Interpreter>(
    stops: &mut RunStops<'_, I>,
    by: StoppedBy,
    at: &kerf_program::Halted,
) -> Break {
    stops.station.drive.heard();
    stops.station.world.tracked().land();
    let stands = stops.station.world.model.position();
    stops.station.world.limit = match by {
        StoppedBy::Limit(input) => Some(input),
        _ => None,
    };
    stops.station.interpreter.stopped(by, &kerf_program::Halted { stands, ..*at });
    stops.station.world.workspace.tape.goes_on();
    stops.station.begin_anew(stands);
    Break::Interrupted
}

/// Builds the question to the operator when the tool is up, before anything turns.
fn ready_question(was_on: &WasOn) -> Question {
    let name = |n: &u8| Output::of_number(*n).map_or(n.to_string(), |line| line.name().to_owned());
    let on: Vec<String> = was_on.outputs.iter().map(name).collect();
    let outputs = match on.as_slice() {
        [] => "No output comes on".to_owned(),
        [one] => format!("Output {one} comes on"),
        all => format!("Outputs {} come on", all.join(", ")),
    };
    Question {
        kind: QuestionKind::Hold,
        text: format!("{outputs}, the tool goes back to where the cut ended. Is everything ready?"),
        title: "Resume".into(),
        buttons: vec![Button::Resume, Button::Quit],
        default: 0,
        prefill: String::new(),
        icon: 0,
        until: None,
    }
}
