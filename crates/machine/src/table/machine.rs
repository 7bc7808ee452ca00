//! Axes, motors, homing, heights and speeds.

use super::Bounds::{Any, NotNegative, Positive, Range};
use super::Unit;
use super::setting::{Area, Setting, row};
use crate::value::Value;

pub(super) const AREAS: &[Area] = &[
    Area { title: "Axes", manual: "Profiler, Axis Parameters", rows: AXES },
    Area { title: "Motors", manual: "Profiler, Motor Parameters", rows: MOTORS },
    Area {
        title: "Homing",
        manual: "Profiler, Finding the Home Position on an Axis",
        rows: HOMING,
    },
    Area { title: "Heights of Z", manual: "Profiler, Special Z Axis Positions", rows: ZPOS },
    Area {
        title: "Plunging and arrow keys",
        manual: "Profiler, Maximum Machine Cutting Speeds",
        rows: SPEEDS,
    },
    Area { title: "Simulated machine", manual: "Kerf", rows: SIMULATED },
];

const AXES: &[Setting] = &[
    row!(
        c,
        "axis.length",
        c.axes.length,
        AxisLength,
        NotNegative,
        "Travel of X, Y, Z, A (z2), B, C (w) from home; 0 for no bounds."
    ),
    row!(
        c,
        "axis.limit_movement",
        c.axes.limit_movement,
        None,
        Any,
        "Motion that would leave the lengths is refused."
    ),
];

/// X, Y and Z have motors of their own; the rows only say so.
macro_rules! fixed {
    ($key:literal, $letter:literal) => {
        Setting {
            key: $key,
            unit: Unit::None,
            bounds: Any,
            doc: concat!("The motor of this axis, always ", $letter, "."),
            get: |_| Value::Text($letter.into()),
            put: |_, value| match value {
                Value::Text(word) if word.eq_ignore_ascii_case($letter) => Ok(()),
                _ => Err(concat!($letter, ", which cannot be changed").into()),
            },
            words: |_| vec![$letter],
        }
    };
}

const MOTORS: &[Setting] = &[
    fixed!("motors.x", "x"),
    fixed!("motors.y", "y"),
    fixed!("motors.z", "z"),
    row!(c, "motors.x2", c.motors.x2, None, Any, "Second motor of X: w, q or r."),
    row!(c, "motors.y2", c.motors.y2, None, Any, "Second motor of Y: w, q or r."),
    row!(
        c,
        "motors.z2",
        c.motors.z2,
        None,
        Any,
        "Motor of the second head, which is axis A of part files: w, q or r."
    ),
    row!(
        c,
        "motors.a",
        c.motors.a,
        None,
        Any,
        "Motor of axis A where it is no second head: w, q or r."
    ),
    row!(c, "motors.b", c.motors.b, None, Any, "Motor of axis B: w, q or r."),
    row!(
        c,
        "motors.w",
        c.motors.w,
        None,
        Any,
        "Motor of the tangential or rotary axis w, axis C of part files: w, q or r."
    ),
    row!(
        c,
        "motors.direction",
        c.motors.direction,
        None,
        Any,
        "Positive direction of X, Y, Z, A (z2), B, C (w): forwards or backwards."
    ),
    row!(
        c,
        "motors.dir_delay_ns",
        c.motors.dir_delay_ns,
        Ns,
        NotNegative,
        "From a change of direction to the step; 0 outputs both at once."
    ),
    row!(
        c,
        "motors.step_delay_ns",
        c.motors.step_delay_ns,
        Ns,
        NotNegative,
        "Widens the step pulse."
    ),
];

/// The switch of each axis.
macro_rules! homing {
    ($($letter:literal $i:literal;)*) => {
        &[
            $(
                row!(c, concat!("homing.", $letter, ".fitted"), c.homing.switches[$i].fitted, None, Any, "The axis has a homing switch."),
                row!(c, concat!("homing.", $letter, ".end"), c.homing.switches[$i].end, None, Any, "Where it sits: low (left, front) or high (right, back, top)."),
                row!(c, concat!("homing.", $letter, ".fast"), c.homing.switches[$i].fast, AxisSpeed, Positive, "Speed of the search."),
                row!(c, concat!("homing.", $letter, ".slow"), c.homing.switches[$i].slow, AxisSpeed, NotNegative, "Speed of finding the edge; 0 takes the place where the switch turned off."),
                row!(c, concat!("homing.", $letter, ".off"), c.homing.switches[$i].off, AxisLength, NotNegative, "Distance of home from the edge."),
            )*
            row!(c, "homing.separate_x", c.homing.separate_x, None, Any, "The two motors of X are homed one by one after they were homed together."),
            row!(c, "homing.separate_y", c.homing.separate_y, None, Any, "The same for Y."),
            row!(c, "homing.z2_adjustment_mm", c.homing.z2_adjustment_mm, Mm, Any, "The second head moves by this further after it is off its switch."),
            row!(c, "homing.before_runs", c.homing.before_runs, None, Any, "When a run begins and axes with a switch were not homed: tell, ask whether to home first, or refuse."),
            row!(c, "homing.at_program_start", c.homing.at_program_start, None, Any, "Axes homed when the program starts: a list of x, y, z, a, b, w."),
            row!(c, "homing.at_job_start", c.homing.at_job_start, None, Any, "Axes homed when a job starts."),
        ]
    };
}

const HOMING: &[Setting] = homing! { "x" 0; "y" 1; "z" 2; "a" 3; "b" 4; "w" 5; };

const ZPOS: &[Setting] = &[
    row!(
        c,
        "zpos.top_mm",
        c.zpos.top_mm,
        Mm,
        Any,
        "Z top: the height when not machining and between shapes; 0 is home, negative below."
    ),
    row!(
        c,
        "zpos.surface_mm",
        c.zpos.surface_mm,
        Mm,
        Any,
        "Z surface: the zero of cutting heights."
    ),
    row!(
        c,
        "zpos.bottom_mm",
        c.zpos.bottom_mm,
        Mm,
        Any,
        "Z bottom: the height of THRU cuts, and the lowest the tool may go."
    ),
];

const SPEEDS: &[Setting] = &[
    row!(
        c,
        "plunge.speed_mm_s",
        c.speeds.plunge_mm_s,
        MmPerS,
        Positive,
        "Speed from Z top down to the cutting height, also as \"1200 mm/min\"; at most that of the Z axis."
    ),
    row!(
        c,
        "arrows.speed_percent",
        c.speeds.arrow_speed_percent,
        Percent,
        Range(1.0, 100.0),
        "Speed of the arrow keys, of the axis' highest."
    ),
    row!(
        c,
        "arrows.accel_percent",
        c.speeds.arrow_accel_percent,
        Percent,
        Range(1.0, 100.0),
        "Acceleration of the arrow keys, of the axis' highest."
    ),
];

const SIMULATED: &[Setting] = &[
    row!(
        c,
        "sim.switch_at",
        c.simulated.switch_at,
        AxisLength,
        Any,
        "Where the homing switch of each motor X, Y, Z, W, Q, R turns on; none without a switch."
    ),
    row!(
        c,
        "sim.hysteresis",
        c.simulated.hysteresis,
        AxisLength,
        NotNegative,
        "Way from turning on to turning off again."
    ),
    row!(
        c,
        "sim.start_at",
        c.simulated.start_at,
        AxisLength,
        Any,
        "True position of each axis when the program starts."
    ),
    row!(
        c,
        "sim.output_delay_ns",
        c.simulated.output_delay_ns,
        Ns,
        NotNegative,
        "Least time from one change of an output to the next."
    ),
];
