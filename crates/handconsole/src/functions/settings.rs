//! Functions that give settings of the machine the number that is typed.

use super::spec::Step::Number;
use super::spec::{Done, Function, Refusal, shown};
use crate::{ConsoleRequest, View};
use kerf_machine::contradictions::{Contradiction, contradictions};
use kerf_machine::{Configuration, Value, table};
use kerf_program::Axis;

/// Seconds of a minute: speeds are typed in mm/min.
const PER_MIN: f64 = 60.0;

/// A function that gives settings the number that is typed, a so-manyth of it. What the first of them is now
/// stands there before.
macro_rules! sets {
    ($number:literal, $name:literal, $doc:literal, $prompt:literal, $per:expr, $first:literal $(, $key:literal)*) => {
        Function {
            number: $number,
            name: $name,
            doc: $doc,
            steps: &[Number { prompt: $prompt, now: |view| now(view, $first, $per) }],
            does: |typed, view| with(view, &[$first $(, $key)*], typed[0] / $per).map(Done::from),
        }
    };
}

/// The same for a yes, which is 1, or no, which is 0.
macro_rules! decides {
    ($number:literal, $name:literal, $doc:literal, $prompt:literal, $key:literal, $words:expr) => {
        Function {
            number: $number,
            name: $name,
            doc: $doc,
            steps: &[Number { prompt: $prompt, now: |view| yes(view, $key, $words) }],
            does: |typed, view| decided(view, $key, $words, typed[0]).map(Done::from),
        }
    };
}

