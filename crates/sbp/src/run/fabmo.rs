//! The statements of FabMo's dialect alone: probes, dialogs, FAIL, data for programs beside the machine.

use super::state::Handler;
use super::{Context, Stop, cutting, eval, fields, pauses, questions};
use crate::tree::Dialog;
use crate::{Expr, Value};
use kerf_diag::Code;
use kerf_program::{Axes, Button, Command, Feed, MoveKind, Question, QuestionKind, Watch};

/// Moves until an input goes on. What follows waits until the move is over; that the target was
/// reached without a touch is for the program to find out.
pub(crate) fn probe(c: &mut Context<'_>, to: Axes, speed_mm_s: f64, input: u8) {
    if c.host.input(input) {
        let message = format!("input {input} is on already, the probe does not move");
        return c.warn(Code::Unusual, message, "back off before probing again");
    }
    let watch = Watch::change(input, true, false);
    let level = c.core.flow.levels.len();
    // First in the list: an ON INPUT of the same input does not fire for a probe.
    c.core.handlers.watches.insert(0, Handler { watch, at: c.at, level, probe: true });
    cutting::line_at(c, MoveKind::Cut, to, Feed::Path(speed_mm_s));
    c.core.handlers.pausing = true;
}

/// DIALOG, and PAUSE with a text: OK goes on, Cancel ends the run.
pub(super) fn dialog(c: &mut Context<'_>, dialog: &Dialog) -> Result<(), Stop> {
    let text = dialog_words(c, dialog)?;
    if let Some(seconds) = &dialog.seconds {
        eval::eval_number(c, seconds)?;
        c.emit(Command::Message { text: text.into() });
        return pauses::pause_for(c, seconds);
    }
    let title = match &dialog.title {
        Some(title) => eval::eval_text(c, title)?,
        None => c.program.name.to_string(),
    };
    let buttons = [Button::OK, Button::Cancel];
    let Some(name) = dialog.variable else {
        let question =
            Question { title, ..questions::question(c, QuestionKind::Pause, text, &buttons) };
        return questions::confirm(c, &question);
    };
    let prefill = eval::variable(c, name).map(Value::display).unwrap_or_default();
    let question = Question { title, ..questions::entry(c, text, prefill) };
    let typed = questions::values_typed(c, &question, 1)?;
    eval::set_variable(c, name, fields::value(&typed).typed());
    Ok(())
}

/// The text, the details, and what the buttons mean where the program names them.
fn dialog_words(c: &mut Context<'_>, dialog: &Dialog) -> Result<String, Stop> {
    let mut text = eval::eval_text(c, &dialog.text)?;
    if let Some(detail) = &dialog.detail {
        text.push('\n');
        text.push_str(&eval::eval_text(c, detail)?);
    }
    for (button, meaning) in [("OK", &dialog.ok), ("Cancel", &dialog.cancel)] {
        if let Some(meaning) = meaning {
            let meaning = eval::eval_text(c, meaning)?;
            text.push_str(&format!("\n{button}: {meaning}"));
        }
    }
    Ok(text)
}

/// FAIL: the program gives up.
pub(super) fn give_up(c: &mut Context<'_>, text: Option<&Expr>) -> Result<(), Stop> {
    let text = text.map_or(Ok("the program gives up".into()), |t| eval::eval_text(c, t))?;
    c.settle()?;
    Err(c.fail(Code::ProgramFailed, text))
}

/// DATA_SEND and DATA_REQUEST: there is no program beside the machine, so what would be sent is
/// shown, and a request is a question to the operator.
pub(super) fn data(c: &mut Context<'_>, request: bool, items: &[Expr]) -> Result<(), Stop> {
    let mut words = Vec::new();
    for item in items {
        words.push(eval::eval_text(c, item)?);
    }
    let text = words.join(" ");
    if !request {
        c.emit(Command::Message { text: text.into() });
        return Ok(());
    }
    let buttons = [Button::OK, Button::Cancel];
    let question = questions::question(c, QuestionKind::Pause, text, &buttons);
    questions::confirm(c, &question)
}
