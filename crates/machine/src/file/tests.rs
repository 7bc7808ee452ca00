//! The file and the table hold each other.

#![allow(clippy::unwrap_used)]

use super::{read, write};
use crate::Configuration;
use crate::table::{self, Bounds, Setting};
use crate::value::Value;
use std::collections::BTreeSet;
use std::sync::Arc;

fn file() -> Arc<str> {
    Arc::from("m.toml")
}

/// The first mistake in a text: line and message.
fn check(text: &str, line: u32, part: &str) {
    let found = read(&file(), text).unwrap_err();
    let first = &found[0];
    assert_eq!(first.place.line, line, "{text}: {found:?}");
    assert!(first.message.contains(part), "{text}: {}", first.message);
}

#[test]
fn keys_are_unique_and_every_section_is_written_once() {
    let mut keys = BTreeSet::new();
    let mut sections = Vec::new();
    for setting in table::settings() {
        assert!(keys.insert(setting.key), "{} twice", setting.key);
        assert!(setting.doc.len() > 5 && !setting.doc.contains('\n'), "{}", setting.key);
        if sections.last() != Some(&setting.section().0) {
            sections.push(setting.section().0);
        }
    }
    let once: BTreeSet<_> = sections.iter().collect();
    assert_eq!(once.len(), sections.len(), "{sections:?}");
}

#[test]
fn a_written_file_reads_back_the_same() {
    let fresh = Configuration::default();
    assert_eq!(read(&file(), &write(&fresh)), Ok(fresh));
}

/// Values other than the default, one of which the bounds allow.
fn others(setting: &Setting, value: &Value) -> Vec<Value> {
    match value {
        Value::Flag(flag) => vec![Value::Flag(!flag)],
        Value::Number(n) => {
            let listed = if let Bounds::OneOf(all) = setting.bounds { all } else { &[] };
            let near = [n + 1.0, n - 1.0, n / 2.0];
            near.iter().chain(listed).filter(|it| *it != n).map(|it| Value::Number(*it)).collect()
        }
        Value::Text(text) => {
            let words = setting.words();
            let words = words.into_iter().filter(|word| word != text);
            let words =
                words.chain(["another", "in", "backwards"]).map(|it| Value::Text(it.into()));
            [1.0, 50.0].map(Value::Number).into_iter().chain(words).collect()
        }
        Value::List(values) => {
            let Some((last, before)) = values.split_last() else {
                return [Value::Number(1.0), Value::Text("x".into())]
                    .map(|it| Value::List(vec![it]))
                    .into();
            };
            let with = |it: Value| Value::List([before, &[it]].concat());
            let reversed = Value::List(values.iter().rev().cloned().collect());
            others(setting, last).into_iter().map(with).chain([reversed]).collect()
        }
    }
}

/// Settings that tell how a machine is, and take nothing else.
const FIXED: [&str; 4] = ["motors.x", "motors.y", "motors.z", "options.console_baud"];

#[test]
fn every_setting_takes_another_value_and_shows_it() {
    let fresh = Configuration::default();
    let shows = |setting: &Setting, value: &Value| {
        let mut c = fresh.clone();
        let taken = setting.set(&mut c, value).is_ok();
        // One number stands for a list of which the rest has usual values.
        let whole = setting.get(&c) == *value || setting.default().is_none();
        taken && whole && table::changed(&fresh, &c).any(|it| it.key == setting.key)
    };
    let is_fixed = |setting: &&Setting| {
        let others = others(setting, &setting.default());
        !others.iter().any(|value| shows(setting, value))
    };
    let fixed: Vec<_> = table::settings().filter(is_fixed).map(|setting| setting.key).collect();
    assert_eq!(fixed, FIXED);
}

#[test]
fn every_setting_takes_its_default_and_refuses_a_date() {
    for setting in table::settings() {
        let mut c = Configuration::default();
        setting.set(&mut c, &setting.default()).unwrap();
        assert_eq!(c, Configuration::default(), "{}", setting.key);
        assert!(
            setting.set(&mut c, &Value::Text("1979-05-27 of old".into())).is_err()
                || matches!(setting.default(), Value::Text(_) | Value::List(_)),
            "{}",
            setting.key
        );
    }
}

