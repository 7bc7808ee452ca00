//! Codes that set a mode: unit, feed mode, plane, distances, overrides, path control, kept modes.

use super::context::Context;
use super::spindle::{set_coolant, set_speed, turn_spindle};
use super::state::{FeedMode, Modal, Plane};
use super::stop::{Stop, fail};
use crate::syntax::codes::{
    ARC_DISTANCE, DISTANCE, FEED_MODE, OVERRIDE, PATH, PLANE, RETURN, STATE, UNITS,
};
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::settings::LinearUnit;
use kerf_program::{Command, PathControl};

/// G93, G94, G95.
pub(super) fn feed_mode(modal: &mut Modal, g: &Gathered) {
    let Some(code) = g.g[FEED_MODE] else { return };
    let mode = match code {
        930 => FeedMode::Inverse,
        950 => FeedMode::PerTurn,
        _ => FeedMode::PerMinute,
    };
    // A feed of one mode means nothing in another.
    if modal.feed_mode != mode {
        modal.feed = None;
    }
    modal.feed_mode = mode;
}

/// G20 and G21, before F: a feed in the same block is in the new unit.
pub(super) fn unit(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let Some(code) = g.g[UNITS] else { return Ok(()) };
    let unit = if matches!(code, 200 | 700) { LinearUnit::Inch } else { LinearUnit::Mm };
    let modal = &mut c.core.state.modal;
    modal.unit_said = true;
    if modal.unit != unit {
        c.core.place.need_uncompensated("another unit")?;
        c.core.state.modal.unit = unit;
        c.core.refresh();
    }
    Ok(())
}

/// M48 … M53.
pub(super) fn overrides(c: &mut Context<'_>, g: &Gathered) {
    let Some(code) = g.m[OVERRIDE] else { return };
    let on = g.get(b'P').is_none_or(|p| p != 0.0);
    let modal = &mut c.core.state.modal;
    let before = modal.overrides;
    match code {
        48 => modal.overrides = [true; 2],
        49 => modal.overrides = [false; 2],
        50 => modal.overrides[0] = on,
        51 => modal.overrides[1] = on,
        // Adaptive feed and feed stop come from the machine, not from the program.
        _ => {}
    }
    let [feed, spindle] = modal.overrides;
    if modal.overrides != before {
        c.emit(Command::Overrides { feed, spindle });
    }
}

/// G90, G91, G90.1, G91.1, G98, G99.
pub(super) fn distance(modal: &mut Modal, g: &Gathered) {
    if let Some(code) = g.g[DISTANCE] {
        modal.relative = code == 910;
    }
    if let Some(code) = g.g[ARC_DISTANCE] {
        modal.arc_absolute = code == 901;
    }
    if let Some(code) = g.g[RETURN] {
        modal.return_to_r = code == 990;
    }
}

/// G17, G18, G19.
pub(super) fn plane(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let Some(code) = g.g[PLANE] else { return Ok(()) };
    let plane = Plane::of_code(code);
    if plane != Plane::Xy {
        c.core.place.need_uncompensated("another plane")?;
    }
    c.core.state.modal.plane = plane;
    Ok(())
}

/// G4: P in seconds; X and S as some controllers write it.
pub(super) fn dwell(c: &mut Context<'_>, g: &Gathered) {
    let seconds = g.get(b'P').or(g.get(b'X')).or(g.get(b'S')).unwrap_or_default();
    if seconds > 0.0 {
        c.emit(Command::Wait { seconds });
    }
}

/// G61, G61.1, G64.
pub(super) fn path_control(c: &mut Context<'_>, g: &Gathered) {
    let unit = c.core.state.modal.unit.mm();
    let path = match g.g[PATH] {
        Some(610) => PathControl::ExactPath,
        Some(611) => PathControl::ExactStop,
        Some(_) => PathControl::Blend {
            tolerance_mm: g.get(b'P').map(|p| p * unit),
            merge_mm: g.get(b'Q').or(g.get(b'P')).map(|q| q * unit),
        },
        None => return,
    };
    if c.core.state.modal.path != path {
        c.core.state.modal.path = path;
        c.emit(Command::PathControl(path));
    }
}

/// M70 … M73.
pub(super) fn keep_modes(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let Some(code) = g.m[STATE] else { return Ok(()) };
    let modal = Box::new(c.core.state.modal.clone());
    match code {
        70 => *c.core.calls.kept_modes() = Some(modal),
        71 => *c.core.calls.kept_modes() = None,
        72 => match c.core.calls.kept_modes().clone() {
            Some(kept) => restore_modes(c, &kept),
            None => {
                return Err(fail(Code::BadFlow, "M72 without M70", "M70 keeps the modes"));
            }
        },
        _ => {
            let Some(call) = c.core.calls.open.last_mut() else { return Ok(()) };
            call.kept = Some(modal);
            call.restore = true;
        }
    }
    Ok(())
}

/// Brings modes back: what the machine should know is told.
pub(super) fn restore_modes(c: &mut Context<'_>, kept: &Modal) {
    let modal = &mut c.core.state.modal;
    let (rpm, motion) = (kept.rpm, modal.motion);
    let (turn, mist, flood) = (kept.turn, kept.mist, kept.flood);
    let now = modal.clone();
    *modal = kept.clone();
    (modal.turn, modal.mist, modal.flood) = (now.turn, now.mist, now.flood);
    (modal.motion, modal.compensation, modal.rpm) = (motion, now.compensation, now.rpm);
    let (path, overrides) = (modal.path, modal.overrides);
    if path != now.path {
        c.emit(Command::PathControl(path));
    }
    if overrides != now.overrides {
        c.emit(Command::Overrides { feed: overrides[0], spindle: overrides[1] });
    }
    set_speed(c, rpm);
    turn_spindle(c, turn);
    set_coolant(c, mist, flood);
    c.relocate();
}

/// Warns that a unit holds though the file never said it: told once, at the first motion.
pub(super) fn doubt_unit(c: &mut Context<'_>) {
    if c.core.state.modal.unit_said || std::mem::replace(&mut c.core.told.units, true) {
        return;
    }
    let options = &c.core.options;
    if options.dialect.is_of_grbl() || options.keep_modes || options.unit_known {
        return;
    }
    let (name, code, other) = match c.core.state.modal.unit {
        LinearUnit::Inch => ("inches", "G20", "G21 if its numbers are millimetres"),
        LinearUnit::Mm => ("millimetres", "G21", "G20 if its numbers are inches"),
    };
    let message = format!("the file does not say its unit; it is read in {name}");
    c.warn(
        Code::UnitsNeverSaid,
        message,
        format!("write {code} at its beginning if that is right, {other}"),
    );
}
