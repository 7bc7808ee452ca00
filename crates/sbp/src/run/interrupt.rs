//! ON INPUT: arming handlers, and what happens when one fires.
//!
//! The machine watches the inputs of the armed handlers while it moves. When one changes it stops,
//! drops what it had not begun, and tells [`Interpreter::interrupt`](super::Interpreter::interrupt),
//! which goes back to the state right behind the interrupted move. The handler's action then runs
//! as if it stood there.

use super::state::Handler;
use super::state::{Level, Purpose};
use super::{Context, Core, Stop, eval, jumps, levels, pauses, statements};
use crate::tree::{Node, Program, Statement, Target};
use crate::{Expr, Value};
use kerf_diag::Code;
use kerf_program::Axes;
use kerf_program::Watch;

/// Takes the machine's position over and queues the handler's action; the handler is disarmed.
///
/// A handler ends with the outermost file: what arrives after its last move was made is ignored.
pub(super) fn arrive(core: &mut Core, watch: &Watch, position: Axes) {
    if core.flow.levels.is_empty() {
        return;
    }
    core.place.position = position;
    core.given.settled = true;
    // Moves that were still in the tab filter lie behind the interruption and are dropped.
    if let Some(tabs) = core.cutting.tabs.as_mut() {
        tabs.drop_buffered();
    }
    if let Some(index) = core.handlers.watches.iter().position(|h| h.watch == *watch) {
        let handler = core.handlers.watches.remove(index);
        core.handlers.fired.push(handler);
        core.answers.forget();
    }
}

/// ON INPUT arms a handler, or disarms it when no action is given.
pub(super) fn on_input(
    c: &mut Context<'_>,
    switch: &Expr,
    state: &Expr,
    armed: bool,
) -> Result<(), Stop> {
    if !armed && eval::eval(c, switch)? == Value::Empty {
        nothing_to_disarm(c, switch);
        return Ok(());
    }
    let watch = watch(c, switch, state)?;
    c.settle()?;
    c.core.handlers.watches.retain(|h| h.watch != watch);
    if armed {
        let level = c.core.flow.levels.len();
        c.core.handlers.watches.push(Handler { watch, at: c.at, level, probe: false });
    }
    Ok(())
}

/// Files tidy up with a variable that they never set: nothing was armed with it either.
fn nothing_to_disarm(c: &mut Context<'_>, switch: &Expr) {
    let message = format!("{} has no value: no ON INPUT is ended", eval::spelled(c, switch.span));
    c.span = switch.span;
    c.warn(Code::Unusual, message, "name the switch that is no longer watched");
}

fn watch(c: &mut Context<'_>, switch: &Expr, state: &Expr) -> Result<Watch, Stop> {
    let input = pauses::switch_number(c, switch)?;
    let condition = eval::eval_number(c, state)?;
    let known = [(0.0, false, false), (1.0, true, false), (2.0, false, true), (3.0, true, true)];
    match known.into_iter().find(|(number, ..)| *number == condition) {
        Some((_, on, ramped)) => Ok(Watch::change(input, on, ramped)),
        None => {
            let shown = Value::Number(condition).display();
            let message = format!("condition must be 0, 1, 2 or 3, not {shown}");
            let hint = "1 on, 0 off, 3 on with a ramped stop, 2 off with a ramped stop";
            Err(c.fail_at(state.span, Code::OutOfRange, message, hint))
        }
    }
}

/// Runs the action of the ON INPUT line at `c.at`, which was armed at a depth of files.
pub(super) fn handler_action(
    c: &mut Context<'_>,
    program: &Program,
    depth: usize,
) -> Result<(), Stop> {
    let node = program.lines.get(c.at.line.saturating_sub(1) as usize).map(|l| l.node);
    let Some(Node::Statement(index)) = node else { return Ok(()) };
    match program.statements.get(index as usize) {
        Some(Statement::OnInput { action: Some(action), .. }) => act(c, action, depth),
        _ => Ok(()),
    }
}

fn act(c: &mut Context<'_>, action: &Statement, depth: usize) -> Result<(), Stop> {
    match action {
        Statement::Gosub(target) => handler_sub(c, target, depth),
        // These belong to the handler's own file: files it called end.
        Statement::Goto(_) | Statement::Return | Statement::End => {
            need_open(c, depth)?;
            levels::leave_levels(c, depth);
            statements::execute(c, action)
        }
        other => statements::execute(c, other),
    }
}

/// GOSUB as an action: RETURN goes back to the line behind the interrupted move, even when
/// that is in a file which the handler's own file called.
fn handler_sub(c: &mut Context<'_>, target: &Target, depth: usize) -> Result<(), Stop> {
    let home = need_open(c, depth)?;
    let line = jumps::label_line(c, target)?;
    if c.core.flow.levels.len() == depth {
        return jumps::call_sub(c, line);
    }
    c.core.flow.levels.push(Level {
        next: line,
        gosubs: Vec::new(),
        gosub_left: false,
        repetitions_left: 0,
        start_z: None,
        skip_to: None,
        tabs: home.tabs_hold(),
        purpose: Purpose::Handler(depth),
        ..home
    });
    c.core.refresh_scale();
    levels::refresh_tabs(c);
    Ok(())
}

/// The handler's own file, which must still be open for its labels to mean anything.
fn need_open(c: &Context<'_>, depth: usize) -> Result<Level, Stop> {
    let level = depth.checked_sub(1).and_then(|index| c.core.flow.levels.get(index));
    level.filter(|l| l.file == c.at.file).cloned().ok_or_else(|| {
        let message = "the file of this ON INPUT is over, so its labels cannot be reached";
        let hint = "set the handler in the file that has its label";
        c.fail_at(c.span, Code::LabelNotFound, message, hint)
    })
}
