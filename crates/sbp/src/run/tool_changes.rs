//! What the file that changes tools (C9) is told in variables, and the lengths that it leaves there.
//!
//! ```text
//!  table of tools, settings ──► &tool_words, &tool_length, &tool_sensor … ──► C9
//!         ▲                                                                   │
//!         └──────────────── &tool_length, &tool_in_length ◄───────────────────┘
//! ```
//!
//! Lengths and places are those of the table base, in the unit of the program. A variable is empty where nothing is known.

use super::Context;
use super::state::Purpose;
use crate::Value;
use kerf_program::{Command, ToolTable, rounded};
use std::sync::Arc;

/// The tool that is wanted.
const WANTED: &str = "TOOL";

/// Its length at the sensor, or of the one in the spindle before.
const LENGTHS: [&str; 2] = ["TOOL_LENGTH", "TOOL_IN_LENGTH"];

/// Digits of a length behind the point, mm: what is less is rounding of units.
const PLACES: i32 = 4;

/// Lengths that differ by less are the same, rounded to another unit and back, mm.
const SAME_MM: f64 = 1e-4;

/// The file just opened changes the tool; its end is told when it is left.
pub(super) fn begin(c: &mut Context<'_>) {
    let Some(level) = c.core.flow.levels.last_mut() else { return };
    level.purpose = Purpose::ToolChange;
    c.emit(Command::ToolChange { begin: true });
    tell(c);
}

/// Puts all that the file may have to know into its variables.
fn tell(c: &mut Context<'_>) {
    let (table, changes) = (c.core.memory.tools.clone(), c.settings().tool_changes);
    let unit_mm = c.settings().linear_unit.mm();
    let length = |mm: Option<f64>| mm.map_or(Value::Empty, |mm| Value::Number(mm / unit_mm));
    let wanted = wanted(c);
    let words = wanted.map(|number| table.asked_for(number));
    let in_spindle = (table.in_spindle > 0).then_some(f64::from(table.in_spindle));
    let number = |number: Option<f64>| number.map_or(Value::Empty, Value::Number);
    // A place of the table is elsewhere in a file that is scaled or laid elsewhere.
    let scaled =
        c.core.flow.level().is_none_or(|it| it.proportion != [1.0; 3] || it.offset != [0.0; 3]);
    let place = |mm: Option<f64>| length(mm.filter(|_| !scaled));
    let told = [
        ("TOOL_WORDS", words.map_or(Value::Empty, |words| Value::text(&words))),
        ("TOOL_IN", number(in_spindle)),
        (LENGTHS[0], length(wanted.and_then(|number| table.touch_mm(number)))),
        (LENGTHS[1], length(table.touch_mm(table.in_spindle))),
        ("TOOL_KEEPS_LENGTH", Value::Number(f64::from(u8::from(changes.keeps_lengths)))),
        ("TOOL_PLACE_X", place(changes.place_x_mm)),
        ("TOOL_PLACE_Y", place(changes.place_y_mm)),
        ("TOOL_SENSOR", number(changes.sensor_input.map(f64::from))),
        // In a file that is scaled a touch is no height.
        ("TOOL_PLATE", number(changes.plate_input.filter(|_| !scaled).map(f64::from))),
        ("TOOL_SENSOR_X", length(changes.sensor_x_mm)),
        ("TOOL_SENSOR_Y", length(changes.sensor_y_mm)),
        ("TOOL_SENSOR_REACH", length(changes.sensor_reach_mm)),
        ("TOOL_SENSOR_SPEED", length(changes.sensor_speed_mm_s)),
    ];
    for (name, value) in told {
        c.core.memory.variables.set(name, value);
    }
}

/// The file has come to its end: the tool that was wanted is in the spindle, and what was measured is kept.
pub(super) fn end(c: &mut Context<'_>) {
    let Some(wanted) = wanted(c) else { return };
    let unit_mm = c.settings().linear_unit.mm();
    let [length_mm, before_mm] = LENGTHS.map(|name| {
        let value = c.core.memory.variables.get(name);
        value.and_then(Value::number).map(|length| length * unit_mm)
    });
    let table: &mut ToolTable = Arc::make_mut(&mut c.core.memory.tools);
    for (number, told_mm) in [(table.in_spindle, before_mm), (wanted, length_mm)] {
        let other = |mm: &f64| table.touch_mm(number).is_none_or(|was| (was - mm).abs() > SAME_MM);
        if let Some(mm) = told_mm.filter(|mm| number > 0 && mm.is_finite() && other(mm)) {
            table.tools.entry(number).or_default().touched(rounded(mm, PLACES));
        }
    }
    table.in_spindle = wanted;
}

/// The number in `&Tool`; nothing where a tool is named otherwise.
fn wanted(c: &Context<'_>) -> Option<u32> {
    let number = c.core.memory.variables.get(WANTED).and_then(Value::number)?;
    let is_one = number.fract() == 0.0 && (1.0..1e6).contains(&number);
    is_one.then_some(number as u32)
}
