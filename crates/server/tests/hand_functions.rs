//! Functions of the hand console that are about the open job, and about what is kept.

use crate::support::hand::Hand;
use crate::support::{Page, Shop, Wanted, at, kept, rsm, start};
use kerf_drawing::{Drawing, Editor, Shape, script};
use kerf_geom::{Point2, Polyarc};
use kerf_machine::Configuration;
use serde_json::{Value, json};

/// SIM, in a hurry, with this job open.
fn with_job(rsm: &str, change: fn(&mut Configuration)) -> (Shop, Hand) {
    let shop = start(Wanted { rate: 20.0, machine: Some(("sim", change)), ..Wanted::default() });
    shop.write("job.rsm", rsm.as_bytes());
    let mut hand = Hand::of(&shop);
    hand.open_file("job.rsm");
    (shop, hand)
}

fn previewed(hand: &mut Hand) {
    hand.until("the preview", |page| page.shown["opened"]["preview"]["state"] == "ready");
}

fn choose(hand: &mut Hand, choice: Value) {
    assert_eq!(hand.act(json!({ "do": "choose", "choice": choice })), None);
    previewed(hand);
}

/// The tool goes to a place, X and Y from the job origin; `to` from home.
fn go(hand: &mut Hand, [x, y]: [f64; 2], to: [f64; 2]) {
    hand.keys(&format!("U21E{x}E{y}EE"));
    let there = |at: [f64; 3]| (at[0] - to[0]).abs() + (at[1] - to[1]).abs() < 1e-6;
    hand.until("the place", |page| there(at(page)));
    rests(hand);
}

#[test]
fn pro_console_f34__the_job_lies_there_from_now_on() {
    let (shop, mut hand) = with_job(&rsm(FIVE), |machine| machine.job.origin_mm = [300.0, 200.0]);
    hand.keys("U34E1E");
    go(&mut hand, [-250.0, -140.0], [50.0, 60.0]);
    // The preview was made with the setting as it was.
    previewed(&mut hand);
    hand.keys("S");
    hand.until("the end", |page| {
        page.shown["job"]["ended"] == "ok" && page.shown["job"]["file"] == "job.rsm"
    });
    rests(&mut hand);
    assert_eq!(at(&hand)[..2], [50.0, 60.0]);
    hand.until("its origin", |page| {
        page.shown["opened"]["choice"]["origin"] == json!([50.0, 60.0])
    });
    hand.keys("U34E0E");
    go(&mut hand, [10.0, 0.0], [60.0, 60.0]);
    hand.keys("U4E");
    hand.until("the origin", |page| at(page)[..2] == [50.0, 60.0]);
    previewed(&mut hand);
    assert_eq!(job(&shop)["origin"], json!([50.0, 60.0]));
}

#[test]
fn pro_files_rsm_start__saved_by_function_10() {
    let (_shop, mut hand) = with_job(&rsm(FIVE), |machine| machine.misc.double_start = true);
    choose(&mut hand, json!({ "start": 5 }));
    hand.keys("U10E");
    hand.shows("Save job", "Job saved");
    hand.act(json!({ "do": "close" }));
    hand.open_file("job.rsm");
    hand.keys("ES");
    hand.shows("Start job", "Shape 5 of 5");
}

#[test]
fn pro_files_rsm_start__chosen_at_the_console() {
    let (shop, mut hand) = with_job(&rsm(FIVE), |machine| machine.misc.double_start = true);
    hand.keys("S");
    hand.shows("Start job", "Shape 1 of 5");
    hand.keys("4E");
    hand.shows("Start job", "Shape 4 of 5");
    hand.keys("UE");
    hand.shows("JOB: job.rsm", "100x40mm #5");
    hand.until("the start", |page| page.shown["opened"]["choice"]["start"] == 4);
    hand.until("the origin", |page| at(page)[..2] == [0.0; 2]);
    rests(&mut hand);
    hand.keys("U10E");
    hand.shows("Save job", "Job saved");
    let saved = kerf_toolpath::read(&std::fs::read(shop.part("job.rsm")).unwrap()).0;
    assert_eq!(saved.start, 4);
}

/// The function is done: the screen shows the job again.
fn rests(hand: &mut Hand) {
    let job =
        |page: &Page| page.shown["handConsole"]["lines"][0].as_str().unwrap().starts_with("JOB");
    hand.until("the job on the screen", job);
    hand.until_state("idle");
}

fn job(shop: &Shop) -> Value {
    shop.get("/api/job").json()
}

