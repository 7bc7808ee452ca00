//! VH: torch height, laser and heater.

use crate::syntax::table::setting::{flag, real};
use crate::syntax::table::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};

const PERCENT: Kind = Kind::Number(Unit::Percent);

const NUMBER: Kind = Kind::Number(Unit::None);

static PARAMS: [ParamSpec; 7] = [
    ParamSpec::of("Mode", Kind::OneOf(&[0, 1]), flag!(height.on))
        .about("1 on, 0 off; with 0 the other values are prepared for later."),
    ParamSpec::of("Height rate", NUMBER, real!(height.rate))
        .within(Bound::NotNegative)
        .about("Torch: speed of Z as a share of the XY speed."),
    ParamSpec::of("Laser low", PERCENT, real!(height.low_percent))
        .within(Bound::Range(0.0, 100.0))
        .about("PWM at rest, percent."),
    ParamSpec::of("Laser high", PERCENT, real!(height.high_percent))
        .within(Bound::Range(0.0, 100.0))
        .about("PWM at full speed, percent."),
    ParamSpec::of("Pulse frequency", NUMBER, real!(height.frequency_khz))
        .within(Bound::Positive)
        .about("Kilohertz."),
    ParamSpec::of("Low cycle time", NUMBER, real!(height.low_cycle))
        .within(Bound::Range(1.0, 10.0))
        .about("Heater: share of time at low PWM, tenths."),
    ParamSpec::of("Set temperature", NUMBER, real!(height.temperature))
        .within(Bound::NotNegative)
        .about("Heater: 0 is off."),
];

pub(super) static VH: CommandSpec = CommandSpec::new(
    "VH",
    "Values: height control",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "Torch height control, laser power or a heater, whichever VN enables in its third value.",
    Act::Value(act::Value::Height),
);
