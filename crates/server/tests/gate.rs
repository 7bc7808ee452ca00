//! Nobody has the machine move, go on, or switch something dangerous who does not drive it, armed.

use crate::support;
use crate::support::{Page, Shop, Wanted, at, shop, start};
use serde_json::{Value, json};
use std::thread;
use std::time::Duration;

/// Words of the reply to an act that is refused.
type Refusal = Option<String>;

fn answer(question: u64, words: &str) -> Value {
    json!({ "do": "answer", "question": question, "answer": words })
}

fn because(why: &str) -> Refusal {
    Some(why.to_owned())
}

/// A program that was stopped in the middle of a cut; whoever drove it has gone.
fn left_alone(shop: &Shop) -> (Page, u64) {
    let mut driver = shop.driver();
    driver.open_file("cut.sbp");
    assert_eq!(driver.run(), None);
    driver.until("some way", |page| at(page)[0] > 5.0);
    driver.act(json!({ "do": "stop" }));
    let question = driver.asked("hold");
    drop(driver);
    let mut other = shop.page();
    other.until("nobody drives", |page| page.shown["lease"].is_null());
    assert_eq!(other.shown["machine"]["armed"], false);
    (other, question)
}

/// Nothing moves for a while.
#[track_caller]
fn stands(page: &mut Page) {
    page.read();
    let before = page.shown["motion"]["at"].clone();
    thread::sleep(Duration::from_millis(400));
    for _ in 0..20 {
        page.read();
    }
    assert_eq!(page.shown["motion"]["at"], before, "something moved");
}

#[test]
fn an_answer_moves_no_machine_that_nobody_drives() {
    let shop = shop(1.0, &[("cut.sbp", "MS,2,2\nMX,20\n")]);
    let (mut other, question) = left_alone(&shop);
    let (way, nudge) = ("jog 0,400,0,0,0,0 1", "nudge x 1");
    for (words, why) in [(way, "malformed"), (nudge, "malformed"), ("Resume", "lease")] {
        assert_eq!(other.act(answer(question, words)), because(why), "{words}");
        let body = json!({ "question": question, "answer": words });
        let refused = shop.post("/api/do/answer", body, &[]).json();
        assert_eq!(refused["why"], why, "{words} over HTTP");
        stands(&mut other);
    }
    other.drive();
    let mended = other.send(answer(question, way));
    assert!(other.problem(mended).contains("jogStart"), "the mend is told");
    assert_eq!(other.act(answer(question, "Resume")), None);
    other.until("the end", |page| page.shown["job"]["ended"] == "ok");
}

#[test]
fn a_stopped_run_is_given_up_by_anybody() {
    let shop = shop(1.0, &[("cut.sbp", "MS,2,2\nMX,20\n")]);
    let (mut other, question) = left_alone(&shop);
    assert_eq!(other.act(answer(question, "Quit")), None);
    other.until("the end", |page| page.shown["job"]["ended"] == "stopped");
}

/// A program asks; another page says so and says that. What was refused.
#[track_caller]
fn check(text: &'static str, kind: &str, refused: &[(&str, &str)], free: Option<&str>) {
    let shop = shop(20.0, &[("ask.sbp", text)]);
    let (mut page, mut other) = (shop.driver(), shop.page());
    page.open_file("ask.sbp");
    assert_eq!(page.run(), None);
    let question = other.asked(kind);
    for (words, why) in refused {
        assert_eq!(other.act(answer(question, words)), because(why), "{kind}: {words}");
    }
    let Some(free) = free else { return };
    page.until("the question", |page| page.shown["asked"]["number"] == question);
    assert_eq!(other.act(answer(question, free)), None, "{kind}: {free}");
    page.until("the next", |page| page.shown["asked"]["number"] != question);
}

#[test]
fn what_goes_on_is_said_by_whoever_drives_and_the_rest_by_anybody() {
    check("INPUT how far &x\nMX,&x\n", "input", &[], Some("3"));
    check("INPUT how far &x\nMX,&x\n", "input", &[], Some("jog 1,2,3,4,5,6 1"));
    check("MSGBOX(\"Go on?\",YesNo)\nMX,1\n", "msgbox", &[("Yes", "lease")], Some("No"));
    check("PAUSE\nMX,1\n", "pause", &[("OK", "lease")], Some("Cancel"));
    check("SO,1,1\nMX,1\n", "spindle", &[("OK", "lease")], Some("Cancel"));
    check("SK\nMX,1\n", "keypad", &[("OK", "lease"), ("pendant", "malformed")], None);
}

