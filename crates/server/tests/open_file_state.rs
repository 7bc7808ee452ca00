//! State of the open file, progress of the run, and the place of the tool in the file.

use crate::support::{Page, shop};
use serde_json::{Value, json};

const BAD: &str = "SA\nM2,1,1\nFOO,1\n";

/// A cut of some seconds, then another one.
const TWO: &str = "SA\nMS,1,1\nMX,4\nMX,0\n";

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn opened(page: &Page) -> &Value {
    &page.shown["opened"]
}

fn over(page: &mut Page) {
    page.until("it is over", |page| page.shown["job"]["ended"] == "ok");
    page.until_state("idle");
}

#[test]
fn a_file_with_mistakes_is_known_as_one_and_refused_with_its_first_line() {
    let shop = shop(20.0, &[("bad.sbp", BAD), ("two.sbp", TWO)]);
    let mut page = shop.driver();
    page.open_file("bad.sbp");
    assert_eq!(opened(&page)["broken"], true);
    // Pages know files by their names in the part folder.
    assert_eq!(opened(&page)["findings"][0]["file"], "bad.sbp");
    let run =
        json!({ "do": "run", "lease": page.lease, "hash": opened(&page)["hash"], "step": false });
    let id = page.send(run);
    let why = page.problem(id);
    assert_eq!(why, "the file has mistakes, the first in line 3: unknown command FOO");
    page.open_file("two.sbp");
    assert_eq!(opened(&page)["broken"], false);
}

#[test]
fn a_file_keeps_its_last_run_until_it_is_another() {
    let shop = shop(50.0, &[("two.sbp", TWO), ("bad.sbp", BAD)]);
    let mut page = shop.driver();
    page.open_file("two.sbp");
    assert_eq!(opened(&page)["ran"], Value::Null);
    assert_eq!(page.run(), None);
    over(&mut page);
    let ran = opened(&page)["ran"].clone();
    assert_eq!((&ran["ended"], &ran["line"]), (&json!("ok"), &json!(4)));
    assert!(ran["at"].as_u64().unwrap() > 0);
    assert_eq!(page.shown["motion"]["progress"], 1.0);
    page.open_file("bad.sbp");
    assert_eq!(opened(&page)["ran"], Value::Null);
    page.open_file("two.sbp");
    assert_eq!(opened(&page)["ran"], ran);
    shop.write("two.sbp", b"SA\nMX,1\n");
    page.open_file("two.sbp");
    assert_eq!(opened(&page)["ran"], Value::Null);
}

#[test]
fn progress_goes_on_within_a_move_and_time_that_is_left_is_that_at_the_override() {
    let shop = shop(2.0, &[("two.sbp", TWO)]);
    let mut page = shop.driver();
    page.open_file("two.sbp");
    let seconds = number(&opened(&page)["seconds"]);
    assert_eq!(page.run(), None);
    page.until("within the first move", |page| {
        let x = number(&page.shown["motion"]["at"]["working"][0]);
        x > 50.0 && page.shown["motion"]["made"] == 0
    });
    let motion = page.shown["motion"].clone();
    let progress = number(&motion["progress"]);
    assert!(progress > 0.2 && progress < 0.5, "{progress}");
    let left = number(&motion["remaining"]);
    // The machine runs twice as fast as the clock.
    assert!((left - seconds / 2.0 * (1.0 - progress)).abs() < 0.1, "{left} of {seconds}");
    let slower = json!({ "do": "override", "lease": page.lease, "feedPercent": 50.0 });
    assert_eq!(page.act(slower), None);
    // On the way to the other speed the time is that of the ramp.
    page.until("behind the first move", |page| page.shown["motion"]["made"] == 1);
    let motion = page.shown["motion"].clone();
    let [progress, left] = ["progress", "remaining"].map(|name| number(&motion[name]));
    assert!(progress > 0.45, "{progress}");
    assert!((left - seconds * (1.0 - progress)).abs() < 0.25, "{left} of {seconds}");
    over(&mut page);
    assert_eq!(page.shown["motion"]["made"], 2, "an override makes one move in several parts");
}

#[test]
fn a_hold_and_the_way_back_are_no_moves_of_the_plan() {
    let shop = shop(10.0, &[("two.sbp", TWO)]);
    let mut page = shop.driver();
    page.open_file("two.sbp");
    assert_eq!(page.run(), None);
    page.until("it cuts", |page| number(&page.shown["motion"]["at"]["working"][0]) > 30.0);
    page.act(json!({ "do": "stop" }));
    let question = page.asked("hold");
    page.act(json!({ "do": "answer", "question": question, "answer": "Resume" }));
    over(&mut page);
    assert_eq!(page.shown["motion"]["made"], 2);
}

#[test]
fn the_line_is_that_of_the_move_and_its_file_is_told() {
    let main = "SA\nMS,.5,.5\nMX,1\nFP,called.sbp\nMX,0\n";
    let shop = shop(4.0, &[("main.sbp", main), ("called.sbp", "MX,3\nMX,1\n")]);
    let mut page = shop.driver();
    page.open_file("main.sbp");
    assert_eq!(page.run(), None);
    let stands = |file: &'static str, line: u32| {
        move |page: &Page| {
            page.shown["job"]["toolFile"] == file && page.shown["motion"]["line"] == line
        }
    };
    for (file, line) in [("main.sbp", 3), ("called.sbp", 1), ("called.sbp", 2), ("main.sbp", 5)] {
        page.until(&format!("line {line} of {file}"), stands(file, line));
    }
    over(&mut page);
}
