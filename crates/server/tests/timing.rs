//! The timing chart of the open file, as pages ask for it.

#![allow(clippy::unwrap_used)]

mod support;

use serde_json::Value;
use support::{Page, Shop, Wanted, rsm, start};

fn shop(name: &str, text: &str) -> Shop {
    let shop = start(Wanted { machine: Some(("sim", |_| {})), ..Wanted::default() });
    shop.write(name, text.as_bytes());
    shop
}

fn timing(shop: &Shop, page: &mut Page, name: &str) -> Value {
    page.open_file(name);
    let key = page.shown["opened"]["preview"]["key"].as_str().unwrap().to_owned();
    shop.get(&format!("/api/preview/{key}/timing")).json()
}

/// The points of a line.
fn points(timing: &Value, kind: &str, name: &str) -> Vec<(f64, f64)> {
    let lines = timing["lines"].as_array().unwrap();
    let line = lines.iter().find(|line| line["kind"] == kind && line["name"] == name);
    let line = line.unwrap_or_else(|| panic!("no {kind} {name} in {timing}"));
    let points = line["points"].as_array().unwrap();
    points.iter().map(|point| (point[0].as_f64().unwrap(), point[1].as_f64().unwrap())).collect()
}

#[test]
fn a_job_is_charted_with_the_times_of_its_run() {
    let shop = shop("job.rsm", &rsm("line 0,10 100,10; line 0,20 100,20"));
    let mut page = shop.driver();
    let timing = timing(&shop, &mut page, "job.rsm");
    let end = timing["seconds"].as_f64().unwrap();
    assert_eq!(timing["whole"], true);
    assert!((end - page.shown["opened"]["seconds"].as_f64().unwrap()).abs() < 1e-6, "{end}");
    let x = points(&timing, "axis", "x");
    assert!(x.len() < 400, "{} points: only ramps are curved", x.len());
    assert!(x.iter().any(|(_, at)| *at == 100.0), "{x:?}");
    let running = points(&timing, "output", "job_running");
    assert_eq!(running, [(0.0, 1.0), (end, 0.0)]);
    // Nothing has moved.
    assert_eq!(support::at(&page)[0], 0.0);
    assert_eq!(page.shown["machine"]["state"], "idle");
}

#[test]
fn a_program_is_charted_with_its_pauses() {
    let shop = shop("part.sbp", "SO,3,1\nM3,20,30,-2\nPAUSE 2\nSO,3,0\nEND\n");
    let mut page = shop.driver();
    let timing = timing(&shop, &mut page, "part.sbp");
    let edges = points(&timing, "output", "output 3");
    let [(on_s, 1.0), (off_s, 0.0)] = edges[..] else { panic!("{edges:?}") };
    let (stands_s, z) = *points(&timing, "axis", "z").last().unwrap();
    assert_eq!(on_s, 0.0);
    assert!((off_s - stands_s - 2.0).abs() < 1e-6, "{off_s} {stands_s}");
    assert!(z < 0.0, "{z}");
}

#[test]
fn an_input_that_is_moved_has_a_line() {
    let shop = shop("part.sbp", "SO,3,1\nPAUSE 2\nEND\n");
    let mut page = shop.driver();
    timing(&shop, &mut page, "part.sbp");
    let key = page.shown["opened"]["preview"]["key"].as_str().unwrap().to_owned();
    let moved = shop.get(&format!("/api/preview/{key}/timing?inputs=arc@0.5=1,arc@1.25=0")).json();
    assert_eq!(points(&moved, "input", "end_bottom_delay"), [(0.5, 1.0), (1.25, 0.0)]);
    let wrong = shop.get(&format!("/api/preview/{key}/timing?inputs=3@soon=1")).json();
    assert_eq!(wrong["text"], "the time is a number of seconds, 0 or more");
}

#[test]
fn a_preview_that_is_gone_has_no_chart() {
    let shop = shop("part.sbp", "END\n");
    let mut page = shop.driver();
    let empty = timing(&shop, &mut page, "part.sbp");
    assert_eq!(empty["lines"].as_array().map(Vec::len), Some(0));
    let gone = shop.get("/api/preview/none/timing");
    assert!(gone.json()["text"].as_str().unwrap().contains("no such preview"));
}
