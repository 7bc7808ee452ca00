//! Jobs: tool paths of drawings, run by the server as the command line runs them.

use crate::support;
use crate::support::{Page, Shop, Wanted, at, rsm, start};
use kerf_drawing::{Editor, script};
use kerf_machine::Configuration;
use kerf_machine::settings::io::Card;
use serde_json::{Value, json};
use std::time::Instant;

/// Five lines above each other.
const FIVE: &str =
    "line 0,10 100,10; line 0,20 100,20; line 0,30 100,30; line 0,40 100,40; line 0,50 100,50";

/// SIM, in a hurry, with this job.
fn shop(clauses: &str, change: fn(&mut Configuration)) -> Shop {
    let shop = start(Wanted { rate: 8.0, machine: Some(("sim", change)), ..Wanted::default() });
    shop.write("job.rsm", rsm(clauses).as_bytes());
    shop
}

/// The path that is made.
fn path(page: &Page) -> u64 {
    page.shown["motion"]["line"].as_u64().unwrap()
}

fn answer(page: &mut Page, words: &str) -> Option<String> {
    let number = page.asked("paused");
    let refused = page.act(json!({ "do": "answer", "question": number, "answer": words }));
    if refused.is_none() {
        page.until("the next question", |page| page.shown["asked"]["number"] != number);
    }
    refused
}

/// Stops the job on a path, behind a place in X, and waits until it asks.
fn stop_on(page: &mut Page, number: u64, x: f64) {
    let there = |page: &Page| {
        path(page) == number && at(page)[0] > x && page.shown["motion"]["cutting"] == true
    };
    page.until("the place to stop", there);
    assert_eq!(page.act(json!({ "do": "stop" })), None);
    page.until_state("stopped");
    page.asked("paused");
}

fn finished(page: &mut Page) {
    page.until("the end", |page| page.shown["job"]["ended"] == "ok");
    page.until_state("idle");
}

fn choose(page: &mut Page, choice: Value) -> Option<String> {
    let refused = page.act(json!({ "do": "choose", "choice": choice }));
    if refused.is_none() {
        page.until("the preview", |page| page.shown["opened"]["preview"]["state"] == "ready");
    }
    refused
}

#[test]
fn a_job_is_opened_previewed_and_cut() {
    let shop = shop(FIVE, |_| {});
    let mut page = shop.driver();
    page.open_file("job.rsm");
    let opened = page.shown["opened"].clone();
    assert_eq!((&opened["kind"], &opened["lines"]), (&json!("job"), &json!(5)));
    assert!(opened["seconds"].as_f64().unwrap() > 5.0);
    let view = shop.get("/api/job").json();
    assert_eq!(view["hash"], opened["hash"]);
    assert_eq!(view["heights"], json!([-10.0, -20.0, -30.0]));
    let numbers: Vec<u64> =
        view["paths"].as_array().unwrap().iter().map(|p| p["number"].as_u64().unwrap()).collect();
    assert_eq!(numbers, [1, 2, 3, 4, 5]);
    assert_eq!(page.run(), None);
    page.until("the third path", |page| path(page) == 3);
    let progress = page.shown["motion"]["progress"].as_f64().unwrap();
    assert!(progress > 0.3 && progress < 0.8, "{progress}");
    finished(&mut page);
    assert_eq!(at(&page), [0.0, 0.0, -10.0]);
}

#[test]
fn a_job_is_paused_moved_and_goes_on_at_the_very_place() {
    let shop = shop("line 0,0 100,0; line 0,50 100,50", |_| {});
    let mut page = shop.driver();
    page.open_file("job.rsm");
    assert_eq!(page.run(), None);
    stop_on(&mut page, 1, 30.0);
    let [x, ..] = at(&page);
    assert_eq!(at(&page)[2], -10.0, "the tool rose");
    assert_eq!(answer(&mut page, "nonsense").as_deref(), Some("mistake"));
    // By a key that is held, and by a distance.
    let jog = json!({ "do": "jogStart", "lease": page.lease, "seq": 1, "clockMs": page.clock_ms(),
        "direction": [0, 1, 0, 0, 0, 0], "distance": 20.0, "speedShare": 1.0 });
    page.act(jog);
    for _ in 0..400 {
        let clock_ms = page.clock_ms();
        page.act(json!({ "do": "jogRenew", "lease": page.lease, "seq": 1, "clockMs": clock_ms }));
        if at(&page)[1] == 20.0 {
            break;
        }
    }
    page.act(json!({ "do": "jogStop", "seq": 1 }));
    page.until("20 mm by hand", |page| at(page)[1] == 20.0);
    page.until_state("stopped");
    assert_eq!(answer(&mut page, "move x 12.5").as_deref(), Some("malformed"), "no answer moves");
    assert_eq!(page.act(json!({ "do": "resume", "lease": page.lease })), None);
    let cuts = |page: &Page| page.shown["motion"]["cutting"] == true && at(page)[2] == -30.0;
    page.until("the cut", cuts);
    assert!(at(&page)[0] >= x - 1e-6 && at(&page)[0] < 100.1, "{:?} behind {x}", at(&page));
    assert!(at(&page)[1].abs() < 1e-6);
    finished(&mut page);
}

