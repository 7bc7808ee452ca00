//! VI: connection and driver channels.

use crate::syntax::table::setting::{axis, flag, whole};
use crate::syntax::table::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Setting, Stack, act};
use kerf_program::Axis;

const fn channel(name: &'static str, setting: Setting) -> ParamSpec {
    ParamSpec::of(name, Kind::AxisLetter, setting)
        .about("The axis that it drives; an axis on two channels drives both.")
}

static PARAMS: [ParamSpec; 12] = [
    ParamSpec::of("Comm port", Kind::Whole, whole!(driver.port))
        .within(Bound::Range(1.0, 16.0))
        .about("Which of the connections in the settings is used."),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    channel("Driver channel 1", axis!(driver.channels[0])),
    channel("Driver channel 2", axis!(driver.channels[1])),
    channel("Driver channel 3", axis!(driver.channels[2])),
    channel("Driver channel 4", axis!(driver.channels[3])),
    ParamSpec::of("Speed", Kind::OneOf(&[2, 3, 4, 5]), whole!(driver.speed_code)).about(
        "2 is 115.2, 3 is 230.4, 4 is 460.8, 5 is 921.6 kbaud, from the next connection on.",
    ),
    channel("Driver channel 5", axis!(driver.channels[4])),
    channel("Driver channel 6", axis!(driver.channels[5])),
    ParamSpec::of("Enable", Kind::OneOf(&[0, 1]), flag!(driver.enabled))
        .about("0 gives no steps and switches no outputs."),
];

pub(super) static VI: CommandSpec = CommandSpec::new(
    "VI",
    "Values: connection and channels",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "How the controller is reached and which axis each driver channel drives. In a part file the \
     values go back at its end, unless SV keeps them.",
    Act::Value(act::Value::Channels),
);
