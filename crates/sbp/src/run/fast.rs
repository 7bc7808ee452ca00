//! The fast road: runs of plain moves without tabs, tool offset or watched inputs.
//!
//! Does exactly what a step does with such lines, with everything that stays the same kept outside the loop. A property
//! holds the two to each other.

use super::Core;
use crate::syntax::tree::{MoveCommand, Node, Program};
use kerf_geom::Vec2;
use kerf_program::settings::Distance;
use kerf_program::{AXES, At, Axes, Axis, Command, Feed, Line, MoveKind, Sourced};

/// Executes plain moves until there is another line, a jog was given, or so many are done; `true` after a jog.
pub(super) fn run_moves(core: &mut Core, out: &mut Vec<Sourced>, most: u64) -> bool {
    if !holds(core) {
        return false;
    }
    let Some(level) = core.flow.level().filter(|l| !l.watched()) else { return false };
    let Some(program) = core.files.get(level.file) else { return false };
    if !program.lines.get(level.next as usize).is_some_and(|line| line.node.is_move()) {
        return false;
    }
    let program = program.clone();
    let (first, before) = (level.next, out.len());
    let mut jogged = false;
    let mut road = Road::of(core, level.file, first);
    for _ in 0..most.min(lines_left(core)) {
        let Some(line) = program.lines.get(road.line as usize) else { break };
        let Node::Move { command, given, first } = line.node else { break };
        let Some(to) = road.target(&program, command, given, first as usize) else { break };
        jogged = road.go(to, command.jog, out);
        if jogged {
            break;
        }
    }
    road.arrive(core, first, (out.len() - before) as u64);
    jogged
}

/// Returns `true` if nothing special holds.
fn holds(core: &Core) -> bool {
    core.cutting.tabs.is_none()
        && core.handlers.fired.is_empty()
        && !core.handlers.pausing
        && !core.values.settings.tool_offset.on
        && core.place.offset_applied == Axes::default()
        && core.place.independent.is_empty()
        && core.place.adrift.is_empty()
}

/// Returns the number of lines that the bound of the run still allows.
fn lines_left(core: &Core) -> u64 {
    match core.options.max_lines {
        0 => u64::MAX,
        most => most.saturating_sub(core.given.lines),
    }
}

/// Values that the moves of a run share, and those that they change.
struct Road {
    file: u32,
    /// Number of lines of the file that lie behind.
    line: u32,
    /// Number of axes that are switched on.
    active: usize,
    scale: [f64; AXES],
    relative: bool,
    /// Machine position of the file's own zero.
    zero: Axes,
    position: Axes,
    /// Last change of X and Y.
    heading: Option<Vec2>,
}

impl Road {
    fn of(core: &Core, file: u32, line: u32) -> Self {
        Self {
            file,
            line,
            active: usize::from(core.values.settings.axis_count),
            scale: core.place.scale,
            relative: core.values.settings.distance == Distance::Relative,
            zero: Axes(Axis::ALL.map(|axis| core.file_zero(axis))),
            position: core.place.position,
            heading: None,
        }
    }

    /// Returns the place that a line names; `None` when the line is none for this road.
    fn target(
        &self,
        program: &Program,
        command: MoveCommand,
        given: u8,
        mut number: usize,
    ) -> Option<Axes> {
        let first = usize::from(command.first);
        let axes = first + usize::from(8 - given.leading_zeros() as u8);
        if given == 0 || axes > self.active {
            return None;
        }
        let mut to = self.position;
        for i in 0..usize::from(command.count) {
            if given & (1 << i) == 0 {
                continue;
            }
            let axis = first + i;
            let value = program.numbers.get(number).copied().unwrap_or_default() * self.scale[axis];
            number += 1;
            let from = if self.relative { self.position.0[axis] } else { self.zero.0[axis] };
            to.0[axis] = value + from;
        }
        Some(to)
    }

    /// Makes the move of the next line; `true` after a jog, which ends the run.
    fn go(&mut self, to: Axes, jog: bool, out: &mut Vec<Sourced>) -> bool {
        self.line += 1;
        if to.same_place(&self.position) {
            return false;
        }
        let along = Vec2::new(to.0[0] - self.position.0[0], to.0[1] - self.position.0[1]);
        if along != Vec2::default() {
            self.heading = Some(along);
        }
        self.position = to;
        let kind = if jog { MoveKind::Jog } else { MoveKind::Cut };
        let command = Command::Line(Line { kind, to, feed: Feed::Axis });
        out.push(Sourced { at: At { file: self.file, line: self.line }, command });
        jog
    }

    /// Hands over what the moves have changed.
    fn arrive(self, core: &mut Core, first: u32, motions: u64) {
        if self.line == first {
            return;
        }
        if let Some(along) = self.heading {
            core.cutting.heading = Some(kerf_geom::vec_to_clock(along));
        }
        core.place.position = self.position;
        core.idling.count(true);
        core.given.lines += u64::from(self.line - first);
        core.given.motions += motions;
        core.given.settled &= motions == 0;
        core.flow.go_on_at(self.line);
    }
}
