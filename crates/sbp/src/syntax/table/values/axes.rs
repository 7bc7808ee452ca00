//! VA: locations.

use crate::syntax::table::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};
use kerf_program::Axis;

const fn working(name: &'static str, axis: Axis) -> ParamSpec {
    ParamSpec::keep(name, Kind::Number(Unit::Axis(axis)))
        .about("What the display shows here from now on.")
}

const fn base(name: &'static str, axis: Axis) -> ParamSpec {
    ParamSpec::keep(name, Kind::Number(Unit::Axis(axis)))
        .about("The same quantity as %(6) to %(10): how far base is ahead of working; a location in the dialect strict.")
}

static PARAMS: [ParamSpec; 10] = [
    working("X location", Axis::X),
    working("Y location", Axis::Y),
    working("Z location", Axis::Z),
    working("A location", Axis::A),
    working("B location", Axis::B),
    base("X table base", Axis::X),
    base("Y table base", Axis::Y),
    base("Z table base", Axis::Z),
    base("A table base", Axis::A),
    base("B table base", Axis::B),
];

pub(super) static VA: CommandSpec = CommandSpec::new(
    "VA",
    "Values: axis locations",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "Says what the present place is called, in working locations and in table base coordinates. \
     Nothing moves. Setting a working location leaves the table base coordinates as they are.",
    Act::Value(act::Value::Locations(5)),
);
