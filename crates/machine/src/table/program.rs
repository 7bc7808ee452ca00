//! Settings that part files run by: units, speeds, ramps, limits, steps and the models of motion.

use super::Bounds::{Any, NotNegative, Positive, PositiveOrInfinite, Range};
use super::Unit;
use super::plain::Plain;
use super::setting::{Area, Setting, row};
use crate::settings::Configuration;
use crate::value::Value;
use kerf_program::{Axes, Dynamics};

/// In the order of a file: units first, since lengths of rotary axes follow them.
pub(super) const AREAS: &[Area] = &[
    Area { title: "Units and axes", manual: "command reference, VU, VD", rows: GENERAL },
    Area { title: "Changing tools", manual: "book, machine", rows: TOOL_CHANGES },
    Area { title: "Speeds", manual: "command reference, VS", rows: SPEEDS },
    Area { title: "Ramps", manual: "command reference, VR", rows: RAMPS },
    Area { title: "Table limits", manual: "command reference, VL", rows: LIMITS },
    Area { title: "Modes of switches", manual: "command reference, VN", rows: IO },
    Area { title: "Steps", manual: "command reference, VU", rows: STEPS },
    Area { title: "What the axes can do", manual: "Profiler, Axis Parameters", rows: DYNAMICS },
    Area {
        title: "Smoothing and cutting speed",
        manual: "Profiler, Tool Path Smoothing",
        rows: SMOOTHING,
    },
];

const GENERAL: &[Setting] = &[
    Setting {
        key: "units",
        unit: Unit::None,
        bounds: Any,
        doc: "What you read and write lengths in: in or mm. Numbers in this file stay millimetres.",
        get: |c| c.program.linear_unit.value(),
        put: |c, value| {
            let mut unit = c.program.linear_unit;
            unit.put(value)?;
            c.program.use_linear_unit(unit);
            Ok(())
        },
        words: |c| c.program.linear_unit.words(),
    },
    row!(c, "axes", c.program.axis_count, None, Range(3.0, 6.0), "How many axes there are."),
    row!(
        c,
        "rotary",
        c.program.rotary_units,
        None,
        Any,
        "What A, B and C are measured in: in, mm or deg."
    ),
    row!(
        c,
        "distance",
        c.program.distance,
        None,
        Any,
        "What the values of moves are: absolute (SA) locations or relative (SR) distances."
    ),
    row!(
        c,
        "warning_s",
        c.program.warning_s,
        Seconds,
        NotNegative,
        "Warning before motion starts (SW)."
    ),
    row!(
        c,
        "ask_spindle",
        c.program.ask_spindle,
        None,
        Any,
        "Starting the spindle from a program asks the operator first."
    ),
    row!(
        c,
        "m6_runs_c9",
        c.program.m6_runs_c9,
        None,
        Any,
        "M6 of G-code changes the tool as C9 does: spindle off, lifted, the operator asked, the tool measured where there is a sensor."
    ),
    row!(
        c,
        "spindle_device",
        c.program.spindle_device,
        None,
        Any,
        "A device takes the speeds of spindles (TR). Without one the operator is asked to set them."
    ),
    row!(
        c,
        "stack_limit",
        c.program.stack_limit,
        None,
        Range(1.0, u32::MAX as f64),
        "Moves read before the tool pulls up and the rest is read; none for no limit."
    ),
    row!(
        c,
        "motion",
        c.program.ramp_model,
        None,
        Any,
        "The model of motion: shopbot (ramps of VR), profiler (smoothed sections) or optimal; none for optimal where it is known what the axes can do, else shopbot."
    ),
];

