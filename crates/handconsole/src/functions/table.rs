//! The table of functions (Profiler reference, "Hand Console").

use super::Function;
use super::Step::Number;
use crate::Wish;
use kerf_machine::Errand;

/// Seconds of a minute: speeds are typed in mm/min.
const PER_MIN: f64 = 60.0;

/// Every function, in the order of their numbers.
pub const FUNCTIONS: &[Function] = &[
    Function {
        number: "0",
        name: "Cut speed",
        steps: &[Number {
            prompt: "Cut speed mm/min:",
            now: |view| view.machine.program.smoothing.cut_speed_mm_s.map(|mm_s| mm_s * PER_MIN),
        }],
        does: |typed, _| Ok(vec![set("smoothing.cut_speed_mm_s", typed[0] / PER_MIN)]),
    },
    Function {
        number: "4",
        name: "Move to origin",
        steps: &[],
        does: |_, _| Ok(vec![Wish::Go(Errand::Origin)]),
    },
    other("1", "Plunge speed"),
    other("2", "Z settings"),
    other("3", "ZBottom adjust"),
    other("5", "Move to finish"),
    other("6", "Move by x,y,z"),
    other("7", "Set job origin"),
    other("8", "Set job finish"),
    other("10", "Save job"),
    other("11", "Save machine"),
    other("17", "HC scale"),
    other("18", "XY set point"),
    other("18.1", "X set point"),
    other("18.2", "Y set point"),
    other("19", "XY adjust mm"),
    other("19.1", "X adjust mm"),
    other("19.2", "Y adjust mm"),
    other("20", "Move to homes"),
    other("21", "Move to x,y,z"),
    other("23", "Z2 adjust mm"),
    other("30", "Bottom delay s"),
    other("31", "Bottom input"),
    other("32", "Raise on pause"),
    other("34", "Origin at start"),
    other("38", "Arrow speed %"),
    other("39", "Arrow accel %"),
    other("40", "Centripetal %"),
    other("50", "Find z(w) home"),
    other("51", "Find xy homes"),
    other("52", "Nearest shape"),
    other("60", "Offset job"),
    other("61", "Job repeats"),
    other("70", "Digitize"),
    other("100.2", "Y speed factor"),
    other("300", "ZBottom justify"),
];

/// A function that is known by its name only.
const fn other(number: &'static str, name: &'static str) -> Function {
    Function { number, name, steps: &[], does: |_, _| Err("not available yet".into()) }
}

/// A setting gets a number.
fn set(key: &'static str, value: f64) -> Wish {
    Wish::Set { key, value: value.to_string() }
}
