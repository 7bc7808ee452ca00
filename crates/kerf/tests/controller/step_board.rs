//! `kerf run --machine klipper:PORT`: runs on a fake board with step queues, on a pseudo terminal.

use crate::shop::{Did, Shop};
use kerf_control::controller::queued::raise_priority;
use kerf_driver_klipper::fake::{Board, Chip, Pace};
use kerf_transport::pretend::Plug;
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::collections::VecDeque;
use std::process::Stdio;
use std::sync::{Arc, Mutex};
use std::thread::{JoinHandle, sleep, spawn};
use std::time::{Duration, Instant};

/// A machine of three motors, a spindle and an input; patient with a computer that does much else.
const MACHINE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n[board]\nx = \"gpio0 gpio1\"\n\
    y = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\noutputs = \"1 gpio20\"\nspindle = \"gpio21\"\nboth_edges = true\n\
    pulse_us = 0.1\ndeadline_s = 2\nwatch_s = 3\n";

const SQUARE: &str =
    "TR,12000\nSO,1,1\nMS,50,10\nJZ,5\nMZ,-2\nMX,25\nMY,25\nMX,0\nMY,0\nSO,1,0\nJZ,5\n";

/// One that lasts longer than the board is silent for.
const LONG: &str = "TR,12000\nSO,1,1\nMS,50,10\nMX,200\nMY,100\nMX,0\nMY,0\nSO,1,0\n";

/// The longest turn of a board that waits for its processor, seconds: the host sends a second ahead at least.
const TURN_S: f64 = 0.5;

/// A board on a port; unplugged when it is dropped.
pub struct Bench {
    board: Arc<Mutex<Board>>,
    pub port: String,
    plugged: Arc<Mutex<bool>>,
    /// Its answers come so much later, seconds.
    late_s: Arc<Mutex<f64>>,
    player: Option<JoinHandle<()>>,
}

impl Bench {
    pub fn new() -> Self {
        let plug = Plug::new().unwrap();
        let mut board = Board::of_seed(1);
        board.records = false;
        let (board, plugged) = (Arc::new(Mutex::new(board)), Arc::new(Mutex::new(true)));
        let port = plug.path().to_owned();
        let late_s = Arc::new(Mutex::new(0.0));
        let (played, until, late) = (board.clone(), plugged.clone(), late_s.clone());
        let player = Some(spawn(move || play(plug, &played, &until, &late)));
        Self { board, port, plugged, late_s, player }
    }

    pub fn look<T>(&self, at: impl FnOnce(&mut Board) -> T) -> T {
        at(&mut self.board.lock().unwrap())
    }

    fn counts(&self) -> Vec<i64> {
        self.look(|board| board.steppers.values().map(|it| it.position).collect())
    }

    pub fn args(&self, words: &str) -> String {
        format!(
            "{words} --machine klipper:{} --machine board.toml --trace t.jsonl --force",
            self.port
        )
    }

    fn run(&self, shop: &Shop, words: &str) -> Did {
        shop.kerf(&self.args(words))
    }
}

impl Drop for Bench {
    fn drop(&mut self) {
        *self.plugged.lock().unwrap() = false;
        if let Some(player) = self.player.take() {
            player.join().unwrap();
        }
    }
}

fn play(mut plug: Plug, board: &Mutex<Board>, plugged: &Mutex<bool>, late_s: &Mutex<f64>) {
    // A real board does not wait for the computer that it hangs on. Where there is no such priority, its clock waits too.
    drop(raise_priority());
    let (since, mut pace, mut bytes) = (Instant::now(), Pace::of_turn(TURN_S), [0; 256]);
    let mut answers = VecDeque::new();
    while *plugged.lock().unwrap() {
        let count = plug.read(&mut bytes, Duration::from_millis(1)).unwrap();
        let out = {
            let mut board = board.lock().unwrap();
            let clock = board.clock_at(pace.at(since.elapsed().as_secs_f64()));
            board.run_to(clock);
            board.feed(&bytes[..count]);
            board.take()
        };
        let now_s = since.elapsed().as_secs_f64();
        answers.push_back((now_s + *late_s.lock().unwrap(), out));
        let due = answers.iter().take_while(|(at_s, _)| *at_s <= now_s).count();
        for (_, out) in answers.drain(..due) {
            plug.write(&out).unwrap();
        }
    }
}

