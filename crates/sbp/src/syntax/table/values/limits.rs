//! VL: table limits.

use crate::syntax::table::setting::{flag, real};
use crate::syntax::table::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};
use kerf_program::Axis;

macro_rules! limit {
    ($name:literal, $side:ident, $axis:ident) => {
        ParamSpec::of(
            $name,
            Kind::Number(Unit::Axis(Axis::$axis)),
            real!(limits.$side[Axis::$axis]),
        )
    };
}

static PARAMS: [ParamSpec; 12] = [
    limit!("Low X", low, X),
    limit!("High X", high, X),
    limit!("Low Y", low, Y),
    limit!("High Y", high, Y),
    limit!("Low Z", low, Z),
    limit!("High Z", high, Z),
    limit!("Low A", low, A),
    limit!("High A", high, A),
    ParamSpec::of("Limit checking", Kind::OneOf(&[0, 1]), flag!(limits.check))
        .about("1 refuses moves that would leave the limits, as SF does."),
    limit!("Low B", low, B),
    limit!("High B", high, B),
    // Real files end with the number of axes to check, which the reference has not.
    ParamSpec::obsolete(),
];

pub(super) static VL: CommandSpec = CommandSpec::new(
    "VL",
    "Values: table limits",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "How far each axis may go, in table base coordinates, and whether that is checked. In a part \
     file the values go back at its end, unless SV keeps them.",
    Act::Value(act::Value::Limits),
);