const TOOL_CHANGES: &[Setting] = &[
    row!(
        c,
        "tool_change.place_x",
        c.program.tool_changes.place_x_mm,
        Mm,
        Any,
        "X of the place where the operator changes the tool, table base; none where it stands."
    ),
    row!(
        c,
        "tool_change.place_y",
        c.program.tool_changes.place_y_mm,
        Mm,
        Any,
        "Y of the place where the operator changes the tool, table base; none where it stands."
    ),
    row!(
        c,
        "tool_change.sensor_input",
        c.program.tool_changes.sensor_input,
        None,
        Range(1.0, 12.0),
        "Input of the sensor, or of the fixed plate, that measures tools when they are changed; none without one."
    ),
    row!(
        c,
        "tool_change.plate_input",
        c.program.tool_changes.plate_input,
        None,
        Range(1.0, 12.0),
        "Input of a loose plate: the operator lays it below the tool before and behind a change; none without one."
    ),
    row!(
        c,
        "tool_change.sensor_x",
        c.program.tool_changes.sensor_x_mm,
        Mm,
        Any,
        "X of the sensor that measures tools, table base."
    ),
    row!(
        c,
        "tool_change.sensor_y",
        c.program.tool_changes.sensor_y_mm,
        Mm,
        Any,
        "Y of the sensor that measures tools, table base."
    ),
    row!(
        c,
        "tool_change.sensor_reach",
        c.program.tool_changes.sensor_reach_mm,
        Mm,
        Positive,
        "How far down from Safe-Z the tool looks for the sensor; none for 4 inches, or what my_variables.sbc says."
    ),
    row!(
        c,
        "tool_change.sensor_speed",
        c.program.tool_changes.sensor_speed_mm_s,
        MmPerS,
        Positive,
        "How fast the tool goes down onto the sensor; none for the speed of the touch plate in my_variables.sbc."
    ),
    row!(
        c,
        "tool_change.keeps_lengths",
        c.program.tool_changes.keeps_lengths,
        None,
        Any,
        "Tools keep their lengths in their holders: one whose length is known is not measured again."
    ),
];

const SPEEDS: &[Setting] = &[
    row!(
        c,
        "speeds.cut.xy",
        c.program.speeds.cut.xy,
        MmPerS,
        Positive,
        "Speed of moves in X and Y together."
    ),
    row!(c, "speeds.cut.z", c.program.speeds.cut.z, MmPerS, Positive, "Speed of moves in Z."),
    row!(c, "speeds.cut.a", c.program.speeds.cut.a, AxisSpeed, Positive, "Speed of moves in A."),
    row!(c, "speeds.cut.b", c.program.speeds.cut.b, AxisSpeed, Positive, "Speed of moves in B."),
    row!(c, "speeds.cut.c", c.program.speeds.cut.c, AxisSpeed, Positive, "Speed of moves in C."),
    row!(
        c,
        "speeds.jog.xy",
        c.program.speeds.jog.xy,
        MmPerS,
        Positive,
        "Speed of jogs in X and Y together."
    ),
    row!(c, "speeds.jog.z", c.program.speeds.jog.z, MmPerS, Positive, "Speed of jogs in Z."),
    row!(c, "speeds.jog.a", c.program.speeds.jog.a, AxisSpeed, Positive, "Speed of jogs in A."),
    row!(c, "speeds.jog.b", c.program.speeds.jog.b, AxisSpeed, Positive, "Speed of jogs in B."),
    row!(c, "speeds.jog.c", c.program.speeds.jog.c, AxisSpeed, Positive, "Speed of jogs in C."),
];