/// Five lines above each other.
const FIVE: &str =
    "line 0,0 100,0; line 0,10 100,10; line 0,20 100,20; line 0,30 100,30; line 0,40 100,40";

#[test]
fn pro_console_f7() {
    let (shop, mut hand) = with_job(&rsm(FIVE), |_| {});
    go(&mut hand, [120.0, 80.0], [120.0, 80.0]);
    hand.keys("U7E");
    hand.shows("Set job origin", "Origin 120,80");
    // Places count from there now.
    hand.keys("U21E");
    hand.shows("Move to x mm:", "0");
    hand.keys("E");
    hand.shows("Move to y mm:", "0");
    hand.keys("U");
    previewed(&mut hand);
    assert_eq!(job(&shop)["origin"], json!([120.0, 80.0]));
    // Also without a job, and where jobs lie that say nothing.
    hand.act(json!({ "do": "close" }));
    hand.keys("U21E");
    hand.shows("Move to x mm:", "0");
}

#[test]
fn pro_console_f8() {
    let (shop, mut hand) = with_job(&rsm(FIVE), |_| {});
    choose(&mut hand, json!({ "origin": [300, 200] }));
    go(&mut hand, [25.0, 20.0], [325.0, 220.0]);
    hand.keys("U8E");
    hand.shows("Set job finish", "Finish 25,20");
    previewed(&mut hand);
    assert_eq!(job(&shop)["finish"], json!([25.0, 20.0]));
    hand.keys("U4E");
    hand.until("the origin", |page| at(page)[..2] == [300.0, 200.0]);
    rests(&mut hand);
    hand.keys("U5E");
    hand.until("the finish", |page| at(page)[..2] == [325.0, 220.0]);
}

#[test]
fn pro_console_f10() {
    let (shop, mut hand) = with_job(&rsm(FIVE), |_| {});
    choose(&mut hand, json!({ "origin": [300, 200], "start": 5, "offset": 1 }));
    let file = || kerf_toolpath::read(&std::fs::read(shop.part("job.rsm")).unwrap()).0;
    let before = file();
    hand.keys("U10E");
    hand.shows("Save job", "Job saved");
    let saved = file();
    assert_eq!((saved.origin, saved.start), (Some(Point2::new(300.0, 200.0)), 5));
    assert_eq!(saved.paths, before.paths, "neither moved nor offset");
    hand.act(json!({ "do": "close" }));
    hand.open_file("job.rsm");
    let view = job(&shop);
    assert_eq!((&view["origin"], &view["start"]), (&json!([300.0, 200.0]), &json!(5)));
    hand.keys("U4E");
    hand.until("the origin", |page| at(page)[..2] == [300.0, 200.0]);
}

#[test]
fn a_job_that_somebody_else_changed_is_not_overwritten() {
    let (shop, mut hand) = with_job(&rsm(FIVE), |_| {});
    shop.write("job.rsm", rsm("line 0,0 1,0").as_bytes());
    let (before, beeps) = (std::fs::read(shop.part("job.rsm")).unwrap(), hand.beeps());
    hand.keys("U10E");
    hand.shows("the file was changed", "since it was opened;");
    assert_eq!(hand.beeps(), beeps + 1);
    assert_eq!(std::fs::read(shop.part("job.rsm")).unwrap(), before);
}

/// A machine on record, as its file says.
fn on_record() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    std::fs::create_dir_all(dir.path().join("data")).unwrap();
    let sim = kerf_machine::profile::profile("sim").unwrap().text;
    std::fs::write(dir.path().join("data/machine.toml"), sim).unwrap();
    dir
}

/// Lets the tool down a little while Z top is asked for, and answers the other heights as they are; gives Z
/// top.
fn lower_top(hand: &mut Hand) -> f64 {
    hand.keys("U2E");
    hand.until("Z top", |page| (at(page)[2] + 10.0).abs() < 1e-6);
    hand.until_state("idle");
    hand.holds('0', "a way down", |page| at(page)[2] < -11.0);
    let top = at(hand)[2];
    hand.keys("E");
    for z in [-20.0, -30.0] {
        hand.until("a height", |page| (at(page)[2] - z).abs() < 1e-6);
        hand.until_state("idle");
        hand.keys("E");
    }
    hand.until("the heights", |page| page.shown["setup"]["heights"]["top"] != -10.0);
    hand.until_state("idle");
    top
}

