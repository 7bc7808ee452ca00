//! Reading the events of a trace.

use serde_json::Value;

/// The events of a trace, an event a line.
pub fn events(trace: &str) -> Vec<Value> {
    trace.lines().map(|line| serde_json::from_str(line).expect("a line of JSON")).collect()
}

/// A number of an event.
pub fn number(event: &Value, key: &str) -> f64 {
    event[key].as_f64().unwrap_or_else(|| panic!("{event} has no number {key}"))
}

/// A text of an event.
pub fn text<'a>(event: &'a Value, key: &str) -> &'a str {
    event[key].as_str().unwrap_or_else(|| panic!("{event} has no text {key}"))
}

/// The line an event points to.
pub fn line_of(event: &Value) -> u64 {
    event["line"].as_u64().unwrap_or_default()
}

/// A location of an event, X to C; axes it lacks are 0.
pub fn location(value: &Value) -> [f64; 6] {
    ["x", "y", "z", "a", "b", "c"].map(|axis| value[axis].as_f64().unwrap_or_default())
}
