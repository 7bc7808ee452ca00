//! The tool and the cutting sequence: delays, pause, intensity, height control, plasma, laser.

use super::Bounds::{Any, NotNegative, Positive, Range, RangeOrNone};
use super::plain::Plain;
use super::setting::{Area, Setting, row};
use crate::value::Value;
use kerf_program::LEVELS;

pub(super) const AREAS: &[Area] = &[
    Area { title: "Delays", manual: "Profiler, Special Delay Times During Cutting", rows: DELAYS },
    Area { title: "Pausing", manual: "Profiler, Pausing the Machine", rows: PAUSE },
    Area { title: "Intensity", manual: "Profiler, Intensity Output", rows: INTENSITY },
    Area { title: "Height control", manual: "Profiler, Automatic Height Control", rows: HEIGHT },
    Area { title: "Plasma", manual: "Profiler, Plasma Startup Sequence", rows: PLASMA },
    Area { title: "Laser", manual: "Profiler, Laser Operation", rows: LASER },
];

/// Waits of a cutting sequence: an hour at the most, more is a slip of the keyboard.
const WAIT: super::Bounds = Range(0.0, 3600.0);

/// The same in milliseconds.
const WAIT_MS: super::Bounds = Range(0.0, 3_600_000.0);

const DELAYS: &[Setting] = &[
    row!(
        c,
        "delays.router_start_s",
        c.delays.router_start_s,
        Seconds,
        WAIT,
        "After the router or shutter goes on at the first shape and after a pause."
    ),
    row!(
        c,
        "delays.air_tool_s",
        c.delays.air_tool_s,
        Seconds,
        WAIT,
        "After a tool output goes on and after it goes off, at each shape."
    ),
    row!(
        c,
        "delays.bottom_type",
        c.delays.bottom_type,
        None,
        Any,
        "What ends the wait at the bottom: time, or input (EndBottomDelay) and then the time."
    ),
    row!(c, "delays.bottom_s", c.delays.bottom_s, Seconds, WAIT, "The wait at the bottom."),
    row!(
        c,
        "delays.bottom_timeout_s",
        c.delays.bottom_timeout_s,
        Seconds,
        WAIT,
        "How long the input is waited for."
    ),
    row!(
        c,
        "delays.bottom_timeout",
        c.delays.bottom_timeout,
        None,
        Any,
        "What happens when it does not come: pause or continue."
    ),
    row!(
        c,
        "delays.end_s",
        c.delays.end_s,
        Seconds,
        WAIT,
        "After the cut output is off and before raising."
    ),
    row!(
        c,
        "delays.end_intensity",
        c.delays.end_intensity,
        None,
        Range(0.0, 127.0),
        "Intensity during the end delay."
    ),
];

const PAUSE: &[Setting] = &[row!(
    c,
    "pause.raise",
    c.pause.raise,
    None,
    Any,
    "The tool rises to Z top once the machine stands in a pause."
)];

const INTENSITY: &[Setting] = &[
    row!(c, "intensity.output", c.intensity.output, None, Any, "Intensity is sent to the port."),
    Setting {
        // A shorter list would leave the rest of a curve to the default.
        put: |c, value| match value {
            Value::List(values) if values.len() == LEVELS => c.intensity.table.put(value),
            _ => Err(format!("a list of {LEVELS} whole numbers")),
        },
        ..row!(
            c,
            "intensity.table",
            c.intensity.table,
            None,
            Range(0.0, 127.0),
            "Intensity of each of the 128 discretized speeds."
        )
    },
    row!(
        c,
        "intensity.scale_percent",
        c.intensity.scale_percent,
        Percent,
        Range(0.0, 100.0),
        "Scale of the output."
    ),
    row!(
        c,
        "intensity.strict_clip",
        c.intensity.strict_clip,
        None,
        Any,
        "The lower clip is rounded up, so that no pulse is shorter than the shortest."
    ),
    row!(
        c,
        "intensity.low_bit_at_bottom",
        c.intensity.low_bit_at_bottom,
        None,
        Any,
        "The lowest bit of the byte is set during the bottom delay (burn bit)."
    ),
    row!(
        c,
        "intensity.port",
        c.intensity.port,
        None,
        Range(1.0, 2.0),
        "Parallel port of intensity and laser frequency: 1 or 2."
    ),
];

