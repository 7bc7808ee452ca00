//! VO: the temporary tool offset.

use crate::syntax::Value;
use crate::syntax::table::setting::real;
use crate::syntax::table::{Act, CommandSpec, Group, Kind, ParamSpec, Setting, Stack, Unit, act};
use kerf_program::Axis;

macro_rules! offset {
    ($name:literal, $axis:ident) => {
        ParamSpec::of(
            $name,
            Kind::Number(Unit::Axis(Axis::$axis)),
            real!(tool_offset.offset[Axis::$axis]),
        )
    };
}

static PARAMS: [ParamSpec; 7] = [
    ParamSpec::of("Offset", Kind::OneOf(&[0, 1, 2]), ON).about("1 on, 2 off; 0 is off too."),
    offset!("Offset X", X),
    offset!("Offset Y", Y),
    offset!("Offset Z", Z),
    offset!("Offset A", A),
    offset!("Offset B", B),
    offset!("Offset C", C),
];

const ON: Setting = Setting {
    read: |s| Some(Value::Number(if s.tool_offset.on { 1.0 } else { 2.0 })),
    write: |s, v| s.tool_offset.on = v.number() == Some(1.0),
};

pub(super) static VO: CommandSpec = CommandSpec::new(
    "VO",
    "Values: temporary tool offset",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "Shifts every axis that a program moves, after offsets and proportions of the file, as a second \
     head needs it. Nothing moves by itself; locations show where the tool really is. Ends with the \
     part file.",
    Act::Value(act::Value::Set),
);
