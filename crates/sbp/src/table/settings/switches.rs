//! Limit checking, outputs, the warning before motion, the spindle.

use crate::format_number;
use crate::interp::{Arguments, Context, SPINDLE_STATUS, Stop};
use crate::table::setting::{flag, real, set};
use crate::table::{Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit};
use kerf_diag::Code;
use kerf_program::settings::Mode;
use kerf_program::{Button, Command, QuestionKind, SPINDLE_OUTPUT};

static LIMITS: [ParamSpec; 1] = [{
    let mut value = ParamSpec::of("Value", Kind::OneOf(&[0, 1]), flag!(limits.check));
    value.default = crate::table::Default::Required;
    value.about("1 on, 0 off.")
}];

pub(super) static SF: CommandSpec = CommandSpec::new(
    "SF",
    "Set limit checking",
    Group::Settings,
    &LIMITS,
    Stack::Ends,
    "Whether moves that would leave the table limits of VL are stopped before they begin. In a part \
     file it goes back at its end, unless SV keeps it.",
    |c, a| {
        set(c, a, &LIMITS);
        Ok(())
    },
);

static WARNING: [ParamSpec; 1] =
    [ParamSpec::of("Duration", Kind::Number(Unit::Seconds), real!(warning_s))
        .within(Bound::NotNegative)
        .special()
        .about("Seconds; 0 is none. Blank is what held when the file began.")];

pub(super) static SW: CommandSpec = CommandSpec::new(
    "SW",
    "Set warning duration",
    Group::Settings,
    &WARNING,
    Stack::Ends,
    "How long light and sound warn before motion starts.",
    |c, a| {
        if a.given(0) {
            set(c, a, &WARNING);
        } else {
            // Shipped files keep the duration from a system variable that is empty here, and give
            // it back with SW.
            let before = c.core.kept.warning_s;
            c.change_settings(|s| s.warning_s = before);
        }
        Ok(())
    },
);

pub(super) static SO: CommandSpec = CommandSpec::new(
    "SO",
    "Set output switch",
    Group::Settings,
    &[
        ParamSpec::required("Switch number", Kind::Whole).within(Bound::Range(1.0, 12.0)),
        ParamSpec::number("State", Kind::OneOf(&[0, 1, -1, -2, -3, -4]), 0.0).about(
            "1 on, 0 off. Output 4 only: -1 on during motion, -2 also off at a stop, -3 also off at a \
             stall, -4 free.",
        ),
    ],
    Stack::Joins,
    "Switches an output. On goes with the stack of moves, off ends it. Starting the spindle (output \
     1) asks first, unless it is active already, in preview, or when the settings say not to. It is \
     active from the answer on, or by SetSpindleStatus, until a stop or the end of a run that leaves \
     it off.",
    output,
);

/// Output with modes of its own, and the mode that frees it.
const MOTION_OUTPUT: u8 = 4;
const FREE: i8 = -4;

fn output(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
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
    let question = c.question(QuestionKind::Spindle, "The spindle is about to start.", &buttons);
    c.confirm(&question)?;
    c.host.store(SPINDLE_STATUS, Some("1"));
    Ok(())
}

pub(super) static TR: CommandSpec = CommandSpec::new(
    "TR",
    "Spindle speed",
    Group::Tools,
    &[
        ParamSpec::required("Speed", Kind::Number(Unit::None))
            .within(Bound::NotNegative)
            .about("Revolutions a minute."),
        ParamSpec::number("Spindle", Kind::Whole, 1.0).within(Bound::Range(1.0, 9.0)),
    ],
    Stack::Ends,
    "Sets the speed of a spindle. Without a device for it (`spindle_device`) the operator is asked to set \
     it. CAM programs \
     write it; the reference does not have it.",
    spindle_speed,
);

fn spindle_speed(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let (number, rpm) = (a.whole(1).unwrap_or(1) as u8, a.number_or(0, 0.0));
    if !c.settings().spindle_device && !draws(c) {
        let text = format!("Set spindle {number} to {} rpm.", format_number(rpm));
        let question = c.question(QuestionKind::Spindle, &text, &[Button::OK, Button::Cancel]);
        c.confirm(&question)?;
    }
    c.emit(Command::EndStack);
    c.emit(Command::Spindle { number, rpm });
    Ok(())
}
