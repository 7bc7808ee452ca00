//! VD: units, number of axes, and what is displayed.

use crate::Value;
use crate::interp::{Arguments, Context, Stop};
use crate::table::setting::{changed, flag, real, whole};
use crate::table::{Bound, CommandSpec, Group, Kind, ParamSpec, Setting, Stack, Unit};
use kerf_diag::Code;
use kerf_program::settings::{AxisUnit, LinearUnit, to_user};
use kerf_program::{Axis, AxisSet, Command, Settings};
use std::sync::Arc;

const SWITCH: Kind = Kind::OneOf(&[0, 1]);
const TWIPS: Kind = Kind::Number(Unit::Twips);
const KEYPAD: usize = 7;
/// Parameters of version 3; files for version 2 may have more.
const COUNT: usize = 18;

static PARAMS: [ParamSpec; 24] = [
    ParamSpec::obsolete(),
    ParamSpec::of("Number of axes", Kind::Whole, whole!(axis_count))
        .within(Bound::Range(3.0, 6.0))
        .about("How many of X Y Z A B C are in use."),
    ParamSpec::of("Linear units", SWITCH, LINEAR).about("0 inches, 1 mm. Values keep their size."),
    ParamSpec::of("A axis units", Kind::OneOf(&[0, 1, 2]), A).about("0 inches, 1 mm, 2 degrees."),
    ParamSpec::of("B axis units", Kind::OneOf(&[0, 1, 2]), B).about("0 inches, 1 mm, 2 degrees."),
    ParamSpec::of("Control console", SWITCH, flag!(display.console)).about("Obsolete."),
    ParamSpec::of("Display file comments", SWITCH, flag!(display.comments))
        .about("1 opens the message screen for comments."),
    ParamSpec::of(
        "Keypad fixed distance",
        Kind::Number(Unit::Length),
        real!(display.keypad_fixed_mm),
    )
    .within(Bound::Positive)
    .about("How far a tap moves."),
    ParamSpec::of("Keypad remote", Kind::OneOf(&[0, 1, 2]), whole!(display.keypad_remote))
        .about("0 mouse, 1 pendant on the inputs, 2 another."),
    ParamSpec::of("Part file log", SWITCH, flag!(display.part_log)),
    ParamSpec::of("System log", SWITCH, flag!(display.system_log)),
    ParamSpec::of("Message screen X", TWIPS, real!(display.message_twips[0])),
    ParamSpec::of("Message screen Y", TWIPS, real!(display.message_twips[1])),
    ParamSpec::of("Message screen width", TWIPS, real!(display.message_twips[2]))
        .within(Bound::Positive),
    ParamSpec::of("Message screen height", TWIPS, real!(display.message_twips[3]))
        .within(Bound::Positive),
    ParamSpec::of("Keypad switches off", SWITCH, flag!(display.keypad_auto_off))
        .about("1 switches all outputs off when the keypad closes."),
    ParamSpec::of("File progress", SWITCH, flag!(display.progress)),
    ParamSpec::of("Main display", SWITCH, flag!(display.easy)).about("1 EASY, 0 FULL."),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
];

const LINEAR: Setting = Setting {
    read: |s| Some(Value::Number(unit_code(AxisUnit::Linear(s.linear_unit)))),
    write: |s, v| {
        let unit = if v.number() == Some(1.0) { LinearUnit::Mm } else { LinearUnit::Inch };
        // The other linear axes follow, unless their own fields say otherwise.
        s.use_linear_unit(unit);
    },
};

const A: Setting = Setting {
    read: |s| Some(Value::Number(unit_code(s.axis_unit(Axis::A)))),
    write: |s, v| set_axis_unit(s, Axis::A, unit_of(v)),
};

const B: Setting = Setting {
    read: |s| Some(Value::Number(unit_code(s.axis_unit(Axis::B)))),
    write: |s, v| set_axis_unit(s, Axis::B, unit_of(v)),
};

const fn unit_code(unit: AxisUnit) -> f64 {
    match unit {
        AxisUnit::Linear(LinearUnit::Inch) => 0.0,
        AxisUnit::Linear(LinearUnit::Mm) => 1.0,
        AxisUnit::Degrees => 2.0,
    }
}

fn unit_of(code: &Value) -> AxisUnit {
    match code.number() {
        Some(1.0) => AxisUnit::Linear(LinearUnit::Mm),
        Some(2.0) => AxisUnit::Degrees,
        _ => AxisUnit::Linear(LinearUnit::Inch),
    }
}

/// Gives an accessory axis its unit. Between inches and mm its values keep their size; between
/// lengths and degrees there is none to keep, so they keep their numbers.
fn set_axis_unit(s: &mut Settings, axis: Axis, unit: AxisUnit) {
    let old = s.axis_unit(axis);
    if let Some(place) = s.rotary_units.get_mut(axis.index() - 3) {
        *place = unit;
    }
    if !is_turn(old, unit) {
        return;
    }
    let factor = unit.scale() / old.scale();
    for speed in [&mut s.speeds.cut, &mut s.speeds.jog, &mut s.ramps.cut, &mut s.ramps.jog] {
        *speed.of_mut(axis) *= factor;
    }
    s.limits.low[axis] *= factor;
    s.limits.high[axis] *= factor;
    s.tool_offset.offset[axis] *= factor;
    s.resolution.steps_per_unit[axis] /= factor;
    if axis == Axis::A {
        s.cutter.safe_a_mm *= factor;
    }
}

/// Returns `true` if an axis changes between lengths and degrees.
fn is_turn(old: AxisUnit, new: AxisUnit) -> bool {
    (old == AxisUnit::Degrees) != (new == AxisUnit::Degrees)
}

pub(super) static VD: CommandSpec = CommandSpec::new(
    "VD",
    "Values: display",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "Units, number of axes, and what is shown where. After a change of units every value reads and \
     is given in the new one; nothing else changes. Alone it clears the message screen.",
    display,
);

fn display(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    if (COUNT..a.len()).any(|i| a.given(i)) {
        let hint = "values behind the 18th are ignored";
        c.warn(Code::OldOrder, "the order of VD is that of version 3", hint);
    }
    let old = c.settings().clone();
    let mut new = changed(c, a, &PARAMS);
    // This length is meant in the unit that the same line chooses.
    if let Some(distance) = a.number(KEYPAD) {
        new.display.keypad_fixed_mm = distance / old.linear_unit.mm() * new.linear_unit.mm();
    }
    turn_axes(c, &old, &new);
    c.core.settings = Arc::new(new);
    c.core.refresh_scale();
    // Told even when all is as before: a given value also opens or closes the message screen.
    let settings = c.core.settings.clone();
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
        let position = c.core.position;
        let renamed = |internal: f64| to_user(internal, old.axis_scale(axis)) * unit.scale();
        let working = renamed(c.core.frame.working(position)[axis]);
        let base = renamed(c.core.frame.base(position)[axis]);
        c.core.frame.set_working(axis, position, working);
        c.core.frame.set_base(axis, position, base);
        let kept = Arc::make_mut(&mut c.core.kept);
        kept.rotary_units = old.rotary_units;
        set_axis_unit(kept, axis, unit);
    }
    if !turned.is_empty() {
        c.location_changed(turned, turned);
    }
}
