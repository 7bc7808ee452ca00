//! A jog moves for as long as somebody holds the key, and not longer.

use crate::support::{Page, Shop, Wanted, at, shop, start as start_shop};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

/// Begins a jog of X.
fn start(page: &Page, seq: u32) -> Value {
    let direction = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    json!({ "do": "jogStart", "lease": page.lease, "seq": seq, "clockMs": page.clock_ms(),
            "direction": direction, "distance": null, "speedShare": 0.2 })
}

fn renew(page: &Page, seq: u32) -> Value {
    json!({ "do": "jogRenew", "lease": page.lease, "seq": seq, "clockMs": page.clock_ms() })
}

fn stop(seq: u32) -> Value {
    json!({ "do": "jogStop", "seq": seq })
}

/// Renews for a while, as a page does.
fn hold(page: &mut Page, seq: u32, time: Duration) {
    let begin = Instant::now();
    while begin.elapsed() < time {
        let renewal = renew(page, seq);
        page.send(renewal);
        let next = Instant::now() + Duration::from_millis(60);
        while Instant::now() < next {
            page.read();
        }
    }
}

#[test]
fn it_goes_on_while_it_is_renewed_and_stops_when_the_key_is_released() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    let begin = start(&page, 1);
    assert_eq!(page.act(begin), None);
    hold(&mut page, 1, Duration::from_millis(800));
    assert_eq!(page.shown["machine"]["state"], "jogging");
    let (before, released) = (page.x(), Instant::now());
    page.act(stop(1));
    page.until_state("idle");
    let took = released.elapsed();
    assert!(before > 5.0, "{before}");
    assert!(took < Duration::from_millis(600), "{took:?}");
    let rest = page.x();
    assert!(rest >= before && rest < before + 15.0, "{before} {rest}");
    assert!(page.shown["asked"].is_null(), "nobody is asked");
}

#[test]
fn it_stops_by_itself_when_nobody_renews_it() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    let (begin, since) = (start(&page, 1), Instant::now());
    assert_eq!(page.act(begin), None);
    assert_eq!(page.shown["machine"]["state"], "jogging");
    page.until_state("idle");
    let took = since.elapsed();
    assert!(took > Duration::from_millis(200) && took < Duration::from_millis(900), "{took:?}");
    let renewal = renew(&page, 1);
    assert_eq!(page.act(renewal).as_deref(), Some("late"));
}

#[test]
fn it_stops_when_the_page_has_gone() {
    let shop = shop(1.0, &[]);
    let (mut page, mut watcher) = (shop.driver(), shop.page());
    let begin = start(&page, 1);
    page.act(begin);
    watcher.until_state("jogging");
    let gone = Instant::now();
    drop(page);
    watcher.until_state("idle");
    assert!(gone.elapsed() < Duration::from_millis(600), "{:?}", gone.elapsed());
    watcher.until("disarmed", |page| page.shown["machine"]["armed"] == false);
}

#[test]
fn a_start_that_comes_behind_its_own_stop_is_dropped() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    page.act(stop(7));
    for seq in [1, 7] {
        let late = start(&page, seq);
        assert_eq!(page.act(late).as_deref(), Some("late"), "{seq}");
    }
    assert_eq!(page.shown["machine"]["state"], "idle");
    let next = start(&page, 8);
    assert_eq!(page.act(next), None);
    // Once more, as a network that doubles messages sends it.
    let twice = start(&page, 8);
    assert_eq!(page.act(twice).as_deref(), Some("late"));
    page.until_state("idle");
}

#[test]
fn stop_and_hold_of_any_page_end_it() {
    let shop = shop(1.0, &[]);
    let (mut page, mut other) = (shop.driver(), shop.page());
    for (seq, word) in [(1, "stop"), (2, "hold")] {
        let begin = start(&page, seq);
        assert_eq!(page.act(begin), None);
        other.until_state("jogging");
        other.act(json!({ "do": word }));
        other.until_state("idle");
        page.until_state("idle");
    }
}

#[test]
fn a_step_ends_at_its_distance() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    let step = json!({ "do": "jogStart", "lease": page.lease, "seq": 1, "clockMs": page.clock_ms(),
        "direction": [0.0, -1.0, 0.0, 0.0, 0.0, 0.0], "distance": 2.54, "speedShare": 1.0 });
    assert_eq!(page.act(step), None);
    page.until_state("jogging");
    hold(&mut page, 1, Duration::from_millis(300));
    page.until_state("idle");
    let y = page.shown["motion"]["at"]["working"][1].as_f64().unwrap();
    assert!((y + 2.54).abs() < 1e-6, "{y}");
}

