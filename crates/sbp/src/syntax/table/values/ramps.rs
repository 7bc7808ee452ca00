//! VR: ramps.

use crate::syntax::table::setting::real;
use crate::syntax::table::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};
use kerf_program::Axis;

const SPEED: Kind = Kind::Number(Unit::Speed);

const LENGTH: Kind = Kind::Number(Unit::Length);

const PERCENT: Kind = Kind::Number(Unit::Percent);

const A: Kind = Kind::Number(Unit::AxisSpeed(Axis::A));

const B: Kind = Kind::Number(Unit::AxisSpeed(Axis::B));

macro_rules! ramp {
    ($name:literal, $kind:ident, $($place:tt)+) => {
        ParamSpec::of($name, $kind, real!(ramps.$($place)+)).within(Bound::Positive)
    };
}

static PARAMS: [ParamSpec; 17] = [
    ramp!("XY move ramp speed", SPEED, cut.xy).about("Speed at which moves start and end."),
    ramp!("Z move ramp speed", SPEED, cut.z),
    ramp!("A move ramp speed", A, cut.a),
    ramp!("B move ramp speed", B, cut.b),
    ramp!("XY jog ramp speed", SPEED, jog.xy).about("Speed at which jogs start and end."),
    ramp!("Z jog ramp speed", SPEED, jog.z),
    ramp!("A jog ramp speed", A, jog.a),
    ramp!("B jog ramp speed", B, jog.b),
    ramp!("Move ramp rate", LENGTH, cut_rate_mm)
        .about("Path in which a move gains 2 in/s (50.8 mm/s) from its ramp speed."),
    ramp!("Jog ramp rate", LENGTH, jog_rate_mm),
    ramp!("3D threshold", PERCENT, threshold_3d_percent)
        .about("More makes ramps for changes of Z speed rarer."),
    ramp!("Minimum distance", LENGTH, min_distance_mm)
        .about("Path over which changes of direction are summed."),
    ParamSpec::of("Slow corner speed", PERCENT, real!(ramps.slow_corner_percent))
        .within(Bound::Range(1.0, 100.0))
        .about("Speed at a gentle corner in percent of the speed before it."),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    ramp!("Keypad ramp rate", LENGTH, keypad_rate_mm),
    ParamSpec::of("Small circle", LENGTH, real!(ramps.small_circle_mm))
        .within(Bound::NotNegative)
        .about("Circles of a smaller diameter run at ramp speed."),
];

pub(super) static VR: CommandSpec = CommandSpec::new(
    "VR",
    "Values: ramps",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "How moves and jogs speed up and slow down.",
    Act::Value(act::Value::Ramps),
);
