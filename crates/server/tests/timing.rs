//! The timing chart of the open file, as pages ask for it.

use crate::support;
use crate::support::{Page, Shop, Wanted, rsm, start};
use serde_json::Value;

fn shop(name: &str, text: &str) -> Shop {
    let shop = start(Wanted { machine: Some(("sim", |_| {})), ..Wanted::default() });
    shop.write(name, text.as_bytes());
    shop
}

fn timing(shop: &Shop, page: &mut Page, name: &str) -> Value {
    page.open_file(name);
    shop.get(&address(page)).json()
}

/// Address of the open file's chart.
fn address(page: &Page) -> String {
    format!("/api/preview/{}/timing", page.shown["opened"]["preview"]["key"].as_str().unwrap())
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

#[test]
fn a_preview_that_is_outdated_is_no_mistake() {
    let shop = shop("part.sbp", "MX,5\nEND\n");
    let mut page = shop.driver();
    timing(&shop, &mut page, "part.sbp");
    let key = page.shown["opened"]["preview"]["key"].as_str().unwrap().to_owned();
    shop.write("other.sbp", b"MX,6\nEND\n");
    timing(&shop, &mut page, "other.sbp");
    for of in ["", "/timing", "/0/0"] {
        let answer = shop.get(&format!("/api/preview/{key}{of}"));
        assert_eq!((answer.status, answer.body.len()), (204, 0), "{of}");
    }
}

#[test]
fn a_chart_is_made_as_the_machine_is_now() {
    let shop = shop("part.sbp", "MX,5\nEND\n");
    let mut page = shop.driver();
    let first = timing(&shop, &mut page, "part.sbp");
    assert_eq!(points(&first, "axis", "x")[0], (0.0, 0.0));
    assert_eq!(shop.get(&address(&page)).json(), first, "it is kept");
    let before = address(&page);
    page.command("SO,3,1");
    page.command("MX,4");
    assert_eq!(address(&page), before, "its preview is what it was");
    let now = shop.get(&address(&page)).json();
    assert_eq!(points(&now, "output", "output 3")[0], (0.0, 1.0));
    assert_eq!(points(&now, "axis", "x")[0], (0.0, 4.0));
    assert!(now["seconds"].as_f64() < first["seconds"].as_f64());
}

#[test]
fn an_input_that_is_on_before_is_on_from_the_beginning() {
    let shop = shop("part.sbp", "PAUSE 2\nEND\n");
    let mut page = shop.driver();
    timing(&shop, &mut page, "part.sbp");
    let off = shop.get(&format!("{}?inputs=3@0.5=0", address(&page))).json();
    assert_eq!(points(&off, "input", "input 3"), [(0.0, 1.0), (0.5, 0.0)]);
}

#[test]
fn a_run_that_fails_says_where_and_why_its_chart_ends() {
    let shop = shop("part.sbp", "&a = 0\nPAUSE 4\nMX,1/&a\nEND\n");
    let failed = timing(&shop, &mut shop.driver(), "part.sbp");
    assert_eq!((&failed["whole"], &failed["full"]), (&false.into(), &false.into()));
    assert_eq!((&failed["status"], &failed["finding"]["line"]), (&"failed".into(), &3.into()));
    assert_eq!(failed["seconds"], 4.0);
}

#[test]
fn courses_follow_a_zero_within_the_program() {
    let shop = shop("part.sbp", "MX,1\nZX\nMX,1\nVA,5\nMX,6\nEND\n");
    let moved = timing(&shop, &mut shop.driver(), "part.sbp");
    let x = points(&moved, "axis", "x");
    let steps: Vec<_> = x.windows(2).filter(|pair| pair[0].0 == pair[1].0).collect();
    let values = steps.iter().map(|pair| (pair[0].1, pair[1].1)).collect::<Vec<_>>();
    assert_eq!(values, [(1.0, 0.0), (1.0, 5.0)], "{x:?}");
    assert_eq!(x.last().map(|point| point.1), Some(6.0));
}

#[test]
fn a_move_across_the_country_is_charted_at_once() {
    // Without a machine that has lengths.
    let shop = support::shop(1.0, &[("part.sbp", "MX,1e9\nEND\n")]);
    let far = timing(&shop, &mut shop.driver(), "part.sbp");
    let x = points(&far, "axis", "x");
    assert!(x.len() < 1000 && x.last().unwrap().1 > 9e8, "{far}");
}

#[test]
fn two_who_ask_for_different_charts_at_a_time_get_both() {
    let long = "&n = 0\nagain:\n&n = &n + 1\nIF &n < 300000 THEN GOTO again\nMX,1\nEND\n";
    let shop = shop("part.sbp", long);
    let mut page = shop.driver();
    page.open_file("part.sbp");
    let address = address(&page);
    std::thread::scope(|scope| {
        let first = scope.spawn(|| shop.get(&format!("{address}?inputs=3@0=1")).json());
        std::thread::sleep(std::time::Duration::from_millis(100));
        assert_eq!(shop.get(&address).json()["status"], "ok");
        let first = first.join().unwrap();
        assert_eq!(first["status"], "ok", "{first}");
    });
}