#[test]
fn nothing_jogs_without_lease_or_armed_machine_or_over_http() {
    let shop = shop(1.0, &[]);
    let mut page = shop.page();
    let begin = start(&page, 1);
    assert_eq!(page.act(begin).as_deref(), Some("lease"));
    page.drive();
    page.act(json!({ "do": "disarm" }));
    let begin = start(&page, 2);
    assert_eq!(page.act(begin).as_deref(), Some("disarmed"));
    let body = start(&page, 3);
    let Value::Object(mut fields) = body else { panic!() };
    fields.remove("do");
    assert_eq!(shop.post("/api/do/jogStart", fields.into(), &[]).status, 400);
}

#[test]
fn directions_and_speeds_that_make_no_sense_are_refused() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    for (direction, distance, speed) in [
        ([0.0; 6], Value::Null, 1.0),
        ([2.0, 0.0, 0.0, 0.0, 0.0, 0.0], Value::Null, 1.0),
        ([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], json!(-1.0), 1.0),
        ([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], Value::Null, 9.0),
        ([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], Value::Null, 0.0),
        ([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], Value::Null, -0.5),
    ] {
        let act = json!({ "do": "jogStart", "lease": page.lease, "seq": 1, "clockMs": page.clock_ms(),
            "direction": direction, "distance": distance, "speedShare": speed });
        assert_eq!(page.act(act).as_deref(), Some("malformed"), "{direction:?} {distance} {speed}");
    }
}

/// Waits until a jog in a question is over.
fn jog_in_question(page: &mut Page, seq: u32, direction: [f64; 6], state: &str) {
    let act = json!({ "do": "jogStart", "lease": page.lease, "seq": seq, "clockMs": page.clock_ms(),
        "direction": direction, "distance": 10.0, "speedShare": 1.0 });
    assert_eq!(page.act(act), None);
    page.until_state("jogging");
    hold(page, seq, Duration::from_millis(500));
    page.until_state(state);
}

/// A program that has opened the keypad, and the number of its question.
fn keypad(program: &'static str) -> (Shop, Page, u64) {
    let shop = shop(1.0, &[("keypad.sbp", program)]);
    let mut page = shop.driver();
    page.open_file("keypad.sbp");
    assert_eq!(page.run(), None);
    let number = page.asked("keypad");
    (shop, page, number)
}

#[test]
fn a_program_that_opened_the_keypad_goes_on_where_the_tool_was_moved() {
    let (_shop, mut page, number) = keypad("SK,\"Move to the corner\"\nZX\nMX,.1\n");
    jog_in_question(&mut page, 1, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0], "asking");
    jog_in_question(&mut page, 2, [1.0, 1.0, 0.0, 0.0, 0.0, 0.0], "asking");
    assert_eq!(page.shown["asked"]["number"], number, "it is the same question");
    assert!((page.x() - 20.0).abs() < 1e-6, "{}", page.x());
    let begin = start(&page, 3);
    assert_eq!(page.act(begin), None);
    page.until_state("jogging");
    page.until_state("asking");
    let let_go = page.x();
    assert!(let_go > 20.0 && let_go < 60.0, "{let_go}");
    assert_eq!(page.act(json!({ "do": "answer", "question": number, "answer": "OK" })), None);
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "ok");
    assert!((page.x() - 2.54).abs() < 1e-6);
    let base = page.shown["motion"]["at"]["base"][0].as_f64().unwrap();
    assert!((base - let_go - 2.54).abs() < 1e-6);
}

#[test]
fn after_a_stop_the_tool_is_moved_away_and_the_cut_goes_on_where_it_was() {
    let shop = shop(1.0, &[("cut.sbp", "MS,1,1\nMZ,-.1\nMX,2\n")]);
    let mut page = shop.driver();
    page.open_file("cut.sbp");
    assert_eq!(page.run(), None);
    page.until("some way", |page| page.x() > 5.0);
    page.act(json!({ "do": "stop" }));
    page.until_state("stopped");
    let stood = page.x();
    jog_in_question(&mut page, 1, [0.0, 1.0, 0.5, 0.0, 0.0, 0.0], "stopped");
    assert_eq!(page.act(json!({ "do": "resume", "lease": page.lease })), None);
    page.until("the cut", |page| page.shown["motion"]["cutting"] == true && page.x() > stood + 1.0);
    let at = page.shown["motion"]["at"]["working"].clone();
    assert!(at[1].as_f64().unwrap().abs() < 1e-6 && (at[2].as_f64().unwrap() + 2.54).abs() < 1e-6);
    page.until_state("idle");
    assert!((page.x() - 50.8).abs() < 1e-6);
}

