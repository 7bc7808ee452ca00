//! MH and JH: to X 0, Y 0, above the work.

use crate::interp::{Context, Stop};
use crate::table::{CommandSpec, Group, Stack};
use kerf_diag::Code;
use kerf_program::settings::AxisUnit;
use kerf_program::{Axes, Axis, MoveKind};

pub(super) static MH: CommandSpec = CommandSpec::new(
    "MH",
    "Move Home",
    Group::Move,
    &[],
    Stack::Joins,
    "Lifts Z to Safe-Z when it is lower, then moves to X 0, Y 0, also in relative mode. In a file \
     with an offset that is the file's own zero.",
    |c, _| home(c, MoveKind::Cut),
);

pub(super) static JH: CommandSpec = CommandSpec::new(
    "JH",
    "Jog Home",
    Group::Jog,
    &[],
    Stack::Joins,
    "Lifts Z to Safe-Z when it is lower, then jogs to X 0, Y 0, also in relative mode. In a file \
     with an offset that is the file's own zero.",
    |c, _| home(c, MoveKind::Jog),
);

fn home(c: &mut Context<'_>, kind: MoveKind) -> Result<(), Stop> {
    c.need_axis(Axis::X)?;
    c.need_axis(Axis::Y)?;
    let up = lifted(c)?;
    c.line(kind, up);
    let mut to = c.core.position;
    for axis in [Axis::X, Axis::Y] {
        to[axis] = c.core.place(axis, c.core.file_zero(axis));
    }
    c.line(kind, to);
    Ok(())
}

/// Returns the place of the tool after lifting Z, and an A axis that moves up and down, to their safe heights.
fn lifted(c: &mut Context<'_>) -> Result<Axes, Stop> {
    let cutter = c.settings().cutter;
    let mut to = c.core.position;
    let lifting_a = c.settings().axis_count > 3
        && c.settings().axis_unit(Axis::A) != AxisUnit::Degrees
        && cutter.safe_z_mm.is_some();
    let heights =
        [(Axis::Z, cutter.safe_z_mm), (Axis::A, Some(cutter.safe_a_mm).filter(|_| lifting_a))];
    for (axis, height) in heights {
        let Some(height) = height else { continue };
        let safe = c.core.frame.working_zero[axis] + height;
        if c.core.free(axis) < safe {
            c.need_axis(axis)?;
            to[axis] = c.core.place(axis, safe);
        }
    }
    if cutter.safe_z_mm.is_none() {
        let hint = "VC,,,,1 sets a height to lift to";
        c.warn(Code::Unusual, "Safe-Z is off: the tool goes home at its present height", hint);
    }
    Ok(to)
}
