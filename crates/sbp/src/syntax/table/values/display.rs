//! VD: units, number of axes, and what is displayed.

use crate::syntax::Value;
use crate::syntax::table::setting::{flag, real, whole};
use crate::syntax::table::{
    Act, Bound, CommandSpec, Group, Kind, ParamSpec, Setting, Stack, Unit, act,
};
use kerf_program::settings::{AxisUnit, LinearUnit};
use kerf_program::{Axis, Settings};

const SWITCH: Kind = Kind::OneOf(&[0, 1]);

const TWIPS: Kind = Kind::Number(Unit::Twips);

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
pub(crate) fn set_axis_unit(s: &mut Settings, axis: Axis, unit: AxisUnit) {
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
pub(crate) fn is_turn(old: AxisUnit, new: AxisUnit) -> bool {
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
    Act::Value(act::Value::Display),
);
