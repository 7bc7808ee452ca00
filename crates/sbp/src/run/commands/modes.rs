//! Modes, and what becomes of locations, variables and values.

use super::outputs;
use super::setting::set;
use crate::run::locate;
use crate::run::preview;
use crate::run::questions;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::act::Mode as Act;
use kerf_diag::Code;
use kerf_program::settings::{LinearUnit, Mode};
use kerf_program::{AxisSet, Button, Command, QuestionKind};

/// Carries a command of the session out.
pub(super) fn run(c: &mut Context<'_>, act: Act, a: &Arguments) -> Result<(), Stop> {
    match act {
        Act::Distance(distance) => c.change_settings(|s| s.distance = distance),
        Act::MoveCut => return move_cut(c),
        Act::Preview if c.settings().mode == Mode::Preview => c.emit(Command::ClearPreview),
        Act::Preview => preview::enter_preview(c),
        Act::Coordinates if a.flag(0) == Some(true) => locate::use_working_locations(c),
        Act::Coordinates => locate::use_table_base(c),
        Act::Unit => unit(c, a),
        Act::ClearVariables => c.core.memory.variables.clear(),
        Act::KeepValues => return keep_values(c),
        Act::EndStack => return end_stack(c, a),
        Act::Warning => warning(c, a),
        Act::Output => return outputs::switch(c, a),
        Act::SpindleSpeed => return outputs::spindle_speed(c, a),
        Act::SendLines => {
            let hint = "a file has no need of it: write the lines here";
            return Err(c.fail_at(c.span, Code::NotSupported, "SI needs the console", hint));
        }
        Act::Keypad => return keypad(c, a),
    }
    Ok(())
}

fn move_cut(c: &mut Context<'_>) -> Result<(), Stop> {
    if c.core.options.draws_only {
        let hint = "arm the machine before this is started";
        let message = "SM leaves preview, and the machine was not armed when this began";
        return Err(c.fail_at(c.span, Code::NotEnabled, message, hint));
    }
    preview::leave_preview(c);
    if !c.core.options.preview && !c.host.is_connected() {
        let text = "not connected: nothing moves; SP shows files in preview".into();
        c.emit(Command::Message { text });
    }
    Ok(())
}

/// Words that SU takes for inches.
const INCHES: [&str; 4] = ["0", "IN", "INCH", "INCHES"];

fn unit(c: &mut Context<'_>, a: &Arguments) {
    let inches = a.text(0).is_some_and(|word| INCHES.contains(&&*word));
    let unit = if inches { LinearUnit::Inch } else { LinearUnit::Mm };
    c.change_settings(|s| s.use_linear_unit(unit));
}

/// The values that would go back at the end of the file stay as they are now.
fn keep_values(c: &mut Context<'_>) -> Result<(), Stop> {
    if c.core.options.typed {
        let hint = "values set at the keyboard stay anyway";
        return Err(c.fail_at(c.span, Code::OnlyInFiles, "SV works only in part files", hint));
    }
    if c.core.options.protected {
        let hint = "give the password of the settings with the run";
        let message = "the settings are protected: these values end with the file";
        c.warn(Code::KeptProtected, message, hint);
        return Ok(());
    }
    c.core.values.kept = c.core.values.settings.clone();
    Ok(())
}

fn end_stack(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    if a.whole(0) != Some(2) {
        return Err(c.fail_at(a.span(0), Code::OutOfRange, "only SC,2 is defined", ""));
    }
    c.emit(Command::EndStack);
    Ok(())
}

fn warning(c: &mut Context<'_>, a: &Arguments) {
    if a.given(0) {
        return set(c, a);
    }
    // Shipped files keep the duration from a system variable that is empty here, and give it back with SW.
    let before = c.core.values.kept.warning_s;
    c.change_settings(|s| s.warning_s = before);
}

fn keypad(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    if c.core.options.preview || c.settings().mode == Mode::Preview {
        c.emit(Command::Message { text: "The keypad does not open in preview.".into() });
        return Ok(());
    }
    let text = a.text(0).unwrap_or_default();
    let question = questions::question(c, QuestionKind::Keypad, &*text, &[Button::OK]);
    c.ask(&question)?;
    locate::take_machine_position(c, AxisSet::first(6));
    if c.settings().display.keypad_auto_off {
        for number in 1..=12 {
            if c.host.output(number) {
                c.emit(Command::Output { number, on: false });
            }
        }
    }
    Ok(())
}
