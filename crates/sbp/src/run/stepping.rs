//! FG: a file that is gone through line by line.
//!
//! Before each line of such a file the operator is asked what to do with it. The question is a step
//! of its own: its answer is kept until the line has run, because a line may have to wait.
//!
//! ```text
//!  ask ─┬─ Step: this line runs, ask again        go to N ─► lines before N are passed over,
//!       ├─ Run: from here on without asking                  all or all but settings and
//!       └─ Quit: the run ends                                assignments
//! ```

use super::{Context, Core, Stop, lifecycle, questions};
use crate::table::{CommandSpec, Group};
use crate::tree::{Node, Program, Span, Statement};
use kerf_diag::Code;
use kerf_program::{At, GoTo, Host, Question, Sourced, Step, StepChoice};

/// Returns `true` if the operator decides about the line that is next.
pub(super) fn asks(core: &Core, node: Node) -> bool {
    let stepped = core.flow.level().is_some_and(|l| l.stepped && l.skip_to.is_none());
    stepped && !core.flow.granted && !matches!(node, Node::Blank)
}

/// Asks what to do with the line that is next.
pub(super) fn ask(
    core: &mut Core,
    host: &mut dyn Host,
    out: &mut Vec<Sourced>,
    at: At,
    program: &Program,
) -> Step {
    let mut context = Context { core, program, host, out, at, span: Span::default() };
    let outcome = ask_step(&mut context);
    lifecycle::after(core, host, out, outcome)
}

/// Passes over a line before the one that the file goes on at. False when the line is to run.
pub(super) fn passes_over(core: &mut Core, program: &Program, node: Node) -> bool {
    let Some(level) = core.flow.levels.last_mut() else { return false };
    let Some(to) = level.skip_to else { return false };
    if level.next >= to {
        level.skip_to = None;
        return false;
    }
    let prepares = prepares(program, node);
    if !prepares {
        level.next += 1;
    }
    !prepares
}

/// Returns `true` if a line only sets something up: a setting or an assignment.
fn prepares(program: &Program, node: Node) -> bool {
    let Node::Statement(index) = node else { return false };
    program.statements.get(index as usize).is_some_and(statement_prepares)
}

fn statement_prepares(statement: &Statement) -> bool {
    match statement {
        Statement::Assign { .. } => true,
        Statement::Command { spec, .. } => sets(spec),
        Statement::If { then, .. } => statement_prepares(then),
        _ => false,
    }
}

/// Values (not the locations of VA), speeds, distances absolute or relative, limits.
fn sets(spec: &CommandSpec) -> bool {
    spec.group == Group::Values && spec.letters != "VA"
        || matches!(spec.letters, "SA" | "SR" | "SF" | "MS" | "JS")
}

fn ask_step(c: &mut Context<'_>) -> Result<(), Stop> {
    let program = c.program;
    let last = c.host.last_line(&program.name);
    let question = Question::of_step(&program.name, program.line_text(c.at.line), last);
    match StepChoice::of(&c.ask(&question)?, last) {
        StepChoice::Once => c.core.flow.granted = true,
        StepChoice::RunOn => c.core.flow.run_on(),
        StepChoice::Quit => return Err(questions::terminated(c)),
        StepChoice::GoTo(to) => go_to(c, to),
        StepChoice::Again => {}
    }
    Ok(())
}

fn go_to(c: &mut Context<'_>, to: GoTo) {
    let program = c.program;
    if let Some((message, hint)) = to.beyond(&program.name, program.lines.len() as u32) {
        return c.warn(Code::OutOfRange, message, hint);
    }
    if let Some(level) = c.core.flow.levels.last_mut() {
        level.go_to(to);
    }
}
