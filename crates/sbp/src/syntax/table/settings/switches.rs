//! Limit checking, outputs, the warning before motion, the spindle.

use crate::syntax::table::setting::{flag, real};
use crate::syntax::table::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};

static LIMITS: [ParamSpec; 1] = [{
    let mut value = ParamSpec::of("Value", Kind::OneOf(&[0, 1]), flag!(limits.check));
    value.default = crate::syntax::table::Default::Required;
    value.about("1 on, 0 off.")
}];

pub(super) static SF: CommandSpec = CommandSpec::new(
    "SF",
    "Set limit checking",
    Group::Settings,
    &LIMITS,
    Stack::Ends,
    "Whether moves that would leave the table limits of VL are stopped before they begin. In a part \
     file it goes back at its end, unless SV keeps it.",
    Act::Value(act::Value::Set),
);

static WARNING: [ParamSpec; 1] =
    [ParamSpec::of("Duration", Kind::Number(Unit::Seconds), real!(warning_s))
        .within(Bound::NotNegative)
        .special()
        .about("Seconds; 0 is none. Blank is what held when the file began.")];

pub(super) static SW: CommandSpec = CommandSpec::new(
    "SW",
    "Set warning duration",
    Group::Settings,
    &WARNING,
    Stack::Ends,
    "How long light and sound warn before motion starts.",
    Act::Mode(act::Mode::Warning),
);

pub(super) static SO: CommandSpec = CommandSpec::new(
    "SO",
    "Set output switch",
    Group::Settings,
    &[
        ParamSpec::required("Switch number", Kind::Whole).within(Bound::Range(1.0, 12.0)),
        ParamSpec::number("State", Kind::OneOf(&[0, 1, -1, -2, -3, -4]), 0.0).about(
            "1 on, 0 off. Output 4 only: -1 on during motion, -2 also off at a stop, -3 also off at a \
             stall, -4 free.",
        ),
    ],
    Stack::Joins,
    "Switches an output. On goes with the stack of moves, off ends it. Starting the spindle (output \
     1) asks first, unless it is active already, in preview, or when the settings say not to. It is \
     active from the answer on, or by SetSpindleStatus, until a stop or the end of a run that leaves \
     it off.",
    Act::Mode(act::Mode::Output),
);

pub(super) static TR: CommandSpec = CommandSpec::new(
    "TR",
    "Spindle speed",
    Group::Tools,
    &[
        ParamSpec::required("Speed", Kind::Number(Unit::None))
            .within(Bound::NotNegative)
            .about("Revolutions a minute."),
        ParamSpec::number("Spindle", Kind::Whole, 1.0).within(Bound::Range(1.0, 9.0)),
    ],
    Stack::Ends,
    "Sets the speed of a spindle. Without a device for it (`spindle_device`) the operator is asked to set \
     it. CAM programs \
     write it; the reference does not have it.",
    Act::Mode(act::Mode::SpindleSpeed),
);
