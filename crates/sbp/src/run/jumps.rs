//! GOTO, GOSUB and RETURN: jumps within a file.

use super::state::Purpose;
use super::{Context, Stop, levels};
use crate::syntax::tree::Target;
use kerf_diag::Code;

/// GOSUBs within each other at most, in one file.
const MOST_GOSUBS: usize = 10_000;
/// The oldest GOSUBs that are forgotten then, where programs leave them by GOTO and never return.
const FORGOTTEN_GOSUBS: usize = 1_000;

/// Goes to a label of this file.
pub(super) fn jump(c: &mut Context<'_>, target: &Target) -> Result<(), Stop> {
    let line = label_line(c, target)?;
    if let Some(level) = c.core.flow.levels.last_mut() {
        level.next = line;
        level.gosub_left |= !level.gosubs.is_empty();
    }
    Ok(())
}

pub(super) fn label_line(c: &Context<'_>, target: &Target) -> Result<u32, Stop> {
    c.program.line_of(target).ok_or_else(|| {
        let name = c.program.label_name(target.label);
        let message = format!("label {name} not found");
        c.fail_at(
            target.span,
            Code::LabelNotFound,
            message,
            "a label is a name alone on a line, ending in a colon",
        )
    })
}

pub(super) fn gosub(c: &mut Context<'_>, target: &Target) -> Result<(), Stop> {
    let line = label_line(c, target)?;
    call_sub(c, line)
}

/// Goes to a line of the innermost file; RETURN comes back to the one that would be next.
pub(super) fn call_sub(c: &mut Context<'_>, line: u32) -> Result<(), Stop> {
    let Some(level) = c.core.flow.levels.last_mut() else { return Ok(()) };
    let deep = level.gosubs.len() >= MOST_GOSUBS;
    if deep && level.gosub_left {
        level.gosubs.drain(..FORGOTTEN_GOSUBS);
    } else if deep {
        let message = format!("GOSUB nested deeper than {MOST_GOSUBS}");
        return Err(c.fail(Code::NestedTooDeep, message));
    }
    if let Some(level) = c.core.flow.levels.last_mut() {
        level.gosubs.push(level.next);
        level.next = line;
    }
    Ok(())
}

pub(super) fn return_from_sub(c: &mut Context<'_>) -> Result<(), Stop> {
    let Some(level) = c.core.flow.levels.last_mut() else { return Ok(()) };
    if let Some(line) = level.gosubs.pop() {
        level.next = line;
        return Ok(());
    }
    if matches!(level.purpose, Purpose::Handler(_)) {
        levels::leave_levels(c, c.core.flow.levels.len() - 1);
        return Ok(());
    }
    // What was read before it is complete, as at the end of a file, and is carried out.
    c.settle()?;
    let hint = "put END before the first subroutine of the file";
    Err(c.fail_at(c.span, Code::ReturnWithoutGosub, "RETURN without GOSUB", hint))
}
