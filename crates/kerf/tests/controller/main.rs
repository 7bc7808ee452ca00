//! `kerf run --driver`: runs on a fake controller, on a pseudo terminal. A program of its own, as the controller
//! moves in real time and notices when nothing is sent to it.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::print_stdout, non_snake_case)]

mod bench;
mod boards;
mod card;
mod fluid_card;
mod gone;
mod held;
mod inputs_and_outputs;
#[cfg(target_os = "linux")]
mod linuxcnc;
mod logged;
mod merged;
mod named;
mod network;
mod overrides;
mod paused;
mod probing;
#[path = "../shop/mod.rs"]
mod shop;
mod step_board;
mod step_board_killed;
#[path = "../../../control/tests/step_path.rs"]
mod step_path;
mod taken_up;
mod time;
mod tool_change;
mod travel;
mod warm_up;
mod zeros;

use bench::Bench;
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::Axes;
use kerf_transport::pretend::Plug;
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use serde_json::Value;
use shop::{Did, Shop};
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::Duration;

fn events(shop: &Shop, kind: &str) -> Vec<Value> {
    let trace = shop.read("t.jsonl");
    let all = trace.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    all.filter(|event| event["e"] == kind).collect()
}

fn interrupt(child: &Child) {
    send(Signal::SIGINT, child);
}

fn send(signal: Signal, child: &Child) {
    kill(Pid::from_raw(child.id() as i32), signal).unwrap();
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 0.02
}

const BOX: &str =
    "TR,12000\nSO,1,1\nMS,2,1\nJZ,.2\nMZ,-.1\nMX,1\nMY,1\nCG,,0,0,-.5,-.5,T,1\nSO,1,0\nJZ,.2\n";

#[test]
fn sbp_ctl_run__on_a_grbl() {
    let (shop, bench) = (Shop::new(&[("box.sbp", BOX)]), Bench::new(&[]));
    bench.run(&shop, "run box.sbp").exits(0).complains("grbl 1.1h").says("ran to its end");
    let [x, y, z, ..] = bench.look(|fake| fake.position()).0;
    assert!(x.abs() < 0.01 && y.abs() < 0.01 && close(z, 5.08), "{x} {y} {z}");
    assert_eq!(bench.look(|fake| (fake.spindle(), fake.overflowed)), (None, 0));
    assert_eq!(
        events(&shop, "arc").len(),
        1,
        "an arc is one event, whatever the controller makes of it"
    );
    assert_eq!(events(&shop, "end")[0]["status"], "ok");
    let lines = bench.look(|fake| fake.lines.clone());
    let place = |word: &str| lines.iter().position(|line| line.starts_with(word)).unwrap();
    assert!(place("S12000") < place("M3") && place("M3") < place("G53"));
    let arc = "G91G2X-25.4Y-25.4I-12.7J-12.7".to_owned();
    assert!(lines.contains(&arc), "an arc is one line, at the same feed: {lines:?}");
    // It stood before the jog that follows the cut, and where the spindle was switched off.
    assert!(bench.look(|fake| fake.stands()) <= 6, "{}", bench.look(|fake| fake.stands()));
}

#[test]
fn a_row_of_short_moves_is_one_motion_on_a_grbl() {
    let place = |n: u32| {
        let angle = f64::from(n) * 0.03;
        format!(
            "M3,{:.4},{:.4},{:.4}\n",
            angle.sin(),
            1.0 - angle.cos(),
            0.01 * (5.0 * angle).sin()
        )
    };
    let moves: String = (1..=900).map(place).collect();
    let (shop, bench) = (Shop::new(&[("many.sbp", &format!("MS,3,3\n{moves}"))]), Bench::new(&[]));
    bench.run(&shop, "run many.sbp").exits(0);
    assert_eq!(bench.look(|fake| (fake.stands(), fake.overflowed)), (1, 0));
    assert_eq!(events(&shop, "move").len(), 900);
}

const SQUARE: &str = "MS,1,1\nSO,1,1\nMX,3\nMY,3\nMX,0\nMY,0\n";

