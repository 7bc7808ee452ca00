//! Canned cycles: G73, G81 … G89 (RS274/NGC 3.5.16), in any plane.
//!
//! A cycle is a list of moves along the drilling axis, made at each place.

use super::context::Context;
use super::core::Core;
use super::hole::{Cycle, Hole};
use super::spindle::turn_spindle;
use super::state::FeedMode;
use super::stop::{Refused, Stop, fail};
use super::{feed, go};
use crate::syntax::codes::g_name;
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::{Command, MoveKind, SpindleTurn};

/// Height above the last bottom at which a peck begins again: LinuxCNC's 0.010 in.
const AGAIN_MM: f64 = 0.254;
/// Repeats of one block; more is a number out of all proportion.
const MOST_REPEATS: f64 = 100_000.0;
/// A canned cycle, in tenths of its code.
pub(super) fn cycle(c: &mut Context<'_>, g: &Gathered, code: i32) -> Result<(), Stop> {
    c.core.place.need_uncompensated("a canned cycle")?;
    if c.core.state.modal.feed_mode == FeedMode::Inverse {
        let message = format!("{} while G93 holds", g_name(code));
        return Err(fail(Code::ModalConflict, message, "write G94 and F before the cycle"));
    }
    let axes = c.core.state.modal.plane.axes();
    let here = c.core.coordinates.place_of(c.core.place.programmed).0[axes[2]];
    let in_force = c.core.sequels.cycle.filter(|cycle| cycle.axis == axes[2]);
    let mut cycle = in_force.unwrap_or(Cycle::new(axes[2], here));
    cycle.take(g);
    let Core { state, coordinates, options, .. } = &*c.core;
    let lenient = options.dialect.is_lenient();
    let hole = Hole::new(code, &cycle, &state.modal, coordinates, lenient)?;
    c.core.sequels.cycle = Some(cycle);
    let times = g.get(b'L').unwrap_or(1.0);
    if times.fract() != 0.0 || !(0.0..=MOST_REPEATS).contains(&times) {
        let message = format!("L of a cycle is how often it is made, not {times}");
        return Err(fail(Code::OutOfRange, message, "L is a whole number from 1"));
    }
    if code == 880 && times > 1.0 {
        let message = "G88 is repeated by L";
        let hint = "it asks at each hole: write each hole on a line of its own";
        return Err(fail(Code::OutOfRange, message, hint));
    }
    repeat_hole(c, g, &hole, times as u32, cycle.initial)
}

fn repeat_hole(
    c: &mut Context<'_>,
    g: &Gathered,
    hole: &Hole,
    times: u32,
    initial: f64,
) -> Result<(), Stop> {
    let mut places = g.clone();
    places.clear(b"XYZ"[hole.axes[2]]);
    // It rises before it travels: R may be higher than that of the hole before.
    let here = c.core.coordinates.place_of(c.core.place.programmed).0[hole.axes[2]];
    if hole.is_above(hole.r, here) || hole.is_above(hole.r, initial) {
        along(c, hole, MoveKind::Jog, hole.r)?;
    }
    for _ in 0..times {
        let to = go::target(c.core, &places)?;
        go::line(c, MoveKind::Jog, to)?;
        along(c, hole, MoveKind::Jog, hole.r)?;
        drill(c, hole)?;
    }
    Ok(())
}

/// A move of the drilling axis to a place, mm.
fn along(c: &mut Context<'_>, hole: &Hole, kind: MoveKind, place: f64) -> Result<(), Stop> {
    go_to(c, kind, &[(hole.axes[2], place)])
}

fn go_to(c: &mut Context<'_>, kind: MoveKind, places: &[(usize, f64)]) -> Result<(), Stop> {
    let to = c.core.coordinates.moved(c.core.place.programmed, places.iter().copied());
    match kind {
        MoveKind::Jog => go::line(c, kind, to),
        MoveKind::Cut => {
            let feed = feed::feed(c, to)?;
            go::line_at(c, kind, to, feed)
        }
    }
}

fn wait(c: &mut Context<'_>, seconds: f64) {
    if seconds > 0.0 {
        c.emit(Command::Wait { seconds });
    }
}

/// The moves of one hole, from R on.
fn drill(c: &mut Context<'_>, hole: &Hole) -> Result<(), Stop> {
    match hole.code {
        730 | 830 => peck(c, hole)?,
        870 => return bore_from_behind(c, hole),
        _ => along(c, hole, MoveKind::Cut, hole.bottom)?,
    }
    if matches!(hole.code, 820 | 840 | 860 | 880 | 890) {
        wait(c, hole.dwell);
    }
    match hole.code {
        840 => tap(c, hole),
        890 => along(c, hole, MoveKind::Cut, hole.clear),
        850 => {
            along(c, hole, MoveKind::Cut, hole.r)?;
            along(c, hole, MoveKind::Jog, hole.clear)
        }
        860 => retract_stopped(c, hole),
        880 => ask_to_retract(c, hole),
        _ => along(c, hole, MoveKind::Jog, hole.clear),
    }
}

