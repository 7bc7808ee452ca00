//! Commands of FabMo's dialect: probes, SU, and VA and VS with their values in another order.
//!
//! They stand before those of the same letters when a file is read in that dialect.

use super::setting::real;
use super::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};
use kerf_program::Axis;

macro_rules! axis {
    ($name:literal, $axis:ident) => {
        ParamSpec::keep($name, Kind::Number(Unit::Axis(Axis::$axis)))
    };
}

/// Location, speed and input of a probe along one axis.
macro_rules! single {
    ($letters:literal, $axis:ident) => {
        CommandSpec::new(
            $letters,
            concat!("Probe ", stringify!($axis)),
            Group::Move,
            &[
                ParamSpec::required("Target", Kind::Number(Unit::Axis(Axis::$axis)))
                    .about("Where the search ends at the latest."),
                ParamSpec::required("Speed", Kind::Number(Unit::AxisSpeed(Axis::$axis)))
                    .within(Bound::Positive),
                INPUT,
            ],
            Stack::Ends,
            PROBE,
            Act::Move(act::Move::Probe { first: Axis::$axis.index() }),
        )
    };
}

/// Locations of the first axes, speed and input of a probe.
macro_rules! several {
    ($letters:literal, $($target:expr),*) => {
        CommandSpec::new(
            $letters,
            concat!("Probe ", $letters),
            Group::Move,
            &[
                $($target,)*
                ParamSpec::required("Speed", Kind::Number(Unit::Speed)).within(Bound::Positive),
                INPUT,
            ],
            Stack::Ends,
            PROBE,
            Act::Move(act::Move::Probe { first: 0 }),
        )
    };
}

const PROBE: &str = "Moves until an input goes on, or to the target when it never does; the program \
     goes on behind it either way. FabMo.";

const INPUT: ParamSpec = ParamSpec::required("Input", Kind::Whole).within(Bound::Range(1.0, 12.0));

const X: ParamSpec = axis!("X target", X);

const Y: ParamSpec = axis!("Y target", Y);

const Z: ParamSpec = axis!("Z target", Z);

const A: ParamSpec = axis!("A target", A);

const B: ParamSpec = axis!("B target", B);

/// Every command of the dialect.
pub static SPECS: [CommandSpec; 14] = [
    single!("PX", X),
    single!("PY", Y),
    single!("PZ", Z),
    single!("PA", A),
    single!("PB", B),
    single!("PC", C),
    several!("P2", X, Y),
    several!("P3", X, Y, Z),
    several!("P4", X, Y, Z, A),
    several!("P5", X, Y, Z, A, B),
    CommandSpec::new(
        "SU",
        "Set unit",
        Group::Settings,
        &[ParamSpec::required("Unit", Kind::Word(&UNITS)).about("0, in or inches; 1 or mm.")],
        Stack::Ends,
        "The unit of the lines that follow, up to the end of the run. FabMo.",
        Act::Mode(act::Mode::Unit),
    ),
    CommandSpec::new(
        "SC",
        "Set coordinates",
        Group::Settings,
        &[ParamSpec::required("System", Kind::OneOf(&[0, 1])).about("0 table base, 1 working.")],
        Stack::Ends,
        "Locations of the table base (0) up to the end of the run or SC,1, which brings the working ones back. FabMo.",
        Act::Mode(act::Mode::Coordinates),
    ),
    CommandSpec::new(
        "VA",
        "Values: axis locations",
        Group::Values,
        &LOCATIONS,
        Stack::Ends,
        "What the present place is called: six working locations, then how far base is ahead of \
         working for six axes. FabMo.",
        Act::Value(act::Value::Locations(6)),
    ),
    CommandSpec::new(
        "VS",
        "Values: speeds",
        Group::Values,
        &SPEEDS,
        Stack::Joins,
        "Move speeds of XY, Z, A, B and C, then their jog speeds. FabMo.",
        Act::Move(act::Move::Speeds),
    ),
];

/// Words that SU takes.
static UNITS: [&str; 8] = ["0", "IN", "INCH", "INCHES", "1", "MM", "MILLIMETER", "MILLIMETERS"];

static LOCATIONS: [ParamSpec; 12] = [
    axis!("X location", X),
    axis!("Y location", Y),
    axis!("Z location", Z),
    axis!("A location", A),
    axis!("B location", B),
    axis!("C location", C),
    axis!("X table base", X),
    axis!("Y table base", Y),
    axis!("Z table base", Z),
    axis!("A table base", A),
    axis!("B table base", B),
    axis!("C table base", C),
];

macro_rules! speed {
    ($name:literal, $unit:expr, $($place:tt)+) => {
        ParamSpec::of($name, Kind::Number($unit), real!(speeds.$($place)+)).within(Bound::Positive)
    };
}

static SPEEDS: [ParamSpec; 10] = [
    speed!("XY move speed", Unit::Speed, cut.xy),
    speed!("Z move speed", Unit::Speed, cut.z),
    speed!("A move speed", Unit::AxisSpeed(Axis::A), cut.a),
    speed!("B move speed", Unit::AxisSpeed(Axis::B), cut.b),
    speed!("C move speed", Unit::AxisSpeed(Axis::C), cut.c),
    speed!("XY jog speed", Unit::Speed, jog.xy),
    speed!("Z jog speed", Unit::Speed, jog.z),
    speed!("A jog speed", Unit::AxisSpeed(Axis::A), jog.a),
    speed!("B jog speed", Unit::AxisSpeed(Axis::B), jog.b),
    speed!("C jog speed", Unit::AxisSpeed(Axis::C), jog.c),
];
