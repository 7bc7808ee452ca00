//! Values of V commands against the rows of the machine's table: `machine.toml` keeps only what has a row.

use kerf_machine::{Configuration, table};
use kerf_program::settings::{AxisUnit, LinearUnit};
use kerf_program::{Dynamics, RampModel, Settings};
use serde_json::{Value, json};

/// Values without a row: they hold for a part file or a visit, and are gone then on purpose.
const GONE_WITH_THE_VISIT: &[&str] = &[
    "/cutter/trigger/active",
    "/mode",
    "/tabs/on",
    "/tool_offset/offset/0",
    "/tool_offset/offset/1",
    "/tool_offset/offset/2",
    "/tool_offset/offset/3",
    "/tool_offset/offset/4",
    "/tool_offset/offset/5",
    "/tool_offset/on",
];

/// Settings without a value that is absent, so that each leaf of theirs can be another.
fn full() -> Settings {
    let mut full = Settings::default();
    let usual = full.axis_dynamics();
    full.dynamics = Some(Dynamics { jerk_mm_s3: Some(usual.accel_mm_s2), ..usual });
    full.stack_limit = Some(100);
    full.ramp_model = Some(RampModel::Profiler);
    full.smoothing.cut_speed_mm_s = Some(50.0);
    full.rotary_units = [AxisUnit::Linear(LinearUnit::Mm); 3];
    full.io.interlock = Some(3);
    (full.tabs.count, full.tabs.start_mm) = (Some(4), Some(10.0));
    let changes = &mut full.tool_changes;
    (changes.place_x_mm, changes.place_y_mm) = (Some(10.0), Some(20.0));
    (changes.sensor_input, changes.plate_input) = (Some(1), Some(2));
    (changes.sensor_x_mm, changes.sensor_y_mm) = (Some(30.0), Some(40.0));
    (changes.sensor_reach_mm, changes.sensor_speed_mm_s) = (Some(50.0), Some(2.0));
    full
}

/// The paths of all numbers, flags and words in a value, as JSON pointers.
fn leaves(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Object(fields) => {
            fields.iter().for_each(|(name, it)| leaves(it, &format!("{path}/{name}"), found));
        }
        Value::Array(all) => {
            all.iter().enumerate().for_each(|(n, it)| leaves(it, &format!("{path}/{n}"), found));
        }
        _ => found.push(path.to_owned()),
    }
}

/// The settings with another value in one place.
fn with_another(all: &Value, path: &str) -> Settings {
    let with = |value: Value| {
        let mut changed = all.clone();
        *changed.pointer_mut(path).unwrap() = value;
        serde_json::from_value::<Settings>(changed)
    };
    let now = all.pointer(path).unwrap();
    let others = match now {
        Value::Bool(flag) => vec![json!(!flag)],
        Value::Number(n) if n.is_f64() => vec![json!(n.as_f64().unwrap() + 1.0)],
        Value::Number(n) => [1, -1].map(|by| json!(n.as_i64().unwrap() + by)).to_vec(),
        // The words of a choice stand in the reason for which another is refused.
        Value::String(_) => match with(json!("?")) {
            Err(error) => error.to_string().split('`').map(|word| json!(word)).collect(),
            Ok(_) => vec![json!("another")],
        },
        _ => panic!("{path} has no value: give it one in `full`"),
    };
    let mut read = others.into_iter().filter(|it| it != now).filter_map(|it| with(it).ok());
    read.next().unwrap_or_else(|| panic!("no other value is known for {path}"))
}

/// A value without a row is lost at the end of the process, without a word. The list of values is that of the type.
#[test]
fn every_value_of_the_v_commands_has_a_row_that_keeps_it() {
    let all = serde_json::to_value(full()).unwrap();
    let mut paths = Vec::new();
    leaves(&all, "", &mut paths);
    let machine = |program| Configuration { program, ..Configuration::default() };
    let before = machine(full());
    let is_lost = |path: &String| {
        let after = machine(with_another(&all, path));
        assert_ne!(before, after, "{path}");
        table::changed(&before, &after).next().is_none()
    };
    let lost: Vec<String> = paths.into_iter().filter(is_lost).collect();
    assert_eq!(lost, GONE_WITH_THE_VISIT);
}
