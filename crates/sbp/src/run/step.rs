//! One line at a time.

use super::state::Handler;
use super::{
    Context, Core, Stop, comments, cutting, interrupt, lifecycle, locate, recorder, statements,
    stepping,
};
use crate::tree::{MoveCommand, Node, Program, Span};
use kerf_diag::Code;
use kerf_program::Step;
use kerf_program::{At, Axis, AxisSet, Command, Host, MoveKind, Sourced};
use std::sync::Arc;

/// Executes one line, or the action of a handler that fired.
pub(super) fn step(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    core.answers.begin_again();
    let step = one_step(core, host, out);
    if !matches!(step, Step::Waiting) {
        core.answers.forget();
    }
    step
}

fn one_step(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    core.files.link(&mut core.memory.variables);
    if !core.place.adrift.is_empty() && !find_axes(core, host) {
        return Step::Waiting;
    }
    if let Some(fired) = core.handlers.fired.first().cloned() {
        return handler(core, host, out, &fired);
    }
    if !core.flow.started {
        return lifecycle::start(core, host, out);
    }
    if core.handlers.pausing {
        if host.settle().is_pending() {
            return Step::Waiting;
        }
        core.handlers.pausing = false;
        core.given.settled = true;
        core.handlers.watches.retain(|handler| !handler.probe);
    }
    let Some(level) = core.flow.levels.last() else { return lifecycle::end(core, host, out) };
    let (file, next) = (level.file, level.next);
    let Some(program) = core.files.programs.get(file as usize).cloned() else {
        return lifecycle::end(core, host, out);
    };
    if next == 0 && core.files.is_gcode(level) {
        // Only where nobody runs both languages.
        return lifecycle::no_gcode(core, host, out, At { file, line: 1 });
    }
    let Some(line) = program.lines.get(next as usize) else {
        return lifecycle::end_of_file(core, host, out);
    };
    if stepping::passes_over(core, &program, line.node) {
        return Step::Ran;
    }
    let at = At { file, line: next + 1 };
    if core.options.max_lines > 0 && core.given.lines >= core.options.max_lines {
        return lifecycle::too_many_lines(core, host, out, at);
    }
    if stepping::asks(core, line.node) {
        return stepping::ask(core, host, out, at, &program);
    }
    execute(core, host, out, at, &program, line.node)
}

/// Executes a line. The next one is chosen before, so that jumps and calls only replace it.
fn execute(
    core: &mut Core,
    host: &mut dyn Host,
    out: &mut Vec<Sourced>,
    at: At,
    program: &Arc<Program>,
    line: Node,
) -> Step {
    let before = BeforeStep::of(core, out);
    core.flow.go_on_at(at.line);
    let given = out.len();
    core.idling.changes =
        !matches!(line, Node::Blank | Node::Comment | Node::Label(_) | Node::Statement(_));
    let mut context = Context { core, program, host, out, at, span: Span::LINE };
    let typed = context.core.options.typed && context.core.flow.levels.len() == 1;
    let outcome = node(&mut context, program, line);
    if typed && outcome.is_ok() {
        recorder::record(&mut context, line);
    }
    if matches!(outcome, Err(Stop::Waiting)) {
        core.flow.go_on_at(at.line - 1);
        return before.wait(core, out);
    }
    core.given.lines += 1;
    core.flow.granted = false;
    // Comments are told again in each round.
    let tells_only = |given: &[Sourced]| {
        given.iter().all(|given| matches!(given.command, Command::Message { .. }))
    };
    let idles = !core.idling.changes && out.get(given..).is_none_or(tells_only);
    core.idling.count(!idles);
    if outcome.is_ok() && goes_round(core, at, program) {
        return lifecycle::endless(core, host, out, at);
    }
    lifecycle::after(core, host, out, outcome)
}

/// Tells that a line came again and nothing has changed since: more lines were executed one after the other than the file
/// has, and each left everything as it was. Inputs may still end a loop while somebody watches them.
/// It is told at a line that jumps back.
fn goes_round(core: &Core, at: At, program: &Program) -> bool {
    core.idling.exceeds(program.lines.len())
        && core.handlers.watches.is_empty()
        && core.flow.levels.last().is_some_and(|level| level.next < at.line)
}

/// State that comes back when a step has to wait.
struct BeforeStep {
    random: u64,
    settled: bool,
    given: usize,
}

impl BeforeStep {
    fn of(core: &Core, out: &[Sourced]) -> Self {
        Self { random: core.memory.random, settled: core.given.settled, given: out.len() }
    }

    /// A step that waits has no effect: what it told is told again when it is repeated. Only moves
    /// that the tab filter let go, which belong to earlier lines, stay given.
    fn wait(self, core: &mut Core, out: &mut Vec<Sourced>) -> Step {
        let told = out.split_off(self.given);
        out.extend(told.into_iter().filter(|c| c.command.is_motion()));
        core.memory.random = self.random;
        core.given.settled = self.settled && out.len() == self.given;
        Step::Waiting
    }
}

/// Takes over where axes are that moved by themselves. False while the machine is not at rest.
fn find_axes(core: &mut Core, host: &mut dyn Host) -> bool {
    if host.settle().is_pending() {
        return false;
    }
    core.given.settled = true;
    core.place.take_position(core.place.adrift, host);
    core.place.adrift = AxisSet::EMPTY;
    true
}

fn node(c: &mut Context<'_>, program: &Arc<Program>, node: Node) -> Result<(), Stop> {
    match node {
        Node::Blank | Node::Label(_) => Ok(()),
        Node::Comment => {
            comments::comment_line(c, program);
            Ok(())
        }
        Node::Move { command, given, first } => plain_move(c, program, command, given, first),
        Node::Statement(index) => match program.statements.get(index as usize) {
            Some(statement) => statements::execute(c, statement),
            None => Ok(()),
        },
        Node::Bad => {
            let line = c.at.line;
            let known = program.diagnostics.iter().find(|d| d.place.line == line && d.is_error());
            Err(match known.cloned() {
                Some(mut diagnostic) => {
                    diagnostic.callers = c.callers();
                    Stop::Failed(Box::new(diagnostic))
                }
                None => c.fail(Code::Syntax, "this line cannot be read"),
            })
        }
    }
}

fn plain_move(
    c: &mut Context<'_>,
    program: &Program,
    command: MoveCommand,
    given: u8,
    first: u32,
) -> Result<(), Stop> {
    let mut to = c.core.place.position;
    let mut index = first as usize;
    for i in 0..command.count {
        if given & (1 << i) == 0 {
            continue;
        }
        let axis = Axis::ALL[usize::from(command.first + i).min(5)];
        c.need_axis(axis)?;
        let value = program.numbers.get(index).copied().unwrap_or_default();
        index += 1;
        let scaled = value * c.core.place.scale[axis.index()];
        to[axis] = c.core.target_scaled(axis, scaled);
    }
    if given == 0 {
        locate::warn_no_motion(c);
    }
    cutting::line(c, if command.jog { MoveKind::Jog } else { MoveKind::Cut }, to);
    Ok(())
}

/// Runs the action of a handler that fired.
fn handler(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>, fired: &Handler) -> Step {
    let at = fired.at;
    let program = &core.files.program(at.file);
    let before = BeforeStep::of(core, out);
    let mut context = Context { core, program, host, out, at, span: Span::LINE };
    let outcome = interrupt::handler_action(&mut context, program, fired.level);
    if matches!(outcome, Err(Stop::Waiting)) {
        return before.wait(core, out);
    }
    core.handlers.fired.remove(0);
    lifecycle::after(core, host, out, outcome)
}
