//! The card of a controller, worked by pages: listed, looked through, written, run, followed and stopped.

use crate::support::{Page, Shop, Wanted, start};
use kerf_driver_grbl::fake::{Board, Fake};
use serde_json::{Value, json};
use std::sync::{Arc, Mutex};

/// A file that takes half a minute.
const LONG: &str = "G21\nM3 S9000\nG1 X300 F900\nG1 X0\n";

/// A shop whose controller has these files on its card, and the page that drives it.
fn shop(on_card: &[(&str, &str)], files: Vec<(&'static str, &'static str)>) -> Carded {
    let fake = Arc::new(Mutex::new(Fake::of(Board::hal_with_card(on_card), &[])));
    Carded::of(fake, files)
}

struct Carded {
    shop: Shop,
    fake: Arc<Mutex<Fake>>,
    page: Page,
}

impl Carded {
    fn of(fake: Arc<Mutex<Fake>>, files: Vec<(&'static str, &'static str)>) -> Self {
        let shop = start(Wanted { files, controller: Some(fake.clone()), ..Wanted::default() });
        let mut page = shop.driver();
        page.until("the card is told", |page| page.shown["controllerCard"]["has"] == true);
        Self { shop, fake, page }
    }

    /// Asks for something; the reason where that is refused at once.
    fn ask(&mut self, task: Value) -> Option<String> {
        let lease = self.page.shown["lease"]["number"].clone();
        let id = self.page.send(json!({ "do": "controllerCard", "lease": lease, "task": task }));
        let refused = self.page.problem(id);
        (!refused.is_empty()).then_some(refused)
    }

    /// Asks, and waits until the task is over.
    fn does(&mut self, task: Value) {
        assert_eq!(self.ask(task), None);
        self.page.until("the task is over", |page| page.shown["controllerCard"]["task"].is_null());
    }

    fn card(&self) -> &Value {
        &self.page.shown["controllerCard"]
    }

    fn x(&self) -> f64 {
        self.fake.lock().unwrap().position().0[0]
    }

    /// Its spindle, and where it stands.
    fn stands(&self) -> (Option<f64>, [f64; 6]) {
        let fake = self.fake.lock().unwrap();
        (fake.spindle(), fake.position().0)
    }

    fn stands_for_good(&self) {
        let stood = self.stands();
        std::thread::sleep(std::time::Duration::from_millis(300));
        assert_eq!((stood.0, self.stands()), (None, stood), "it has stood since then");
    }
}

#[test]
fn a_file_of_the_card_is_listed_looked_through_run_held_and_stopped() {
    let mut carded = shop(&[("long.nc", LONG)], Vec::new());
    carded.does(json!({ "to": "list" }));
    assert_eq!(carded.card()["files"][0]["name"], "long.nc");
    assert_eq!(carded.card()["files"][0]["bytes"], LONG.len());
    let refused = carded.ask(json!({ "to": "run", "name": "long.nc" })).unwrap();
    assert!(refused.contains("was not looked through"), "{refused}");
    carded.does(json!({ "to": "look", "name": "long.nc" }));
    let seconds = carded.card()["files"][0]["looked"]["seconds"].as_f64().unwrap();
    assert!((40.0..46.0).contains(&seconds), "600 mm at 15 mm/s: {seconds}");

    assert_eq!(carded.ask(json!({ "to": "run", "name": "long.nc" })), None);
    let shows = |page: &Page, state: &str| page.shown["machine"]["state"] == state;
    carded.page.until("it is told", |page| page.shown["job"]["fromCard"] == true);
    assert_eq!(carded.page.shown["job"]["file"], "long.nc");
    carded.page.until("its place is told", |page| crate::support::at(page)[0] > 2.0);
    let left = carded.page.shown["motion"]["remaining"].as_f64().unwrap();
    // The controller has read all of so short a file at once: what is left is told by the time.
    let elapsed = carded.page.shown["motion"]["elapsed"].as_f64().unwrap();
    assert!((left - (seconds - elapsed)).abs() < 2.0, "{left} of {seconds}, {elapsed} over");
    assert_eq!(carded.page.act(json!({ "do": "hold" })), None);
    carded.page.until("it is held", |page| shows(page, "held"));
    let held = carded.stands().1[0];
    let lease = carded.page.shown["lease"]["number"].clone();
    assert_eq!(carded.page.act(json!({ "do": "resume", "lease": lease })), None);
    carded.page.until("it goes on", |page| shows(page, "running"));
    let fake = carded.fake.clone();
    carded.page.until("it moves", |_| fake.lock().unwrap().position().0[0] > held + 2.0);
    let turned = json!({ "do": "override", "lease": lease, "feedPercent": 50.0 });
    assert_eq!(carded.page.act(turned), None);
    carded.page.until("its feed is told", |page| page.shown["overrides"]["feedPercent"] == 50.0);

    assert_eq!(carded.page.act(json!({ "do": "stop" })), None);
    carded.page.until("it is over", |page| page.shown["job"]["ended"] == "stopped");
    carded.page.until_state("idle");
    carded.stands_for_good();
    let place = carded.x();
    carded
        .page
        .until("its place is told", |page| (crate::support::at(page)[0] - place).abs() < 0.01);
}