#[test]
fn every_mistake_is_told_with_its_line() {
    check("\nunit = 3", 2, "there is no setting unit");
    check("units = \"cm\"", 1, "units must be in or mm, not \"cm\"");
    check("axes = 7", 1, "axes must be 3 to 6, not 7");
    check("[speeds.cut]\nxy = 0", 2, "speeds.cut.xy must be greater than 0, not 0");
    check("speeds.cut = { xy = 0 }", 1, "speeds.cut.xy must be greater than 0");
    check("[ramps]\ncut_rate_mm = inf", 2, "ramps.cut_rate_mm must be greater than 0, not inf");
    check("[io]\ninterlock = 13", 2, "io.interlock must be 1 to 12, not 13");
    check("[io]\ninputs = [5]", 2, "io.inputs must be 0 to 4, not [5]");
    check("[io]\noutputs = [0,0,0,0,0,0,0,0,0,0,0,0,0]", 2, "a shorter list, of at most 12");
    check("[steps]\nper_unit = [nan]", 2, "steps.per_unit must be greater than 0");
    check("motion = \"fast\"", 1, "motion must be shopbot, profiler or optimal, or none");
    check("stack_limit = 0", 1, "stack_limit must be 1 to 4294967295, not 0");
    check("axes = ", 1, "");
    check("axes = 1979-05-27", 1, "cannot be a date");
    check("[delays]\nend_s = \"long\"", 2, "delays.end_s must be a number, not \"long\"");
    let all = read(&file(), "unit = 1\naxes = 9\n[x]\ny = 1").unwrap_err();
    assert_eq!(all.iter().map(|d| d.place.line).collect::<Vec<_>>(), [1, 2, 4]);
}

#[test]
fn the_example_of_the_book_is_a_configuration() {
    let page = include_str!("../../../../docs/book/machine.md");
    let example = page.split("```toml").nth(1).unwrap().split("```").next().unwrap();
    let s = read(&file(), example).unwrap().program;
    assert_eq!((s.axis_count, s.warning_s, s.io.outputs[2]), (4, 2.0, 3));
    assert!(s.dynamics.is_some());
}

#[test]
fn what_is_named_is_set_and_the_rest_keeps_its_default() {
    let text = "units = \"mm\"\naxes = 4\n[speeds.cut]\nxy = 30.0\n[limits]\nlow = [-1, -2]\n\
        check = true\n[io]\ninputs = [0, 2]\noutput4 = -4\ninterlock = 12\n[steps]\nper_unit = [40]";
    let (s, d) = (read(&file(), text).unwrap().program, Configuration::default().program);
    assert_eq!((s.axis_count, s.speeds.cut.xy, s.speeds.cut.z), (4, 30.0, d.speeds.cut.z));
    assert_eq!((s.limits.low.0[1], s.limits.low.0[2]), (-2.0, d.limits.low.0[2]));
    assert_eq!((s.limits.check, s.io.inputs[1], s.io.output4), (true, 2, -4));
    assert_eq!((s.resolution.steps_per_unit.0[0], s.io.interlock), (40.0, Some(12)));
}

#[test]
#[allow(non_snake_case)] // a row and its variant
fn pro_smoothing_default__negative_refused() {
    assert_eq!(Configuration::default().program.smoothing.factor, 0.6);
    check("smoothing.factor = -0.1", 1, "smoothing.factor must be 0 or greater, not -0.1");
}

#[test]
#[allow(non_snake_case)]
fn pro_smoothing_stop_default__bounds() {
    assert_eq!(Configuration::default().program.smoothing.stop_angle_deg, 1.0);
    for angle in ["-0.1", "181"] {
        check(&format!("smoothing.stop_angle_deg = {angle}"), 1, "stop_angle_deg must be 0 to 180");
    }
}

