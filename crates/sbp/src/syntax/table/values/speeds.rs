//! VS, and the speeds that MS and JS set too.

use crate::syntax::table::setting::real;
use crate::syntax::table::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};
use kerf_program::Axis;

macro_rules! speed {
    ($name:literal, $unit:expr, $($place:tt)+) => {
        ParamSpec::of($name, Kind::Number($unit), real!(speeds.$($place)+)).within(Bound::Positive)
    };
}

const A: Unit = Unit::AxisSpeed(Axis::A);

const B: Unit = Unit::AxisSpeed(Axis::B);

/// The move speeds, as MS lists them.
pub(crate) const MOVE: [ParamSpec; 4] = [
    speed!("XY move speed", Unit::Speed, cut.xy).about("Of the tool's tip along its path."),
    speed!("Z move speed", Unit::Speed, cut.z),
    speed!("A move speed", A, cut.a),
    speed!("B move speed", B, cut.b),
];

/// The jog speeds, as JS lists them.
pub(crate) const JOG: [ParamSpec; 4] = [
    speed!("XY jog speed", Unit::Speed, jog.xy).about("Of the tool's tip along its path."),
    speed!("Z jog speed", Unit::Speed, jog.z),
    speed!("A jog speed", A, jog.a),
    speed!("B jog speed", B, jog.b),
];

static PARAMS: [ParamSpec; 8] =
    [MOVE[0], MOVE[1], MOVE[2], MOVE[3], JOG[0], JOG[1], JOG[2], JOG[3]];

pub(super) static VS: CommandSpec = CommandSpec::new(
    "VS",
    "Values: speeds",
    Group::Values,
    &PARAMS,
    Stack::Joins,
    "Move and jog speeds of all axes. Unlike MS and JS it does not interrupt motion. In a part file \
     the values go back at its end, unless SV keeps them.",
    Act::Value(act::Value::Speeds),
);
