//! Moves, jogs and probes.

use super::{direction, independent, speeds};
use crate::run::cutting;
use crate::run::fabmo;
use crate::run::locate;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::act::Move;
use kerf_diag::Code;
use kerf_program::settings::AxisUnit;
use kerf_program::{Axes, Axis, MoveKind};

/// Carries a move command out.
pub(super) fn run(c: &mut Context<'_>, act: Move, a: &Arguments) -> Result<(), Stop> {
    match act {
        Move::Axes { kind, first } => go(c, a, kind, first),
        Move::Home(kind) => home(c, kind),
        Move::Direction => direction::go(c, a),
        Move::Independent => independent::start(c, a),
        Move::MotorsOff => independent::motors_off(c),
        Move::Speeds => speeds::set(c, a),
        Move::Nudge => {
            let hint = "stop the file and nudge there, or move and set the location with VA";
            Err(c.fail_at(c.span, Code::NotSupported, "MN needs the console", hint))
        }
        Move::Probe { first } => probe(c, a, first),
    }
}

/// Moves the axes that have values; parameter i belongs to axis `first + i`.
fn go(c: &mut Context<'_>, a: &Arguments, kind: MoveKind, first: usize) -> Result<(), Stop> {
    let given = (0..a.len()).filter_map(|i| Some((Axis::ALL[first + i], a.number(i)?)));
    let given: Vec<_> = given.collect();
    if given.is_empty() {
        locate::warn_no_motion(c);
    }
    for (axis, _) in &given {
        c.need_axis(*axis)?;
    }
    let to = locate::targets(c, given);
    cutting::line(c, kind, to);
    Ok(())
}

fn home(c: &mut Context<'_>, kind: MoveKind) -> Result<(), Stop> {
    c.need_axis(Axis::X)?;
    c.need_axis(Axis::Y)?;
    let up = lifted(c)?;
    cutting::line(c, kind, up);
    let mut to = c.core.place.position;
    for axis in [Axis::X, Axis::Y] {
        to[axis] = c.core.with_tool_offset(axis, c.core.file_zero(axis));
    }
    cutting::line(c, kind, to);
    Ok(())
}

/// Returns the place of the tool after lifting Z, and an A axis that moves up and down, to their safe heights.
fn lifted(c: &mut Context<'_>) -> Result<Axes, Stop> {
    let cutter = c.settings().cutter;
    let mut to = c.core.place.position;
    let lifting_a = c.settings().axis_count > 3
        && c.settings().axis_unit(Axis::A) != AxisUnit::Degrees
        && cutter.safe_z_mm.is_some();
    let heights =
        [(Axis::Z, cutter.safe_z_mm), (Axis::A, Some(cutter.safe_a_mm).filter(|_| lifting_a))];
    for (axis, height) in heights {
        let Some(height) = height else { continue };
        let safe = c.core.place.frame.working_zero[axis] + height;
        if c.core.place.free(axis) < safe {
            c.need_axis(axis)?;
            to[axis] = c.core.with_tool_offset(axis, safe);
        }
    }
    if cutter.safe_z_mm.is_none() {
        let hint = "VC,,,,1 sets a height to lift to";
        c.warn(Code::Unusual, "Safe-Z is off: the tool goes home at its present height", hint);
    }
    Ok(to)
}

/// Targets of axes from the first one on, then speed and input.
fn probe(c: &mut Context<'_>, a: &Arguments, first: usize) -> Result<(), Stop> {
    let count = a.len().saturating_sub(2);
    let given = Axis::ALL.into_iter().skip(first).take(count).enumerate();
    let given: Vec<_> = given.filter_map(|(i, axis)| Some((axis, a.number(i)?))).collect();
    for (axis, _) in &given {
        c.need_axis(*axis)?;
    }
    let to = locate::targets(c, given);
    let input = a.number_or(count + 1, 1.0) as u8;
    fabmo::probe(c, to, a.number_or(count, 1.0), input);
    Ok(())
}