#[test]
fn a_start_path_is_part_of_what_was_previewed() {
    let shop = shop(FIVE, |_| {});
    let mut page = shop.driver();
    page.open_file("job.rsm");
    let whole = page.shown["opened"].clone();
    assert_eq!(choose(&mut page, json!({ "start": 4 })), None);
    let part = page.shown["opened"].clone();
    assert_ne!(part["hash"], whole["hash"]);
    assert!(part["seconds"].as_f64().unwrap() < whole["seconds"].as_f64().unwrap() * 0.6);
    assert_eq!(shop.get("/api/job").json()["start"], 4);
    let old = json!({ "do": "run", "lease": page.lease, "hash": whole["hash"] });
    assert_eq!(page.act(old).as_deref(), Some("changed"));
    for wrong in [json!({ "start": 6 }), json!({ "start": 0 })] {
        assert_eq!(choose(&mut page, wrong).as_deref(), Some("mistake"));
    }
    assert_eq!(page.run(), None);
    page.until("a cut", |page| page.shown["motion"]["cutting"] == true);
    assert_eq!(path(&page), 4);
    assert_eq!(choose(&mut page, json!({ "start": 1 })).as_deref(), Some("state"));
    finished(&mut page);
    // The file on the disk is another by now.
    shop.write("job.rsm", rsm("line 0,0 1,0").as_bytes());
    assert_eq!(page.run().as_deref(), Some("changed"));
}

#[test]
fn an_origin_and_an_offset_hold_without_changing_the_file() {
    let shop = shop("rect 0,0 90,90", |_| {});
    let mut page = shop.driver();
    page.open_file("job.rsm");
    assert_eq!(choose(&mut page, json!({ "origin": [300, 200], "offset": 1 })), None);
    let view = shop.get("/api/job").json();
    assert_eq!(view["origin"], json!([300.0, 200.0]));
    let key = page.shown["opened"]["preview"]["key"].as_str().unwrap().to_owned();
    let bounds = shop.get(&format!("/api/preview/{key}")).json()["bounds"].clone();
    let x = bounds.to_string();
    assert!(x.contains("301") || x.contains("299"), "{x}");
    assert_eq!(choose(&mut page, json!({ "offset": 60 })), None);
    assert_eq!(page.run().as_deref(), Some("mistake"), "out of bounds");
}

#[test]
fn a_chosen_origin_is_kept_in_the_file_when_that_is_wanted() {
    let shop = shop(FIVE, |_| {});
    let mut page = shop.driver();
    page.open_file("job.rsm");
    let keep = || json!({ "do": "keepOrigin" });
    assert_eq!(page.act(keep()).as_deref(), Some("state"), "none was chosen");
    assert_eq!(choose(&mut page, json!({ "origin": [300, 200], "start": 2 })), None);
    let before = shop.get("/api/job").json();
    assert_eq!(page.act(keep()), None);
    page.until("the file's", |page| page.shown["opened"]["choice"]["origin"].is_null());
    assert_eq!(page.shown["opened"]["choice"]["start"], 2, "the rest of the choice stays");
    page.open_file("job.rsm");
    let after = shop.get("/api/job").json();
    assert_eq!(after["origin"], json!([300.0, 200.0]));
    assert_eq!((&after["paths"], &after["finish"]), (&before["paths"], &before["finish"]));
    assert_eq!(choose(&mut page, json!({ "origin": [1, 2] })), None);
    shop.write("job.rsm", rsm("line 0,10 100,10").as_bytes());
    assert_eq!(page.act(keep()).as_deref(), Some("changed"), "it was written by somebody else");
}

