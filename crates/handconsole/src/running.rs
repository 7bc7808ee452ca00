//! The machine moves, is paused, asks something, or is in alarm.

use crate::next::{Next, To};
use crate::start::GO_ON;
use crate::{COLUMNS, ConsoleRequest, Key, Screen, View};
use kerf_wire::{Asked, State};

pub(crate) fn screen(view: &View) -> Screen {
    match view.state {
        State::Alarm => Screen::of_text(view.why.as_deref().unwrap_or("Alarm")),
        State::Held => screen_of_shape("Held", view),
        State::Jogging => Screen::new("Moving", ""),
        _ => screen_of_shape("Running", view),
    }
}

/// Returns the screen of an action and of the shape that it is done with.
pub(crate) fn screen_of_shape(action: &str, view: &View) -> Screen {
    match view.shape {
        0 => Screen::new(action, ""),
        shape => Screen::new(action, format!("Shape {shape} of {}", view.shapes())),
    }
}

pub(crate) fn press<M>(key: Key, state: State) -> Next<M> {
    match (key, state) {
        (Key::Enter, State::Alarm) => Next::request([ConsoleRequest::Acknowledge]),
        (Key::Start, State::Held) => Next::request([ConsoleRequest::Resume]),
        _ => Next::default(),
    }
}

/// Start goes on, Func gives up if Enter says so.
pub(crate) fn press_paused<M>(key: Key) -> Next<M> {
    match key {
        Key::Start => Next::request([ConsoleRequest::Answer(GO_ON.into())]),
        Key::Func => Next::to(To::Aborting),
        _ => Next::default(),
    }
}

/// A question, and its answers with the digit of each.
pub(crate) fn question(asked: &Asked) -> Screen {
    let buttons = asked.buttons.iter().zip(1..).map(|(word, digit)| format!("{digit}{word}"));
    let answers = buttons.collect::<Vec<_>>().join(" ");
    let text = if asked.text.is_empty() { &asked.title } else { &asked.text };
    Screen::new(text, answers.chars().take(COLUMNS).collect::<String>())
}

pub(crate) fn press_asked<M>(key: Key, asked: &Asked) -> Next<M> {
    let Key::Digit(digit) = key else { return Next::default() };
    let button = usize::from(digit).checked_sub(1).and_then(|at| asked.buttons.get(at));
    Next::request(button.cloned().map(ConsoleRequest::Answer))
}
