//! A machine on a controller: what is done at its own controls is told to pages.

use crate::support::{Page, Shop, Wanted, start};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_program::Axes;
use serde_json::{Value, json};
use std::sync::{Arc, Mutex};

/// A long cut on a controller of which somebody is at the controls.
fn cutting() -> (Shop, Arc<Mutex<Fake>>, Page) {
    let mut fake = Fake::default();
    fake.offsets.systems[0] = Axes::xyz(10.0, 20.0, -5.0);
    let fake = Arc::new(Mutex::new(fake));
    let files = vec![("long.sbp", "MS,1\nMX,30\n")];
    let shop = start(Wanted { files, controller: Some(fake.clone()), ..Wanted::default() });
    let mut page = shop.driver();
    page.open_file("long.sbp");
    assert_eq!(page.run(), None);
    page.until("it moves", |_| fake.lock().unwrap().position().0[0] > 2.0);
    (shop, fake, page)
}

/// A zigzag that is open, on a controller whose axes gain so much speed.
fn zigzag(accel_mm_s2: f64) -> (Shop, Arc<Mutex<Fake>>, Page) {
    let fake = Fake::new(&[(120, accel_mm_s2), (121, accel_mm_s2)]);
    let fake = Arc::new(Mutex::new(fake));
    let files = vec![(
        "zigzag.sbp",
        "MS,3\nSR\n&n = 0\nagain:\nM2,0.2,0.2\nM2,0.2,-0.2\n&n = &n + 1\nIF &n < 20 THEN GOTO again\nSA\n",
    )];
    let shop = start(Wanted { files, controller: Some(fake.clone()), ..Wanted::default() });
    let mut page = shop.driver();
    page.open_file("zigzag.sbp");
    (shop, fake, page)
}

/// Seconds that its preview tells.
fn told_s(shop: &Shop, page: &Page) -> f64 {
    let preview = &page.shown["opened"]["preview"];
    let key = preview["key"].as_str().unwrap_or_else(|| panic!("{preview}"));
    shop.get(&format!("/api/preview/{key}")).json()["seconds"].as_f64().unwrap()
}

#[test]
fn the_time_of_a_file_is_that_of_the_controller_with_its_settings() {
    let told_s = |accel_mm_s2| {
        let (shop, _fake, page) = zigzag(accel_mm_s2);
        told_s(&shop, &page)
    };
    let (usual, slow) = (told_s(400.0), told_s(100.0));

    // Legs that never come to their speed take as long as the root of the acceleration says.
    assert!((slow / usual - 2.0).abs() < 0.02, "{slow} s and {usual} s");
}

#[test]
fn the_time_of_a_file_follows_settings_that_are_written_while_the_controller_is_attached() {
    let (shop, fake, mut page) = zigzag(400.0);
    let before = told_s(&shop, &page);
    for line in ["$120=100", "$121=100"] {
        page.command(line);
    }
    assert_eq!(fake.lock().unwrap().is_set_to(121), 100.0);
    page.until("the time is another", |page| {
        let seconds = page.shown["opened"]["seconds"].as_f64().unwrap_or(0.0);
        (seconds / before - 2.0).abs() < 0.02
    });
    // A run that is begun now is told by the same time.
    assert_eq!(page.run(), None);
    page.until("it runs", |page| !page.shown["job"].is_null());
    let seconds = page.shown["job"]["seconds"].as_f64().unwrap();
    assert!((seconds / before - 2.0).abs() < 0.02, "{seconds} s and {before} s");
}

#[test]
fn a_finished_run_shows_how_much_longer_motion_takes_and_that_is_forgotten_by_a_page() {
    let (_shop, _fake, mut page) = zigzag(400.0);
    assert!(page.shown["machine"]["pace"].is_null());
    assert_eq!(page.run(), None);
    page.until("the run has shown something", |page| page.shown["machine"]["pace"]["runs"] == 1);
    let factor = page.shown["machine"]["pace"]["factor"].as_f64().unwrap();
    assert!((factor - 1.0).abs() < 0.051, "{factor}");
    page.until_state("idle");
    let forget = json!({ "do": "forgetPace", "lease": page.lease });
    assert_eq!(page.act(forget), None);
    page.until("it is forgotten", |page| page.shown["machine"]["pace"].is_null());
}