#[test]
fn pro_job_view() {
    let shop = shop(FIVE, |_| {});
    let mut editor = Editor::default();
    for (_, operation) in script(FIVE).unwrap() {
        editor.apply(&operation).unwrap();
    }
    shop.write("part.rsg", kerf_formats::rsg::write(&editor.drawing).as_bytes());
    let mut page = shop.driver();
    page.open_file("part.rsg");
    assert_eq!(page.shown["opened"]["kind"], "drawing");
    let id = page
        .send(json!({ "do": "run", "lease": page.lease, "hash": page.shown["opened"]["hash"] }));
    assert!(page.problem(id).starts_with("create the tool path first"));
    page.until_state("idle");
    assert_eq!(page.act(json!({ "do": "machine", "drawing": "part.rsg" })), None);
    let ready = |page: &Page| {
        let opened = &page.shown["opened"];
        opened["name"] == "part.rsm" && opened["preview"]["state"] == "ready"
    };
    page.until("the job", ready);
    assert_eq!(page.run(), None);
    finished(&mut page);
    // With a drawing on the desk and no file: the same.
    page.act(json!({ "do": "close" }));
    assert_eq!(page.act(json!({ "do": "draw", "op": { "op": "open", "name": "part.rsg" } })), None);
    let id = page.send(json!({ "do": "run", "lease": page.lease, "hash": "" }));
    assert!(page.problem(id).starts_with("create the tool path first"));
}

#[test]
fn a_job_changed_by_hand_is_not_made_anew_without_a_word() {
    let shop = shop(FIVE, |_| {});
    let (job, _) = kerf_toolpath::read(rsm(FIVE).as_bytes());
    let drawing = job.as_drawing();
    shop.write("part.rsg", kerf_formats::rsg::write(&drawing).as_bytes());
    shop.write("part.rsm", kerf_toolpath::write(&job.edited(&drawing)).as_bytes());
    let mut page = shop.driver();
    let make = |anew: bool| json!({ "do": "machine", "drawing": "part.rsg", "anew": anew });
    assert_eq!(page.act(make(false)).as_deref(), Some("changed"));
    assert_eq!(page.act(make(true)), None);
}

#[test]
fn pro_job_step_start__over_http() {
    let shop = shop(FIVE, |machine| {
        machine.misc.double_start = true;
        machine.homing.at_job_start = kerf_program::AxisSet::EMPTY.with(kerf_program::Axis::Z);
    });
    let mut page = shop.driver();
    page.open_file("job.rsm");
    let start = json!({ "lease": page.lease, "hash": page.shown["opened"]["hash"] });
    // The lease is this page's, not that of a script.
    assert_eq!(shop.post("/api/job/start", start, &[]).status, 403);
    let act = |name: &str, body| shop.post(&format!("/api/do/{name}"), body, &[]);
    assert_eq!(act("takeLease", json!({ "force": true })).status, 200);
    let lease = |page: &Page| page.shown["lease"]["number"].clone();
    let mine = page.lease;
    page.until("another driver", |page| lease(page) != json!(mine) && lease(page) != Value::Null);
    let lease = lease(&page);
    assert_eq!(act("arm", json!({ "lease": lease })).status, 200);
    let start = json!({ "lease": lease, "hash": page.shown["opened"]["hash"] });
    assert_eq!(shop.post("/api/job/start", start.clone(), &[]).status, 200);
    // The first Start prepares, the second cuts.
    page.until_state("asking");
    page.asked("paused");
    assert_eq!(page.shown["asked"]["text"], "Start with shape 1?");
    let said = page.shown["messages"].to_string();
    assert!(said.contains("z homed") && !said.contains("x homed"), "{said}");
    assert_eq!(path(&page), 0, "nothing is cut yet");
    assert_eq!(shop.post("/api/job/start", start, &[]).status, 200);
    finished(&mut page);
}

#[test]
fn a_job_takes_its_time_after_homing() {
    let shop = shop(FIVE, |machine| {
        machine.homing.at_job_start = kerf_program::AxisSet::first(3);
    });
    let mut page = shop.driver();
    page.open_file("job.rsm");
    let begun = Instant::now();
    assert_eq!(page.run(), None);
    page.until("homed", |page| page.shown["messages"].to_string().contains("y homed"));
    finished(&mut page);
    let took_s = begun.elapsed().as_secs_f64();
    let job_s = page.shown["job"]["summary"]["seconds"].as_f64().unwrap() / 8.0;
    assert!(took_s > 0.9 * job_s, "{took_s} of {job_s} s: it was made in a hurry");
}