#[test]
fn an_answer_that_arrived_before_a_disarm_does_not_go_on() {
    let shop = shop(1.0, &[("ask.sbp", "PAUSE\nMX,1\n")]);
    let mut page = shop.driver();
    page.open_file("ask.sbp");
    assert_eq!(page.run(), None);
    let question = page.asked("pause");
    let (lease, before) = (page.lease, at(&page));
    assert_eq!(page.act(json!({ "do": "giveLease", "lease": lease })), None);
    assert_eq!(page.act(answer(question, "OK")), because("lease"));
    assert_eq!(page.act(json!({ "do": "takeLease", "force": false })), None);
    assert_eq!(page.act(answer(question, "OK")), because("disarmed"));
    stands(&mut page);
    assert_eq!(at(&page), before);
}

/// Writes a value of the registry over the network: status and answer.
fn put(shop: &Shop, key: &str, value: &str) -> (u16, Value) {
    let answer = shop.ask(&format!("PUT /api/registry/{key}"), &[], value.as_bytes());
    (answer.status, answer.json()["text"].clone())
}

/// The machine is left, and Kerf starts anew: after a SIGKILL the journal is as it was at that moment.
fn started_anew(shop: Shop) -> Shop {
    let Shop { server, dir } = shop;
    drop(server);
    support::kept(dir)
}

#[test]
fn what_the_machine_says_of_itself_is_written_by_nobody_else() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    let facts = ["SpindleStatus", "PositionLost", "ConfirmLocation", "SimulatedSwitches", "Status"];
    for key in facts.into_iter().chain(["Editor", "uPartFile", "Recorded", "ControllerLeft"]) {
        for value in ["1", ""] {
            let (status, text) = put(&shop, key, value);
            assert_eq!(status, 400, "{key}={value}");
            assert!(text.as_str().unwrap().contains("Kerf alone writes"), "{key}: {text}");
        }
    }
    // Nor by the file that other programs write.
    let data = shop.dir.path().join("data");
    let lines = facts.map(|key| format!("{key}=1\n")).concat() + "Mine=1\n";
    std::fs::write(data.join("new"), lines).unwrap();
    std::fs::rename(data.join("new"), data.join("registry.in")).unwrap();
    let value = |key: &str| shop.get(&format!("/api/registry/{key}"));
    let mut page = shop.page();
    page.until("what was written", |_| value("Mine").status == 200);
    assert_eq!(value("SpindleStatus").body, b"0");
    assert_eq!([value("PositionLost").status, value("ConfirmLocation").status], [404, 404]);
    for key in ["uValue", "uValueClrd", "Mine", "%24mine"] {
        assert_eq!(put(&shop, key, "1").0, 200, "{key}");
    }
}

#[test]
fn the_question_of_the_spindle_is_asked_anew_after_every_start() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    let mut page = shop.driver();
    let spindle = json!({ "do": "command", "lease": page.lease, "line": "SO,1,1" });
    assert_eq!(page.act(spindle), None);
    let question = page.asked("spindle");
    assert_eq!(page.act(answer(question, "OK")), None);
    page.until("the spindle", |page| page.shown["io"]["outputs"][0]["on"] == true);
    page.until_state("idle");
    assert_eq!(shop.get("/api/registry/SpindleStatus").body, b"1");
    let shop = started_anew(shop);
    assert_eq!(shop.get("/api/registry/SpindleStatus").body, b"0");
    let mut page = shop.driver();
    let spindle = json!({ "do": "command", "lease": page.lease, "line": "SO,1,1" });
    assert_eq!(page.act(spindle), None);
    page.asked("spindle");
    assert_eq!(page.shown["io"]["outputs"][0]["on"], false);
}

