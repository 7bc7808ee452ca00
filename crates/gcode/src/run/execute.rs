//! One block, in the order that RS274/NGC lays down (section 3.8, table 8), with LinuxCNC's
//! additions at the places LinuxCNC gives them.

use super::compensate::compensation;
use super::context::Context;
use super::core::Core;
use super::modes::{self, distance, feed_mode, path_control, plane};
use super::state::Plane;
use super::stop::{Refused, Stop, fail};
use super::{controllers, feed, io, motion, offsets, spindle, stops};
use crate::syntax::codes::{IO, MOTION, NOTHING, ONCE, PLANE, SPINDLE, TOOL, g_name};
use crate::syntax::gathered::{AXIS_WORDS, Gathered, letters};
use kerf_diag::Code;
use kerf_program::{Axis, SpindleTurn};

/// Letters that ask for a motion.
const MOVING: u32 = AXIS_WORDS | letters(b"@^");
/// Letters that ask for another turn of an arc.
const CENTRE: u32 = letters(b"IJK");

/// Carries out a block.
pub(super) fn execute(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    if !waits(g) && !starts_spindle(c.core, g) {
        return carry_out(c, g);
    }
    // A block that stops the program is repeated as a whole when the host has no answer yet.
    c.settle()?;
    let saved = c.core.clone();
    c.core.asking.begin();
    let outcome = carry_out(c, g);
    let answers = c.core.asking.end();
    if matches!(outcome, Err(Stop::Waiting)) {
        *c.core = saved;
        c.core.asking.keep(answers);
    }
    outcome
}

/// Returns `true` if the block starts the spindle and the operator is asked first.
fn starts_spindle(core: &Core, g: &Gathered) -> bool {
    matches!(g.m[SPINDLE], Some(3 | 4)) && core.would_ask_spindle(SpindleTurn::Clockwise)
}

fn carry_out(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let motion = match motion_of(c.core, g) {
        None => behind_a_cycle(c, g),
        motion => motion,
    };
    need_dialect(c, g, motion)?;
    need_use(c, g, motion)?;
    need_axes(c.core, g)?;
    feed_mode(&mut c.core.state.modal, g);
    modes::unit(c, g)?;
    feed::take_feed(&mut c.core.state.modal, g);
    spindle::take_speed(c, g);
    if let Some(tool) = g.tool(b'T') {
        c.core.state.selected = tool;
    }
    if c.core.options.path_only {
        modes::keep_modes(c, g)?;
    } else {
        machine_codes(c, g)?;
    }
    plane(c, g)?;
    compensation(c, g)?;
    offsets::tool_length(c, g)?;
    offsets::system(c, g)?;
    path_control(c, g);
    distance(&mut c.core.state.modal, g);
    offsets::once(c, g)?;
    if let Some(motion) = motion {
        motion::set_motion(c, g, motion)?;
    }
    stops::stop(c, g)
}

/// Carries out what a block does besides its path.
fn machine_codes(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    io::inputs_and_outputs(c, g)?;
    stops::tool_change(c, g)?;
    spindle::spindle(c, g)?;
    modes::keep_modes(c, g)?;
    spindle::coolant(c, g);
    modes::overrides(c, g);
    if g.g[ONCE] == Some(40) {
        modes::dwell(c, g);
    }
    Ok(())
}

/// The motion that this block makes, in tenths; `None` when it makes none.
fn motion_of(core: &Core, g: &Gathered) -> Option<i32> {
    if let Some(motion) = g.g[MOTION] {
        return Some(motion);
    }
    let modal = core.state.modal.motion;
    let arc = matches!(modal, Some(20 | 30)) && g.has_any(CENTRE);
    let wanted = !g.axes_taken() && (g.has_any(MOVING) || arc);
    if wanted { modal } else { None }
}

/// The motion of a place alone behind G80: that before the cycle, as on Fanuc and Mach3.
fn behind_a_cycle(c: &mut Context<'_>, g: &Gathered) -> Option<i32> {
    let alone = g.has_any(AXIS_WORDS) && !g.axes_taken() && g.g[MOTION].is_none();
    if !alone || !c.core.options.dialect.is_lenient() {
        return None;
    }
    let motion = c.core.state.modal.before_cycle?;
    if !std::mem::replace(&mut c.core.told.behind_cycle, true) {
        let code = g_name(motion);
        let message = format!("a place behind G80 without a motion: {code} of before the cycle");
        let hint = format!(
            "so do Fanuc and Mach3; LinuxCNC and grbl refuse it: write {code} before the place"
        );
        c.warn(Code::Unusual, message, hint);
    }
    Some(motion)
}

fn need_use(c: &mut Context<'_>, g: &Gathered, motion: Option<i32>) -> Result<(), Stop> {
    let Some(letter) = g.unused(motion) else { return Ok(()) };
    let still = matches!(motion, None | Some(800));
    let axes = g.has_any(MOVING) && still && !g.axes_taken();
    let (message, hint) = if matches!(letter, 'U' | 'V' | 'W') {
        (format!("there is no axis {letter}"), "axes are X Y Z A B C")
    } else if axes && "XYZABC@^".contains(letter) {
        if c.core.told.motion_lost {
            // The mistake before, which was told, may have named it.
            return Ok(());
        }
        let what = format!("{letter} without a motion");
        (what, "no motion is in force here; write G0 or G1 before it")
    } else {
        (format!("nothing in this block uses {letter}"), "is a code missing, or the letter wrong?")
    };
    let no_axis = matches!(letter, 'U' | 'V' | 'W');
    if c.core.options.dialect.is_lenient() && !axes && !no_axis {
        c.warn(Code::UnusedWord, message, hint);
        return Ok(());
    }
    Err(fail(Code::UnusedWord, message, hint))
}

/// Refuses an axis that VD has not switched on.
fn need_axes(core: &Core, g: &Gathered) -> Result<(), Refused> {
    for axis in Axis::ALL {
        let given = g.has(axis.letter() as u8);
        if given && axis.index() >= usize::from(core.settings.axis_count) {
            let message = format!("{} axis not active", axis.letter());
            let hint = "switch it on in the machine's configuration";
            return Err(fail(Code::AxisNotActive, message, hint));
        }
    }
    Ok(())
}

/// Refuses what the controller of the dialect refuses.
fn need_dialect(c: &mut Context<'_>, g: &Gathered, motion: Option<i32>) -> Result<(), Stop> {
    need_fan(c, g);
    let plane = match g.g[PLANE] {
        Some(code) => Plane::of_code(code),
        None => c.core.state.modal.plane,
    };
    match controllers::refuses(c.core.options.dialect, g, motion, plane) {
        Some(refused) => Err(refused.into()),
        None => Ok(()),
    }
}

/// M106 and M107 switch the fan of a printer's board, where a laser or a relay may hang: told once.
fn need_fan(c: &mut Context<'_>, g: &Gathered) {
    let Some(code) = g.m[NOTHING].filter(|m| matches!(m, 106 | 107)) else { return };
    if !std::mem::replace(&mut c.core.told.fan, true) {
        let message = format!("M{code} switches nothing here");
        let hint = "it is the fan of a printer's board; a laser or a relay on it is switched by M3 and M5, or M64 P0 and \
                    M65 P0";
        c.warn(Code::Unusual, message, hint);
    }
}

/// Returns `true` if a block waits for the machine, the operator or an input.
fn waits(g: &Gathered) -> bool {
    g.m[TOOL] == Some(6) || g.m[IO] == Some(66) || matches!(g.g[MOTION], Some(382..=385))
}
