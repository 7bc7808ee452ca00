//! One line at a time.

use super::block::{assign, bad, gather};
use super::call::leave_call;
use super::calls::{Call, CallKind};
use super::comments::comments;
use super::compensate::end_compensation;
use super::context::Context;
use super::controllers::{self, need_words};
use super::core::Core;
use super::cycles::retract_by_hand;
use super::execute::execute;
use super::expression::evaluate_settings;
use super::flow::{flow, is_linked};
use super::probe::end_probe;
use super::stepping::{begin_at, steps_over};
use super::stop::{Stop, fail};
use super::stops::{begin_tool_change, hold};
use crate::syntax::dialect::Dialect;
use crate::syntax::gathered::Gathered;
use crate::syntax::tree::{Block, Node, Program, Setting, Span, Target};
use kerf_diag::{Code, Diagnostic};
use kerf_program::{At, Command, Host, Sourced, Status, Step};

/// Executes one line, or what a step is left to do of an earlier one.
pub(super) fn step(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    if !core.progress.started {
        core.progress.started = true;
        core.calls.open.push(Call::new(0, 0, CallKind::Main));
        let mut c = Context { core, host, out, at: At::default(), span: Span::default() };
        c.relocate();
        let outcome = begin_at(&mut c);
        return finish(&mut c, outcome, 0);
    }
    if core.only_is_done() && !core.progress.over {
        return Step::Done(Status::Ok, None);
    }
    let (file, next) = core.calls.next();
    let program = core.calls.program(file);
    let node = program.line(next + 1).map(|l| l.node());
    let at = At { file, line: if node.is_some() { next + 1 } else { next } };
    if node.is_some() && core.options.max_lines > 0 && core.progress.lines >= core.options.max_lines
    {
        return too_many_lines(core, host, out, at);
    }
    let given = out.len();
    let mut c = Context { core, host, out, at, span: Span::default() };
    let outcome = run_line(&mut c, &program, node);
    finish(&mut c, outcome, given)
}

/// Turns the outcome of a line into a step.
fn finish(c: &mut Context<'_>, outcome: Result<(), Stop>, given: usize) -> Step {
    match outcome {
        Ok(()) | Err(Stop::Again) => Step::Ran,
        Err(Stop::Waiting) => {
            c.out.truncate(given);
            Step::Waiting
        }
        Err(Stop::Refused(refused)) => {
            let diagnostic = c.told(*refused);
            failed(c, Box::new(diagnostic))
        }
        Err(Stop::Failed(diagnostic)) => failed(c, diagnostic),
        Err(Stop::Finished(status)) => {
            c.core.abandon();
            Step::Done(status, None)
        }
    }
}

/// A line failed: that ends the run, or is only told.
fn failed(c: &mut Context<'_>, diagnostic: Box<Diagnostic>) -> Step {
    c.core.under_way.changing = false;
    if !c.core.options.keep_going {
        c.core.abandon();
        return Step::Done(Status::Failed, Some(diagnostic));
    }
    c.core.told.motion_lost = true;
    c.emit(Command::Diagnostic(diagnostic));
    Step::Ran
}

fn too_many_lines(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>, at: At) -> Step {
    let bound = core.options.max_lines;
    let c = Context { core, host, out, at, span: Span::default() };
    let diagnostic = c
        .diagnostic(Span::default(), Code::LineLimit, format!("stopped after {bound} lines"))
        .hint("is there a loop that never ends? --max-lines raises the bound");
    core.abandon();
    Step::Done(Status::Limit, Some(Box::new(diagnostic)))
}

/// Executes a line, or what is left to do of an earlier one; `None` behind the last line.
fn run_line(c: &mut Context<'_>, program: &Program, node: Option<Node>) -> Result<(), Stop> {
    if c.core.under_way.probing.is_some() {
        return end_probe(c);
    }
    if c.core.progress.over {
        end_compensation(c);
        c.settle()?;
        return Err(Stop::Finished(Status::Ok));
    }
    let Some(node) = node else {
        end_of_file(c);
        return Ok(());
    };
    if c.core.under_way.holding.is_none() && steps_over(c, program, node)? {
        return Ok(());
    }
    c.core.progress.lines += 1;
    c.core.calls.go_on_at(c.at.line);
    let outcome = match c.core.under_way.holding.clone() {
        Some(text) => hold(c, &text).and_then(|()| retract_by_hand(c)),
        None => run_node(c, program, node),
    };
    // A block that holds the program is the one at hand until somebody has answered.
    let holds = outcome.is_ok() && c.core.under_way.holding.is_some();
    if holds || matches!(outcome, Err(Stop::Waiting | Stop::Again)) {
        c.core.progress.lines -= 1;
        c.core.calls.go_on_at(c.at.line - 1);
    } else {
        // The next line is asked for again.
        c.core.progress.stepping.granted = false;
    }
    outcome
}