fn shop() -> Shop {
    Shop::new(&[("square.sbp", SQUARE), ("long.sbp", LONG), ("board.toml", MACHINE)])
}

#[test]
fn a_part_file_is_made_to_the_step_and_its_place_is_known_afterwards() {
    let (shop, bench) = (shop(), Bench::new());
    bench
        .run(&shop, "run square.sbp")
        .exits(0)
        .complains("fake-1, motors: 3")
        .says("ran to its end");
    assert_eq!(bench.counts(), [0, 0, 1000]);
    let (reason, off) = bench.look(|board| {
        (board.reason().map(str::to_owned), board.outputs.values().all(|it| it.value == 0))
    });
    assert_eq!((reason, off), (None, true));
    let turned =
        bench.look(|board| board.outputs.values().any(|it| it.made.iter().any(|m| m.1 > 1)));
    assert!(turned, "the spindle had a speed");
    let travelled: usize =
        bench.look(|board| board.steppers.values().map(|it| it.made.len()).sum());
    assert_eq!(travelled, 4 * 2500 + 1000 + 1400 + 1400, "each step of the plan and no other");
}

#[test]
fn what_a_board_lacks_is_told_before_anything_moves() {
    let (shop, bench) = (shop(), Bench::new());
    shop.write("lacks.sbp", b"SO,3,1\nMX,5\n");
    bench.run(&shop, "run lacks.sbp").exits(1).complains("has no output 3, but 1 (spindle)");
    shop.write("board.toml", b"units = \"mm\"\n");
    bench.run(&shop, "run square.sbp").exits(1).complains("names no pins of motors");
    shop.write("board.toml", b"[board]\nx = \"gpio0 gpio99\"\n");
    bench.run(&shop, "run square.sbp").exits(1).complains("gpio99");
    bench.run(&shop, "run square.sbp --home").exits(1).complains("no axis has a home switch");
    assert_eq!(bench.counts(), [0; 3], "nothing has moved");
}

#[test]
fn a_host_that_is_killed_leaves_motors_and_spindle_off_and_the_place_known() {
    let (shop, bench) = (shop(), Bench::new());
    let mut command = shop.command();
    command.args(bench.args("run long.sbp").split_whitespace());
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    crate::shop::until("it moves", || bench.counts().first().is_some_and(|x| *x > 500));
    kill(Pid::from_raw(child.id() as i32), Signal::SIGKILL).unwrap();
    child.wait().unwrap();
    crate::shop::until("the board notices", || bench.look(|board| board.reason().is_some()));
    let counts = bench.counts();
    sleep(Duration::from_millis(300));
    assert_eq!(counts, bench.counts(), "nothing moves any more");
    assert!(bench.look(|board| board.outputs.values().all(|it| it.value == 0)));
    bench.run(&shop, "run square.sbp").exits(1).complains("the board is shut down");
    shop.write("stay.sbp", b"'\n");
    let place =
        format!("stands at {:.3}, {:.3}", counts[0] as f64 / 100.0, counts[1] as f64 / 100.0);
    bench.run(&shop, "run stay.sbp --unlock").complains(&place);
}

#[test]
fn who_a_board_is_is_told_and_nothing_of_it_changes() {
    let (shop, bench) = (shop(), Bench::new());
    let connect = || shop.kerf(&format!("machine connect klipper:{}", bench.port));
    connect().exits(0).says("fake-1").says("none since it was powered").says("gpio0…gpio");
    shop.kerf(&format!("machine connect {}", bench.port))
        .exits(0)
        .says(&format!("klipper:{}", bench.port))
        .says("fake-1, a board with step queues, rp2040");
    assert!(bench.look(|board| board.steppers.is_empty()), "nothing was configured");
    bench.run(&shop, "run square.sbp").exits(0);
    connect().exits(0).says("another one needs a reset");
    bench.look(|board| board.shut("ADC out of range"));
    connect().exits(0).says("shut down");
}

