//! Last run of a file, and the time that a run takes yet.

use crate::support;
use crate::support::{Page, kept, shop};
use serde_json::json;

const PART: &str = "SA\nMS,10\nMX,1\nMX,2\nEND\n";

/// The open file has run to its end.
fn has_run(page: &mut Page) {
    page.until("the end of the run", |page| page.shown["opened"]["ran"]["ended"] == "ok");
    page.until_state("idle");
}

#[test]
fn when_a_file_ran_is_known_after_a_restart() {
    let shop = kept(tempfile::tempdir().unwrap());
    shop.write("a.sbp", PART.as_bytes());
    let mut page = shop.driver();
    page.open_file("a.sbp");
    assert_eq!(page.run(), None);
    has_run(&mut page);
    let ran = page.shown["opened"]["ran"].clone();
    drop(page);
    let support::Shop { server, dir } = shop;
    drop(server);
    let shop = kept(dir);
    let mut page = shop.page();
    page.open_file("a.sbp");
    assert_eq!(page.shown["opened"]["ran"], ran);
    // Another text under the name has not run.
    shop.write("a.sbp", b"SA\nMX,5\n");
    page.open_file("a.sbp");
    assert!(page.shown["opened"]["ran"].is_null());
}

#[test]
fn a_file_that_a_typed_line_runs_has_run() {
    let shop = shop(50.0, &[("a.sbp", PART), ("b.sbp", "SA\nMX,3\n")]);
    let mut page = shop.driver();
    page.command("FP,b.sbp");
    page.open_file("a.sbp");
    assert!(page.shown["opened"]["ran"].is_null(), "that was another file");
    page.command("FP,a.sbp");
    has_run(&mut page);
    assert_eq!(page.shown["job"]["hash"], page.shown["opened"]["hash"]);
    page.open_file("b.sbp");
    has_run(&mut page);
}

/// In preview mode a run takes no time; the picture tells how long the file takes when it is cut.
#[test]
fn a_file_that_is_opened_in_preview_mode_tells_its_time() {
    let shop = shop(50.0, &[("a.sbp", PART)]);
    let mut page = shop.driver();
    page.open_file("a.sbp");
    let seconds = page.shown["opened"]["seconds"].as_f64().unwrap();
    assert!(seconds > 0.0);
    page.command("SP");
    page.open_file("a.sbp");
    assert_eq!(page.shown["opened"]["seconds"].as_f64(), Some(seconds));
    page.command("FP,a.sbp");
    page.until("all of it", |page| page.shown["motion"]["progress"] == 1.0);
}

/// A simulated machine that is four times as fast leaves a quarter of the time.
#[test]
fn time_that_is_left_is_that_of_whoever_waits() {
    let shop = shop(4.0, &[("long.sbp", "SA\nMS,1\nMX,40\nEND\n")]);
    let mut page = shop.driver();
    page.open_file("long.sbp");
    let planned = page.shown["opened"]["seconds"].as_f64().unwrap();
    assert!(planned > 20.0, "{planned}");
    assert_eq!(page.run(), None);
    page.until("motion", |page| page.shown["motion"]["progress"].as_f64() > Some(0.02));
    let part = page.shown["motion"]["progress"].as_f64().unwrap();
    let left = page.shown["motion"]["remaining"].as_f64().unwrap();
    assert!(
        (left - (1.0 - part) * planned / 4.0).abs() < 0.1 * planned / 4.0,
        "{left} of {planned}"
    );
    assert_eq!(page.act(json!({ "do": "stop" })), None);
}

/// Its run is over before its plan is there; and from where it ends in preview the next plan has nothing to make.
#[test]
fn a_file_that_a_typed_line_runs_in_preview_mode_is_all_made() {
    let shop = shop(50.0, &[("a.sbp", PART), ("b.sbp", "SA\nMX,3\nMY,2\nEND\n")]);
    let mut page = shop.driver();
    page.command("SP");
    for round in 0..10 {
        let name = ["a.sbp", "b.sbp"][round % 2];
        page.command(&format!("FP,{name}"));
        page.until(&format!("{name} in round {round}"), |page| {
            let hash = &page.shown["opened"]["hash"];
            page.shown["opened"]["name"] == name
                && page.shown["opened"]["ran"]["ended"] == "ok"
                && page.shown["job"]["hash"] == *hash
                && page.shown["motion"]["progress"] == 1.0
        });
    }
}

/// A file keeps its history under another name, also one that calls others.
#[test]
fn a_file_with_another_name_has_run() {
    const CALLS: &str = "SA\nFP,sub.sbp\nEND\n";
    for (name, text) in [("a.sbp", PART), ("calls.sbp", CALLS)] {
        let shop = shop(50.0, &[(name, text), ("b.sbp", text), ("sub.sbp", "MX,2\n")]);
        let mut page = shop.driver();
        page.open_file(name);
        assert_eq!(page.run(), None);
        has_run(&mut page);
        let tag = format!("\"{}\"", page.shown["opened"]["content"].as_str().unwrap());
        let renames = format!("DELETE /api/files/{name}?renamed=b.sbp");
        assert_eq!(shop.ask(&renames, &[("if-match", &tag)], b"").status, 200);
        page.open_file("b.sbp");
        assert_eq!(page.shown["opened"]["ran"]["ended"], "ok", "{name}");
        let runs = shop.get("/api/history").json();
        assert_eq!(runs[0]["file"], "b.sbp");
    }
}

/// A run belongs to the file, not to its text.
#[test]
fn a_copy_of_a_file_that_ran_has_not_run() {
    let shop = shop(50.0, &[("a.sbp", PART), ("copy.sbp", PART)]);
    let mut page = shop.driver();
    page.open_file("a.sbp");
    assert_eq!(page.run(), None);
    has_run(&mut page);
    page.open_file("copy.sbp");
    assert!(page.shown["opened"]["ran"].is_null(), "that was the other file");
    assert_ne!(page.shown["job"]["hash"], page.shown["opened"]["hash"]);
    page.open_file("a.sbp");
    has_run(&mut page);
}
