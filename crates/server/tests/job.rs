//! A job from its preview to its end, with questions, holds and stops, seen by several pages.

use crate::support::shop;
use serde_json::json;

const SQUARE: &str = "MS,1,1\nM3,0,0,-.1\nMX,2\nMY,2\nMX,0\nMY,0\nJZ,.5\n";

#[test]
fn a_file_is_opened_previewed_and_cut() {
    let shop = shop(20.0, &[("square.sbp", SQUARE)]);
    let mut page = shop.driver();
    page.open_file("square.sbp");
    let opened = page.shown["opened"].clone();
    assert!(opened["seconds"].as_f64().unwrap() > 8.0);
    assert_eq!(opened["lines"], 7);
    let key = opened["preview"]["key"].as_str().unwrap().to_owned();
    let info = shop.get(&format!("/api/preview/{key}")).json();
    assert_eq!(info["moves"], 6);
    assert_eq!(info["details"][0]["pieces"], 1);
    let piece = shop.get(&format!("/api/preview/{key}/0/0")).body;
    assert_eq!(u32::from_le_bytes(piece[..4].try_into().unwrap()), 6);
    assert_eq!(shop.get(&format!("/api/preview/{key}/0/1")).status, 404);
    assert_eq!(shop.get(&format!("/api/preview/{key}/9/0")).status, 404);

    assert_eq!(page.run(), None);
    page.until("cutting", |page| page.shown["motion"]["cutting"] == true);
    page.until("halfway", |page| page.shown["motion"]["progress"].as_f64().unwrap() > 0.5);
    assert!(page.shown["motion"]["line"].as_u64().unwrap() >= 3);
    page.until_state("idle");
    let job = &page.shown["job"];
    assert_eq!((&job["ended"], &job["file"]), (&json!("ok"), &json!("square.sbp")));
    assert!((page.shown["motion"]["at"]["working"][2].as_f64().unwrap() - 12.7).abs() < 1e-9);
}

const TALK: &str = "PRINT \"begin\"\nINPUT \"how far\" &x\nMSGBOX(\"go on?\",YESNO,\"Part\")\n\
                    PAUSE\nMX,&x\nPRINT \"end \";&x\n";

#[test]
fn questions_belong_to_the_job_and_are_on_any_page() {
    let shop = shop(20.0, &[("talk.sbp", TALK)]);
    let (mut page, mut other) = (shop.driver(), shop.page());
    page.open_file("talk.sbp");
    assert_eq!(page.run(), None);
    let number = other.asked("input");
    assert_eq!(other.shown["asked"]["file"], "talk.sbp");
    assert_eq!(other.shown["asked"]["line"], 2);
    // A page that comes later, or is loaded again, sees the same.
    assert_eq!(shop.page().shown["asked"], other.shown["asked"]);
    let answer =
        |number: u64, word: &str| json!({ "do": "answer", "question": number, "answer": word });
    assert_eq!(other.act(answer(number + 1, "3")).as_deref(), Some("late"));
    assert_eq!(other.act(answer(number, "3")), None);
    let number = page.asked("msgbox");
    assert_eq!(page.act(answer(number, "perhaps")).as_deref(), Some("mistake"));
    assert_eq!(page.act(answer(number, "yes")), None);
    let number = other.asked("pause");
    assert_eq!(page.act(answer(number - 1, "OK")).as_deref(), Some("late"), "an old one");
    // A value is anybody's; the machine goes on for whoever drives it.
    assert_eq!(other.act(answer(number, "OK")).as_deref(), Some("lease"));
    assert_eq!(page.act(answer(number, "OK")), None);
    page.until_state("idle");
    assert_eq!(page.shown["printed"], json!(["begin", "end 3"]));
    assert!((page.x() - 3.0 * 25.4).abs() < 1e-6);
}