#[test]
fn a_stop_on_a_grbl_ends_where_the_controller_stands() {
    let (shop, bench) =
        (Shop::new(&[("square.sbp", SQUARE), ("back.sbp", "J2,0,0\n")]), Bench::new(&[]));
    let child = bench.start(&shop, "run square.sbp");
    bench.until(|fake| fake.position().0[0] > 30.0);
    interrupt(&child);
    Did::of(child.wait_with_output().unwrap()).exits(3).says("STOPPED");
    assert_eq!(bench.look(|fake| fake.spindle()), None);
    let stood = bench.x_mm();
    assert!(stood > 30.0 && stood < 70.0, "{stood}");
    let made = events(&shop, "move");
    assert!(close(made[0]["to"]["x"].as_f64().unwrap() * 25.4, stood), "{made:?} {stood}");
    // The simulated machine does not go on with it.
    let stopped = format!("square.sbp was stopped behind line 3 on grbl:{}", bench.port);
    let again = shop.kerf("run --resume");
    again.exits(1).complains(&stopped).complains(&format!("it ran on grbl:{}", bench.port));
    let back = bench.run(&shop, "run back.sbp");
    let way = format!("--resume --machine grbl:{}", bench.port);
    back.exits(0).complains(&stopped).complains(&way);
    assert!(bench.x_mm().abs() < 0.01, "the location was kept: {}", bench.x_mm());
}

#[test]
fn an_alarm_of_a_grbl_names_the_line_and_doubts_the_place() {
    let (shop, bench) = (Shop::new(&[("square.sbp", SQUARE)]), Bench::new(&[]));
    let child = bench.start(&shop, "run square.sbp");
    bench.until(|fake| fake.position().0[1] > 10.0);
    bench.look(Fake::hits_limit);
    let did = Did::of(child.wait_with_output().unwrap());
    did.exits(1).complains("M008").complains("square.sbp:4").complains("limit switch");
    assert_eq!(bench.look(|fake| fake.spindle()), None);
    bench.run(&shop, "run square.sbp").exits(1).complains("it is locked");
    let again = bench.run(&shop, "run square.sbp --unlock");
    again.exits(3).says("Position unverified");
}

#[test]
fn a_grbl_that_is_unplugged_ends_the_run() {
    let (shop, mut bench) = (Shop::new(&[("square.sbp", SQUARE)]), Bench::new(&[]));
    let child = bench.start(&shop, "run square.sbp");
    bench.until(|fake| fake.position().0[0] > 20.0);
    bench.unplug();
    let did = Did::of(child.wait_with_output().unwrap());
    did.exits(1).complains("M005").complains("square.sbp:3");
    let cut = events(&shop, "end")[0]["cut"].as_f64().unwrap();
    assert!(cut > 0.5 && cut < 3.0, "what was told last is what is known: {cut}");
    shop.kerf("run square.sbp --driver grbl:/dev/none")
        .exits(1)
        .complains("there is no serial port");
}

#[test]
fn what_a_grbl_lacks_is_found_before_anything_moves() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[(20, 1.0)]));
    let lacks = |program: &str, what: &str| {
        shop.write("p.sbp", program.as_bytes());
        bench.run(&shop, "run p.sbp --start fresh").exits(1).complains(what).complains("M008");
        assert_eq!(bench.look(|fake| fake.way_mm()), 0.0, "{what}");
    };
    lacks("VD,,4\nMX,-1\nMA,90\n", "has no axis A");
    lacks("MX,-1\nSO,7,1\n", "has no output 7");
    lacks("MX,-1\nMX,1\n", "ends at X -600.000 … 0.000");
    let nothing = Plug::new().unwrap();
    let silent = format!("run p.sbp --driver grbl:{}", nothing.path());
    shop.kerf(&silent).exits(1).complains("does not answer");
    shop.kerf("run p.sbp --driver marlin:/dev/ttyS0")
        .exits(2)
        .complains("there is no driver 'marlin'");
}

#[test]
fn an_input_of_a_grbl_interrupts_the_program() {
    let program = "MS,1,1\nON INP(1,1) GOTO hit\nMX,5\nEND\nhit:\nPRINT \"at \";%(1)\nMX,0\nEND\n";
    let (shop, bench) = (Shop::new(&[("touch.sbp", program)]), Bench::new(&[]));
    let child = bench.start(&shop, "run touch.sbp");
    bench.until(|fake| fake.position().0[0] > 30.0);
    bench.look(|fake| fake.pins("P"));
    let pressed = bench.x_mm();
    Did::of(child.wait_with_output().unwrap()).exits(0);
    let stood = events(&shop, "move")[0]["to"]["x"].as_f64().unwrap() * 25.4;
    // It has gone back from the end of its ramp to the place of the contact.
    let rest = bench.look(|fake| fake.rests()[1]);
    assert!(close(stood, rest.0[0]), "the program stands where the machine does: {stood} {rest:?}");
    assert!(stood > pressed - 0.5 && stood < pressed + 5.0, "{pressed} {stood}");
    assert!(bench.x_mm().abs() < 0.01);
}