const RAMPS: &[Setting] = &[
    row!(
        c,
        "ramps.cut.xy",
        c.program.ramps.cut.xy,
        MmPerS,
        NotNegative,
        "Speed at which moves in X and Y begin and end."
    ),
    row!(c, "ramps.cut.z", c.program.ramps.cut.z, MmPerS, NotNegative, "The same in Z."),
    row!(c, "ramps.cut.a", c.program.ramps.cut.a, AxisSpeed, NotNegative, "The same in A."),
    row!(c, "ramps.cut.b", c.program.ramps.cut.b, AxisSpeed, NotNegative, "The same in B."),
    row!(c, "ramps.cut.c", c.program.ramps.cut.c, AxisSpeed, NotNegative, "The same in C."),
    row!(
        c,
        "ramps.jog.xy",
        c.program.ramps.jog.xy,
        MmPerS,
        NotNegative,
        "Speed at which jogs in X and Y begin and end."
    ),
    row!(c, "ramps.jog.z", c.program.ramps.jog.z, MmPerS, NotNegative, "The same in Z."),
    row!(c, "ramps.jog.a", c.program.ramps.jog.a, AxisSpeed, NotNegative, "The same in A."),
    row!(c, "ramps.jog.b", c.program.ramps.jog.b, AxisSpeed, NotNegative, "The same in B."),
    row!(c, "ramps.jog.c", c.program.ramps.jog.c, AxisSpeed, NotNegative, "The same in C."),
    row!(
        c,
        "ramps.cut_rate_mm",
        c.program.ramps.cut_rate_mm,
        Mm,
        Positive,
        "Way in which a move gains 2 in/s above its ramp speed."
    ),
    row!(c, "ramps.jog_rate_mm", c.program.ramps.jog_rate_mm, Mm, Positive, "The same for jogs."),
    row!(
        c,
        "ramps.threshold_3d_percent",
        c.program.ramps.threshold_3d_percent,
        Percent,
        NotNegative,
        "How sharp a corner in 3D has to be to be ramped."
    ),
    row!(
        c,
        "ramps.min_distance_mm",
        c.program.ramps.min_distance_mm,
        Mm,
        NotNegative,
        "Path over which changes of direction are summed."
    ),
    row!(
        c,
        "ramps.slow_corner_percent",
        c.program.ramps.slow_corner_percent,
        Percent,
        NotNegative,
        "Speed at a corner that just counts, of the speed of the move."
    ),
    row!(
        c,
        "ramps.keypad_rate_mm",
        c.program.ramps.keypad_rate_mm,
        Mm,
        Positive,
        "Ramp rate in keypad mode."
    ),
    row!(
        c,
        "ramps.small_circle_mm",
        c.program.ramps.small_circle_mm,
        Mm,
        NotNegative,
        "Circles of a smaller diameter run at ramp speed."
    ),
];

const LIMITS: &[Setting] = &[
    row!(
        c,
        "limits.low",
        c.program.limits.low,
        AxisLength,
        Any,
        "Lowest location of X, Y, Z, A, B, C in base coordinates."
    ),
    row!(
        c,
        "limits.high",
        c.program.limits.high,
        AxisLength,
        Any,
        "Highest location of each axis."
    ),
    row!(
        c,
        "limits.check",
        c.program.limits.check,
        None,
        Any,
        "Whether moves that leave the limits are refused."
    ),
];

const IO: &[Setting] = &[
    row!(c, "io.limits_active", c.program.io.limits_active, None, Any, "Limit inputs stop motion."),
    row!(
        c,
        "io.input4_normally_open",
        c.program.io.input4_normally_open,
        None,
        Any,
        "Input 4 is a normally open stop."
    ),
    row!(
        c,
        "io.analog",
        c.program.io.analog,
        None,
        Range(0.0, 5.0),
        "0 none, 1 torch, 2 laser, 3 analog 1, 4 analog 2, 5 both."
    ),
    row!(
        c,
        "io.inputs",
        c.program.io.inputs,
        None,
        Range(0.0, 4.0),
        "Mode of each input: 0 standard, 1 NO limit, 2 NC limit, 3 NO stop, 4 NC stop."
    ),
    row!(
        c,
        "io.outputs",
        c.program.io.outputs,
        None,
        Range(0.0, 5.0),
        "Mode of each output, as VN lists them."
    ),
    row!(c, "io.output4", c.program.io.output4, None, Range(-4.0, -1.0), "Mode of output 4."),
    row!(
        c,
        "io.interlock",
        c.program.io.interlock,
        None,
        Range(1.0, 12.0),
        "The input that is ON while the enclosure is open."
    ),
];

const STEPS: &[Setting] = &[
    row!(
        c,
        "steps.per_unit",
        c.program.resolution.steps_per_unit,
        StepsPerUnit,
        Positive,
        "Steps of each axis."
    ),
    row!(
        c,
        "steps.multipliers",
        c.program.resolution.multipliers,
        None,
        Range(1.0, 255.0),
        "Resolution multipliers during jogs."
    ),
    row!(
        c,
        "steps.divider",
        c.program.resolution.divider,
        None,
        Range(1.0, 100.0),
        "Step interval divider."
    ),
    row!(
        c,
        "steps.no_shift",
        c.program.resolution.no_shift,
        None,
        Any,
        "Resolution shifting is disabled; jogs reach 16 in/s at most."
    ),
    row!(
        c,
        "steps.circle_mm",
        c.program.resolution.circle_mm,
        Mm,
        Positive,
        "Length of the segments of circles."
    ),
];