/// SIM where a program has opened the keypad.
fn sim_with_keypad(homed: bool, change: fn(&mut kerf_machine::Configuration)) -> (Shop, Page) {
    let shop = start_shop(Wanted {
        homed,
        files: vec![("keypad.sbp", "SK\nMX,.1\n")],
        machine: Some(("sim", change)),
        ..Wanted::default()
    });
    let mut page = shop.driver();
    page.open_file("keypad.sbp");
    assert_eq!(page.run(), None);
    page.asked("keypad");
    (shop, page)
}

/// Jogs one way in the question until the machine stands by itself, and tells where it is.
fn jog_to_the_end(page: &mut Page, direction: [f64; 6]) -> [f64; 3] {
    let begin = json!({ "do": "jogStart", "lease": page.lease, "seq": 1, "clockMs": page.clock_ms(),
        "direction": direction, "distance": Value::Null, "speedShare": 1.0 });
    assert_eq!(page.act(begin), None);
    page.until_state("jogging");
    let begun = Instant::now();
    while page.shown["machine"]["state"] == "jogging" {
        hold(page, 1, Duration::from_millis(50));
        assert!(begun.elapsed() < Duration::from_secs(15), "nothing ends it: {:?}", at(page));
    }
    at(page)
}

#[test]
fn pro_zpos_bottom_limit__a_jog_in_a_question() {
    let (_shop, mut page) = sim_with_keypad(true, |_| {});
    let at = jog_to_the_end(&mut page, [0.0, 0.0, -1.0, 0.0, 0.0, 0.0]);
    assert!((at[2] + 30.0).abs() < 1e-3, "{at:?}");
    let told = page.shown["messages"].to_string();
    assert!(told.contains("Z bottom (zpos.bottom_mm)"), "{told}");
}

#[test]
fn pro_axes_limit_unhomed__a_jog_in_a_question() {
    let (_shop, mut page) = sim_with_keypad(false, |machine| machine.axes.length.0[0] = 40.0);
    let at = jog_to_the_end(&mut page, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert!((at[0] - 40.0).abs() < 1e-3, "{at:?}");
}

#[test]
fn a_hold_of_a_machine_that_asks_ends_no_later_jog() {
    let (_shop, mut page, _) = keypad("SK\n");
    page.act(json!({ "do": "hold" }));
    jog_in_question(&mut page, 1, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0], "asking");
    assert!((page.x() - 10.0).abs() < 1e-6, "{}", page.x());
}

#[test]
fn a_stop_during_a_jog_in_a_question_ends_the_job() {
    let (_shop, mut page, _) = keypad("SK\nMX,5\n");
    let begin = start(&page, 1);
    assert_eq!(page.act(begin), None);
    page.until_state("jogging");
    page.act(json!({ "do": "stop" }));
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "stopped");
}

#[test]
fn the_first_answer_counts_also_during_a_jog() {
    let (shop, mut page, number) = keypad("SK\nINPUT how &n\nMX,&n\n");
    let mut first = shop.page();
    let answer =
        |number: u64, words: &str| json!({ "do": "answer", "question": number, "answer": words });
    let begin = start(&page, 1);
    assert_eq!(page.act(begin), None);
    page.until_state("jogging");
    assert_eq!(page.act(answer(number, "OK")), None);
    assert_eq!(page.act(answer(number, "OK")).as_deref(), Some("late"));
    let number = page.asked("input");
    first.send(answer(number, "3"));
    let late = first.send(answer(number, "1"));
    assert_eq!(first.reply(late).as_deref(), Some("late"));
    page.until_state("idle");
    assert!((page.x() - 76.2).abs() < 1e-6, "{}", page.x());
}

fn key(page: &Page, number: u8, on: bool) -> Value {
    json!({ "do": "input", "lease": page.lease, "number": number, "on": on })
}

#[test]
fn sbp_val_vd_remote__a_key_of_the_pendant_moves_the_tool_until_it_is_let_go() {
    let shop = shop(1.0, &[("keypad.sbp", "VD,,,,,,,,,1\nSK\nMZ,.1\n")]);
    let mut page = shop.driver();
    page.open_file("keypad.sbp");
    assert_eq!(page.run(), None);
    let number = page.asked("keypad");
    for (input, way) in [(5, 1.0), (6, -1.0)] {
        let before = page.x();
        let press = key(&page, input, true);
        assert_eq!(page.act(press), None);
        page.until_state("jogging");
        page.until("some way", |page| (page.x() - before) * way > 3.0);
        let release = key(&page, input, false);
        assert_eq!(page.act(release), None);
        page.until_state("asking");
        let stands = page.x();
        std::thread::sleep(Duration::from_millis(300));
        page.read();
        assert_eq!(page.x(), stands, "nothing moves any more");
    }
    assert_eq!(page.shown["asked"]["number"], number, "it is the same question");
    let close = key(&page, 12, true);
    assert_eq!(page.act(close), None);
    page.until("the question is over", |page| page.shown["asked"].is_null());
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "ok");
}