#[test]
fn a_setting_that_a_controller_does_not_take_is_told_and_nothing_else_happens() {
    let (_shop, fake, mut page) = zigzag(400.0);
    page.command("$120=fast");
    page.until("it is told", |page| {
        page.shown["messages"].to_string().contains("$120 is a number, and 'fast' is none")
    });
    page.command("$120=300");
    assert_eq!(page.shown["machine"]["state"], "idle");
    assert_eq!(fake.lock().unwrap().is_set_to(120), 300.0);
}

#[test]
fn what_a_machine_waits_for_at_its_own_controls_is_told_to_pages() {
    let (_shop, fake, mut page) = cutting();
    let hold = |byte: &[u8]| fake.lock().unwrap().hear(byte, 0.0);
    let says = |page: &Page, words: &str| {
        page.shown["machine"]["why"].as_str().unwrap_or("").contains(words)
    };
    assert!(page.shown["machine"]["why"].is_null());
    hold(b"!");
    page.until("the hold is told", |page| says(page, "it is held: its own button"));
    assert_eq!(page.shown["machine"]["state"], "running");
    hold(b"~");
    page.until("it goes on", |page| page.shown["machine"]["why"].is_null());
    fake.lock().unwrap().pins("D");
    page.until("the door is told", |page| says(page, "its door is open"));
    fake.lock().unwrap().pins("");
    page.until("the door is closed", |page| says(page, "its door was open"));
    fake.lock().unwrap().cycle_start();
    page.until("it goes on", |page| page.shown["machine"]["why"].is_null());
}

#[test]
fn overrides_that_somebody_turns_at_a_controller_are_shown() {
    let (_shop, fake, mut page) = cutting();
    // A pendant: feed 20 % less, rapids 50 %, spindle 10 % more.
    fake.lock().unwrap().hear(&[0x92, 0x92, 0x96, 0x9A], 0.0);
    let turned = |page: &Page, what: &str, percent: f64| {
        page.shown["overrides"][what].as_f64() == Some(percent)
    };
    page.until("the feed is told", |page| turned(page, "feedPercent", 80.0));
    page.until("rapids are told", |page| turned(page, "rapidPercent", 50.0));
    page.until("the spindle is told", |page| turned(page, "spindlePercent", 110.0));
    let Fake { override_percent, rapid_percent, spindle_percent, .. } = *fake.lock().unwrap();
    let holds = [override_percent, rapid_percent, spindle_percent];
    assert_eq!(holds, [80, 50, 110], "it is not turned back");
}

#[test]
fn zero_points_of_a_controller_are_shown_and_seen_to_change() {
    let fake = Arc::new(Mutex::new(Fake::default()));
    fake.lock().unwrap().offsets.systems[0] = Axes::xyz(10.0, 20.0, -5.0);
    let shop = start(Wanted { controller: Some(fake.clone()), ..Wanted::default() });
    let mut page = shop.page();
    let x = |page: &Page, name: &str| {
        let zeros = page.shown["zeros"].as_array().cloned().unwrap_or_default();
        zeros.iter().find(|zero| zero["name"] == name).and_then(|zero| zero["at"][0].as_f64())
    };
    page.until("it is told", |page| x(page, "G54") == Some(10.0));
    assert_eq!(x(&page, "G59.3"), Some(0.0));
    // Somebody at a pendant.
    fake.lock().unwrap().hear(b"G10L2P1X33Y0Z0\n", 0.0);
    page.until("it is seen", |page| x(page, "G54") == Some(33.0));
}

