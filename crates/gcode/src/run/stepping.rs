//! A file that is gone through line by line, or taken up in the middle.
//!
//! ```text
//!  ask ─┬─ Step: this line runs, ask again        go to N ─► lines before N are passed over, all
//!       ├─ Run: from here on without asking                  of them or only what they set up
//!       └─ Quit: the run ends
//! ```
//!
//! The question is a step of its own: its answer is kept until the line has run, because a line may
//! have to wait.

use super::block::{assign, gather};
use super::context::Context;
use super::execute::execute;
use super::expression::evaluate_settings;
use super::stop::{Stop, fail};
use crate::syntax::codes::{
    ARC_DISTANCE, DISTANCE, FEED_MODE, MOTION, PATH, PLANE, RETURN, SYSTEM, TOOL_LENGTH, UNITS,
};
use crate::syntax::gathered::Gathered;
use crate::syntax::tree::{Block, Node, Program};
use kerf_diag::Code;
use kerf_program::{GoTo, Question, Status, StepChoice};

/// The modes that lines set up for those behind them. Zeros (G10, G92), tools, spindle, outputs
/// and cutter compensation are not among them: they do something.
const MODES: [usize; 9] =
    [PLANE, DISTANCE, ARC_DISTANCE, FEED_MODE, UNITS, RETURN, SYSTEM, PATH, TOOL_LENGTH];

/// Begins at the line that the options name.
pub(super) fn begin_at(c: &mut Context<'_>) -> Result<(), Stop> {
    match c.core.options.from.take() {
        Some(to) => go_to(c, to),
        None => Ok(()),
    }
}

/// Asks about a line, or passes over it; false when it is to run.
pub(super) fn steps_over(c: &mut Context<'_>, program: &Program, node: Node) -> Result<bool, Stop> {
    if c.core.progress.stepping.is_off() {
        return Ok(false);
    }
    if let Some(to) = c.core.progress.stepping.skip_to {
        if c.at.line <= to {
            // Behind a mistake too, so that a check comes to its end.
            c.core.calls.go_on_at(c.at.line);
            set_up(c, program, node)?;
            return Ok(true);
        }
        c.core.progress.stepping.skip_to = None;
    }
    let stepping = c.core.progress.stepping;
    if !stepping.asks || stepping.granted || node == Node::Blank {
        return Ok(false);
    }
    ask_step(c, program)?;
    Ok(true)
}

fn ask_step(c: &mut Context<'_>, program: &Program) -> Result<(), Stop> {
    let last = c.host.last_line(&program.name);
    let question = Question::of_step(&program.name, program.line_text(c.at.line), last);
    match StepChoice::of(&c.ask_at_once(&question)?, last) {
        StepChoice::Once => c.core.progress.stepping.granted = true,
        StepChoice::RunOn => c.core.progress.stepping.asks = false,
        StepChoice::Quit => return Err(Stop::Finished(Status::Stopped)),
        StepChoice::GoTo(to) => go_to(c, to)?,
        StepChoice::Again => {}
    }
    Ok(())
}

fn go_to(c: &mut Context<'_>, to: GoTo) -> Result<(), Stop> {
    let program = c.program();
    if let Some((message, hint)) = to.beyond(&program.name, program.line_count()) {
        c.warn(Code::OutOfRange, message, hint);
        return Ok(());
    }
    if c.core.calls.open.len() == 1 && program.is_in_subroutine(to.line) {
        let message = format!("line {} lies in a subroutine", to.line);
        return Err(fail(Code::BadFlow, message, "begin at a line that calls it"));
    }
    let call = c.core.calls.open.last_mut();
    let (next, skip_to) = to.way_from(call.as_ref().map_or(0, |call| call.next));
    call.into_iter().for_each(|call| call.next = next);
    c.core.progress.stepping.skip_to = skip_to;
    Ok(())
}

/// Carries out what a line sets up for those behind it: modes, feed, speed, parameters.
fn set_up(c: &mut Context<'_>, program: &Program, node: Node) -> Result<(), Stop> {
    match node {
        Node::Move => {
            let plain = program.move_of(c.at.line).unwrap_or_default();
            set_modes(c, &Gathered::of_move(&plain))
        }
        Node::Block(index) => match program.blocks.get(index as usize) {
            Some(block) => set_up_block(c, program, *block),
            None => Ok(()),
        },
        _ => Ok(()),
    }
}

fn set_up_block(c: &mut Context<'_>, program: &Program, block: Block) -> Result<(), Stop> {
    let extra = program.extra_of(&block);
    if block.delete > 0 && block.delete <= c.core.options.block_delete
        || extra.is_some_and(|e| e.flow.is_some())
    {
        return Ok(());
    }
    let gathered = gather(c.core, program, &block, c.span)?;
    let settings = match extra {
        Some(extra) => evaluate_settings(&c.core.parameters(), program, &extra.settings)?,
        None => Vec::new(),
    };
    set_modes(c, &gathered)?;
    assign(c, program, settings)
}

fn set_modes(c: &mut Context<'_>, all: &Gathered) -> Result<(), Stop> {
    execute(c, &all.only(&MODES, b"FST"))?;
    if let Some(motion @ (0 | 10 | 20 | 30)) = all.g[MOTION] {
        c.core.state.modal.motion = Some(motion);
    }
    Ok(())
}