#[test]
fn sbp_val_vd_remote__a_key_that_is_held_moves_nothing_after_a_stop_or_disarmed() {
    let shop = shop(1.0, &[("keypad.sbp", "VD,,,,,,,,,1\nSK\nMX,5\n")]);
    let mut page = shop.driver();
    page.open_file("keypad.sbp");
    assert_eq!(page.run(), None);
    page.asked("keypad");
    let press = key(&page, 5, true);
    assert_eq!(page.act(press), None);
    page.until_state("jogging");
    page.act(json!({ "do": "stop" }));
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "stopped");
    let stood = page.x();
    // Its preview is made anew from where the tool is now.
    while page.run().as_deref() == Some("state") {
        std::thread::sleep(Duration::from_millis(50));
    }
    page.asked("keypad");
    std::thread::sleep(Duration::from_millis(300));
    page.read();
    assert_eq!((page.x(), &page.shown["machine"]["state"]), (stood, &json!("asking")));
    assert_eq!(page.act(json!({ "do": "giveLease", "lease": page.lease })), None);
    page.until("disarmed", |page| page.shown["machine"]["armed"] == false);
    assert_eq!(page.act(json!({ "do": "takeLease", "force": false })), None);
    page.until("the lease", |page| page.shown["lease"]["client"] == page.who["client"]);
    page.lease = page.shown["lease"]["number"].as_u64().unwrap();
    let press = key(&page, 7, true);
    assert_eq!(page.act(press).as_deref(), Some("disarmed"));
    page.act(json!({ "do": "stop" }));
    page.until_state("idle");
}

#[test]
fn sbp_val_vd_remote__another_program_is_the_pendant() {
    let shop = shop(1.0, &[("keypad.sbp", "VD,,,,,,,,,2\nSK\nZX\n")]);
    let mut page = shop.driver();
    page.open_file("keypad.sbp");
    assert_eq!(page.run(), None);
    let number = page.asked("keypad");
    let mut pendant = shop.driver();
    pendant.asked("keypad");
    jog_in_question(&mut pendant, 1, [0.0, 1.0, 0.0, 0.0, 0.0, 0.0], "asking");
    let begin = start(&pendant, 2);
    assert_eq!(pendant.act(begin), None);
    page.until("the way along X", |page| page.x() > 1.0);
    page.until_state("asking");
    let late = start(&page, 1);
    assert_eq!(page.act(late).as_deref(), Some("lease"), "one hand at a time");
    assert!(page.x() < 60.0, "nobody renewed it: {}", page.x());
    let close = json!({ "do": "answer", "question": number, "answer": "OK" });
    assert_eq!(pendant.act(close), None);
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "ok");
}

#[test]
fn a_jog_ends_by_the_age_of_its_signs_however_late_they_come() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    let mut stale = start(&page, 1);
    std::thread::sleep(Duration::from_millis(300));
    assert_eq!(page.act(stale.clone()).as_deref(), Some("late"), "a start that was under way long");
    assert_eq!(page.shown["machine"]["state"], "idle");
    // Ahead by less than is believed: set back by what it was ahead.
    stale["clockMs"] = json!(page.clock_ms() + 10_000.0);
    stale["seq"] = json!(2);
    assert_eq!(page.act(stale).as_deref(), Some("late"), "a clock that is far ahead");
    let begin = start(&page, 3);
    assert_eq!(page.act(begin), None);
    let (old, since) = (renew(&page, 3), Instant::now());
    // A burst of signs of one moment is no hand that holds on.
    while page.shown["machine"]["state"] == "jogging" {
        page.send(old.clone());
        page.read();
        assert!(since.elapsed() < Duration::from_secs(3), "old signs keep it going");
    }
}

#[test]
fn no_number_of_a_jog_uses_the_others_up() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    for seq in [u64::from(u32::MAX), u64::MAX] {
        let mut far = start(&page, 1);
        far["seq"] = json!(seq);
        assert_eq!(page.act(far).as_deref(), Some("malformed"), "{seq}");
        page.act(json!({ "do": "jogStop", "seq": seq }));
    }
    let begin = start(&page, 1);
    assert_eq!(page.act(begin), None);
    page.until_state("idle");
}