#[test]
fn pro_console_f11() {
    let shop = kept(on_record());
    let mut hand = Hand::of(&shop);
    let top = |hand: &Hand| hand.shown["setup"]["heights"]["top"].as_f64().unwrap();
    let lowered = lower_top(&mut hand);
    assert!((top(&hand) - lowered).abs() < 1e-6, "it holds");
    let Shop { server, dir } = shop;
    drop((hand, server));
    let shop = kept(dir);
    let mut hand = Hand::of(&shop);
    assert_eq!(top(&hand), -10.0, "it was not saved");
    let lowered = lower_top(&mut hand);
    hand.keys("U11E");
    hand.shows("Save machine", "1 setting saved");
    let Shop { server, dir } = shop;
    drop((hand, server));
    let shop = kept(dir);
    let hand = Hand::of(&shop);
    assert!((top(&hand) - lowered).abs() < 1e-6, "{} {lowered}", top(&hand));
}

#[test]
fn pro_console_f52() {
    // The fourth line is 2 mm away, the seventh 9.
    let lines = [300.0, 310.0, 320.0, 40.0, 330.0, 340.0, 51.0, 350.0];
    let clauses = lines.map(|y| format!("line 0,{y} 100,{y}")).join("; ");
    let (_shop, mut hand) =
        with_job(&rsm(&clauses), |machine| machine.job.origin_mm = [10.0, 20.0]);
    go(&mut hand, [50.0, 42.0], [60.0, 62.0]);
    hand.keys("U52E");
    hand.shows("Nearest shape", "4 of 8");
}

#[test]
fn pro_console_f60() {
    let (shop, mut hand) = with_job(&rsm("rect 0,0 90,90; select 1; reverse"), |_| {});
    let before = job(&shop)["paths"].clone();
    hand.shows("JOB: job.rsm", "90x90mm #1");
    hand.keys("U60E1E");
    hand.shows("JOB: job.rsm", "88x88mm #1");
    hand.keys("U60E");
    hand.shows("Offset job mm:", "1");
    hand.keys("0E");
    hand.shows("JOB: job.rsm", "90x90mm #1");
    assert_eq!(job(&shop)["paths"], before, "exactly");
    let beeps = hand.beeps();
    hand.keys("U60E60E");
    hand.until("a beep", |page| page.shown["handConsole"]["beeps"] == beeps + 1);
    assert_eq!(hand.shown["opened"]["choice"]["offset"], 0.0, "no room");
}

/// A job of one line in space, whose lowest place is 4 mm below the surface.
fn in_space() -> String {
    let path = Polyarc::lines([0.0, 50.0, 100.0].map(|x| Point2::new(x, 10.0)), false);
    let mut editor = Editor::default();
    editor.drawing = Drawing::of([Shape::with_heights(path, vec![0.0, -4.0, -1.0])]);
    for (_, operation) in script("set black height=3d").unwrap() {
        editor.apply(&operation).unwrap();
    }
    kerf_toolpath::write(&kerf_toolpath::job(&editor.drawing).unwrap().0)
}

#[test]
fn pro_console_f300() {
    let (shop, mut hand) = with_job(&in_space(), |_| {});
    // The lowest place of the cuts, machine frame; previews may follow on each other.
    let cuts = |hand: &mut Hand, z: f64| {
        hand.until(&format!("cuts at {z}"), |page| {
            let key = page.shown["opened"]["preview"]["key"].as_str().unwrap_or_default();
            shop.get(&format!("/api/preview/{key}")).json()["bounds"][0][2] == z
        });
    };
    cuts(&mut hand, -24.0);
    hand.keys("U300E-1E");
    hand.shows("ZBottom justify", "ZBottom -31");
    hand.until("the bottom", |page| page.shown["setup"]["heights"]["bottom"] == -31.0);
    hand.until("the job", |page| page.shown["opened"]["choice"]["lift"] == -7.0);
    hand.until_state("idle");
    cuts(&mut hand, -31.0);
    // A preview may still follow on the one that was looked at.
    assert!((0..100).any(|_| hand.read() && hand.run().is_none()), "it runs");
    hand.until("the end", |page| page.shown["job"]["ended"] == "ok");
    hand.until_state("idle");
    // Once more: it does not add up.
    hand.keys("U300E0E");
    hand.until_state("idle");
    cuts(&mut hand, -31.0);
    hand.keys("U300E1E");
    hand.until("the job", |page| page.shown["opened"]["choice"]["lift"] == -6.0);
    cuts(&mut hand, -30.0);
}
