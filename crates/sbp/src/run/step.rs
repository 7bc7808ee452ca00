//! One line at a time.

use super::watch::Handler;
use super::{Context, Core, Step, Stop, lifecycle, stepping};
use crate::tree::{MoveCommand, Node, Program, Span};
use kerf_diag::Code;
use kerf_program::{At, Axis, AxisSet, Command, Feed, Host, Line, MoveKind, Sourced};
use std::sync::Arc;

/// Executes one line, or the action of a handler that fired.
pub(super) fn step(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    core.taken = 0;
    let step = one_step(core, host, out);
    if !matches!(step, Step::Waiting) {
        core.heard.clear();
    }
    step
}

fn one_step(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    if core.links.len() < core.programs.len() {
        core.relink();
    }
    if !core.adrift.is_empty() && !find_axes(core, host) {
        return Step::Waiting;
    }
    if let Some(fired) = core.fired.first().cloned() {
        return handler(core, host, out, &fired);
    }
    if !core.started {
        return lifecycle::start(core, host, out);
    }
    if core.pausing {
        if host.settle().is_pending() {
            return Step::Waiting;
        }
        core.pausing = false;
        core.settled = true;
        core.watches.retain(|handler| !handler.probe);
    }
    let Some(level) = core.levels.last() else { return lifecycle::end(core, host, out) };
    let (file, next) = (level.file, level.next);
    let Some(program) = core.programs.get(file as usize).cloned() else {
        return lifecycle::end(core, host, out);
    };
    if next == 0 && core.is_gcode(level) {
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
    if core.options.max_lines > 0 && core.lines >= core.options.max_lines {
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
    let before = Before::of(core, out);
    go_on_at(core, at.line);
    let given = out.len();
    core.changes =
        !matches!(line, Node::Blank | Node::Comment | Node::Label(_) | Node::Statement(_));
    let mut context = Context { core, program, host, out, at, span: Span::LINE };
    let typed = context.core.options.typed && context.core.levels.len() == 1;
    let outcome = node(&mut context, program, line);
    if typed && outcome.is_ok() {
        context.record(line);
    }
    if matches!(outcome, Err(Stop::Waiting)) {
        go_on_at(core, at.line - 1);
        return before.wait(core, out);
    }
    core.lines += 1;
    core.granted = false;
    // Comments are told again in each round.
    let tells_only = |given: &[Sourced]| {
        given.iter().all(|given| matches!(given.command, Command::Message { .. }))
    };
    let idles = !core.changes && out.get(given..).is_none_or(tells_only);
    core.idle = if idles { core.idle + 1 } else { 0 };
    if outcome.is_ok() && goes_round(core, at, program) {
        return lifecycle::endless(core, host, out, at);
    }
    lifecycle::after(core, host, out, outcome)
}

/// Tells that a line came again and nothing has changed since: more lines were executed one after the other than the file
/// has, and each left everything as it was. Inputs may still end a loop while somebody watches them.
/// It is told at a line that jumps back.
fn goes_round(core: &Core, at: At, program: &Program) -> bool {
    core.idle > program.lines.len() as u64
        && core.watches.is_empty()
        && core.levels.last().is_some_and(|level| level.next < at.line)
}

/// Chooses the line (by index) that the innermost file goes on at.
fn go_on_at(core: &mut Core, index: u32) {
    if let Some(level) = core.levels.last_mut() {
        level.next = index;
    }
}

/// State that comes back when a step has to wait.
struct Before {
    random: u64,
    settled: bool,
    given: usize,
}

impl Before {
    fn of(core: &Core, out: &[Sourced]) -> Self {
        Self { random: core.random, settled: core.settled, given: out.len() }
    }

    /// A step that waits has no effect: what it told is told again when it is repeated. Only moves
    /// that the tab filter let go, which belong to earlier lines, stay given.
    fn wait(self, core: &mut Core, out: &mut Vec<Sourced>) -> Step {
        let told = out.split_off(self.given);
        out.extend(told.into_iter().filter(|c| c.command.is_motion()));
        core.random = self.random;
        core.settled = self.settled && out.len() == self.given;
        Step::Waiting
    }
}

/// Takes over where axes are that moved by themselves. False while the machine is not at rest.
fn find_axes(core: &mut Core, host: &mut dyn Host) -> bool {
    if host.settle().is_pending() {
        return false;
    }
    core.settled = true;
    core.take_position(core.adrift, host);
    core.adrift = AxisSet::EMPTY;
    true
}

fn node(c: &mut Context<'_>, program: &Arc<Program>, node: Node) -> Result<(), Stop> {
    match node {
        Node::Blank | Node::Label(_) => Ok(()),
        Node::Comment => {
            c.comment_line(program);
            Ok(())
        }
        Node::Move { command, given, first } => plain_move(c, program, command, given, first),
        Node::Statement(index) => match program.statements.get(index as usize) {
            Some(statement) => c.statement(statement),
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
    let mut to = c.core.position;
    let mut index = first as usize;
    for i in 0..command.count {
        if given & (1 << i) == 0 {
            continue;
        }
        let axis = Axis::ALL[usize::from(command.first + i).min(5)];
        c.need_axis(axis)?;
        let value = program.numbers.get(index).copied().unwrap_or_default();
        index += 1;
        let scaled = value * c.core.scale[axis.index()];
        to[axis] = c.core.target_scaled(axis, scaled);
    }
    if given == 0 {
        c.warn_no_motion();
    }
    c.line(if command.jog { MoveKind::Jog } else { MoveKind::Cut }, to);
    Ok(())
}

/// The fast road: runs of plain moves without tabs, tool offset or watched inputs.
///
/// Does exactly what [`plain_move`] does, with everything that stays the same kept outside the loop.
pub(super) fn run_moves(core: &mut Core, out: &mut Vec<Sourced>, most: u64) {
    if core.tabs.is_some()
        || !core.fired.is_empty()
        || core.settings.tool_offset.on
        || core.offset_applied != Default::default()
        || !core.independent.is_empty()
        || !core.adrift.is_empty()
    {
        return;
    }
    let Some(level) = core.levels.last().filter(|l| !l.watched()) else { return };
    let Some(program) = core.programs.get(level.file as usize) else { return };
    if !program.lines.get(level.next as usize).is_some_and(|line| line.node.is_move()) {
        return;
    }
    let program = program.clone();
    let (file, mut next, offset) = (level.file, level.next as usize, level.offset);
    let bound = if core.options.max_lines == 0 { u64::MAX } else { core.options.max_lines };
    let mut left = most.min(bound.saturating_sub(core.lines));
    let active = usize::from(core.settings.axis_count);
    let relative = core.settings.distance == kerf_program::settings::Distance::Relative;
    let scale = core.scale;
    let zero: [f64; 6] = std::array::from_fn(|i| {
        core.frame.working_zero.0[i] + offset.get(i).copied().unwrap_or(0.0)
    });
    let start = next;
    let mut position = core.position;
    let mut heading = None;
    let before = out.len();
    while left > 0
        && let Some(line) = program.lines.get(next)
    {
        let Node::Move { command, given, first } = line.node else { break };
        if given == 0
            || usize::from(command.first) + usize::from(8 - given.leading_zeros() as u8) > active
        {
            break;
        }
        let mut to = position;
        let mut index = first as usize;
        for i in 0..usize::from(command.count) {
            if given & (1 << i) != 0 {
                let axis = usize::from(command.first) + i;
                let value = program.numbers.get(index).copied().unwrap_or_default() * scale[axis];
                index += 1;
                to.0[axis] = value + if relative { position.0[axis] } else { zero[axis] };
            }
        }
        next += 1;
        left -= 1;
        if to.same_place(&position) {
            continue;
        }
        if to.0[0] != position.0[0] || to.0[1] != position.0[1] {
            heading = Some((to.0[0] - position.0[0], to.0[1] - position.0[1]));
        }
        position = to;
        let kind = if command.jog { MoveKind::Jog } else { MoveKind::Cut };
        let command = Command::Line(Line { kind, to, feed: Feed::Axis });
        out.push(Sourced { at: At { file, line: next as u32 }, command });
        if kind == MoveKind::Jog {
            break;
        }
    }
    if next == start {
        return;
    }
    if let Some((x, y)) = heading {
        core.heading = Some(kerf_geom::vec_to_clock(kerf_geom::Vec2::new(x, y)));
    }
    core.position = position;
    core.idle = 0;
    core.lines += (next - start) as u64;
    core.motions += (out.len() - before) as u64;
    core.settled &= out.len() == before;
    if let Some(level) = core.levels.last_mut() {
        level.next = next as u32;
    }
}

/// Runs the action of a handler that fired.
fn handler(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>, fired: &Handler) -> Step {
    let at = fired.at;
    let program = &core.program(at.file);
    let before = Before::of(core, out);
    let mut context = Context { core, program, host, out, at, span: Span::LINE };
    let outcome = context.handler_action(program, fired.level);
    if matches!(outcome, Err(Stop::Waiting)) {
        return before.wait(core, out);
    }
    core.fired.remove(0);
    lifecycle::after(core, host, out, outcome)
}
