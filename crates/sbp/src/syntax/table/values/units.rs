//! VU: unit values and resolution.

use crate::syntax::table::setting::{flag, real, whole};
use crate::syntax::table::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};
use kerf_program::Axis;

macro_rules! steps {
    ($name:literal, $axis:ident) => {
        ParamSpec::of(
            $name,
            Kind::Number(Unit::StepsPer(Axis::$axis)),
            real!(resolution.steps_per_unit[Axis::$axis]),
        )
        .within(Bound::NotZero)
        .about("Motor steps for one inch, millimetre or degree; negative turns the axis round.")
    };
}

macro_rules! multiplier {
    ($name:literal, $axis:literal) => {
        ParamSpec::of($name, Kind::Whole, whole!(resolution.multipliers[$axis]))
            .within(Bound::Range(1.0, 10.0))
            .about("Coarser steps while jogging.")
    };
}

static PARAMS: [ParamSpec; 16] = [
    steps!("X unit value", X),
    steps!("Y unit value", Y),
    steps!("Z unit value", Z),
    steps!("A unit value", A),
    ParamSpec::of("Circle resolution", Kind::Number(Unit::Length), real!(resolution.circle_mm))
        .within(Bound::AtLeast(0.005))
        .about("Length of the chords for machines that know no arcs."),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    steps!("B unit value", B),
    multiplier!("X resolution multiplier", 0),
    multiplier!("Y resolution multiplier", 1),
    multiplier!("Z resolution multiplier", 2),
    multiplier!("A resolution multiplier", 3),
    multiplier!("B resolution multiplier", 4),
    ParamSpec::of("Step interval divider", Kind::Whole, whole!(resolution.divider))
        .within(Bound::Range(1.0, 100.0))
        .about("Makes all motion so many times slower."),
    ParamSpec::of("Disable resolution shifting", Kind::OneOf(&[0, 1]), flag!(resolution.no_shift))
        .about("1 limits jogs to about 16 in/s (400 mm/s)."),
];

pub(super) static VU: CommandSpec = CommandSpec::new(
    "VU",
    "Values: unit values",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "Motor steps for a unit of each axis, and the resolution of circles and jogs. In a part file the \
     values go back at its end, unless SV keeps them.",
    Act::Value(act::Value::UnitValues),
);
