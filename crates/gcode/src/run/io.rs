//! M62 … M68: outputs, inputs.

use super::context::Context;
use super::parameters::ANSWER;
use super::stop::{Refused, Stop, fail};
use crate::syntax::codes::IO;
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::settings::SWITCHES;
use kerf_program::{Command, QuestionKind};

/// M62 … M68.
pub(super) fn inputs_and_outputs(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    match g.m[IO] {
        // M62 and M63 change with the next motion, M64 and M65 at once; what goes on does so between moves
        // either way, and what goes off where the machine stands.
        Some(code @ 62..=65) => {
            let number = switch(g.or_zero(b'P'))?;
            c.emit(Command::Output { number, on: code % 2 == 0 });
            Ok(())
        }
        Some(66) => wait_for_input(c, g),
        // M67 changes with the next motion, which goes on through it; M68 at once, where the machine stands.
        Some(code @ (67 | 68)) => {
            let channel = switch(g.or_zero(b'E'))?;
            if code == 68 {
                c.settle()?;
            }
            let percent = g.or_zero(b'Q').clamp(0.0, 100.0);
            c.emit(Command::Pwm { channel, percent });
            Ok(())
        }
        _ => Ok(()),
    }
}

/// The number here, from 1, of a switch that G-code counts from 0.
fn switch(number: f64) -> Result<u8, Refused> {
    if number.fract() == 0.0 && (0.0..SWITCHES as f64).contains(&number) {
        return Ok(number as u8 + 1);
    }
    let hint = format!("they are numbered 0 to {}", SWITCHES - 1);
    Err(fail(Code::OutOfRange, format!("there is no input or output {number}"), hint))
}

/// M66: L0 reads, L1 waits for the rise, L2 for the fall, L3 for on, L4 for off.
fn wait_for_input(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let Some(p) = g.get(b'P') else {
        let hint = "P reads a switch";
        return Err(fail(Code::NotSupported, "there are no analog inputs to wait for", hint));
    };
    let number = switch(p)?;
    let mode = g.or_zero(b'L');
    c.settle()?;
    let on = c.host.input(number);
    let wanted = match mode {
        0.0 => {
            answer(c, f64::from(u8::from(on)));
            return Ok(());
        }
        1.0 | 3.0 => true,
        2.0 | 4.0 => false,
        _ => {
            let message = format!("M66 L{mode} is not known");
            return Err(fail(Code::OutOfRange, message, "L is 0 to 4"));
        }
    };
    if on != wanted {
        let state = if wanted { "on" } else { "off" };
        let text = format!("waiting until input {number} is {state}");
        c.hold_for(QuestionKind::Pause, &text, Some((number, wanted)))?;
    }
    answer(c, 1.0);
    Ok(())
}

fn answer(c: &mut Context<'_>, value: f64) {
    c.core.state.parameters.insert(ANSWER, value);
}