#[test]
fn the_other_boards_of_a_machine_are_shown_with_the_first() {
    let (shop, [main, two]) = (shop(), [Bench::new(), Bench::new()]);
    let others = format!("[board]\nothers = \"two {}\"\n", two.port);
    shop.write("board.toml", MACHINE.replace("[board]\n", &others).as_bytes());
    let connect = format!("machine connect klipper:{} --machine board.toml", main.port);
    shop.kerf(&connect)
        .exits(0)
        .says(&format!("klipper:{}\n", main.port))
        .says(&format!("klipper:{}\n", two.port));
}

#[test]
fn a_board_is_proved_with_its_steps_its_lead_and_its_stops() {
    let (shop, bench) = (shop(), Bench::new());
    let port = &bench.port;
    let prove =
        format!("machine prove --report prove.md --machine klipper:{port} --machine board.toml");
    shop.kerf(&prove)
        .exits(0)
        .says("a stop on the way stands within the plan, outputs off: held")
        .says("steps of X: 20000 planned and made")
        .says("latest step: sent")
        .says("round trip:")
        .says("ms until the board told its counts, longest of 5");
    let report = shop.read("prove.md");
    assert!(report.contains("| a plan is made whole") && report.contains("- lead:"), "{report}");
    let off = || bench.look(|board| board.outputs.values().all(|it| it.value == 0));
    crate::shop::until("outputs are off", off);
}

#[test]
fn a_board_that_loses_a_step_and_answers_late_is_told() {
    let (shop, bench) = (shop(), Bench::new());
    // One on the second way there, one on the way back: at the end the counts would be right.
    bench.look(|board| board.loses = vec![(0, 4_321), (0, 6_543)]);
    *bench.late_s.lock().unwrap() = 0.01;
    let port = &bench.port;
    let prove = format!(
        "machine prove --format json --report prove.md --machine klipper:{port} --machine board.toml"
    );
    let did = shop.kerf(&prove);
    let told: serde_json::Value = serde_json::from_str(did.out().trim()).unwrap();
    did.exits(1);
    let check = |name: &str| {
        let checks = told["checks"].as_array().unwrap();
        checks.iter().find(|check| check["name"] == name).unwrap().clone()
    };
    let saw = |name: &str| check(name)["saw"].as_str().unwrap().to_owned();
    let wrong =
        ["steps of X", "stop without a ramp"].map(|name| check(name)["ok"].as_bool().unwrap());
    assert_eq!((&told["failed"], wrong), (&2.into(), [false; 2]), "{told}");
    assert!(saw("steps of X").contains("motor 0 made 1999 steps, 2000 were planned"), "{told}");
    let first =
        |name: &str| saw(name).split(' ').find_map(|word| word.parse::<f64>().ok()).unwrap();
    assert!(first("round trip") > 10.0 && first("latest step") > 0.0, "{told}");
    assert!(first("lead") > 0.0, "{told}");
    assert!(told["passed"].as_u64().unwrap() > 7, "{told}");
    assert!(
        shop.read("prove.md").contains("- steps of X: WRONG: on way 2 of 5 to 20 mm: klipper:")
    );
}

#[test]
fn two_boards_are_one_machine() {
    let (shop, [main, two]) = (shop(), [Bench::new(), Bench::new()]);
    let file = MACHINE.replace("gpio2 gpio3", "two:gpio0 two:gpio1");
    let with =
        |port: &str| file.replace("[board]\n", &format!("[board]\nothers = \"two {port}\"\n"));
    shop.write("board.toml", with(&two.port).as_bytes());
    main.run(&shop, "run square.sbp").exits(0).complains("motors: 3").says("ran to its end");
    assert_eq!((main.counts(), two.counts()), (vec![0, 1000], vec![0]));
    let travelled = two.look(|board| board.steppers[&0].made.len());
    assert_eq!(travelled, 2 * 2500, "Y is made on the second board");
    let connect = format!("machine connect klipper:{} klipper:{}", main.port, two.port);
    shop.kerf(&connect).exits(0).says(&format!("klipper:{}\n", two.port));
    let prove = format!("machine prove --machine klipper:{} --machine board.toml", main.port);
    shop.kerf(&prove).exits(0).says("steps of X: 20000 planned and made");
    shop.write("board.toml", with(&main.port).as_bytes());
    main.run(&shop, "run square.sbp").exits(1).complains("boards main and two hang on one port");
    shop.write("board.toml", file.as_bytes());
    main.run(&shop, "run square.sbp").exits(1).complains("is on no board that board.others names");
}