#[test]
fn a_door_that_opens_holds_a_run_on_a_grbl_until_somebody_has_it_go_on() {
    let program = "SO,1,1\nMS,1,1\nMX,5\nEND\n";
    let (shop, bench) =
        (Shop::new(&[("door.sbp", program)]), Bench::of(Fake::of(Board::hal(0), &[])));
    let child = bench.start(&shop, "run door.sbp");
    bench.until(|fake| fake.position().0[0] > 30.0);
    bench.look(|fake| fake.pins("D"));
    let opened = bench.x_mm();
    sleep(Duration::from_millis(2500));
    let stood = bench.x_mm();
    assert!(
        stood < opened + 5.0 && bench.look(|fake| fake.spindle()).is_none(),
        "{opened} {stood}"
    );
    bench.look(|fake| fake.pins(""));
    bench.look(Fake::cycle_start);
    Did::of(child.wait_with_output().unwrap()).exits(0).says("ran to its end");
    assert!(close(bench.x_mm(), 127.0), "{}", bench.x_mm());
    // Open before the start, it forbids everything.
    let bench = Bench::new(&[]);
    bench.look(|fake| fake.pins("D"));
    bench.run(&shop, "run door.sbp").exits(1).complains("its door is open");
    assert!(bench.x_mm().abs() < 0.01);
}

/// The light that is on while something moves is nobody's need; a program that switches an output itself needs it.
#[test]
fn a_board_without_auxiliary_outputs_runs_what_needs_none() {
    let (shop, bench) = (Shop::new(&[("box.sbp", BOX)]), Bench::of(Fake::of(Board::hal(0), &[])));
    bench.run(&shop, "run box.sbp").exits(0).complains("has no output 4").says("ran to its end");
    let lines = bench.look(|fake| fake.lines.clone());
    assert!(!lines.iter().any(|line| line.starts_with("M64")), "{lines:?}");
    shop.write("p.sbp", b"MX,1\nSO,5,1\n");
    let did = bench.run(&shop, "run p.sbp --start fresh");
    did.exits(1).complains("has no output 5, but 1 (spindle)").complains("p.sbp:");
    let beam = Bench::of(Fake::of(Board::hal(0), &[(32, 1.0)]));
    beam.run(&shop, "run box.sbp --start fresh").exits(1).complains("set $32=0");
    assert_eq!(beam.look(|fake| fake.way_mm()), 0.0);
}

#[test]
fn a_job_is_where_it_belongs_whatever_a_grbl_tells_and_its_settings_are_put_back() {
    for unit in [0.0, 1.0] {
        let mut fake = Fake::of(Board::hal(0), &[(10, 508.0), (13, unit)]);
        fake.offsets.systems[0] = Axes::xyz(100.0, 50.0, -20.0);
        let (shop, bench) = (Shop::new(&[("square.sbp", SQUARE)]), Bench::of(fake));
        let did = bench.run(&shop, "run square.sbp");
        did.exits(0).complains("$10 is 511 while Kerf drives it, 508 again afterwards");
        let (way_mm, place) = bench.look(|fake| (fake.way_mm(), fake.position()));
        assert!(
            (way_mm - 4.0 * 76.2).abs() < 0.1 && place == Axes::default(),
            "{way_mm} {place:?}"
        );
        assert_eq!(bench.look(|fake| fake.lowest_mm), 0.0);
        assert_eq!(bench.look(|fake| fake.is_set_to(10)), 508.0);
        // Killed in the middle it is put back behind the next run.
        let mut child = bench.start(&shop, "run square.sbp --start fresh");
        bench.until(|fake| fake.position().0[0] > 20.0);
        child.kill().unwrap();
        child.wait().unwrap();
        assert_eq!(bench.look(|fake| fake.is_set_to(10)), 511.0);
        shop.write("nothing.sbp", b"PRINT 1\n");
        bench.run(&shop, "run nothing.sbp");
        assert_eq!(bench.look(|fake| fake.is_set_to(10)), 508.0);
    }
}

#[test]
fn a_job_runs_on_a_grbl() {
    runs_a_job(&Bench::new(&[]));
}

#[test]
fn the_router_of_a_job_is_the_spindle_of_a_board_with_many_outputs_too() {
    runs_a_job(&Bench::of(Fake::of(Board::hal(20), &[])));
}

