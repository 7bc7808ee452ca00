//! Outputs, and the spindle.

use crate::run::SPINDLE_STATUS;
use crate::run::questions;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::format_number;
use kerf_diag::Code;
use kerf_program::settings::Mode;
use kerf_program::{Button, Command, QuestionKind, SPINDLE_OUTPUT};

/// Output with modes of its own, and the mode that frees it.
const MOTION_OUTPUT: u8 = 4;

const FREE: i8 = -4;

/// Switches an output, or changes the mode of the one that follows motion.
pub(super) fn switch(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let number = a.whole(0).unwrap_or_default() as u8;
    let state = a.whole(1).unwrap_or_default() as i8;
    let outputs = c.settings().controller.outputs;
    if number > outputs {
        let message = format!("this controller has {outputs} outputs, there is no output {number}");
        return Err(c.fail_at(
            a.span(0),
            Code::OutOfRange,
            message,
            "driver.outputs says how many",
        ));
    }
    if state < 0 {
        return output_mode(c, a, number, state);
    }
    if number == MOTION_OUTPUT && c.settings().io.output4 != FREE {
        let hint = "SO,4,-4 frees it for programs";
        c.warn(Code::Unusual, "output 4 is automatic; this line does nothing", hint);
        return Ok(());
    }
    let on = state == 1;
    if !on {
        c.settle()?;
    } else if number == SPINDLE_OUTPUT {
        ask_spindle(c)?;
    }
    c.emit(Command::Output { number, on });
    Ok(())
}

fn output_mode(c: &mut Context<'_>, a: &Arguments, number: u8, mode: i8) -> Result<(), Stop> {
    if number != MOTION_OUTPUT {
        let message = format!("state must be 0 or 1, not {mode}");
        let hint = "-1 to -4 are modes of output 4";
        return Err(c.fail_at(a.span(1), Code::OutOfRange, message, hint));
    }
    c.settle()?;
    c.change_settings(|s| s.io.output4 = mode);
    Ok(())
}

/// Returns `true` if everything is only drawn.
fn draws(c: &Context<'_>) -> bool {
    c.core.options.preview || c.settings().mode == Mode::Preview
}

/// The spindle starts only when the operator says so, unless it counts as active.
fn ask_spindle(c: &mut Context<'_>) -> Result<(), Stop> {
    let active = c.host.stored(SPINDLE_STATUS).is_some_and(|v| v.trim() == "1");
    if active || draws(c) || !c.settings().ask_spindle {
        return Ok(());
    }
    let buttons = [Button::OK, Button::Cancel];
    let question =
        questions::question(c, QuestionKind::Spindle, "The spindle is about to start.", &buttons);
    questions::confirm(c, &question)?;
    c.host.store(SPINDLE_STATUS, Some("1"));
    Ok(())
}

/// Gives the speed of a spindle to its device, or asks the operator to set it.
pub(super) fn spindle_speed(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let (number, rpm) = (a.whole(1).unwrap_or(1) as u8, a.number_or(0, 0.0));
    if !c.settings().spindle_device && !draws(c) {
        let text = format!("Set spindle {number} to {} rpm.", format_number(rpm));
        let question =
            questions::question(c, QuestionKind::Spindle, &text, &[Button::OK, Button::Cancel]);
        questions::confirm(c, &question)?;
    }
    c.emit(Command::EndStack);
    c.emit(Command::Spindle { number, rpm });
    Ok(())
}