#[test]
fn a_file_of_the_card_runs_to_its_end() {
    let mut carded = shop(&[("short.nc", "G21\nG1 X4 F3000\nM30\n")], Vec::new());
    carded.does(json!({ "to": "list" }));
    let unseen = json!({ "to": "run", "name": "short.nc", "unseen": true });
    let refused = carded.ask(unseen).unwrap();
    assert!(refused.contains("was not looked through"), "its text can be read: {refused}");
    carded.does(json!({ "to": "look", "name": "short.nc" }));
    carded.does(json!({ "to": "run", "name": "short.nc" }));
    carded.page.until("it is over", |page| page.shown["job"]["ended"] == "ok");
    carded.page.until_state("idle");
    carded.page.until("its place is told", |page| (crate::support::at(page)[0] - 4.0).abs() < 0.01);
    carded.page.command("M2,1,0");
    carded.page.until_state("idle");
    assert_eq!(carded.x(), 25.4, "what is typed behind it is made from there");
}

#[test]
fn a_file_beyond_the_limits_is_not_put_on_the_card_and_the_reason_has_its_line() {
    let files = vec![("far.sbp", "SA\nMX,-1\nMX,-999\n"), ("box.sbp", "MS,2\nMX,-1\nMY,-1\n")];
    let limits = [(20, 1.0), (130, 400.0), (131, 400.0), (132, 400.0)];
    let fake = Fake::of(Board::hal_with_card(&[]), &limits);
    let mut carded = Carded::of(Arc::new(Mutex::new(fake)), files);
    carded.does(json!({ "to": "upload", "file": "far.sbp" }));
    let why = carded.card()["refused"][0].as_str().unwrap();
    assert!(why.starts_with("far.sbp:3: ") && why.contains("X would go to -25374.6"), "{why}");
    assert!(carded.fake.lock().unwrap().card().files.is_empty());

    carded.does(json!({ "to": "upload", "file": "box.sbp" }));
    assert_eq!(carded.card()["refused"], json!([]));
    let file = carded.card()["files"][0].clone();
    assert_eq!(file["name"], "box.nc");
    assert!(file["looked"]["seconds"].as_f64().unwrap() > 1.0, "{file}");
    carded.does(json!({ "to": "upload", "file": "box.sbp" }));
    assert_eq!(carded.card()["replaces"], "box.nc");
    carded.does(json!({ "to": "upload", "file": "box.sbp", "replaces": true }));
    assert_eq!(carded.card()["refused"], json!([]));

    carded.does(json!({ "to": "keep", "name": "box.nc" }));
    let kept = std::fs::read_to_string(carded.shop.part("box.nc")).unwrap();
    let there = carded.fake.lock().unwrap().card().files["box.nc"].clone();
    assert_eq!(kept.trim_end(), String::from_utf8(there).unwrap().trim_end());
    carded.does(json!({ "to": "keep", "name": "box.nc" }));
    assert_eq!(carded.card()["replaces"], "box.nc", "{}", carded.card());
    carded.does(json!({ "to": "delete", "name": "box.nc" }));
    assert_eq!(carded.card()["files"], json!([]));
}

/// G-code of so many lines, which the dry run passes over in a moment.
fn wide(lines: usize) -> String {
    format!("G21\n{}G1 X1 F900\nM30\n", format!("({})\n", "x".repeat(200)).repeat(lines))
}

