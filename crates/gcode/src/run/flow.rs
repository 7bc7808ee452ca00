//! O-words: subroutines, branches, loops.

use super::call::{call, leave_call};
use super::calls::{CallKind, Calls, LOCALS};
use super::context::Context;
use super::core::Core;
use super::expression::evaluate;
use super::stop::{Stop, fail};
use crate::syntax::gathered::Fault;
use crate::syntax::tree::{Flow, Keyword, Label, Node, Program};
use kerf_diag::Code;

/// Carries out an O-word that has the partner it needs.
pub(super) fn flow(c: &mut Context<'_>, program: &Program, flow: &Flow) -> Result<(), Stop> {
    match flow.keyword {
        // A definition met on the way is passed by.
        Keyword::Sub => c.core.calls.go_on_at(flow.target),
        Keyword::Endsub | Keyword::Return => return return_with(c, program, flow),
        Keyword::Call => return call_flow(c, program, flow),
        Keyword::If => {
            if !holds(c.core, program, flow)? {
                return next_branch(c, program, flow.target);
            }
        }
        // Met at the end of the branch that was taken.
        Keyword::Elseif | Keyword::Else => c.core.calls.go_on_at(flow.end),
        Keyword::While => {
            if !holds(c.core, program, flow)? {
                c.core.calls.go_on_at(flow.target);
            }
        }
        Keyword::Endwhile => c.core.calls.go_on_at(flow.target - 1),
        Keyword::DoWhile => {
            if holds(c.core, program, flow)? {
                c.core.calls.go_on_at(flow.target);
            }
        }
        Keyword::Repeat => repeat(c, program, flow)?,
        Keyword::Endrepeat => end_turn(&mut c.core.calls, flow.target),
        Keyword::Break => leave_loop(&mut c.core.calls, flow),
        Keyword::Continue => next_turn(&mut c.core.calls, program, flow),
        Keyword::Do | Keyword::Endif | Keyword::Program => {}
    }
    Ok(())
}

fn value(core: &Core, program: &Program, flow: &Flow) -> Result<f64, Fault> {
    match flow.values.first() {
        Some(expr) => evaluate(&core.parameters(), program, expr, flow.span),
        None => Ok(0.0),
    }
}

fn holds(core: &Core, program: &Program, flow: &Flow) -> Result<bool, Fault> {
    Ok(value(core, program, flow)? != 0.0)
}

/// Looks for the branch to take from a line on: `elseif`, `else` or `endif`.
fn next_branch(c: &mut Context<'_>, program: &Program, mut line: u32) -> Result<(), Stop> {
    while let Some(flow) = flow_at(program, line) {
        let taken = match flow.keyword {
            Keyword::Elseif => holds(c.core, program, flow)?,
            _ => true,
        };
        if taken {
            break;
        }
        line = flow.target;
    }
    c.core.calls.go_on_at(line);
    Ok(())
}

fn repeat(c: &mut Context<'_>, program: &Program, flow: &Flow) -> Result<(), Stop> {
    let times = value(c.core, program, flow)?.round_ties_even().max(0.0) as u64;
    if times == 0 {
        c.core.calls.go_on_at(flow.target);
    } else if let Some(call) = c.core.calls.open.last_mut() {
        call.loops.retain(|(line, _)| *line != c.at.line);
        call.loops.push((c.at.line, times - 1));
    }
    Ok(())
}

/// The end of a turn of the counted loop that begins at a line.
fn end_turn(calls: &mut Calls, line: u32) {
    let Some(call) = calls.open.last_mut() else { return };
    let Some(at) = call.loops.iter().rposition(|(l, _)| *l == line) else { return };
    if call.loops[at].1 == 0 {
        call.loops.truncate(at);
        return;
    }
    call.loops[at].1 -= 1;
    call.next = line;
}

fn leave_loop(calls: &mut Calls, flow: &Flow) {
    if let Some(call) = calls.open.last_mut() {
        call.loops.retain(|(line, _)| *line != flow.target);
    }
    calls.go_on_at(flow.end);
}

fn next_turn(calls: &mut Calls, program: &Program, flow: &Flow) {
    match flow_at(program, flow.target).map(|f| f.keyword) {
        Some(Keyword::While) => calls.go_on_at(flow.target - 1),
        // The last line decides whether there is another turn.
        _ => calls.go_on_at(flow.end - 1),
    }
}

fn call_flow(c: &mut Context<'_>, program: &Program, flow: &Flow) -> Result<(), Stop> {
    let mut values = Vec::with_capacity(LOCALS);
    for expr in &flow.values {
        values.push(evaluate(&c.core.parameters(), program, expr, flow.span)?);
    }
    let label = match (&flow.label, &flow.computed) {
        (Some(label), _) => label.clone(),
        (None, Some(expr)) => Label::Number(
            evaluate(&c.core.parameters(), program, expr, flow.span)?.round().max(0.0) as u32,
        ),
        (None, None) => return Ok(()),
    };
    call(c, &label, CallKind::Sub, values)
}

fn return_with(c: &mut Context<'_>, program: &Program, flow: &Flow) -> Result<(), Stop> {
    let value = match flow.values.first() {
        Some(expr) => Some(evaluate(&c.core.parameters(), program, expr, flow.span)?),
        None => None,
    };
    if c.core.calls.is_inside() {
        leave_call(c, value);
        return Ok(());
    }
    // An endsub that is run into without a call: the definition is just text.
    if flow.keyword == Keyword::Return {
        return Err(fail(Code::BadFlow, "return outside a subroutine", "M2 or M30 ends a program"));
    }
    Ok(())
}

/// Returns `true` if an O-word has the partner it needs; the reader told where it has not.
pub(super) fn is_linked(flow: &Flow) -> bool {
    match flow.keyword {
        Keyword::Elseif | Keyword::Else | Keyword::Break | Keyword::Continue => flow.end > 0,
        Keyword::Sub
        | Keyword::If
        | Keyword::While
        | Keyword::Endwhile
        | Keyword::DoWhile
        | Keyword::Repeat
        | Keyword::Endrepeat => flow.target > 0,
        _ => true,
    }
}

fn flow_at(program: &Program, line: u32) -> Option<&Flow> {
    let node = program.line(line)?.node();
    let Node::Block(index) = node else { return None };
    let block = program.blocks.get(index as usize)?;
    program.extra_of(block)?.flow.as_ref()
}