#[test]
fn a_stop_ramps_down_and_asks_and_the_job_goes_on_or_not() {
    let shop = shop(10.0, &[("square.sbp", SQUARE)]);
    let (mut page, mut other) = (shop.driver(), shop.page());
    page.open_file("square.sbp");
    assert_eq!(page.run(), None);
    page.until("cutting", |page| page.shown["motion"]["cutting"] == true);
    assert_eq!(other.act(json!({ "do": "stop" })), None);
    page.until_state("stopped");
    page.asked("hold");
    assert_eq!(page.shown["motion"]["speedMmS"], 0.0);
    assert_eq!(page.act(json!({ "do": "resume", "lease": page.lease })), None);
    page.until_state("running");
    page.until("cutting", |page| page.shown["motion"]["cutting"] == true);
    other.act(json!({ "do": "stop" }));
    page.until_state("stopped");
    // Stopped once more: it is over.
    other.act(json!({ "do": "stop" }));
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "stopped");
}

#[test]
fn a_hold_stands_until_it_is_resumed_and_nothing_resumes_by_itself() {
    let shop = shop(10.0, &[("square.sbp", SQUARE)]);
    let (mut page, mut other) = (shop.driver(), shop.page());
    page.open_file("square.sbp");
    assert_eq!(page.run(), None);
    page.until("cutting", |page| page.shown["motion"]["cutting"] == true);
    other.act(json!({ "do": "hold" }));
    page.until_state("held");
    let stood = page.shown["motion"]["at"].clone();
    assert_eq!(page.shown["motion"]["speedMmS"], 0.0);
    drop(other);
    std::thread::sleep(std::time::Duration::from_millis(300));
    while page.shown["clients"].as_array().unwrap().len() > 1 {
        page.read();
    }
    assert_eq!(
        (&page.shown["machine"]["state"], &page.shown["motion"]["at"]),
        (&json!("held"), &stood)
    );
    page.act(json!({ "do": "resume", "lease": page.lease }));
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "ok");
}

#[test]
fn a_lost_page_stops_no_job() {
    let shop = shop(10.0, &[("square.sbp", SQUARE)]);
    let (mut page, mut other) = (shop.driver(), shop.page());
    page.open_file("square.sbp");
    assert_eq!(page.run(), None);
    other.until("cutting", |page| page.shown["motion"]["cutting"] == true);
    drop(page);
    other.until("the end", |page| page.shown["job"]["ended"] == "ok");
}

#[test]
fn a_stop_while_a_question_is_open_ends_the_job() {
    let shop = shop(10.0, &[("talk.sbp", TALK)]);
    let mut page = shop.driver();
    page.open_file("talk.sbp");
    assert_eq!(page.run(), None);
    page.asked("input");
    page.act(json!({ "do": "stop" }));
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "stopped");
    assert!(page.shown["asked"].is_null());
    assert_eq!(page.x(), 0.0);
}

#[test]
fn a_program_that_never_ends_is_previewed_and_can_be_stopped() {
    let shop = shop(1.0, &[("loop.sbp", "&x = 0\nAGAIN:\n&x = &x + 1\nGOTO AGAIN\n")]);
    let mut page = shop.driver();
    page.open_file("loop.sbp");
    assert_eq!(page.run(), None);
    page.act(json!({ "do": "stop" }));
    page.until_state("stopped");
    page.act(json!({ "do": "stop" }));
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "stopped");
}

#[test]
fn overrides_change_how_long_it_takes() {
    let shop = shop(10.0, &[("long.sbp", "MS,1\nMX,10\n")]);
    let mut page = shop.driver();
    page.open_file("long.sbp");
    assert_eq!(page.run(), None);
    page.until("cutting", |page| page.shown["motion"]["cutting"] == true);
    assert_eq!(
        page.act(json!({ "do": "override", "lease": page.lease, "feedPercent": 200.0 })),
        None
    );
    page.until("twice the speed", |page| page.shown["motion"]["speedMmS"].as_f64().unwrap() > 45.0);
    assert_eq!(page.shown["overrides"]["feedPercent"], 200.0);
    assert_eq!(
        page.act(json!({ "do": "override", "lease": page.lease, "feedPercent": 1000.0 }))
            .as_deref(),
        Some("malformed")
    );
    page.until_state("idle");
}

