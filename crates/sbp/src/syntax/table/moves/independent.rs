//! MI: an axis that turns or swings beside the others. MO: motors off.

use crate::syntax::table::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};

const NUMBER: Kind = Kind::Number(Unit::None);

static PARAMS: [ParamSpec; 5] = [
    {
        let mut axis = ParamSpec::keep("Axis", Kind::AxisLetter);
        axis.default = crate::syntax::table::Default::Word("B");
        axis
    },
    ParamSpec::number("Direction", Kind::OneOf(&[1, -1]), 1.0)
        .about("Of a rotation: 1 clockwise, -1 the other way."),
    ParamSpec::keep("Rotary speed", NUMBER)
        .within(Bound::NotNegative)
        .about("Units of the axis a second; 0 stops it. Not with a frequency."),
    ParamSpec::keep("Frequency", NUMBER)
        .within(Bound::NotNegative)
        .about("Of an oscillation, cycles a second; 0 stops it."),
    ParamSpec::keep("Distance", NUMBER)
        .within(Bound::Positive)
        .about("Of an oscillation, from one end to the other, in units of the axis."),
];

pub(super) static MI: CommandSpec = CommandSpec::new(
    "MI",
    "Move Indexer",
    Group::Move,
    &PARAMS,
    Stack::Ends,
    "Turns an axis at a speed, or swings it, until it is stopped, while the program goes on with the \
     other axes. The end of a file does not stop it; MO does.",
    Act::Move(act::Move::Independent),
);

pub(super) static MO: CommandSpec = CommandSpec::new(
    "MO",
    "Motors Off",
    Group::Move,
    &[],
    Stack::Ends,
    "Cuts motor power, where the controller can, and turns all outputs off. Pushing the machine by \
     hand afterwards loses its position and makes the motors generate voltage. M0 is the same.",
    Act::Move(act::Move::MotorsOff),
);