#[test]
fn pro_smoothing_saved() {
    let text = "[smoothing]\nfactor = 0.8\nstop_angle_deg = 2.0";
    let first = read(&file(), text).unwrap();
    let s = read(&file(), &write(&first)).unwrap().program.smoothing;
    assert_eq!((s.factor, s.stop_angle_deg, s.centripetal_percent), (0.8, 2.0, 100.0));
}

#[test]
#[allow(non_snake_case)]
fn pro_speeds_centripetal__bounds() {
    for percent in ["0", "101"] {
        check(&format!("smoothing.centripetal_percent = {percent}"), 1, "percent must be 1 to 100");
    }
}

/// The settings of a text, written and read again.
fn saved(text: &str) -> Configuration {
    read(&file(), &write(&read(&file(), text).unwrap())).unwrap()
}

#[test]
fn pro_intensity_table() {
    let identity: Vec<u8> = (0..128).collect();
    assert_eq!(Configuration::default().intensity.table.to_vec(), identity);
    let list = |values: &[i32]| format!("[intensity]\ntable = {values:?}");
    let halves: Vec<i32> = (0..128).map(|i| i / 2).collect();
    assert_eq!(saved(&list(&halves)).intensity.table[100], 50);
    check(&list(&halves[1..]), 2, "intensity.table must be");
    check(&list(&[halves.clone(), vec![1]].concat()), 2, "intensity.table must be");
    for wrong in [-1, 128] {
        let mut values = halves.clone();
        values[7] = wrong;
        check(&list(&values), 2, "intensity.table must be");
    }
}

#[test]
fn pro_plasma_times() {
    let text = "[plasma]\ninitial_height_mm = 3.5\ninitial_wait_s = 0.25\ndebounce_s = 0";
    let plasma = saved(text).plasma;
    let times = [plasma.initial_height_mm, plasma.initial_wait_s, plasma.debounce_s];
    assert_eq!(times, [3.5, 0.25, 0.0]);
    for key in ["initial_height_mm", "initial_wait_s", "debounce_s"] {
        let wanted = if key.ends_with("_s") { "0 to 3600" } else { "0 or greater" };
        let wanted = format!("plasma.{key} must be {wanted}");
        check(&format!("[plasma]\n{key} = -0.1"), 2, &wanted);
    }
}

#[test]
fn no_wait_of_a_job_is_longer_than_an_hour() {
    for key in ["router_start_s", "air_tool_s", "bottom_s", "bottom_timeout_s", "end_s"] {
        let wanted = format!("delays.{key} must be 0 to 3600, not 1000000000000");
        check(&format!("[delays]\n{key} = 1e12"), 2, &wanted);
    }
    check("laser.gas.wait_ms = 1e12", 1, "laser.gas.wait_ms must be 0 to 3600000");
    assert_eq!(saved("[delays]\nend_s = 3600").delays.end_s, 3600.0);
}

#[test]
fn a_speed_may_carry_its_unit() {
    for (written, mm_s) in [
        ("100", 100.0),
        ("\"6000 mm/min\"", 100.0),
        ("\"6000mm/min\"", 100.0),
        ("\"6 m/min\"", 100.0),
        ("\"100 mm/s\"", 100.0),
        ("\"2 in/s\"", 50.8),
        ("\"60 IN/MIN\"", 25.4),
    ] {
        let text = format!("smoothing.cut_speed_mm_s = {written}");
        let read = read(&"m.toml".into(), &text).unwrap();
        assert_eq!(read.program.smoothing.cut_speed_mm_s, Some(mm_s), "{written}");
    }
    let none = read(&"m.toml".into(), "smoothing.cut_speed_mm_s = \"none\"").unwrap();
    assert_eq!(none.program.smoothing.cut_speed_mm_s, None);
    let units = "must be a number of mm/s, or one with its unit: mm/s, mm/min, m/min, in/s, in/min";
    check("plunge.speed_mm_s = \"20 rpm\"", 1, &format!("plunge.speed_mm_s {units}"));
    check("plunge.speed_mm_s = \"-1 mm/min\"", 1, "plunge.speed_mm_s must be greater than 0");
    check("zpos.top_mm = \"1 mm/min\"", 1, "zpos.top_mm must be a number");
}