fn run_node(c: &mut Context<'_>, program: &Program, node: Node) -> Result<(), Stop> {
    match node {
        Node::Blank => Ok(()),
        Node::Move => {
            c.span = program.code_of(c.at.line);
            let plain = program.move_of(c.at.line).unwrap_or_default();
            execute(c, &Gathered::of_move(&plain))
        }
        Node::Block(index) => match program.blocks.get(index as usize) {
            Some(block) => run_block(c, program, *block),
            None => Ok(()),
        },
        Node::Percent => {
            percent(c, program);
            Ok(())
        }
        Node::Console => console(c, program),
        Node::Bad => bad(c, program),
    }
}

fn run_block(c: &mut Context<'_>, program: &Program, block: Block) -> Result<(), Stop> {
    if block.delete > 0 && block.delete <= c.core.options.block_delete {
        return Ok(());
    }
    c.span = program.code_of(c.at.line);
    let extra = program.extra_of(&block);
    if let Some(o_word) = extra.and_then(|e| e.flow.as_ref()) {
        need_words(c.core.options.dialect, controllers::O_WORDS)?;
        comments(c, extra)?;
        return if is_linked(o_word) { flow(c, program, o_word) } else { bad(c, program) };
    }
    let gathered = gather(c.core, program, &block, c.span)?;
    begin_tool_change(c, &gathered)?;
    let settings = match extra {
        Some(extra) if !extra.settings.is_empty() => {
            need_words(c.core.options.dialect, kind_of(&extra.settings))?;
            evaluate_settings(&c.core.parameters(), program, &extra.settings)?
        }
        _ => Vec::new(),
    };
    let told = c.out.len();
    comments(c, extra)?;
    let outcome = if block.words.0 == block.words.1 { Ok(()) } else { execute(c, &gathered) };
    if matches!(outcome, Err(Stop::Waiting)) {
        c.out.truncate(told);
        return outcome;
    }
    assign(c, program, settings)?;
    outcome
}

/// `%`: the first line of a file, or its end.
fn percent(c: &mut Context<'_>, program: &Program) {
    let mut others = program.lines.others();
    let begins = (0..c.at.line - 1).all(|index| {
        let (line, node) = others.next().unwrap_or((index, Node::Bad));
        line == index && (node == Node::Blank || is_comment(program, node))
    });
    if !begins {
        c.core.progress.over = true;
    }
}

fn console(c: &mut Context<'_>, program: &Program) -> Result<(), Stop> {
    c.span = program.code_of(c.at.line);
    let message = "a line for the controller's console is not run";
    let hint = "settings of a controller belong into its configuration, not into a part";
    if c.core.options.dialect == Dialect::LinuxCnc {
        let hint = "lines with $ are grbl's; run it with --dialect grbl";
        return Err(fail(Code::ConsoleLine, message, hint));
    }
    if !std::mem::replace(&mut c.core.told.console, true) {
        c.warn(Code::ConsoleLine, message, hint);
    }
    Ok(())
}

fn is_comment(program: &Program, node: Node) -> bool {
    let Node::Block(index) = node else { return false };
    let block = program.blocks.get(index as usize);
    block.is_some_and(|b| {
        b.words.0 == b.words.1
            && program.extra_of(b).is_none_or(|e| e.settings.is_empty() && e.flow.is_none())
    })
}

/// The kind of parameters that a line sets.
fn kind_of(settings: &[Setting]) -> &'static str {
    let named = settings.iter().any(|setting| matches!(setting.target, Target::Named(_)));
    if named { controllers::NAMED } else { controllers::NUMBERED }
}

/// The file is over.
fn end_of_file(c: &mut Context<'_>) {
    if c.core.calls.is_inside() {
        leave_call(c, None);
    } else {
        c.core.progress.over = true;
    }
}
