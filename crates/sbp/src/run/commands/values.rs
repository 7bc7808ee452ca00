//! The values of the machine. A line that is refused changes nothing: everything is checked before anything is changed.

use super::setting::{changed, set};
use super::{display, speeds};
use crate::run::cutting;
use crate::run::levels;
use crate::run::locate;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::act::Value;
use kerf_diag::Code;
use kerf_program::settings::{AxisUnit, MM_PER_INCH};
use kerf_program::{Axis, AxisSet};

/// Carries a V command out.
pub(super) fn run(c: &mut Context<'_>, act: Value, a: &Arguments) -> Result<(), Stop> {
    match act {
        Value::Set => set(c, a),
        Value::Speeds => {
            speeds::warn_old_order(c, a);
            return speeds::set(c, a);
        }
        Value::Locations(axes) => locations(c, a, axes),
        Value::Tabs => tabs(c, a),
        Value::Cutter => return cutter(c, a),
        Value::Display => return display::set(c, a),
        Value::Height => return height(c, a),
        Value::Channels => return channels(c, a),
        Value::Limits => return limits(c, a),
        Value::Ramps => ramps(c, a),
        Value::UnitValues => {
            set(c, a);
            speeds::warn_capped_jogs(c);
        }
        // The reader makes an assignment of it; what arrives here is none.
        Value::Assignment => {
            let hint = "write VV,&name = value";
            return Err(c.fail_at(a.span(0), Code::Syntax, "an assignment is expected", hint));
        }
    }
    Ok(())
}

/// Names the present place: working locations of the first axes, then their table base coordinates.
fn locations(c: &mut Context<'_>, a: &Arguments, axes: usize) {
    let given = |first: usize| {
        let axes = Axis::ALL.into_iter().take(axes);
        axes.filter_map(move |axis| Some((axis, a.number(first + axis.index())?)))
    };
    let (mut working, mut base) = (AxisSet::EMPTY, AxisSet::EMPTY);
    for (axis, value) in given(0) {
        locate::set_working(c, axis, value);
        working.insert(axis);
    }
    for (axis, value) in given(axes) {
        locate::set_base(c, axis, value);
        base.insert(axis);
    }
    if !(working.is_empty() && base.is_empty()) {
        locate::location_set(c, working, base);
    }
}

const ON: usize = 4;

fn tabs(c: &mut Context<'_>, a: &Arguments) {
    let mut settings = changed(c, a);
    // Number and start belong to one series: what is not given with ON does not hold.
    if a.given(ON) {
        settings.tabs.count = a.whole(ON + 1).map(|n| n as u32);
        settings.tabs.start_mm = a.number(ON + 2);
    }
    // A series under way ends; what follows is tabbed by the new values.
    cutting::end_tabs(c);
    c.change_settings(|s| *s = settings);
    levels::refresh_tabs(c);
}

const TRIGGER: usize = 7;

fn cutter(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let settings = changed(c, a);
    if a.flag(TRIGGER) == Some(true) && c.core.options.typed {
        let hint = "write VC into the file that drills";
        let message = "the triggered output works only in part files";
        return Err(c.fail_at(a.span(TRIGGER), Code::OnlyInFiles, message, hint));
    }
    c.change_settings(|s| *s = settings);
    Ok(())
}

fn channels(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let new = changed(c, a);
    let used = Axis::ALL.into_iter().take(usize::from(new.axis_count));
    if let Some(axis) = used.into_iter().find(|axis| !new.driver.channels.contains(axis)) {
        let letter = axis.letter();
        let message = format!("{letter} would have no driver channel: nothing would move it");
        let hint = "name each axis in use for one of the channels, or use fewer axes (VD)";
        return Err(c.fail_at(c.span, Code::OutOfRange, message, hint));
    }
    set(c, a);
    Ok(())
}

fn height(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let settings = changed(c, a);
    if settings.height.on && settings.io.analog == 0 {
        let hint = "VN,,,1 enables the torch, 2 the laser, 3 to 5 analog inputs";
        return Err(c.fail_at(a.span(0), Code::NotEnabled, "not enabled in VN", hint));
    }
    if settings.height.on && settings.io.analog >= 2 && !settings.controller.pwm {
        let hint = "driver.pwm says whether the controller has it";
        return Err(c.fail_at(a.span(0), Code::NotSupported, "no PWM on this controller", hint));
    }
    c.change_settings(|s| *s = settings);
    Ok(())
}

fn limits(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let settings = changed(c, a);
    let limits = settings.limits;
    if let Some(axis) = Axis::ALL.into_iter().find(|axis| limits.low[*axis] > limits.high[*axis]) {
        let letter = axis.letter();
        let message = format!("the low limit of {letter} is above its high limit");
        let hint = "low and high are given in pairs; a blank keeps what was";
        return Err(c.fail_at(c.span, Code::OutOfRange, message, hint));
    }
    c.change_settings(|s| *s = settings);
    Ok(())
}

/// The first eight values are ramp speeds; these are the axes they belong to.
const AXES: [Axis; 8] = [Axis::X, Axis::Z, Axis::A, Axis::B, Axis::X, Axis::Z, Axis::A, Axis::B];

fn ramps(c: &mut Context<'_>, a: &Arguments) {
    set(c, a);
    let speeds = AXES.into_iter().enumerate().filter_map(|(i, axis)| {
        let linear = c.settings().axis_unit(axis) != AxisUnit::Degrees;
        Some((a.params()[i].name, a.number(i)? / MM_PER_INCH)).filter(|_| linear)
    });
    // Command reference, "Working with Ramp Speed".
    let odd: Vec<_> = speeds.filter(|(_, v)| !(0.2 - 1e-9..=1.2 + 1e-9).contains(v)).collect();
    for (name, speed) in odd {
        let (what, hint) = if speed < 0.2 {
            ("slow", "below 0.2 in/s (5 mm/s) a slower start brings little")
        } else {
            ("fast", "above 1.2 in/s (30 mm/s) motors may lose steps")
        };
        c.warn(Code::Unusual, format!("{} is {what}", name.to_lowercase()), hint);
    }
}