/// Answers of somebody who wires X and two motors of Y, a switch and an output.
const ANSWERS: &str =
    "gpio0 gpio1\n^gpio10\ngpio2 gpio3\n-\n-\n-\ny\n-\ngpio4 gpio5\n-\n-\n\n1 gpio20\n\nn\n";

#[test]
fn a_board_is_wired_question_by_question() {
    let (shop, bench) = (shop(), Bench::new());
    shop.write("bare.toml", b"units = \"mm\"\n[steps]\nper_unit = [100, 100, 100, 100, 100, 100]\n[board]\nboth_edges = true\npulse_us = 0.1\ndeadline_s = 2\nwatch_s = 3\n");
    let wire = format!("machine wire klipper:{} --machine bare.toml --into mine.toml", bench.port);
    // X goes the other way, then right; Y goes half as far; the switch is closed while it is left alone.
    bench.look(|board| _ = board.driven.insert(10, vec![(0, true)]));
    // The second motor of Y goes the other way, then right.
    // X is right at its first speed and not at the second, and at two accelerations; Y at no speed.
    let more = "\nn\n\ny\n\n0.5\n\ny\n\nn\n\ny\n\n\nn\n\ny\ny\ny\nn\ny\ny\ny\nn\ny\nn\nn\n";
    shop.kerf_with(&wire, format!("{ANSWERS}{more}").as_bytes())
        .exits(0)
        .says("motor X, step and direction []")
        .says("X goes 1 mm towards plus")
        .says("Nothing changed: look at its pin")
        .says("Output 1 goes on")
        .says("Y goes 1 mm with both motors")
        .says("X: at most 5 mm/s")
        .says("X: at most 100 mm/s²")
        .says("Y: no speed was good, its own is kept")
        .says("written: mine.toml");
    let file = shop.read("mine.toml");
    assert!(
        file.contains("x = \"gpio0 !gpio1\"") && file.contains("y = \"gpio2 gpio3\""),
        "{file}"
    );
    let steps = |axis: u8| bench.look(|board| board.steppers[&axis].made.len());
    let per_unit = kerf_machine::file::read(&"mine.toml".into(), &file).unwrap();
    let [x, y] = [0, 1].map(|n| per_unit.program.resolution.steps_per_unit.0[n]);
    assert!(file.contains("w = \"gpio4 !gpio5\"") && file.contains("y2 = \"w\""), "{file}");
    // Twice 1 mm there and back, and 20 mm for each of two speeds and three accelerations.
    assert_eq!((y / x, steps(0)), (2.0, 204 * x as usize), "Y makes twice the steps a millimetre");
    let speeds = per_unit.program.axis_dynamics().speed_mm_s.0;
    assert!(speeds[0] == 5.0 && speeds[1] != 10.0, "{speeds:?}");
    let on =
        bench.look(|board| board.outputs.values().any(|it| it.made.iter().any(|it| it.1 == 1)));
    assert!(on, "the output was on");
    let off = || bench.look(|board| board.outputs.values().all(|it| it.value == 0));
    crate::shop::until("the output is off", off);
    shop.kerf_with(&wire, ANSWERS.as_bytes()).exits(2).complains("is there already");
}

#[test]
fn a_board_that_is_sold_is_wired_by_its_name() {
    let (shop, bench) = (shop(), Bench::new());
    let wire =
        |name: &str| format!("machine wire klipper:{} --board {name} --into mine.toml", bench.port);
    let pins = "\n\n0.8\n\n\n0.8\n\n\n0.5\n\n\n\n\ny\n\n^gpio25 ^gpio29\nq\n";
    bench.look(|board| board.chips = [0, 2, 1].map(|address| Chip::tmc2209(9, address)).to_vec());
    shop.kerf_with(&wire("skr-pico"), pins.as_bytes())
        .exits(3)
        .says("X, Y, Z are motors X, Y, Z; outputs 1 and up are FAN1")
        .says("motor X, step and direction [gpio11 gpio10]")
        .says("home switch of Z [^gpio25]")
        .says("outputs by number (1 gpio20, 2 gpio21) [1 gpio17, 2 gpio18")
        .says("current of Z while it turns, amperes [0]")
        .says("inputs by number (1 ^gpio22) [1 ^gpio22]")
        .says("switches too high and too low, two pins, - for none []")
        .says("X goes 1 mm");
    let pins =
        bench.look(|board| board.steppers.values().map(|it| it.step_pin).collect::<Vec<_>>());
    assert_eq!(pins, [11, 6, 19]);
    shop.kerf(&wire("skr-3"))
        .exits(1)
        .complains("has the chip rp2040, and the BIGTREETECH SKR 3 has stm32h743");
    shop.kerf(&wire("skr-pic")).exits(2).complains("skr-pico");
    shop.kerf("machine boards").exits(0).says("octopus-1.1").says("8 motors, stm32f446, stm32f407");
    shop.kerf("machine boards skr-pico")
        .exits(0)
        .says("motor Z     step gpio19, direction gpio28")
        .says("probe       gpio22");
}