/// The first half of a start-up line runs, and is stopped; whoever looks says how it goes on.
fn stopped_start_up(answers: &str) -> Page {
    let begin_with = vec!["MS,2,2\nMX,20", "MY,1"];
    let shop = start(Wanted { begin_with, ..Wanted::default() });
    let mut page = shop.page();
    page.until("some way", |page| at(page)[0] > 5.0);
    assert_eq!(page.act(json!({ "do": "stop" })), None);
    let question = page.asked("hold");
    if answers == "Resume" {
        page.drive();
    }
    assert_eq!(page.act(answer(question, answers)), None);
    page.until("what is left is told", |page| {
        let messages = page.shown["messages"].as_array().unwrap();
        messages.iter().any(|it| it["text"].as_str().unwrap().starts_with("MY,1 of the start-up"))
    });
    page.until_state("idle");
    page
}

#[test]
fn a_stop_ends_all_of_a_start_up_line() {
    assert_eq!(at(&stopped_start_up("Quit"))[1], 0.0);
    let page = stopped_start_up("Resume");
    assert_eq!([at(&page)[0].round(), at(&page)[1]], [508.0, 0.0]);
}

#[test]
fn a_start_up_line_that_nobody_stops_is_carried_out() {
    let begin_with = vec!["MS,2,2\nMX,.1", "MY,.2"];
    let shop = start(Wanted { rate: 20.0, begin_with, ..Wanted::default() });
    let mut page = shop.page();
    page.until("both", |page| (at(page)[1] - 0.2 * 25.4).abs() < 1e-6);
    page.until_state("idle");
}

/// Outputs 1 and 7 are on, whatever follows switches them off, or not.
fn rests(stays_on: bool, ends: impl Fn(&mut Page, &Shop)) {
    let shop = shop(20.0, &[]);
    let mut page = shop.driver();
    page.command("SetSpindleStatus 1\nSO,1,1\nSO,7,1");
    if stays_on {
        page.set("misc.outputs_stay_on", "true");
    }
    let mut watcher = shop.page();
    let on = |page: &Page| [0, 6].map(|n| page.shown["io"]["outputs"][n]["on"] == true);
    assert_eq!(on(&watcher), [true; 2]);
    assert_eq!(watcher.shown["setup"]["outputsStayOn"], stays_on);
    ends(&mut page, &shop);
    drop(page);
    if stays_on {
        thread::sleep(Duration::from_millis(400));
        assert_eq!(on(&shop.page()), [true; 2]);
    } else {
        watcher.until("outputs off", |page| on(page) == [false; 2]);
        watcher.until_state("idle");
    }
}

#[test]
fn a_machine_that_stands_and_is_stopped_disarmed_or_left_switches_off() {
    rests(false, |page, _| assert_eq!(page.act(json!({ "do": "disarm" })), None));
    rests(false, |page, _| {
        let lease = page.lease;
        assert_eq!(page.act(json!({ "do": "giveLease", "lease": lease })), None);
    });
    rests(false, |_, _| ());
    rests(true, |page, shop| {
        assert_eq!(page.act(json!({ "do": "stop" })), None);
        assert_eq!(shop.page().act(json!({ "do": "disarm" })), None);
    });
    // The stop of another page, while this one goes on driving.
    rests(false, |page, shop| {
        assert_eq!(shop.page().act(json!({ "do": "stop" })), None);
        page.until("outputs off", |page| page.shown["io"]["outputs"][6]["on"] == false);
        assert_eq!(page.shown["machine"]["armed"], true);
        page.command("SO,7,1");
        page.until("the next", |page| page.shown["io"]["outputs"][6]["on"] == true);
    });
}

#[test]
fn a_workpiece_is_nudged_while_the_question_after_a_stop_is_open() {
    let shop = start(Wanted { files: vec![("cut.sbp", "MS,2,2\nMX,20\n")], ..Wanted::default() });
    let mut page = shop.driver();
    page.open_file("cut.sbp");
    assert_eq!(page.run(), None);
    page.until("some way", |page| at(page)[0] > 5.0);
    page.act(json!({ "do": "stop" }));
    page.asked("hold");
    let before = at(&page)[1];
    let nudge = json!({ "do": "nudge", "lease": page.lease, "axis": "Y", "distance": 2.5 });
    assert_eq!(page.act(nudge), None);
    page.until("the nudge", |page| (at(page)[1] - before - 2.5).abs() < 1e-6);
    let foreign = json!({ "do": "nudge", "lease": page.lease, "axis": "Y", "distance": 2.5 });
    assert_eq!(shop.page().act(foreign), because("lease"));
}