/// `none` anywhere says that nothing is known; a value where nothing was known brings usual ones.
macro_rules! dynamics_row {
    ($key:literal, $d:ident, $place:expr, $unit:ident, $bounds:expr, $doc:literal) => {
        Setting {
            key: $key,
            unit: Unit::$unit,
            bounds: $bounds,
            doc: $doc,
            get: |c| c.program.dynamics.as_ref().map_or_else(Value::none, |$d| $place.value()),
            put: |c, value| with_dynamics(c, value, |$d| $place.put(value)),
            words: |_| vec![crate::value::NONE],
        }
    };
}

const DYNAMICS: &[Setting] = &[
    dynamics_row!(
        "dynamics.speed_mm_s",
        d,
        d.speed_mm_s,
        AxisSpeed,
        Positive,
        "Highest speed of each axis: X, Y, Z, A, B, C (w). none when it is not known."
    ),
    dynamics_row!(
        "dynamics.accel_mm_s2",
        d,
        d.accel_mm_s2,
        AxisAccel,
        Positive,
        "Highest acceleration of each axis."
    ),
    Setting {
        key: "dynamics.jerk_mm_s3",
        unit: Unit::AxisJerk,
        bounds: PositiveOrInfinite,
        doc: "Highest jerk of each axis; none leaves it free.",
        get: |c| {
            c.program.dynamics.and_then(|d| d.jerk_mm_s3).map_or_else(Value::none, |j| j.value())
        },
        put: put_jerk,
        words: |_| vec![crate::value::NONE],
    },
    dynamics_row!(
        "dynamics.tolerance_mm",
        d,
        d.tolerance_mm,
        Mm,
        NotNegative,
        "How far the path may leave the programmed one."
    ),
];

fn with_dynamics(
    c: &mut Configuration,
    value: &Value,
    put: impl FnOnce(&mut Dynamics) -> Result<(), String>,
) -> Result<(), String> {
    if value.is_none() {
        c.program.dynamics = None;
        return Ok(());
    }
    let mut dynamics = c.program.axis_dynamics();
    put(&mut dynamics).map_err(|wanted| format!("{wanted}, or none"))?;
    c.program.dynamics = Some(dynamics);
    Ok(())
}

fn put_jerk(c: &mut Configuration, value: &Value) -> Result<(), String> {
    if value.is_none() {
        c.program.dynamics.iter_mut().for_each(|d| d.jerk_mm_s3 = None);
        return Ok(());
    }
    with_dynamics(c, value, |d| {
        let mut jerk = d.jerk_mm_s3.unwrap_or(Axes::splat(f64::INFINITY));
        jerk.put(value)?;
        d.jerk_mm_s3 = Some(jerk);
        Ok(())
    })
}

const SMOOTHING: &[Setting] = &[
    row!(
        c,
        "smoothing.factor",
        c.program.smoothing.factor,
        None,
        NotNegative,
        "A smooth curve may leave the segments by so many tenths of a millimetre; 0 for no smoothing."
    ),
    row!(
        c,
        "smoothing.stop_angle_deg",
        c.program.smoothing.stop_angle_deg,
        Degrees,
        Range(0.0, 180.0),
        "Corners that turn by less are passed without slowing."
    ),
    row!(
        c,
        "smoothing.centripetal_percent",
        c.program.smoothing.centripetal_percent,
        Percent,
        Range(1.0, 100.0),
        "Acceleration in curves, of the lesser of X's and Y's."
    ),
    row!(
        c,
        "smoothing.cut_speed_mm_s",
        c.program.smoothing.cut_speed_mm_s,
        MmPerS,
        Positive,
        "The machine's highest cutting speed along X, also as \"6000 mm/min\"; none for that of the X axis."
    ),
    row!(
        c,
        "smoothing.y_factor",
        c.program.smoothing.y_factor,
        None,
        Positive,
        "The highest cutting speed along Y is so many times that along X."
    ),
];
