//! PAUSE in its three forms, and WARNING OFF.

use super::{Context, Stop, comments, eval, questions};
use crate::{Expr, Value};
use kerf_diag::Code;
use kerf_program::{Button, Command, Question, QuestionKind};

/// No pause is longer, about three years: beyond, a clock loses its milliseconds.
const LONGEST_S: f64 = 1e8;

/// PAUSE n: waits so many seconds. The comment above was told when its own line ran.
pub(super) fn pause_for(c: &mut Context<'_>, seconds: &Expr) -> Result<(), Stop> {
    let n = eval::eval_number(c, seconds)?;
    if !(0.0..=LONGEST_S).contains(&n) {
        let message = format!(
            "a pause lasts 0 or more seconds, at most 100000000, not {}",
            Value::Number(n).display()
        );
        return Err(c.fail_at(seconds.span, Code::OutOfRange, message, ""));
    }
    c.settle()?;
    c.emit(Command::Wait { seconds: n });
    c.core.handlers.pausing = !c.core.handlers.watches.is_empty();
    Ok(())
}

/// PAUSE: waits for the operator.
pub(super) fn pause(c: &mut Context<'_>) -> Result<(), Stop> {
    let question = pause_question(c);
    questions::confirm(c, &question)
}

/// PAUSE UNTIL: waits for the operator or for an input; goes on at once when the input is
/// already in the state (readings, A-29).
pub(super) fn pause_until(c: &mut Context<'_>, switch: &Expr, state: &Expr) -> Result<(), Stop> {
    let input = switch_number(c, switch)?;
    let on = switch_state(c, state)?;
    c.settle()?;
    if c.host.input(input) == on {
        return Ok(());
    }
    let question = Question { until: Some((input, on)), ..pause_question(c) };
    questions::confirm(c, &question)
}

fn pause_question(c: &Context<'_>) -> Question {
    let text = comments::comment_above(c).unwrap_or_else(|| "Continue?".into());
    questions::question(c, QuestionKind::Pause, text, &[Button::OK, Button::Cancel])
}

fn switch_state(c: &mut Context<'_>, state: &Expr) -> Result<bool, Stop> {
    let n = eval::eval_number(c, state)?;
    if n == 0.0 || n == 1.0 {
        return Ok(n == 1.0);
    }
    let message = format!("a switch is 1 or 0, not {}", Value::Number(n).display());
    Err(c.fail_at(state.span, Code::OutOfRange, message, "1 closed, 0 open"))
}

/// WARNING OFF: no flashing until the next motion.
pub(super) fn warning_off(c: &mut Context<'_>) -> Result<(), Stop> {
    c.settle()?;
    c.emit(Command::WarningOff);
    Ok(())
}

/// An input or output number, 1 … 12.
pub(super) fn switch_number(c: &mut Context<'_>, expr: &Expr) -> Result<u8, Stop> {
    let n = eval::eval_number(c, expr)?;
    if n.fract() == 0.0 && (1.0..=12.0).contains(&n) {
        return Ok(n as u8);
    }
    let message = format!("switches are numbered 1 to 12, not {}", Value::Number(n).display());
    Err(c.fail_at(expr.span, Code::OutOfRange, message, ""))
}