#[test]
fn speeds_and_heights_are_changed_in_a_pause() {
    let shop = shop("line 0,0 200,0; line 0,50 200,50", |_| {});
    let mut page = shop.driver();
    page.open_file("job.rsm");
    assert_eq!(page.run(), None);
    stop_on(&mut page, 1, 30.0);
    assert!(page.shown["job"]["inForce"].is_null(), "it is as it was set");
    for words in ["zbottom -0.5", "cut 3000", "raise no"] {
        assert_eq!(answer(&mut page, words), None, "{words}");
        page.until_state("stopped");
    }
    // Told to every page, also to one that comes later: no dialog has to remember it.
    let plunge = shop.get("/api/job").json()["plungeMmS"].clone();
    let in_force = json!({ "cutMmS": 50.0, "plungeMmS": plunge, "raise": false });
    page.until("what is in force", |page| page.shown["job"]["inForce"] == in_force);
    assert_eq!(shop.page().shown["job"]["inForce"], in_force);
    assert_eq!(page.act(json!({ "do": "resume", "lease": page.lease })), None);
    page.until("half a millimetre deeper", |page| (at(page)[2] + 30.5).abs() < 1e-6);
    let speed = |page: &Page| page.shown["motion"]["speedMmS"].as_f64().unwrap();
    page.until("50 mm/s", |page| at(page)[2] < -30.4 && (speed(page) - 50.0).abs() < 1e-6);
    stop_on(&mut page, 1, 0.0);
    assert!((at(&page)[2] + 30.5).abs() < 1e-6, "it does not rise any more: {:?}", at(&page));
    // STOP once more gives the job up.
    assert_eq!(page.act(json!({ "do": "stop" })), None);
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "stopped");
    assert!(page.shown["io"]["outputs"].as_array().unwrap().iter().all(|lamp| lamp["on"] == false));
    assert_eq!(page.run(), None);
    page.until("as it was set", |page| page.shown["job"]["inForce"].is_null());
}

fn ports(page: &Page) -> Value {
    page.shown["io"]["ports"].clone()
}

#[test]
fn pro_io_diag_read__in_the_state_of_pages() {
    let shop = start(Wanted::default());
    let mut page = shop.driver();
    assert_eq!(ports(&page), json!({ "inputs": [0, 0], "outputs": [0, 0, 0] }));
    // The switch of X is line 15.
    let press = json!({ "do": "input", "lease": page.lease, "number": 15, "on": true });
    assert_eq!(page.act(press), None);
    page.until("port A", |page| ports(page)["inputs"] == json!([4, 0]));
    let bits = shop.get("/api/ports").json();
    let xhome = bits.as_array().unwrap().iter().find(|bit| bit["name"] == "xhome").unwrap();
    let told = (&xhome["port"], &xhome["place"], &xhome["output"]);
    assert_eq!(told, (&json!("A"), &json!(2), &json!(false)));
    assert_eq!(bits.as_array().unwrap().len(), 40);
}

/// On a page a switch is put so that its input reads what is shown, at whatever level of its pin.
#[test]
fn pro_io_pci_i_elec__a_switch_of_pages() {
    let shop = shop("line 0,0 1,0", |machine| machine.io.card = Card::Pci);
    let mut page = shop.driver();
    for (on, byte) in [(true, 32), (false, 0)] {
        let press = json!({ "do": "input", "lease": page.lease, "number": 18, "on": on });
        assert_eq!(page.act(press), None);
        page.until("port A", |page| ports(page)["inputs"] == json!([byte, 0]));
    }
}

/// A switch that is moved shows at once: in the middle of a move, and while somebody is asked.
#[test]
fn lamps_of_inputs_do_not_wait_for_the_end_of_a_move() {
    let shop = support::shop(1.0, &[("a.sbp", "VS,1\nMX,20\nPAUSE\nMX,21\n")]);
    let mut page = shop.driver();
    page.open_file("a.sbp");
    assert_eq!(page.run(), None);
    let press = |page: &mut Page, on: bool| {
        let press = json!({ "do": "input", "lease": page.lease, "number": 3, "on": on });
        assert_eq!(page.act(press), None);
        page.until("the lamp", |page| page.shown["io"]["inputs"][2]["on"] == on);
    };
    page.until("motion", |page| page.x() > 5.0);
    press(&mut page, true);
    press(&mut page, false);
    assert!(page.x() < 200.0, "in the middle of the move");
    page.send(json!({ "do": "stop" }));
    page.until_state("stopped");
    press(&mut page, true);
    press(&mut page, false);
    assert_eq!(page.shown["machine"]["state"], "stopped");
}