const HEIGHT: &[Setting] = &[
    row!(c, "height.on", c.height.on, None, Any, "Height control acts in THRU shapes."),
    row!(
        c,
        "height.mode",
        c.height.mode,
        None,
        Any,
        "How the height is sensed: simple (two inputs) or proportional (readings)."
    ),
    row!(
        c,
        "height.speed_mm_s",
        c.height.speed_mm_s,
        MmPerS,
        Positive,
        "Highest speed of Z under height control; at most that of the axis."
    ),
    row!(
        c,
        "height.accel_mm_s2",
        c.height.accel_mm_s2,
        MmPerS2,
        Positive,
        "Highest acceleration of Z under height control; at most that of the axis."
    ),
    row!(
        c,
        "height.activation_percent",
        c.height.activation_percent,
        Percent,
        Range(0.0, 100.0),
        "Acts above this share of the cutting speed; 0 always."
    ),
    row!(
        c,
        "height.between",
        c.height.between,
        None,
        Any,
        "Acts between THRU shapes too. Beware of high speeds in X and Y."
    ),
    row!(
        c,
        "height.x_set_point",
        c.height.x_set_point,
        None,
        Range(0.0, 255.0),
        "Reading wanted when cutting along X."
    ),
    row!(
        c,
        "height.y_set_point",
        c.height.y_set_point,
        None,
        Range(0.0, 255.0),
        "Reading wanted when cutting along Y."
    ),
    row!(
        c,
        "height.k",
        c.height.k,
        None,
        Positive,
        "Steps of the Z motor for one unit of the reading."
    ),
    row!(
        c,
        "height.scale_mm",
        c.height.scale_mm,
        Mm,
        Positive,
        "Millimetres for one unit of the reading."
    ),
    row!(
        c,
        "height.display_accuracy_mm",
        c.height.display_accuracy_mm,
        Mm,
        NotNegative,
        "Errors above this are drawn in another colour."
    ),
    row!(c, "height.invert", c.height.invert, None, Any, "A larger reading means a smaller gap."),
    row!(c, "height.port", c.height.port, None, Range(1.0, 4.0), "Serial port of the readings."),
    row!(c, "height.baud", c.height.baud, Baud, Range(300.0, 921_600.0), "Its speed."),
];

const PLASMA: &[Setting] = &[
    row!(c, "plasma.use", c.plasma.use_sequence, None, Any, "The plasma start sequence is used."),
    row!(
        c,
        "plasma.initial_height_mm",
        c.plasma.initial_height_mm,
        Mm,
        NotNegative,
        "Height above the place where Too-Close came."
    ),
    row!(
        c,
        "plasma.initial_wait_s",
        c.plasma.initial_wait_s,
        Seconds,
        WAIT,
        "Wait after the arc came during which its input is ignored."
    ),
    row!(
        c,
        "plasma.debounce_s",
        c.plasma.debounce_s,
        Seconds,
        WAIT,
        "From the start of cutting the arc input is ignored for so long."
    ),
    row!(
        c,
        "plasma.arc_timeout_s",
        c.plasma.arc_timeout_s,
        Seconds,
        WAIT,
        "How long the arc is waited for."
    ),
];

const LASER: &[Setting] = &[
    row!(c, "laser.use", c.laser.use_laser, None, Any, "A laser is the tool."),
    row!(c, "laser.type", c.laser.kind, None, Any, "The kind: cw (continuous) or pwm (pulsed)."),
    row!(c, "laser.cut_hz", c.laser.cut_hz, Hz, Positive, "Pulse frequency while cutting."),
    row!(c, "laser.min_pulse_us", c.laser.min_pulse_us, Us, NotNegative, "Shortest pulse."),
    row!(c, "laser.max_pulse_us", c.laser.max_pulse_us, Us, Positive, "Longest pulse."),
    row!(
        c,
        "laser.legacy_board",
        c.laser.legacy_board,
        None,
        Any,
        "An old board: the lowest bit with cut 1 gives full intensity, with cut 2 none."
    ),
    row!(
        c,
        "laser.engrave_cut",
        c.laser.engrave_cut,
        None,
        RangeOrNone(1.0, 3.0),
        "Cut output that marks engraving groups, which are not pierced."
    ),
    row!(
        c,
        "laser.pierce.use",
        c.laser.pierce.use_sequence,
        None,
        Any,
        "The pierce sequence is used in place of the bottom delay."
    ),
    row!(c, "laser.pierce.hz", c.laser.pierce.hz, Hz, Positive, "Pulse frequency while piercing."),
    row!(
        c,
        "laser.pierce.height_mm",
        c.laser.pierce.height_mm,
        Mm,
        NotNegative,
        "Height above the surface."
    ),
    row!(
        c,
        "laser.pierce.gas_tool",
        c.laser.pierce.gas_tool,
        None,
        RangeOrNone(1.0, 3.0),
        "Tool output of the pierce gas."
    ),
    row!(
        c,
        "laser.pierce.gas_wait_ms",
        c.laser.pierce.gas_wait_ms,
        Ms,
        WAIT_MS,
        "Wait for the pierce gas."
    ),
    row!(
        c,
        "laser.pierce.intensity",
        c.laser.pierce.intensity,
        None,
        Range(0.0, 127.0),
        "Intensity, mapped through the table."
    ),
    row!(c, "laser.pierce.time_ms", c.laser.pierce.time_ms, Ms, WAIT_MS, "Time the laser is on."),
    row!(
        c,
        "laser.pierce.purge_ms",
        c.laser.pierce.purge_ms,
        Ms,
        WAIT_MS,
        "Wait while cut gas displaces the pierce gas."
    ),
    row!(
        c,
        "laser.gas.tool",
        c.laser.gas.tool,
        None,
        RangeOrNone(1.0, 3.0),
        "Tool output of the cut gas."
    ),
    row!(c, "laser.gas.wait_ms", c.laser.gas.wait_ms, Ms, WAIT_MS, "Wait for the cut gas."),
    row!(
        c,
        "laser.gas.overrides",
        c.laser.gas.overrides,
        None,
        Any,
        "It is used instead of the group's tool output."
    ),
];