fn runs_a_job(bench: &Bench) {
    let drawing = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/figures/line.rsg");
    let shop = Shop::new(&[]);
    shop.kerf(&format!("toolpath {drawing} -o line.rsm")).exits(0);
    let did = bench.run(&shop, "run line.rsm --start fresh");
    did.exits(0).complains("has no output 13 (tool1): it is left out").says("ran to its end");
    let lines = bench.look(|fake| fake.lines.clone());
    let (on, off) = ("M3".to_owned(), "M5".to_owned());
    assert!(lines.contains(&on) && lines.contains(&off), "the router is its spindle: {lines:?}");
    let [x, y, z, ..] = bench.look(|fake| fake.position()).0;
    let end = events(&shop, "move").pop().unwrap()["to"].clone();
    let told = |axis: &str| end[axis].as_f64().unwrap();
    assert!(close(x, told("x")) && close(y, told("y")) && close(z, told("z")), "{x} {y} {z} {end}");
    let way_mm = bench.look(|fake| fake.way_mm());
    assert!(way_mm > 10.0);
    let burnt = "run line.rsm --start fresh --config";
    for machine in ["plasma", "laser-pwm"] {
        bench.run(&shop, &format!("{burnt} {machine}")).exits(1).complains("a torch or a beam");
    }
    assert_eq!(bench.look(|fake| fake.way_mm()), way_mm, "nothing moves");
}

#[test]
fn sbp_cmd_ui() {
    let (shop, bench) = (Shop::new(&[("ui.sbp", "MX,.5\nUI\nMX,1\n")]), Bench::new(&[]));
    let yes = "Yes\n";
    shop.write("yes.txt", yes.as_bytes());
    let ui = |more: &str| bench.run(&shop, &format!("run ui.sbp --answers yes.txt {more}"));
    ui("--allow-shell").exits(1).complains("options.firmware");
    let set = |command: &str| {
        let mut kerf = shop.command();
        Did::of(kerf.args(["machine", "set", "options.firmware", command]).output().unwrap())
            .exits(0);
    };
    set("echo flashing {port} && echo {port} > flashed.txt");
    ui("").exits(1).complains("--allow-shell");
    assert!(!shop.file("flashed.txt").exists());
    let loaded = ui("--allow-shell");
    loaded.exits(0).says("firmware loaded: grbl 1.1h").says(&format!("flashing {}", bench.port));
    assert_eq!(shop.read("flashed.txt").trim(), bench.port);
    // What the command says of itself counts, and the run does not go on.
    set("exit 3");
    let way = bench.look(|fake| fake.way_mm());
    ui("--allow-shell").exits(1).complains("failed: exit status: 3");
    assert!(bench.look(|fake| fake.way_mm()) - way < 13.0, "the second move was not made");
    shop.kerf("run ui.sbp --answers yes.txt")
        .exits(1)
        .complains("no firmware on the simulated machine");
}

#[test]
fn a_grbl_that_homes_says_where_the_machine_is() {
    let (shop, bench) = (Shop::new(&[("p.sbp", "MX,-2\n")]), Bench::new(&[(22, 1.0)]));
    bench.run(&shop, "run p.sbp").exits(1).complains("--home");
    bench.run(&shop, "run p.sbp --home").exits(0).complains("stands at -1.000");
    assert!(close(bench.x_mm(), -50.8), "{}", bench.x_mm());
}

#[test]
fn going_home_is_stopped_by_the_operator() {
    let (shop, bench) = (Shop::new(&[("p.sbp", "MX,-2\n")]), Bench::new(&[(22, 1.0)]));
    let child = bench.start(&shop, "run p.sbp --home");
    bench.until(|fake| fake.lines.iter().any(|line| line == "$H"));
    interrupt(&child);
    let did = Did::of(child.wait_with_output().unwrap());
    did.exits(1).complains("was stopped before it could get home");
    bench.run(&shop, "run p.sbp").exits(1).complains("--home");
}

#[test]
fn a_grbl_that_somebody_holds_is_given_up_when_the_operator_stops() {
    let program = "PAUSE 1\nSO,1,1\nPAUSE 1\nMX,1\n";
    let (shop, bench) = (Shop::new(&[("held.sbp", program)]), Bench::new(&[]));
    let child = bench.start(&shop, "run held.sbp");
    bench.until(|fake| fake.lines.iter().any(|line| line.starts_with("G17")));
    bench.look(|fake| fake.hear(b"!", 0.0));
    sleep(Duration::from_millis(1500));
    interrupt(&child);
    let did = Did::of(child.wait_with_output().unwrap());
    did.exits(1).complains("was stopped before it had made its last moves");
    assert_eq!((bench.x_mm(), bench.look(|fake| fake.spindle())), (0.0, None));
}