#[test]
fn a_nudge_of_a_machine_that_stands_moves_the_tool_and_its_working_zero() {
    let shop = start(Wanted::default());
    let mut page = shop.driver();
    let nudge = |page: &Page, mm: f64| json!({ "do": "nudge", "lease": page.lease, "axis": "Y", "distance": mm });
    let (before, line) = (at(&page)[1], "MY,0");
    assert_eq!(page.act(nudge(&page, 2.5)), None);
    page.until("the nudge", |page| (at(page)[1] - before - 2.5).abs() < 1e-6);
    page.until("it stands", |page| page.shown["machine"]["state"] == "idle");
    page.command(line);
    page.until("it stands", |page| page.shown["machine"]["state"] == "idle");
    assert!((at(&page)[1] - before - 2.5).abs() < 1e-6, "{:?}: where 0 is now", at(&page));
}

/// A cut that a stop input ends, with a STOP while the tool slows down for it: the page, and its question.
fn stopped_twice() -> (Shop, Page, u64) {
    let settings = |settings: &mut kerf_program::Settings| settings.io.inputs[6] = 3;
    let files = vec![("cut.sbp", "MS,4,4\nMX,2.5\n")];
    // A tenth of the world's time: the ramp is long enough for a finger.
    let shop = start(Wanted { rate: 0.1, files, settings, ..Wanted::default() });
    let mut page = shop.driver();
    page.open_file("cut.sbp");
    assert_eq!(page.run(), None);
    page.until("full speed", |page| at(page)[0] > 20.0);
    let pressed = json!({ "do": "input", "lease": page.lease, "number": 7, "on": true });
    page.send(pressed);
    page.until("the input", |page| page.shown["io"]["inputs"][6]["on"] == true);
    page.send(json!({ "do": "stop" }));
    let question = page.asked("hold");
    (shop, page, question)
}

#[test]
fn a_stop_while_the_tool_slows_down_for_an_input_asks_once() {
    let (_shop, mut page, question) = stopped_twice();
    let text = page.shown["asked"]["text"].as_str().unwrap().to_owned();
    assert!(text.starts_with("stopped by stop input 7"), "{text}");
    let stood = at(&page);
    let released = json!({ "do": "input", "lease": page.lease, "number": 7, "on": false });
    assert_eq!(page.act(released), None);
    stands(&mut page);
    assert_eq!((at(&page)[0], page.asked("hold")), (stood[0], question), "it waits for Resume");
    assert_eq!(page.act(answer(question, "Resume")), None);
    page.until("it goes on", |page| at(page)[0] > stood[0] + 5.0);
    assert_eq!(page.shown["asked"], Value::Null);
    page.until_state("idle");
    assert!((at(&page)[0] - 2.5 * 25.4).abs() < 1e-6, "{:?}", at(&page));
}

#[test]
fn lines_that_move_nothing_are_typed_at_a_disarmed_machine() {
    let shop = shop(1.0, &[]);
    let mut driver = shop.driver();
    driver.act(json!({ "do": "disarm" }));
    driver.until("it is disarmed", |page| page.shown["machine"]["armed"] == false);
    let lease = driver.shown["lease"]["number"].clone();
    let mut typed =
        |line: &str| driver.act(json!({ "do": "command", "lease": lease, "line": line }));
    for line in ["MX,1", "SO,1,1", "ZX", "SK", "VA,1", "MS,2\nMX,1", "&a=1\nFP,cut.sbp"] {
        assert_eq!(typed(line), because("disarmed"), "{line}");
    }
    assert_eq!(typed("MS,2,1\nSA\nSP"), None);
    driver.until("it previews", |page| page.shown["machine"]["mode"] == "preview");
    assert_eq!(driver.shown["machine"]["armed"], false);
}
