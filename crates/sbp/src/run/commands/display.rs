//! VD: units, number of axes, and what is displayed.

use super::setting::changed;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::{is_turn, set_axis_unit};
use kerf_diag::Code;
use kerf_program::settings::to_user;
use kerf_program::{Axis, AxisSet, Command, Settings};
use std::sync::Arc;

const KEYPAD: usize = 7;

/// Parameters of version 3; files for version 2 may have more.
const COUNT: usize = 18;

/// Sets units, number of axes and what is shown.
pub(super) fn set(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    if (COUNT..a.len()).any(|i| a.given(i)) {
        let hint = "values behind the 18th are ignored";
        c.warn(Code::OldOrder, "the order of VD is that of version 3", hint);
    }
    let old = c.settings().clone();
    let mut new = changed(c, a);
    // This length is meant in the unit that the same line chooses.
    if let Some(distance) = a.number(KEYPAD) {
        new.display.keypad_fixed_mm = distance / old.linear_unit.mm() * new.linear_unit.mm();
    }
    turn_axes(c, &old, &new);
    c.core.values.settings = Arc::new(new);
    c.core.refresh_scale();
    // Told even when all is as before: a given value also opens or closes the message screen.
    let settings = c.core.values.settings.clone();
    c.emit(Command::Settings(settings));
    Ok(())
}

/// Locations of an axis that changes between lengths and degrees keep their numbers, and so do the
/// values that return at the end of the run.
fn turn_axes(c: &mut Context<'_>, old: &Settings, new: &Settings) {
    let mut turned = AxisSet::EMPTY;
    for axis in [Axis::A, Axis::B] {
        let unit = new.axis_unit(axis);
        if !is_turn(old.axis_unit(axis), unit) {
            continue;
        }
        turned.insert(axis);
        let position = c.core.place.position;
        let renamed = |internal: f64| to_user(internal, old.axis_scale(axis)) * unit.scale();
        let working = renamed(c.core.place.frame.working(position)[axis]);
        let base = renamed(c.core.place.frame.base(position)[axis]);
        c.core.place.frame.set_working(axis, position, working);
        c.core.place.frame.set_base(axis, position, base);
        let kept = Arc::make_mut(&mut c.core.values.kept);
        kept.rotary_units = old.rotary_units;
        set_axis_unit(kept, axis, unit);
    }
    if !turned.is_empty() {
        c.location_changed(turned, turned);
    }
}
