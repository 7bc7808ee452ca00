//! The hand console: keys of a page, and what its screen shows of the simulated machine.

use crate::support;
use crate::support::hand::{Hand, sample, shop, with_sample};
use crate::support::{Page, at, rsm};
use kerf_handconsole::functions::FUNCTIONS;
use kerf_program::{Axis, AxisSet};
use serde_json::json;

/// Tells whether the machine is at a place, near enough for people.
fn near(page: &Page, place: [f64; 3]) -> bool {
    at(page).iter().zip(place).all(|(a, b)| (a - b).abs() < 1e-6)
}

#[test]
fn pro_console_idle() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    hand.shows("JOB: Untitled", "0x0mm #0");
    shop.write("SAMPLE.RSM", sample().as_bytes());
    hand.open_file("SAMPLE.RSM");
    hand.shows("JOB: SAMPLE.RSM", "720x360mm #16");
}

#[test]
fn pro_console_func() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    hand.keys("U");
    hand.shows("Enter function:", "0 Cut speed");
    hand.keys("1");
    hand.shows("Enter function:", "1 Plunge speed");
    hand.keys("5P");
    hand.shows("Enter function:", "1 Plunge speed");
    hand.keys("U");
    hand.shows("JOB: Untitled", "0x0mm #0");
}

#[test]
fn pro_console_func_unknown() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    hand.keys("U9E");
    hand.shows("Enter function:", "9 ?");
    assert_eq!(hand.beeps(), 1);
    hand.keys("P4");
    hand.shows("Enter function:", "4 Move to origin");
}

#[test]
fn a_function_moves_the_machine() {
    let (_shop, mut hand) = with_sample(|_| {});
    hand.act(json!({ "do": "choose", "choice": { "origin": [300, 200] } }));
    hand.until("the preview", |page| page.shown["opened"]["preview"]["state"] == "ready");
    hand.keys("U4E");
    hand.shows("Move to origin", "");
    hand.until("the origin", |page| near(page, [300.0, 200.0, 0.0]));
    hand.shows("JOB: SAMPLE.RSM", "720x360mm #16");
}

#[test]
fn pro_console_idle_jog() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    let ways = [
        ('6', [1, 0, 0]),
        ('8', [0, 1, 0]),
        ('4', [-1, 0, 0]),
        ('2', [0, -1, 0]),
        ('9', [1, 1, 0]),
        ('1', [-1, -1, 0]),
        ('6', [1, 0, 0]),
        ('7', [-1, 1, 0]),
        ('3', [1, -1, 0]),
        ('0', [0, 0, -1]),
        ('5', [0, 0, 1]),
    ];
    for (key, way) in ways {
        let before = at(&hand);
        let went = |page: &Page| {
            let ways = at(page).into_iter().zip(before).map(|(now, then)| now - then);
            ways.zip(way).all(|(went, way)| match way {
                0 => went.abs() < 1e-9,
                way => went * f64::from(way) > 1.0,
            })
        };
        hand.holds(key, &format!("{key}: {way:?} from {before:?}"), went);
    }
}

#[test]
fn pro_console_idle_enter() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    hand.keys("S");
    hand.until("a refusal", |page| page.shown["handConsole"]["beeps"] == 1);
    assert_ne!(hand.shown["handConsole"]["lines"][0], "JOB: Untitled");
    hand.keys("E");
    hand.shows("JOB: Untitled", "0x0mm #0");
}

#[test]
fn pro_console_file() {
    let shop = shop(|_| {});
    for name in ["B.RSM", "A.RSM", "x.rsg"] {
        shop.write(name, sample().as_bytes());
    }
    let mut hand = Hand::of(&shop);
    hand.keys("F");
    hand.shows("Select File (2):", "A.RSM");
    hand.keys("2");
    hand.shows("Select File (2):", "B.RSM");
}

#[test]
fn pro_console_file_open() {
    let shop = shop(|_| {});
    shop.write("A.RSM", sample().as_bytes());
    shop.write("B.RSM", rsm("rect 0,0 90,60").as_bytes());
    let mut hand = Hand::of(&shop);
    for leaves in ["F", "U"] {
        hand.keys("F2");
        hand.shows("Select File (2):", "B.RSM");
        hand.keys(leaves);
        hand.shows("JOB: Untitled", "0x0mm #0");
    }
    hand.keys("F2E");
    hand.shows("JOB: B.RSM", "90x60mm #1");
    hand.keys("FU");
    hand.shows("JOB: B.RSM", "90x60mm #1");
}