/// G73 breaks the chip, G83 brings it out.
fn peck(c: &mut Context<'_>, hole: &Hole) -> Result<(), Stop> {
    if hole.peck <= 0.0 {
        return along(c, hole, MoveKind::Cut, hole.bottom);
    }
    let mut depth = hole.below(hole.r, hole.peck);
    while hole.is_above(depth, hole.bottom) {
        along(c, hole, MoveKind::Cut, depth)?;
        if hole.code == 830 {
            along(c, hole, MoveKind::Jog, hole.r)?;
        }
        let again = hole.below(depth, -AGAIN_MM);
        let again = if hole.is_above(again, hole.r) { hole.r } else { again };
        along(c, hole, MoveKind::Jog, again)?;
        depth = hole.below(depth, hole.peck);
    }
    along(c, hole, MoveKind::Cut, hole.bottom)
}

/// The way the spindle turns, which has to turn.
fn spindle_turn(core: &Core, hole: &Hole) -> Result<SpindleTurn, Refused> {
    let turn = core.state.modal.turn;
    if turn != SpindleTurn::Off || core.options.dialect.is_lenient() {
        return Ok(turn);
    }
    let message = format!("{} while the spindle stands", g_name(hole.code));
    Err(fail(Code::MissingWord, message, "M3 or M4 before the cycle turns it on"))
}

fn tap(c: &mut Context<'_>, hole: &Hole) -> Result<(), Stop> {
    let turn = spindle_turn(c.core, hole)?;
    let back = match turn {
        SpindleTurn::Clockwise => SpindleTurn::Counterclockwise,
        SpindleTurn::Counterclockwise => SpindleTurn::Clockwise,
        other => other,
    };
    turn_spindle(c, back);
    along(c, hole, MoveKind::Cut, hole.clear)?;
    turn_spindle(c, turn);
    Ok(())
}

/// G88: the spindle stands, and the operator retracts; what is left of the way comes with the answer.
fn ask_to_retract(c: &mut Context<'_>, hole: &Hole) -> Result<(), Stop> {
    let turn = spindle_turn(c.core, hole)?;
    c.core.under_way.retracting = Some((*hole, turn));
    turn_spindle(c, SpindleTurn::Off);
    c.core.under_way.holding = Some("G88: retract by hand, then go on".into());
    Ok(())
}

/// Behind the answer: what is left of the way out, and the spindle turns again.
pub(super) fn retract_by_hand(c: &mut Context<'_>) -> Result<(), Stop> {
    let Some((hole, turn)) = c.core.under_way.retracting.take() else { return Ok(()) };
    along(c, &hole, MoveKind::Jog, hole.clear)?;
    turn_spindle(c, turn);
    Ok(())
}

/// G86: out with the spindle at rest.
fn retract_stopped(c: &mut Context<'_>, hole: &Hole) -> Result<(), Stop> {
    let turn = spindle_turn(c.core, hole)?;
    turn_spindle(c, SpindleTurn::Off);
    along(c, hole, MoveKind::Jog, hole.clear)?;
    turn_spindle(c, turn);
    Ok(())
}

/// G87: in beside the hole, up from below.
fn bore_from_behind(c: &mut Context<'_>, hole: &Hole) -> Result<(), Stop> {
    let turn = spindle_turn(c.core, hole)?;
    let [u, v, _] = hole.axes;
    let place = c.core.coordinates.place_of(c.core.place.programmed);
    let at = [(u, place.0[u]), (v, place.0[v])];
    let beside = [(u, place.0[u] + hole.beside[0]), (v, place.0[v] + hole.beside[1])];
    go_to(c, MoveKind::Jog, &beside)?;
    turn_spindle(c, SpindleTurn::Off);
    along(c, hole, MoveKind::Jog, hole.bottom)?;
    go_to(c, MoveKind::Jog, &at)?;
    turn_spindle(c, turn);
    along(c, hole, MoveKind::Cut, hole.higher(hole.middle, hole.bottom))?;
    along(c, hole, MoveKind::Cut, hole.bottom)?;
    turn_spindle(c, SpindleTurn::Off);
    go_to(c, MoveKind::Jog, &beside)?;
    along(c, hole, MoveKind::Jog, hole.clear)?;
    go_to(c, MoveKind::Jog, &at)?;
    turn_spindle(c, turn);
    Ok(())
}