#[test]
fn command_lines_move_the_machine_and_change_its_settings() {
    let shop = shop(20.0, &[]);
    let mut page = shop.driver();
    page.command("MX,1");
    assert!((page.x() - 25.4).abs() < 1e-9);
    page.command("ZX");
    assert_eq!(page.x(), 0.0);
    page.command("VS,3");
    assert_eq!(page.shown["speeds"]["cutMmS"][0], 3.0 * 25.4);
    page.command("SR");
    assert_eq!(page.shown["units"]["absolute"], false);
    let wrong = json!({ "do": "command", "lease": page.lease, "line": "QQ,1" });
    assert_eq!(page.act(wrong).as_deref(), Some("mistake"));
    page.command("SO,2,1");
    assert_eq!(page.shown["io"]["outputs"][1]["on"], true);
}

#[test]
fn one_thing_runs_at_a_time() {
    let shop = shop(5.0, &[("square.sbp", SQUARE)]);
    let mut page = shop.driver();
    page.open_file("square.sbp");
    assert_eq!(page.run(), None);
    assert_eq!(page.run().as_deref(), Some("state"));
    let more = json!({ "do": "command", "lease": page.lease, "line": "MX,1" });
    assert_eq!(page.act(more).as_deref(), Some("state"));
}

#[test]
fn a_limit_is_an_alarm_that_somebody_takes_note_of() {
    let shop = shop(20.0, &[]);
    let mut page = shop.driver();
    page.command("VL,0,10,0,10,,,,,1");
    page.act(json!({ "do": "command", "lease": page.lease, "line": "MX,30" }));
    let number = page.asked("limit");
    let answer = json!({ "do": "answer", "question": number, "answer": "End" });
    assert_eq!(page.act(answer), None);
    page.until_state("alarm");
    assert_eq!(page.shown["machine"]["armed"], false);
    assert_eq!(page.act(json!({ "do": "arm", "lease": page.lease })).as_deref(), Some("state"));
    page.act(json!({ "do": "acknowledge" }));
    page.until_state("idle");
    assert_eq!(page.act(json!({ "do": "arm", "lease": page.lease })), None);
}

#[test]
fn scripts_do_the_same_over_http() {
    let shop = shop(50.0, &[("square.sbp", SQUARE)]);
    let act = |name: &str, body| shop.post(&format!("/api/do/{name}"), body, &[]);
    assert_eq!(act("open", json!({ "name": "square.sbp" })).status, 200);
    let mut page = shop.page();
    page.until("the preview", |page| page.shown["opened"]["preview"]["state"] == "ready");
    let hash = page.shown["opened"]["hash"].clone();
    assert_eq!(act("run", json!({ "lease": 1, "hash": hash })).status, 403);
    assert_eq!(act("takeLease", json!({ "force": false })).status, 200);
    assert_eq!(act("arm", json!({ "lease": 1 })).status, 200);
    assert_eq!(act("run", json!({ "lease": 1, "hash": hash })).status, 200);
    page.until("the end", |page| page.shown["job"]["ended"] == "ok");
    assert_eq!(act("nonsense", json!({})).status, 400);
    assert_eq!(act("run", json!({ "hash": 1 })).status, 400);
    let described = shop.get("/api/openapi.json").json();
    assert_eq!(described["openapi"], "3.1.0");
    assert!(described["components"]["schemas"]["Snapshot"].is_object());
}

#[test]
fn the_machine_is_never_shown_where_it_was_before() {
    let shop = shop(2.0, &[("long.sbp", "MS,1\nMX,10\n")]);
    let mut page = shop.driver();
    page.open_file("long.sbp");
    assert_eq!(page.run(), None);
    page.until("cutting", |page| page.x() > 5.0);
    page.act(json!({ "do": "override", "lease": page.lease, "feedPercent": 150.0 }));
    let mut last = 0.0;
    let mut stopped = false;
    while page.shown["machine"]["state"] == "running" {
        // Two sums of the same way may differ in the last digit.
        assert!(page.x() >= last - 1e-9, "{} after {last}", page.x());
        last = page.x();
        if last > 80.0 && !stopped {
            stopped = true;
            page.send(json!({ "do": "stop" }));
        }
        page.read();
    }
    page.until_state("stopped");
    assert!(page.x() >= last && page.x() < 200.0, "{}", page.x());
}