#[test]
fn runs_on_the_simulated_machine_do_not_move_what_a_grbl_without_homing_is_believed_to_be() {
    let files = [("two.sbp", "MX,2\n"), ("far.sbp", "J2,9,7\n"), ("back.sbp", "J2,0,0\n")];
    let (shop, bench) = (Shop::new(&files), Bench::new(&[]));
    bench.run(&shop, "run two.sbp").exits(0).complains("has not been driven before");
    assert!(close(bench.x_mm(), 50.8));
    shop.kerf("run far.sbp").exits(0);
    bench.run(&shop, "run back.sbp").exits(0).complains("stands at 50.800 and not at 228.600");
    assert!(bench.look(|fake| fake.position()).0[..2].iter().all(|place| place.abs() < 0.02));
    // Somebody jogged it at the controller.
    bench.look(|fake| fake.hear(b"G53G1X3F600\n", 0.0));
    bench.until(|fake| close(fake.position().0[0], 3.0));
    bench.run(&shop, "run back.sbp").exits(0).complains("is believed to stand at 0.000");
}

#[test]
fn a_process_that_is_to_end_stops_its_controller_first() {
    shop::hear_hangups();
    for signal in [Signal::SIGTERM, Signal::SIGHUP, Signal::SIGQUIT] {
        let files =
            [("square.sbp", SQUARE), ("yes.txt", "hold=Resume\n"), ("back.sbp", "J2,0,0\n")];
        let (shop, bench) = (Shop::new(&files), Bench::new(&[]));
        let child = bench.start(&shop, "run square.sbp --answers yes.txt");
        bench.until(|fake| fake.position().0[0] > 30.0);
        send(signal, &child);
        // Whoever ends processes may say so twice; the stop goes on.
        sleep(Duration::from_millis(100));
        send(signal, &child);
        Did::of(child.wait_with_output().unwrap()).exits(3).says("STOPPED");
        let [x, _, z, ..] = bench.look(|fake| fake.position()).0;
        assert!(x > 30.0 && x < 70.0, "{signal}: {x}");
        assert!(z > 1.0, "{signal}: the tool is lifted: {z}");
        assert_eq!(bench.look(|fake| fake.spindle()), None, "{signal}");
        bench.run(&shop, "run back.sbp").exits(0).complains("was stopped behind line 3");
        assert!(bench.x_mm().abs() < 0.01, "{signal}: the location was kept");
    }
}

#[test]
fn whoever_watches_inputs_is_ended_by_a_signal() {
    for signal in [Signal::SIGTERM, Signal::SIGINT] {
        let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
        let port = format!("grbl:{}", bench.port);
        let mut command = shop.command();
        command.args(["io", "watch", "--machine", &port]).stdin(Stdio::null());
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        bench.until(|fake| fake.lines.iter().any(|line| line == "$#"));
        sleep(Duration::from_millis(500));
        send(signal, &child);
        Did::of(child.wait_with_output().unwrap()).exits(0);
    }
}

/// A process that is suspended hears nothing, and its controller would go on with what it has.
#[test]
fn a_run_on_a_controller_is_stopped_and_not_suspended() {
    let (shop, bench) = (Shop::new(&[("square.sbp", SQUARE)]), Bench::new(&[]));
    let mut child = bench.start(&shop, "run square.sbp");
    bench.until(|fake| fake.position().0[0] > 30.0);
    send(Signal::SIGTSTP, &child);
    let ended = (0..400).any(|_| {
        sleep(Duration::from_millis(50));
        child.try_wait().unwrap().is_some()
    });
    if !ended {
        child.kill().unwrap();
    }
    assert!(ended, "it hears what asks it to suspend itself");
    Did::of(child.wait_with_output().unwrap())
        .exits(3)
        .says("Stopped. Resume, Quit")
        .says("STOPPED");
    let [x, _, z, ..] = bench.look(|fake| fake.position()).0;
    assert!(x > 30.0 && x < 70.0 && z > 1.0, "{x} {z}");
    assert_eq!(bench.look(|fake| fake.spindle()), None);
}