#[test]
fn pro_console_file_dir() {
    let shop = shop(|_| {});
    shop.write("A.RSM", sample().as_bytes());
    std::fs::create_dir(shop.part("doors")).unwrap();
    shop.write("doors/D.RSM", rsm("rect 0,0 90,60").as_bytes());
    let mut hand = Hand::of(&shop);
    // No key leads out of the folder.
    hand.keys("F0123456789-SP");
    hand.shows("Select File (1):", "A.RSM");
    hand.keys("F");
    hand.open_file("doors/D.RSM");
    hand.keys("F");
    hand.shows("Select File (1):", "D.RSM");
    hand.keys("E");
    hand.shows("JOB: D.RSM", "90x60mm #1");
    // A folder that is chosen at a page is the current one, too.
    assert_eq!(hand.act(json!({ "do": "folder", "name": "doors", "mask": null })), None);
    hand.until("the folder", |page| page.shown["folder"]["name"] == "doors");
    hand.until_state("idle");
    // The console looks at the folder some 30 times a second: a key waits for that.
    hand.keys("F");
    hand.shows("Select File (1):", "D.RSM");
    hand.keys("F");
    assert_eq!(hand.act(json!({ "do": "folder", "name": "", "mask": null })), None);
    hand.until("the folder", |page| page.shown["folder"]["name"] == "");
    hand.until_state("idle");
    hand.keys("F");
    hand.shows("Select File (1):", "A.RSM");
}

/// The first Start was pressed: the job waits for the second.
fn started(change: fn(&mut kerf_machine::Configuration)) -> (support::Shop, Hand) {
    let (shop, mut hand) = with_sample(change);
    hand.keys("S");
    hand.shows("Start job", "Shape 1 of 16");
    (shop, hand)
}

const TWICE: fn(&mut kerf_machine::Configuration) = |machine| machine.misc.double_start = true;

/// Start of a shape of the sample, at Z top.
fn over(shape: u32) -> [f64; 3] {
    let (column, row) = ((shape - 1) % 4, (shape - 1) / 4);
    [f64::from(column) * 225.0, f64::from(row) * 105.0, -10.0]
}

#[test]
fn pro_console_start() {
    let (_shop, hand) = started(|machine| {
        machine.misc.double_start = true;
        machine.homing.at_job_start = AxisSet::EMPTY.with(Axis::Z);
    });
    let said = hand.shown["messages"].to_string();
    assert!(said.contains("z homed") && !said.contains("x homed"), "{said}");
    assert_eq!(hand.shown["motion"]["line"], 0, "nothing is cut yet");
}

#[test]
fn pro_console_start_file() {
    let (_shop, mut hand) = started(TWICE);
    let before = (at(&hand), hand.shown["machine"].clone(), hand.shown["asked"].clone());
    hand.keys("F");
    // A key behind it has been heard, so this one was.
    hand.keys("1");
    hand.shows("Start job", "Shape 1");
    hand.keys("P");
    hand.shows("Start job", "Shape 1 of 16");
    let after = (at(&hand), hand.shown["machine"].clone(), hand.shown["asked"].clone());
    assert_eq!(after, before);
}

#[test]
fn pro_console_start_start() {
    let shop = shop(TWICE);
    shop.write(
        "five.rsm",
        rsm("line 0,10 90,10; line 0,20 90,20; line 0,30 90,30; line 0,40 90,40").as_bytes(),
    );
    let mut hand = Hand::of(&shop);
    hand.open_file("five.rsm");
    hand.keys("S");
    hand.shows("Start job", "Shape 1 of 4");
    hand.keys("3E");
    hand.shows("Start job", "Shape 3 of 4");
    hand.keys("S");
    let mut cut = Vec::new();
    while hand.shown["job"]["ended"].is_null() {
        hand.read();
        let motion = &hand.shown["motion"];
        if motion["cutting"] == true && cut.last() != Some(&motion["line"]) {
            cut.push(motion["line"].clone());
        }
    }
    assert_eq!(cut, [3, 4]);
    hand.shows("JOB: five.rsm", "90x30mm #4");
}

#[test]
fn pro_console_start_stop() {
    let (_shop, mut hand) = started(TWICE);
    hand.keys("12P");
    hand.shows("Start job", "Shape 1");
    hand.keys("P");
    hand.shows("Start job", "Shape 1 of 16");
    hand.keys("PP4");
    hand.shows("Start job", "Shape 4");
    assert_eq!(hand.shown["machine"]["state"], "asking", "nothing was stopped");
}

#[test]
fn pro_console_start_digits() {
    let (_shop, mut hand) = started(TWICE);
    hand.keys("12");
    hand.shows("Start job", "Shape 12");
    hand.keys("E");
    hand.until("shape 12", |page| near(page, over(12)));
    hand.shows("Start job", "Shape 12 of 16");
    hand.keys("S");
    hand.until("a cut", |page| page.shown["motion"]["cutting"] == true);
    assert_eq!(hand.shown["motion"]["line"], 12);
}

#[test]
fn pro_console_start_pm() {
    let (_shop, mut hand) = started(TWICE);
    let home = at(&hand);
    hand.keys("-1");
    hand.shows("Start job", "Shape 1");
    assert_eq!(at(&hand), home, "there is none before the first");
    hand.keys("P3E");
    hand.until("shape 3", |page| near(page, over(3)));
    hand.shows("Start job", "Shape 3 of 16");
    hand.keys("-");
    hand.until("shape 2", |page| near(page, over(2)));
    hand.shows("Start job", "Shape 2 of 16");
}

