//! Spindle and coolant.

use super::context::Context;
use super::stop::{Stop, fail};
use crate::syntax::codes::{COOLANT, MIST, SPINDLE};
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::{Command, QuestionKind, SPINDLE_STATUS, SpindleTurn};

/// The spindle that M3 … M5 speak of.
pub(super) const SPINDLE_NUMBER: u8 = 1;

/// S: told when it changes.
pub(super) fn take_speed(c: &mut Context<'_>, g: &Gathered) {
    // S beside G4 is a time on some controllers; it is a speed here.
    if let Some(rpm) = g.get(b'S') {
        set_speed(c, rpm);
    }
}

/// Sets the speed of the spindle, and tells it when it changes.
pub(super) fn set_speed(c: &mut Context<'_>, rpm: f64) {
    if rpm != c.core.state.modal.rpm {
        c.core.state.modal.rpm = rpm;
        c.emit(Command::Spindle { number: SPINDLE_NUMBER, rpm });
    }
}

/// M3, M4, M5.
pub(super) fn spindle(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let turn = match g.m[SPINDLE] {
        Some(3) => SpindleTurn::Clockwise,
        Some(4) if c.core.options.laser => SpindleTurn::Dynamic,
        Some(4) => SpindleTurn::Counterclockwise,
        Some(5) => SpindleTurn::Off,
        Some(_) => {
            let hint = "the spindle here cannot stop at an angle";
            return Err(fail(Code::NotSupported, "M19 cannot be carried out", hint));
        }
        None => return Ok(()),
    };
    ask_spindle(c, turn)?;
    turn_spindle(c, turn);
    Ok(())
}

/// The spindle starts only when the operator says so, unless it counts as active.
fn ask_spindle(c: &mut Context<'_>, turn: SpindleTurn) -> Result<(), Stop> {
    if !c.core.would_ask_spindle(turn) {
        return Ok(());
    }
    if c.host.stored(SPINDLE_STATUS).is_some_and(|v| v.trim() == "1") {
        return Ok(());
    }
    c.hold_for(QuestionKind::Spindle, "The spindle is about to start.", None)?;
    c.host.store(SPINDLE_STATUS, Some("1"));
    Ok(())
}

/// Turns the spindle and the output that follows it.
pub(super) fn turn_spindle(c: &mut Context<'_>, turn: SpindleTurn) {
    let before = std::mem::replace(&mut c.core.state.modal.turn, turn);
    if before != turn {
        c.emit(Command::SpindleTurn { number: SPINDLE_NUMBER, turn });
    }
    let (on, number) = (turn != SpindleTurn::Off, c.core.options.spindle_output);
    if number > 0 && on != (before != SpindleTurn::Off) {
        c.emit(Command::Output { number, on });
    }
}

/// M7, M8, M9.
pub(super) fn coolant(c: &mut Context<'_>, g: &Gathered) {
    let modal = &c.core.state.modal;
    let mut wanted = (modal.mist, modal.flood);
    if g.m[COOLANT] == Some(9) {
        wanted = (false, false);
    }
    if g.m[MIST].is_some() {
        wanted.0 = true;
    }
    if g.m[COOLANT] == Some(8) {
        wanted.1 = true;
    }
    set_coolant(c, wanted.0, wanted.1);
}

/// Switches the coolants, and tells it when one changes.
pub(super) fn set_coolant(c: &mut Context<'_>, mist: bool, flood: bool) {
    let modal = &mut c.core.state.modal;
    if (modal.mist, modal.flood) != (mist, flood) {
        (modal.mist, modal.flood) = (mist, flood);
        c.emit(Command::Coolant { mist, flood });
    }
}