/// Words with which a setting spells no and yes.
type NoYes = [&'static str; 2];

const FLAG: NoYes = ["false", "true"];

pub(super) const CUT_SPEED: Function = sets!(
    "0",
    "Cut speed",
    "Highest cutting speed of the machine; at most that of the X axis. `smoothing.cut_speed_mm_s`",
    "Cut speed mm/min:",
    PER_MIN,
    "smoothing.cut_speed_mm_s"
);

pub(super) const PLUNGE_SPEED: Function = sets!(
    "1",
    "Plunge speed",
    "Speed from ZTop down to the cut; at most that of the Z axis. `plunge.speed_mm_s`",
    "Plunge speed mm/min:",
    PER_MIN,
    "plunge.speed_mm_s"
);

pub(super) const SET_POINTS: Function = sets!(
    "18",
    "XY set point",
    "Both set points of proportional height control, 0 to 255. `height.x_set_point`, `height.y_set_point`",
    "XY set point:",
    1.0,
    "height.x_set_point",
    "height.y_set_point"
);

pub(super) const X_SET_POINT: Function =
    sets!("18.1", "X set point", "That of X", "X set point:", 1.0, "height.x_set_point");

pub(super) const Y_SET_POINT: Function =
    sets!("18.2", "Y set point", "That of Y", "Y set point:", 1.0, "height.y_set_point");

pub(super) const Z2_ADJUSTMENT: Function = sets!(
    "23",
    "Z2 adjust mm",
    "By how much the second head goes further when it is homed. `homing.z2_adjustment_mm`",
    "Z2 adjustment mm:",
    1.0,
    "homing.z2_adjustment_mm"
);

pub(super) const BOTTOM_DELAY: Function = sets!(
    "30",
    "Bottom delay s",
    "The wait at the bottom before the cut. `delays.bottom_s`",
    "Bottom delay s:",
    1.0,
    "delays.bottom_s"
);

pub(super) const BOTTOM_INPUT: Function = decides!(
    "31",
    "Bottom by input",
    "Whether an input ends that wait. `delays.bottom_type`",
    "By input 1 yes 0 no:",
    "delays.bottom_type",
    ["time", "input"]
);

pub(super) const RAISE: Function = decides!(
    "32",
    "Raise on pause",
    "Whether the tool rises in a pause. `pause.raise`",
    "Raise 1 yes 0 no:",
    "pause.raise",
    FLAG
);

pub(super) const ORIGIN_AT_START: Function = decides!(
    "34",
    "Origin at start",
    "Whether each Start takes the present position as job origin. `job.change_origin_at_start`",
    "Change 1 yes 0 no:",
    "job.change_origin_at_start",
    FLAG
);

pub(super) const ARROW_SPEED: Function = sets!(
    "38",
    "Arrow speed %",
    "Speed of the digits that move the tool, of the highest of each axis. `arrows.speed_percent`",
    "Arrow speed %:",
    1.0,
    "arrows.speed_percent"
);

pub(super) const ARROW_ACCEL: Function = sets!(
    "39",
    "Arrow accel %",
    "Their acceleration. `arrows.accel_percent`",
    "Arrow accel %:",
    1.0,
    "arrows.accel_percent"
);

pub(super) const CENTRIPETAL: Function = sets!(
    "40",
    "Centripetal %",
    "Acceleration in curves, of the lesser of X's and Y's. `smoothing.centripetal_percent`",
    "Centripetal accel %:",
    1.0,
    "smoothing.centripetal_percent"
);

pub(super) const REPEATS: Function = sets!(
    "61",
    "Job repeats",
    "How often a Start cuts the job. `job.repeats`",
    "Job repeats:",
    1.0,
    "job.repeats"
);

pub(super) const Y_FACTOR: Function = sets!(
    "100.2",
    "Y speed factor",
    "The highest cutting speed along Y is so many times that along X. `smoothing.y_factor`",
    "Y speed factor:",
    1.0,
    "smoothing.y_factor"
);

pub(super) const SCALE: Function = Function {
    number: "17",
    name: "HC scale",
    doc: "Millimetres of one unit of the height sensor; a K that suits is told, K itself stays. `height.scale_mm`",
    steps: &[Number {
        prompt: "HC scale mm/unit:",
        now: |view| Some(view.machine.height.scale_mm),
    }],
    does: |typed, view| {
        let wanted = changed(view, &[("height.scale_mm", typed[0].to_string())])?;
        let steps = wanted.program.resolution.steps_per_unit[Axis::Z];
        let k = shown(wanted.height.suggested_k(steps));
        Ok(Done::from(with(view, &["height.scale_mm"], typed[0])?)
            .saying(format!("Suggested K {k}")))
    },
};

/// A setting as a number is typed for it.
fn now(view: &View, key: &str, per: f64) -> Option<f64> {
    match table::setting(key)?.get(&view.machine) {
        Value::Number(number) => Some(number * per),
        _ => None,
    }
}

/// Settings get a number.
pub(super) fn with(
    view: &View,
    keys: &[&'static str],
    value: f64,
) -> Result<Vec<ConsoleRequest>, Refusal> {
    set(view, keys.iter().map(|key| (*key, value.to_string())).collect())
}

/// Settings get values, all of them or none.
pub(super) fn set(
    view: &View,
    values: Vec<(&'static str, String)>,
) -> Result<Vec<ConsoleRequest>, Refusal> {
    changed(view, &values)?;
    Ok(vec![ConsoleRequest::Set(values)])
}

/// The machine with these values, if it takes them.
fn changed(view: &View, values: &[(&'static str, String)]) -> Result<Configuration, Refusal> {
    let mut wanted = (*view.machine).clone();
    for (key, value) in values {
        let Some(setting) = table::setting(key) else { continue };
        setting.set(&mut wanted, &Value::typed(value)).map_err(|refused| refused.wanted)?;
    }
    match contradictions(&wanted).first() {
        Some(crossed) => Err(in_short(crossed, &wanted)),
        None => Ok(wanted),
    }
}

/// Names the settings that do not go together, in words that a small screen has room for.
fn in_short(crossed: &Contradiction, wanted: &Configuration) -> Refusal {
    let most = wanted.program.axis_dynamics().speed_mm_s;
    let at_most = |axis: Axis| format!("at most {} mm/min", shown(most[axis] * PER_MIN));
    match crossed.keys[..] {
        ["smoothing.cut_speed_mm_s", ..] => at_most(Axis::X),
        ["plunge.speed_mm_s", ..] => at_most(Axis::Z),
        ["zpos.bottom_mm", "axis.length"] => "below the travel of z".into(),
        [key, ..] if key.starts_with("zpos.") => "order: ZTop, ZSurface, ZBottom".into(),
        _ => crossed.message.clone(),
    }
}

/// 1 where a setting says yes.
fn yes(view: &View, key: &str, [_, yes]: NoYes) -> Option<f64> {
    let value = table::setting(key)?.get(&view.machine);
    Some(f64::from(u8::from(value == Value::typed(yes))))
}

fn decided(
    view: &View,
    key: &'static str,
    [no, yes]: NoYes,
    typed: f64,
) -> Result<Vec<ConsoleRequest>, Refusal> {
    let word = match typed {
        0.0 => no,
        1.0 => yes,
        _ => return Err("0 or 1".into()),
    };
    set(view, vec![(key, word.into())])
}