#[test]
fn motor_drivers_are_set_and_one_that_is_not_well_is_told() {
    let (shop, bench) = (shop(), Bench::new());
    let drivers = "[drivers]\nx = \"tmc2209 gpio40 gpio41 0\"\ny = \"tmc2130 gpio44\"\nspi = \"gpio50 gpio51 gpio52\"\n\
        current_a = [0.8, 0.6, 0, 0, 0, 0]\nmicrosteps = [32, 16, 16, 16, 16, 16]\n";
    shop.write("board.toml", format!("{MACHINE}{drivers}").as_bytes());
    bench
        .run(&shop, "run square.sbp")
        .exits(1)
        .complains("the driver of motor X: the motor driver does not answer");
    assert_eq!(bench.counts(), [0; 3], "nothing has moved");
    bench.look(|board| board.chips = vec![Chip::tmc2209(40, 0), Chip::tmc2130(44)]);
    bench.run(&shop, "run square.sbp").exits(0).says("ran to its end");
    let resolutions = bench
        .look(|board| board.chips.iter().map(|it| it.get(0x6c) >> 24 & 0xf).collect::<Vec<_>>());
    assert_eq!(resolutions, [3, 4], "32 and 16 microsteps");
    bench.look(|board| _ = board.chips[0].registers.insert(0x6f, 0b10));
    bench.run(&shop, "run long.sbp").exits(1).complains("the driver of motor X: it is too hot");
    shop.write("board.toml", format!("{MACHINE}{}", drivers.replace("0.6", "9")).as_bytes());
    bench.run(&shop, "run square.sbp").exits(1).complains("drivers.y: 9 A is beyond its resistors");
}

#[test]
fn wiring_stops_at_each_question_and_writes_nothing() {
    let (shop, bench) = (shop(), Bench::new());
    let wire = format!("machine wire klipper:{} --into mine.toml", bench.port);
    for answers in ["", "q\n", "gpio0 gpio1\nq\n"] {
        shop.kerf_with(&wire, answers.as_bytes()).exits(3).complains("nothing is written");
    }
    let twice = "gpio0 gpio1\n-\ngpio0 gpio3\n-\n-\n-\n\n-\n-\n-\nn\nq\n";
    shop.kerf_with(&wire, twice.as_bytes()).exits(3).says("pin `gpio0` is used twice");
    assert!(!shop.names().contains(&"mine.toml".to_owned()));
    assert!(bench.look(|board| board.steppers.is_empty()), "nothing was configured");
    shop.kerf("machine wire grbl:x").exits(2).complains("is no board");
}

#[test]
fn the_pins_of_a_printer_are_lines_of_a_machine() {
    let shop = shop();
    let printer =
        b"[stepper_x]\nstep_pin: gpio0\ndir_pin: !gpio1\nmicrosteps: 16\nrotation_distance: 32\n\
        [stepper_y]\nstep_pin: gpio2\ndir_pin: gpio3\nendstop_pin: probe:y\n";
    shop.write("printer.cfg", printer);
    shop.kerf("machine import printer.cfg")
        .exits(0)
        .says("x = \"gpio0 !gpio1\"")
        .says("per_unit = [100, ")
        .complains("probe is no pin of this board");
    shop.write("printer.cfg", b"[printer]\n");
    shop.kerf("machine import printer.cfg").exits(1).complains("names no motors");
}
