//! The table of system variables.

use super::{Context, Family, Stop, VERSION};
use crate::Value;
use crate::run::sysvar;
use kerf_program::Axis;
use kerf_program::settings::{Distance, LinearUnit, Mode, PerGroup};

const UNITS: &str = "user units";
const SPEED: &str = "user units/s";
const SWITCH: &str = "0-1";
const INPUT_MODE: &str = "0-4";
const OUTPUT_MODE: &str = "0-5";

const fn family(
    first: u8,
    unit: &'static str,
    names: &'static [&'static str],
    read: fn(&mut Context<'_>, usize) -> Result<Value, Stop>,
) -> Family {
    Family { first, unit, names, read }
}

pub(super) static FAMILIES: &[Family] = &[
    family(
        1,
        UNITS,
        &["location X", "location Y", "location Z", "location A", "location B"],
        |c, i| sysvar::working_location(c, Axis::ALL[i]),
    ),
    family(
        6,
        UNITS,
        &["table base X", "table base Y", "table base Z", "table base A", "table base B"],
        |c, i| sysvar::base_location(c, Axis::ALL[i]),
    ),
    family(
        11,
        UNITS,
        &[
            "low limit X",
            "high limit X",
            "low limit Y",
            "high limit Y",
            "low limit Z",
            "high limit Z",
            "low limit A",
            "high limit A",
            "low limit B",
            "high limit B",
        ],
        |c, i| {
            let (axis, limits) = (Axis::ALL[i / 2], c.settings().limits);
            let side = if i % 2 == 0 { limits.low } else { limits.high };
            Ok(sysvar::axis_value(c, axis, side[axis]))
        },
    ),
    family(21, SWITCH, &["distance mode: 0 absolute, 1 relative"], |c, _| {
        truth(c.settings().distance == Distance::Relative)
    }),
    family(22, SWITCH, &["mode: 0 move/cut, 1 preview"], |c, _| {
        truth(c.core.options.preview || c.settings().mode == Mode::Preview)
    }),
    family(23, UNITS, &["cutter diameter"], |c, _| {
        Ok(sysvar::length_value(c, c.settings().cutter.diameter_mm))
    }),
    family(25, SWITCH, &["linear unit: 0 inches, 1 mm"], |c, _| {
        truth(c.settings().linear_unit == LinearUnit::Mm)
    }),
    family(27, "3-6", &["number of axes"], |c, _| number(c.settings().axis_count)),
    family(28, UNITS, &["Safe-Z, empty when off"], |c, _| {
        let height = c.settings().cutter.safe_z_mm;
        Ok(height.map_or(Value::Empty, |mm| sysvar::length_value(c, mm)))
    }),
    family(29, UNITS, &["Safe-A"], |c, _| {
        Ok(sysvar::axis_value(c, Axis::A, c.settings().cutter.safe_a_mm))
    }),
    family(30, "3-6", &["number of axes whose limits are checked"], |c, _| {
        number(c.settings().axis_count)
    }),
    family(
        31,
        "steps a user unit",
        &["unit value X", "unit value Y", "unit value Z", "unit value A", "unit value B"],
        |c, i| {
            let axis = Axis::ALL[i];
            let scale = 1.0 / c.settings().axis_scale(axis);
            let steps = c.settings().resolution.steps_per_unit[axis];
            Ok(Value::Number(kerf_program::settings::to_user(steps, scale)))
        },
    ),
    family(
        36,
        "X-C",
        &[
            "axis of driver channel 1",
            "axis of driver channel 2",
            "axis of driver channel 3",
            "axis of driver channel 4",
            "axis of driver channel 5",
        ],
        |c, i| Ok(Value::text(c.settings().driver.channels[i].letter().to_string())),
    ),
    family(41, UNITS, &["tab pull-up", "distance to next tab", "tab size", "tab lead"], |c, i| {
        let tabs = c.settings().tabs;
        Ok(sysvar::length_value(c, [tabs.up_mm, tabs.next_mm, tabs.size_mm, tabs.lead_mm][i]))
    }),
    family(46, SWITCH, &["input 3 is a limit (obsolete)"], |c, _| {
        truth(matches!(c.settings().io.inputs[2], 1 | 2))
    }),
    family(47, SWITCH, &["input 4 is normally open (obsolete)"], |c, _| {
        truth(c.settings().io.input4_normally_open)
    }),
    family(48, "text", &["software version"], |_, _| Ok(Value::text(VERSION))),
    family(49, "whole number", &["firmware version"], |c, _| {
        Ok(Value::Number(f64::from(c.host.firmware())))
    }),
    family(50, "0-255", &["inputs 1-8 as a byte, input 1 lowest"], |c, _| {
        byte(c, 1, sysvar::input_state)
    }),
    family(
        51,
        SWITCH,
        &["input 1", "input 2", "input 3", "input 4", "input 5", "input 6", "input 7", "input 8"],
        |c, i| truth(sysvar::input_state(c, i + 1)?),
    ),
    family(60, "text", &["name of the current file"], |c, _| {
        let running = !c.core.flow.levels.is_empty();
        Ok(if running { Value::text(&c.program.name) } else { Value::Empty })
    }),
    family(
        61,
        UNITS,
        &["offset X of the file", "offset Y of the file", "offset Z of the file"],
        |c, i| Ok(sysvar::length_value(c, c.core.flow.level().map_or(0.0, |l| l.offset[i]))),
    ),
    family(
        66,
        "factor",
        &["proportion X of the file", "proportion Y of the file", "proportion Z of the file"],
        |c, i| Ok(Value::Number(c.core.flow.proportion(Axis::ALL[i]))),
    ),
    family(
        71,
        SPEED,
        &["move speed X", "move speed Y", "move speed Z", "move speed A", "move speed B"],
        |c, i| speed(c, c.settings().speeds.cut, i),
    ),
    family(
        76,
        SPEED,
        &["jog speed X", "jog speed Y", "jog speed Z", "jog speed A", "jog speed B"],
        |c, i| speed(c, c.settings().speeds.jog, i),
    ),
    family(
        81,
        SPEED,
        &[
            "move ramp speed X",
            "move ramp speed Y",
            "move ramp speed Z",
            "move ramp speed A",
            "move ramp speed B",
        ],
        |c, i| speed(c, c.settings().ramps.cut, i),
    ),
    family(
        86,
        SPEED,
        &[
            "jog ramp speed X",
            "jog ramp speed Y",
            "jog ramp speed Z",
            "jog ramp speed A",
            "jog ramp speed B",
        ],
        |c, i| speed(c, c.settings().ramps.jog, i),
    ),
    family(
        91,
        INPUT_MODE,
        &[
            "mode of input 1",
            "mode of input 2",
            "mode of input 3",
            "mode of input 4",
            "mode of input 5",
            "mode of input 6",
            "mode of input 7",
            "mode of input 8",
        ],
        |c, i| input_mode(c, i),
    ),
    family(99, SWITCH, &["torch height control"], |c, _| truth(c.settings().io.analog == 1)),
    family(100, "0-255", &["outputs 1-8 as a byte, output 1 lowest"], |c, _| {
        byte(c, 1, sysvar::output_state)
    }),
    family(
        101,
        SWITCH,
        &[
            "output 1", "output 2", "output 3", "output 4", "output 5", "output 6", "output 7",
            "output 8",
        ],
        |c, i| truth(sysvar::output_state(c, i + 1)?),
    ),
    family(109, "-1 to -4", &["mode of output 4"], |c, _| {
        Ok(Value::Number(f64::from(c.settings().io.output4)))
    }),
    family(
        111,
        OUTPUT_MODE,
        &[
            "file mode of output 1",
            "file mode of output 2",
            "file mode of output 3",
            "file mode of output 4",
            "file mode of output 5",
            "file mode of output 6",
            "file mode of output 7",
            "file mode of output 8",
            "file mode of output 9",
            "file mode of output 10",
            "file mode of output 11",
            "file mode of output 12",
        ],
        |c, i| number(c.settings().io.outputs[i]),
    ),
    family(123, SWITCH, &["an axis moves by itself (MI)"], |c, _| {
        truth(!c.core.place.independent.is_empty())
    }),
    family(126, SWITCH, &["input 9", "input 10", "input 11", "input 12"], |c, i| {
        truth(sysvar::input_state(c, i + 9)?)
    }),
    family(
        131,
        INPUT_MODE,
        &["mode of input 9", "mode of input 10", "mode of input 11", "mode of input 12"],
        |c, i| input_mode(c, i + 8),
    ),
    family(135, "0-15", &["outputs 9-12 in four bits, output 9 lowest"], |c, _| {
        byte(c, 9, sysvar::output_state)
    }),
    family(136, SWITCH, &["output 9", "output 10", "output 11", "output 12"], |c, i| {
        truth(sysvar::output_state(c, i + 9)?)
    }),
    family(141, UNITS, &["trigger on threshold", "trigger off threshold"], |c, i| {
        let trigger = c.settings().cutter.trigger;
        Ok(sysvar::length_value(c, [trigger.on_at_mm, trigger.off_at_mm][i]))
    }),
    family(144, UNITS, &["location C"], |c, _| sysvar::working_location(c, Axis::C)),
    family(145, UNITS, &["table base C"], |c, _| sysvar::base_location(c, Axis::C)),
    family(150, "1-100", &["step interval divider"], |c, _| {
        number(c.settings().resolution.divider)
    }),
    family(
        151,
        "1-10",
        &[
            "resolution multiplier X",
            "resolution multiplier Y",
            "resolution multiplier Z",
            "resolution multiplier A",
            "resolution multiplier B",
            "resolution multiplier C",
        ],
        |c, i| number(c.settings().resolution.multipliers[i]),
    ),
];

fn truth(yes: bool) -> Result<Value, Stop> {
    number(u8::from(yes))
}

fn number(n: u8) -> Result<Value, Stop> {
    Ok(Value::Number(f64::from(n)))
}

fn speed(c: &Context<'_>, speeds: PerGroup, place: usize) -> Result<Value, Stop> {
    let axis = Axis::ALL[place];
    Ok(sysvar::axis_value(c, axis, speeds.of(axis)))
}

/// Mode of an input by index. Input 4 is always a stop; VN says only which kind.
fn input_mode(c: &Context<'_>, index: usize) -> Result<Value, Stop> {
    let io = c.settings().io;
    number(match index {
        3 if io.input4_normally_open => 3,
        3 => 4,
        _ => io.inputs[index],
    })
}

/// Up to eight switches from `first` on, the first as the lowest bit.
fn byte(
    c: &mut Context<'_>,
    first: usize,
    state: fn(&mut Context<'_>, usize) -> Result<bool, Stop>,
) -> Result<Value, Stop> {
    let mut bits = 0;
    for number in first..=(first + 7).min(12) {
        bits |= u8::from(state(c, number)?) << (number - first);
    }
    number(bits)
}