#[test]
fn stop_and_cancel_are_heard_while_a_file_is_on_its_way() {
    for (act, why) in [("stop", "it was stopped"), ("cancel", "it was stopped")] {
        let mut carded = shop(&[], Vec::new());
        carded.shop.write("wide.nc", wide(10_000).as_bytes());
        assert_eq!(carded.ask(json!({ "to": "upload", "file": "wide.nc" })), None);
        let done = |page: &Page| page.shown["controllerCard"]["task"]["done"].as_u64();
        carded.page.until("it is on its way", |page| done(page).is_some_and(|done| done > 2000));
        match act {
            "stop" => assert_eq!(carded.page.act(json!({ "do": "stop" })), None),
            _ => assert_eq!(carded.ask(json!({ "to": "cancel" })), None),
        }
        let over = |page: &Page| page.shown["controllerCard"]["task"].is_null();
        carded.page.until("it is over", over);
        assert!(carded.card()["refused"].to_string().contains(why), "{}", carded.card());
        carded.page.until_state("idle");
        assert!(carded.fake.lock().unwrap().card().files.is_empty(), "half a file is none");
        carded.does(json!({ "to": "list" }));
        assert_eq!(carded.card()["refused"], json!([]), "it hears lines again");
    }
}

#[test]
fn a_file_of_the_card_goes_on_when_the_server_ends() {
    let mut carded = shop(&[("long.nc", LONG)], Vec::new());
    carded.does(json!({ "to": "list" }));
    carded.does(json!({ "to": "look", "name": "long.nc" }));
    assert_eq!(carded.ask(json!({ "to": "run", "name": "long.nc" })), None);
    let fake = carded.fake.clone();
    carded.page.until("it moves", |_| fake.lock().unwrap().position().0[0] > 2.0);
    carded.shop.server.wait(|| true);
    drop(carded);
    // Nobody speaks for it any more: its time passes by these looks.
    let mut fake = fake.lock().unwrap();
    drop(fake.speak(60.0));
    assert_eq!(fake.spindle(), Some(9000.0));
    assert!(fake.position().0[0].abs() < 0.01, "it has made all of it: {:?}", fake.position());
}

#[test]
fn a_file_that_is_wrong_everywhere_is_refused_in_a_few_lines() {
    let moves: String = (900..990).map(|x| format!("MX,-{x}\n")).collect();
    let limits = [(20, 1.0), (130, 400.0), (131, 400.0), (132, 400.0)];
    let fake = Arc::new(Mutex::new(Fake::of(Board::hal_with_card(&[]), &limits)));
    let mut carded = Carded::of(fake, Vec::new());
    carded.shop.write("far.sbp", moves.as_bytes());
    carded.does(json!({ "to": "upload", "file": "far.sbp" }));
    let refused = carded.card()["refused"].as_array().unwrap().clone();
    assert_eq!(refused.len(), 13, "{refused:?}");
    assert_eq!(refused[12], "78 more are wrong in the same file");
    let why = refused[0].as_str().unwrap();
    assert!(why.ends_with("; change the file, or where its zero lies"), "{why}");
}

#[test]
fn a_server_that_begins_while_a_file_runs_follows_it_and_stop_ends_it() {
    let fake = Arc::new(Mutex::new(Fake::of(Board::hal_with_card(&[("long.nc", LONG)]), &[])));
    assert!(fake.lock().unwrap().runs_from_card("long.nc"));
    let files = vec![("short.sbp", "MX,1\n")];
    let shop = start(Wanted { files, controller: Some(fake.clone()), ..Wanted::default() });
    let mut page = shop.driver();
    page.until("it is followed", |page| page.shown["job"]["fromCard"] == true);
    page.until("it moves", |_| fake.lock().unwrap().position().0[0] > 2.0);
    let file = page.shown["job"]["file"].clone();
    assert_eq!(file, "long.nc");
    assert_eq!(page.act(json!({ "do": "stop" })), None);
    page.until("it is over", |page| page.shown["job"]["ended"] == "stopped");
    page.until_state("idle");
    page.until("it is attached", |page| page.shown["controllerCard"]["has"] == true);
    let mut carded = Carded { shop, fake, page };
    carded.stands_for_good();
    carded.page.open_file("short.sbp");
    carded.page.drive();
    assert_eq!(carded.page.run(), None);
    carded.page.until("a run of Kerf ends well", |page| {
        page.shown["job"]["fromCard"] == false && page.shown["job"]["ended"] == "ok"
    });
}