#[test]
fn zero_points_of_a_controller_are_written_from_a_page_and_the_working_zero_follows_the_one_that_holds()
 {
    let fake = Arc::new(Mutex::new(Fake::default()));
    fake.lock().unwrap().offsets.systems[1] = Axes::xyz(10.0, 20.0, -5.0);
    let shop = start(Wanted { controller: Some(fake.clone()), ..Wanted::default() });
    let mut page = shop.driver();
    page.until("it is told", |page| {
        page.shown["zeros"].as_array().is_some_and(|it| !it.is_empty())
    });
    let zero = |page: &mut Page, name: &str, change: Value| {
        let act = json!({ "do": "zero", "lease": page.lease, "name": name, "change": change });
        let refused = page.act(act);
        page.until_state("idle");
        refused
    };
    let reads = |page: &Page, place: [f64; 3]| {
        let axes = page.shown["motion"]["at"]["working"].as_array().unwrap().iter().zip(place);
        axes.into_iter().all(|(mm, reads)| (mm.as_f64().unwrap() - reads).abs() < 0.001)
    };
    page.command("MX,2");
    let values = json!([5.0, null, -1.0, null, null, null]);
    assert_eq!(zero(&mut page, "G54", json!({ "to": "reads", "values": values })), None);
    page.until("it follows", |page| reads(page, [5.0, 0.0, -1.0]));
    assert_eq!(fake.lock().unwrap().offsets.systems[0], Axes::xyz(45.8, 0.0, 1.0));
    let y = json!([null, 21.5, null, null, null, null]);
    assert_eq!(zero(&mut page, "G55", json!({ "to": "lies", "at": y })), None);
    assert!(reads(&page, [5.0, 0.0, -1.0]), "another one than holds");
    assert_eq!(zero(&mut page, "G55", json!({ "to": "holds" })), None);
    page.until("it follows", |page| reads(page, [40.8, -21.5, 5.0]));
    assert_eq!(fake.lock().unwrap().offsets.chosen, 1);
    page.until("it is told", |page| {
        page.shown["zeros"][1]["holds"] == true && page.shown["zeros"][1]["at"][1] == 21.5
    });
    fake.lock().unwrap().hear(b"G92X0\n", 0.0);
    page.until("it is seen", |page| page.shown["zeros"][9]["at"][0] != 0.0);
    assert!(reads(&page, [40.8, -21.5, 5.0]), "nobody took it");
    assert_eq!(zero(&mut page, "G92", json!({ "to": "gone" })), None);
    page.until("it is gone", |page| page.shown["zeros"][9]["at"][0] == 0.0);
    assert_eq!(zero(&mut page, "G28", json!({ "to": "holds" })).as_deref(), Some("malformed"));
}

#[test]
fn a_machine_that_keeps_no_zero_points_says_so() {
    let shop = start(Wanted::default());
    let mut page = shop.driver();
    let act =
        json!({ "do": "zero", "lease": page.lease, "name": "G54", "change": { "to": "holds" } });
    let asked = page.send(act);
    let refused = page.problem(asked);
    assert!(refused.contains("this machine keeps no zero points of its own"), "{refused}");
}

#[test]
fn stop_ends_a_file_that_a_controller_runs_from_its_own_card() {
    let board = Board::hal_with_card(&[("long.nc", "G21\nM3 S9000\nG1 X300 F900\nG1 X0\n")]);
    let fake = Arc::new(Mutex::new(Fake::of(board, &[])));
    let files = vec![("short.sbp", "MX,1\n")];
    let shop = start(Wanted { files, controller: Some(fake.clone()), ..Wanted::default() });
    let mut page = shop.driver();
    page.open_file("short.sbp");
    assert!(fake.lock().unwrap().runs_from_card("long.nc"), "somebody at its panel begins it");
    page.until("it is told", |page| page.shown["job"]["fromCard"] == true);
    page.until("it moves", |_| fake.lock().unwrap().position().0[0] > 2.0);
    assert_eq!(page.run(), Some("state".into()), "nothing begins beside it");

    assert_eq!(page.act(json!({ "do": "stop" })), None);
    page.until("it is over", |page| page.shown["job"]["ended"] == "stopped");
    let at = || {
        let fake = fake.lock().unwrap();
        (fake.spindle(), fake.position())
    };
    let stood = at();
    std::thread::sleep(std::time::Duration::from_millis(300));
    assert_eq!((stood.0, at()), (None, stood), "it has stood since then");
}
