//! Holds, tool changes and ends of a program.

use super::call::{call, leave_call};
use super::calls::CallKind;
use super::compensate::end_compensation;
use super::context::Context;
use super::spindle::{set_coolant, turn_spindle};
use super::state::Modal;
use super::stop::Stop;
use crate::syntax::codes::{STOP, TOOL};
use crate::syntax::gathered::Gathered;
use crate::syntax::tree::Label;
use kerf_program::{Command, QuestionKind, SpindleTurn, ToolPathStart};

/// M6, M61.
pub(super) fn tool_change(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    match g.m[TOOL] {
        Some(6) => {
            c.core.place.need_uncompensated("a tool change")?;
            change_tool(c)
        }
        Some(_) => {
            c.core.state.tool = g.tool(b'Q').unwrap_or_default();
            Ok(())
        }
        None => Ok(()),
    }
}

/// Before the operator reaches into the machine the spindle stands: that is carried out first,
/// then the block is read again.
pub(super) fn begin_tool_change(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let core = &mut *c.core;
    let changes = g.m[TOOL] == Some(6) && core.place.compensator.is_none();
    if !changes || std::mem::replace(&mut core.under_way.changing, true) {
        return Ok(());
    }
    // Behind a tool change the program goes on from where the tool really is.
    core.place.arrive(core.place.tool());
    turn_spindle(c, SpindleTurn::Off);
    let tool = g.tool(b'T').unwrap_or(c.core.state.selected);
    if tool != c.core.state.tool && changes_elsewhere(c, tool) {
        c.core.under_way.due_tool = Some(tool);
    } else if tool != c.core.state.tool {
        c.emit(Command::ToolChange { begin: true });
    }
    Err(Stop::Again)
}

/// Returns `true` if whoever owns the run puts a tool in. Taking one out is asked for here.
const fn changes_elsewhere(c: &Context<'_>, tool: u32) -> bool {
    c.core.options.changes_elsewhere && tool > 0
}

fn change_tool(c: &mut Context<'_>) -> Result<(), Stop> {
    let tool = c.core.state.selected;
    if tool != c.core.state.tool && !changes_elsewhere(c, tool) {
        let text = match tool {
            0 => "take the tool out".into(),
            _ => format!("put in tool {}", c.core.state.tool_table().asked_for(tool)),
        };
        c.hold_for(QuestionKind::Pause, &text, None)?;
        c.emit(Command::ToolChange { begin: false });
    }
    c.core.under_way.changing = false;
    c.core.state.tool = tool;
    if tool > 0 {
        let tool = Some(format!("T{tool}").into());
        c.emit(Command::ToolPath(ToolPathStart { name: None, tool }));
    }
    Ok(())
}

/// M0, M1, M2, M30, M60, M98, M99.
pub(super) fn stop(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    match g.m[STOP] {
        Some(0) => holds_after(c, "program stop (M0)"),
        Some(60) => holds_after(c, "program stop (M60)"),
        Some(1) if c.core.options.optional_stop => holds_after(c, "optional stop (M1)"),
        Some(2 | 30) => end_program(c),
        Some(98) => call_numbered(c, g)?,
        Some(99) => leave_numbered(c),
        _ => {}
    }
    Ok(())
}

/// The block holds the program when all else of it is done: what moves in it is made before anybody is
/// asked.
fn holds_after(c: &mut Context<'_>, text: &str) {
    let text = message_above(c).unwrap_or_else(|| text.into());
    c.core.under_way.holding = Some(text);
}

/// Holds behind a block that was carried out.
pub(super) fn hold(c: &mut Context<'_>, text: &str) -> Result<(), Stop> {
    let held = c.hold_at_once(text);
    if !matches!(held, Err(Stop::Waiting)) {
        c.core.under_way.holding = None;
    }
    held
}

/// The message in this line, for the box that M0 opens.
fn message_above(c: &Context<'_>) -> Option<String> {
    let of_block = c.out.iter().rev().take_while(|s| s.at == c.at);
    let mut said = of_block.filter_map(|s| match &s.command {
        Command::Message { text } if !text.is_empty() => Some(text.to_string()),
        _ => None,
    });
    said.next()
}

/// M2, M30: the machine is left as a program should leave it.
fn end_program(c: &mut Context<'_>) {
    end_compensation(c);
    turn_spindle(c, SpindleTurn::Off);
    set_coolant(c, false, false);
    let modal = &mut c.core.state.modal;
    let kept = (modal.unit, modal.unit_said, modal.rpm, modal.return_to_r);
    *modal = Modal::default();
    (modal.unit, modal.unit_said, modal.rpm, modal.return_to_r) = kept;
    c.core.sequels.cycle = None;
    c.relocate();
    c.core.progress.over = true;
}

/// M98 P… L…
fn call_numbered(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let times = g.get(b'L').map_or(1, |l| l as u64);
    if times == 0 {
        return Ok(());
    }
    let label = Label::Number(g.or_zero(b'P') as u32);
    call(c, &label, CallKind::Fanuc { again: times - 1, first: 0 }, Vec::new())
}

/// M99: back, or the whole program again.
fn leave_numbered(c: &mut Context<'_>) {
    if c.core.calls.is_inside() {
        leave_call(c, None);
    } else {
        c.core.calls.go_on_at(0);
    }
}
