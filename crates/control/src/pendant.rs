//! A pendant at the keypad: keys that are wired to inputs (command reference, VD "Keypad remote").
//!
//! A key moves the tool from when it is pressed until it is let go. Whatever else ends a motion, nothing
//! moves before a key is pressed anew: one that is held already was meant for something else.

use crate::hand_words::Jog;
use crate::station::Station;
use kerf_machine::hand::FAR;
use kerf_model::Watched;
use kerf_program::{AXES, Answer, At, Axes, Axis, Button, Interpreter, QuestionKind};

/// Moves for as long as keys are held, another way as soon as others are. Tells whether a key closes
/// the keypad.
pub(crate) fn follow_pendant<I: Interpreter>(station: &mut Station<'_, I>) -> bool {
    let Some(keys) = station.world.keys(QuestionKind::Keypad) else { return false };
    let closes = loop {
        let machine = &station.world.model;
        let pressed = |input: u8| machine.input(input);
        let way = keys.way(pressed);
        if pressed(keys.close) || way == [0.0; AXES] {
            break pressed(keys.close);
        }
        let change =
            |input: u8| Watched { input, on: !pressed(input), ramped: true, level_from_s: None };
        let changes: Vec<Watched> = keys.inputs().map(change).collect();
        let speed = if pressed(keys.fast) { 1.0 } else { slow_share(station, way) };
        let jog = Jog { by: Axes(way.map(|way| way * FAR)), speed };
        if !station.jog_until(jog, &changes) {
            break false;
        }
    };
    station.interpreter.moved(station.world.model.position());
    closes
}

/// The share of the jog speed at which cuts are made.
fn slow_share<I: Interpreter>(station: &Station<'_, I>, way: [f64; AXES]) -> f64 {
    let speeds = &station.world.model.settings().speeds;
    let share = |axis| speeds.cut.of(axis) / speeds.jog.of(axis);
    let moves = Axis::ALL.into_iter().filter(|axis| way[axis.index()] != 0.0);
    moves.map(share).fold(1.0, f64::min)
}

/// Keys are pressed while a program asks: they move the tool, or close the keypad.
pub(crate) fn use_pendant<I: Interpreter>(station: &mut Station<'_, I>, at: At) {
    if follow_pendant(station) {
        station.world.answered_by_input(Answer::Button(Button::OK), at);
    }
}