#[test]
fn pro_console_start_enter() {
    let (_shop, mut hand) = started(TWICE);
    hand.keys("7E");
    hand.until("shape 7", |page| near(page, over(7)));
    hand.shows("Start job", "Shape 7 of 16");
    hand.keys("E");
    hand.until("shape 8", |page| near(page, over(8)));
    hand.shows("Start job", "Shape 8 of 16");
    hand.keys("99E");
    hand.shows("1-16", "");
    assert_eq!(hand.beeps(), 1);
    hand.keys("E");
    hand.shows("Start job", "Shape 8 of 16");
    assert!(near(&hand, over(8)));
}

#[test]
fn pro_console_start_func() {
    let (_shop, mut hand) = with_sample(TWICE);
    hand.act(json!({ "do": "choose", "choice": { "origin": [100, 50] } }));
    hand.until("the preview", |page| page.shown["opened"]["preview"]["state"] == "ready");
    hand.keys("S");
    hand.shows("Start job", "Shape 1 of 16");
    hand.keys("2E");
    hand.shows("Start job", "Shape 2 of 16");
    hand.keys("U");
    hand.shows("Abort? Enter=yes", "");
    hand.keys("4");
    hand.shows("Start job", "Shape 2 of 16");
    hand.keys("UE");
    hand.until("the origin", |page| near(page, [100.0, 50.0, -10.0]));
    hand.until_state("idle");
    assert_eq!(hand.shown["job"]["ended"], "ok", "the move to the origin");
    hand.shows("JOB: SAMPLE.RSM", "720x360mm #16");
}

#[test]
fn pro_console_stop__a_job() {
    let (_shop, mut hand) = with_sample(|_| {});
    hand.keys("P");
    hand.keys("S");
    hand.until("a cut", |page| page.shown["motion"]["cutting"] == true);
    hand.shows("Running", "Shape 1 of 16");
    hand.keys("P");
    hand.until_state("stopped");
    hand.shows("Paused", "Shape 1 of 16");
    // Stop again changes nothing: only Func gives a job up.
    hand.keys("P");
    hand.keys("S");
    hand.until("a cut", |page| page.shown["motion"]["cutting"] == true);
    hand.keys("P");
    hand.until_state("stopped");
    hand.keys("UE");
    hand.until("the origin", |page| near(page, [0.0, 0.0, -10.0]));
    hand.shows("JOB: SAMPLE.RSM", "720x360mm #16");
}

#[test]
fn keys_of_somebody_who_does_not_drive_are_refused_but_for_stop() {
    let (shop, mut hand) = with_sample(|_| {});
    let mut other = shop.page();
    let act = |key: &str| json!({ "do": "key", "lease": 0, "seq": 1, "key": key });
    assert_eq!(other.act(act("8")).as_deref(), Some("lease"));
    assert_eq!(other.act(act("x")).as_deref(), Some("lease"));
    let wrong = json!({ "do": "key", "lease": hand.lease, "seq": 1, "key": "x" });
    assert_eq!(hand.act(wrong).as_deref(), Some("malformed"));
    hand.keys("S");
    hand.until("a cut", |page| page.shown["motion"]["cutting"] == true);
    // Stop is one whatever the page says of its clock.
    let mut stop = act("P");
    stop["clockMs"] = json!(1e12);
    assert_eq!(other.act(stop), None);
    hand.until_state("stopped");
}

#[test]
fn a_disarmed_machine_is_taken_with_enter() {
    let (_shop, mut hand) = with_sample(|_| {});
    assert_eq!(hand.act(json!({ "do": "disarm" })), None);
    hand.keys("U4E");
    hand.shows("Disarmed", "Enter takes control");
    hand.keys("E");
    hand.until("arms", |page| page.shown["machine"]["armed"] == true);
    hand.shows("JOB: SAMPLE.RSM", "720x360mm #16");
}

#[test]
fn pro_console_subset() {
    let (_shop, mut hand) = with_sample(|_| {});
    for op in ["rect 0,0 90,60", "line 0,0 10,10"] {
        let drawn = json!({ "do": "draw", "op": { "op": "do", "clauses": op } });
        assert_eq!(hand.act(drawn), None);
    }
    let drawing = hand.shown["drawing"].clone();
    assert!(!drawing.is_null());
    hand.keys("-E");
    for function in FUNCTIONS.iter().filter(|function| function.name != "Digitize") {
        hand.keys(&format!("U{}E", function.number.replace('.', "F")));
        hand.settles();
        // Whatever it asks or says is left.
        while hand.shown["handConsole"]["lines"][0] != "JOB: SAMPLE.RSM" {
            hand.keys("U");
            hand.settles();
        }
    }
    assert_eq!(hand.shown["drawing"], drawing, "shapes, groups, selection");
}

#[test]
fn a_key_pressed_while_the_tool_slows_down_moves_it_as_soon_as_it_stands() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    hand.press('6');
    hand.until("a move", |page| at(page)[0] > 1.0);
    let before = hand.seq;
    hand.act(json!({ "do": "jogStop", "seq": before }));
    hand.holds('8', "the next move", |page| at(page)[1] > 1.0);
    assert_eq!(hand.beeps(), 0, "nothing was refused");
}