#[test]
fn a_run_that_is_to_outlive_its_terminal_does() {
    let (shop, bench) = (Shop::new(&[("square.sbp", SQUARE)]), Bench::new(&[]));
    let mut plain = shop.command();
    plain.args(bench.args("run square.sbp").split_whitespace());
    let mut nohup = std::process::Command::new("sh");
    nohup.args(["-c", "trap '' HUP; exec \"$0\" \"$@\""]).arg(plain.get_program());
    nohup.args(plain.get_args()).current_dir(shop.path()).env("KERF_DATA", shop.file("data"));
    let nohup = nohup.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let child = nohup.spawn().unwrap();
    bench.until(|fake| fake.position().0[0] > 10.0);
    send(Signal::SIGHUP, &child);
    Did::of(child.wait_with_output().unwrap()).exits(0).says("ran to its end");
}

#[test]
fn nobody_knows_where_a_grbl_stands_whose_run_was_killed() {
    let (shop, bench) =
        (Shop::new(&[("square.sbp", SQUARE), ("x.sbp", "MX,1\n")]), Bench::new(&[]));
    let mut child = bench.start(&shop, "run square.sbp");
    bench.until(|fake| fake.position().0[0] > 20.0);
    child.kill().unwrap();
    child.wait().unwrap();
    // It goes on with what it was told, and its spindle turns.
    bench.until(|fake| fake.position().0[1] > 5.0);
    assert!(bench.look(|fake| fake.spindle()).is_some());
    // A run elsewhere makes nothing of it known.
    shop.kerf("run x.sbp").exits(3);
    shop.kerf("send MX,1").exits(0);
    for told in [true, false] {
        let did = bench.run(&shop, "run square.sbp");
        did.exits(3).says("Position unverified: x, y, z");
        assert_eq!(bench.look(|fake| fake.spindle()), None, "what went on is switched off");
        let [x, y, ..] = bench.look(|fake| fake.position()).0;
        let place = format!("believed to stand at {x:.3}, {y:.3}, ");
        assert_eq!(did.err().contains(&place), told, "{place} {}", did.err());
    }
    shop.write("yes.txt", b"location=Continue\n");
    bench.run(&shop, "run square.sbp --answers yes.txt").exits(0);
    bench.run(&shop, "run x.sbp").exits(0);
}

/// The machine stops itself where its probe touches: nothing is pressed into the plate, and zero is its surface.
#[test]
fn a_touch_plate_is_found_to_a_step_on_a_grbl() {
    let program =
        "MS,1,.5\nON INP(1,1) GOTO hit\nMZ,-1\nEND\nhit:\nVA,,,.5\nPRINT \"at \";%(3)\nMZ,1\nEND\n";
    let (shop, bench) = (Shop::new(&[("touch.sbp", program)]), Bench::new(&[]));
    bench.look(|fake| fake.plate_mm = Some(-10.0));
    bench.run(&shop, "run touch.sbp").exits(0);
    let stood = events(&shop, "move")[0]["to"]["z"].as_f64().unwrap() * 25.4;
    assert!((stood + 10.0).abs() < 0.0015, "{stood}");
    let lowest = bench.look(|fake| fake.lowest_mm);
    assert!(lowest > -10.25, "on a ramp of 400 mm/s² from 12.7 mm/s: {lowest}");
    // Half an inch above the plate is a place that is an inch higher than half an inch below zero.
    let z = bench.look(|fake| fake.position().0[2]);
    assert!((z - 2.7).abs() < 0.003, "{z}");
    assert!(bench.look(|fake| fake.lines.iter().any(|line| line.starts_with("G91G38.3Z"))));
}

/// An input that can only be looked at now and then stops the machine within a tenth of a millimetre.
#[test]
fn a_move_until_an_input_that_is_only_looked_at_is_slow() {
    let program = "MS,1,1\nON INP(5,1) GOTO hit\nMX,.3\nEND\nhit:\nMX,0\nEND\n";
    let (shop, bench) = (Shop::new(&[("edge.sbp", program)]), Bench::new(&[]));
    let child = bench.start(&shop, "run edge.sbp");
    bench.until(|fake| fake.position().0[0] > 1.0);
    bench.look(|fake| fake.pins("X"));
    let pressed = bench.x_mm();
    Did::of(child.wait_with_output().unwrap()).exits(0);
    let stood = events(&shop, "move")[0]["to"]["x"].as_f64().unwrap() * 25.4;
    // A computer that is busy with other things is no measure: the machine is slow, whatever it does.
    assert!(stood >= pressed && stood < pressed + 1.0, "{pressed} {stood}");
    assert!(bench.look(|fake| fake.lines.iter().any(|line| line.ends_with("F90"))));
}