#[test]
fn lamps_of_the_card_follow_a_job() {
    let shop = shop("line 0,0 100,0; line 100,50 0,50", |_| {});
    let mut page = shop.driver();
    page.open_file("job.rsm");
    assert_eq!(page.run(), None);
    // Tool 1, cut 1, router and job running; X steps forwards, then backwards.
    let x = |page: &Page| ports(page)["outputs"][0].as_u64().unwrap() & 0b11;
    page.until("the first path", |page| {
        x(page) == 0b11 && ports(page)["outputs"][1] == 0b1100_0011
    });
    page.until("the way back", |page| x(page) == 0b10 && path(page) == 2);
    finished(&mut page);
    assert_eq!(ports(&page)["outputs"][1], 0);
    assert_eq!(ports(&page)["outputs"][0].as_u64().unwrap() & 0b1010_1010, 0, "nothing steps");
}

/// Every position and speed that a page is told while a job of two lines runs.
fn told(tenths: u8) -> Vec<([f64; 3], f64)> {
    fn with(tenths: u8) -> fn(&mut Configuration) {
        match tenths {
            0 => |machine| machine.misc.runtime_drawing = 0,
            5 => |machine| machine.misc.runtime_drawing = 5,
            _ => |machine| machine.misc.runtime_drawing = 10,
        }
    }
    let shop = shop("line 0,0 100,0; line 700,0 600,0", with(tenths));
    let mut page = shop.driver();
    page.open_file("job.rsm");
    assert_eq!(page.run(), None);
    let mut told = Vec::new();
    while page.shown["job"]["ended"].is_null() {
        assert!(page.read());
        let speed = page.shown["motion"]["speedMmS"].as_f64().unwrap();
        if page.shown["machine"]["state"] == "running" && told.last() != Some(&(at(&page), speed)) {
            told.push((at(&page), speed));
        }
    }
    page.until_state("idle");
    assert_eq!(at(&page), [0.0, 0.0, -10.0], "where it stands is told in any case");
    told
}

/// Everything that a run tells.
#[derive(Default)]
struct Trace(Vec<kerf_trace::Event>);

impl kerf_trace::Sink for Trace {
    fn event(&mut self, event: &kerf_trace::Event) {
        self.0.push(event.clone());
    }
}

/// The trace of the same job.
fn trace(tenths: u8) -> Vec<kerf_trace::Event> {
    let mut machine = kerf_machine::profile::profile("sim").unwrap().configuration().unwrap();
    machine.misc.runtime_drawing = tenths;
    let (job, _) = kerf_toolpath::read(rsm("line 0,0 100,0; line 700,0 600,0").as_bytes());
    let work = kerf_import::job_file::work(&job, "job.rsm".into(), machine);
    let folders = kerf_files::Folders::new(".".into(), Vec::new(), Vec::new());
    let stored = kerf_workspace::stored::Stored::in_memory(Default::default());
    let disk = kerf_files::RealDisk;
    let mut workspace = kerf_workspace::Workspace::preview(disk, folders, &stored, ".".into());
    let mut sink = Trace::default();
    let context = kerf_control::RunContext {
        sink: &mut sink,
        operator: &mut (),
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    let options = kerf_journal::RunOptions::default();
    kerf_control::Session::default().run(work, options, &mut workspace, context);
    sink.0
}

#[test]
fn pro_misc_runtime() {
    assert!(trace(0).len() > 20 && trace(0) == trace(10), "what moves is the same");
    let most = |told: &[([f64; 3], f64)]| told.iter().map(|(_, speed)| *speed).fold(0.0, f64::max);
    let (never, half, always) = (told(0), told(5), told(10));
    // SIM moves at 200 mm/s at the most.
    assert!(always.len() > 15 && most(&always) > 150.0, "{always:?}");
    assert!(half.len() > 5 && most(&half) > 50.0 && most(&half) <= 100.0 + 1e-6, "{half:?}");
    assert!(never.iter().all(|(_, speed)| *speed == 0.0), "{never:?}");
    let shop = shop(FIVE, |_| {});
    let mut page = shop.driver();
    for wrong in ["-1", "11"] {
        let act = json!({ "do": "set", "lease": page.lease, "key": "misc.runtime_drawing", "value": wrong });
        assert_eq!(page.act(act).as_deref(), Some("mistake"));
    }
}

#[test]
fn a_damaged_job_is_not_opened() {
    let shop = shop(FIVE, |_| {});
    let text = rsm(FIVE);
    let lines: Vec<&str> = text.lines().collect();
    shop.write("hurt.rsm", [&lines[..2], &lines[4..]].concat().join("\n").as_bytes());
    let mut page = shop.driver();
    assert_eq!(page.act(json!({ "do": "open", "name": "hurt.rsm" })).as_deref(), Some("mistake"));
    assert_eq!(page.act(json!({ "do": "open", "name": "job.rsm" })), None);
}
