//! VH: torch height, laser and heater.

use crate::interp::{Arguments, Context, Stop};
use crate::table::setting::{changed, flag, real};
use crate::table::{Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit};
use kerf_diag::Code;

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
    height,
);

fn height(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let settings = changed(c, a, &PARAMS);
    if settings.height.on && settings.io.analog == 0 {
        let hint = "VN,,,1 enables the torch, 2 the laser, 3 to 5 analog inputs";
        return Err(c.fail_at(a.span(0), Code::NotEnabled, "not enabled in VN", hint));
    }
    if settings.height.on && settings.io.analog >= 2 && !settings.controller.pwm {
        let hint = "driver.pwm says whether the controller has it";
        return Err(c.fail_at(a.span(0), Code::NotSupported, "no PWM on this controller", hint));
    }
    c.change_settings(|s| *s = settings);
    Ok(())
}
