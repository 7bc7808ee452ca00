//! Area `console`: functions that set something, and what the machine does then.

use kerf_geom::{Point2, Polyarc, Vertex};
use kerf_handconsole::{Console, ConsoleRequest, Key, View};
use kerf_ledger::hand_console::HandConsole;
use kerf_ledger::jobs::{JobRun, job, line, t1, t2};
use kerf_machine::settings::delays::BottomDelayType;
use kerf_machine::settings::motors::FreeMotor;
use kerf_program::job::JobShape;
use kerf_program::{Axis, AxisSet};
use kerf_wire::State;

/// Presses keys on SIM; gives the console.
fn pressed(keys: &str) -> HandConsole {
    let mut console = HandConsole::default();
    console.press(keys);
    console
}

/// A value that is refused: what is said, and that there is a beep.
#[track_caller]
fn refuses(keys: &str, says: &str) {
    let mut console = HandConsole::default();
    let (machine, beeps) = (console.machine.clone(), console.beeps());
    console.press(keys);
    let [top, bottom] = console.shows();
    assert!(top.len() <= 20 && bottom.len() <= 20, "{top} {bottom}");
    assert_eq!(format!("{top} {bottom}").trim(), says, "{keys}");
    assert_eq!(console.beeps(), beeps + 1, "{keys}");
    assert_eq!(console.machine, machine, "nothing is set");
}

#[test]
fn pro_console_f0() {
    let mut console = pressed("Func 0 Enter");
    assert_eq!(console.shows(), ["Cut speed mm/min:", "6000"], "the old value first");
    console.press("3000 Enter");
    assert_eq!(console.run(t1()).cutting_speeds(), [50.0]);
    console.press("Func 0 Enter");
    assert_eq!(console.shows()[1], "3000");
    refuses("Func 0 Enter 12001 Enter", "at most 12000 mm/min");
    refuses("Func 0 Enter 0 Enter", "greater than 0");
    assert_eq!(pressed("Func 0 Enter 12000 Enter").run(t1()).cutting_speeds(), [200.0]);
}

#[test]
fn pro_console_f1() {
    let moves = |console: &mut HandConsole| console.run(t1()).moves();
    let mut console = pressed("Func 1 Enter 600 Enter");
    // 20 mm down at 10 mm/s and 500 mm/s².
    assert!(moves(&mut console).contains(&"2.800-4.820 z-30".into()), "{:?}", moves(&mut console));
    assert!(moves(&mut HandConsole::default()).contains(&"2.800-3.840 z-30".into()));
    refuses("Func 1 Enter 3001 Enter", "at most 3000 mm/min");
}

#[test]
fn pro_console_f17() {
    let console = pressed("Func 17 Enter 0.04 Enter");
    assert_eq!(console.shows(), ["HC scale", "Suggested K 10"]);
    let height = console.machine.height;
    assert_eq!((height.scale_mm, height.k), (0.04, 20.0), "K itself stays");
    refuses("Func 17 Enter 0 Enter", "greater than 0");
}

/// The set points of X and Y.
fn points(console: &HandConsole) -> (u8, u8) {
    (console.machine.height.x_set_point, console.machine.height.y_set_point)
}

#[test]
fn pro_console_f18() {
    assert_eq!(points(&pressed("Func 18 Enter 160 Enter")), (160, 160));
    refuses("Func 18 Enter 256 Enter", "0 to 255");
    refuses("Func 18 Enter -1 Enter", "0 to 255");
    refuses("Func 18 Enter 1.5 Enter", "a whole number");
}

#[test]
fn pro_console_f18_1() {
    assert_eq!(points(&pressed("Func 18.1 Enter 155 Enter")), (155, 150));
}

#[test]
fn pro_console_f18_2() {
    assert_eq!(points(&pressed("Func 18.2 Enter 170 Enter")), (150, 170));
}

#[test]
fn pro_console_f19() {
    let console = pressed("Func 19 Enter 0.38 Enter");
    assert_eq!((points(&console), &*console.shows()[1]), ((160, 160), "X 160 Y 160"));
    let mut held = pressed("Func 19 Enter 99 Enter");
    assert_eq!(
        (points(&held), held.shows()),
        ((255, 255), ["XY adjust mm", "X 255 Y 255 (limit)"].map(str::to_owned))
    );
    held.press("Enter Func 19 Enter -99 Enter");
    assert_eq!(points(&held), (0, 0));
}

#[test]
fn pro_console_f19_1() {
    assert_eq!(points(&pressed("Func 19.1 Enter -0.38 Enter")), (140, 150));
}

#[test]
fn pro_console_f19_2() {
    assert_eq!(points(&pressed("Func 19.2 Enter 0.19 Enter")), (150, 155));
}

#[test]
fn pro_console_f23() {
    let homed = |keys: &str| {
        let mut console = HandConsole::default().unhomed().with(|machine| {
            machine.motors.z2 = Some(FreeMotor::Q);
            machine.homing.switches[3] = machine.homing.switches[2];
            machine.homing.at_job_start = AxisSet::EMPTY.with(Axis::Z).with(Axis::A);
            machine.simulated.switch_at[4] = machine.simulated.switch_at[2];
        });
        console.press(keys);
        let trace = console.run(job([line(1, (0.0, 0.0), (2.0, 0.0))]));
        trace.session.truth()[3][0]
    };
    let lower = homed("Enter") - homed("Func 23 Enter -0.35 Enter");
    assert!((lower - 0.35).abs() < 0.005, "at the next homing of z2: {lower}");
}

#[test]
fn pro_console_f30() {
    let starts = |console: &mut HandConsole| {
        let moves = console.run(t1()).moves();
        moves.into_iter().find(|made| made.ends_with(" x100")).unwrap()
    };
    assert!(starts(&mut HandConsole::default()).starts_with("4.840-"));
    assert!(starts(&mut pressed("Func 30 Enter 1.5 Enter")).starts_with("5.340-"));
    refuses("Func 30 Enter -1 Enter", "0 to 3600");
}

#[test]
fn pro_console_f31() {
    let kind = |keys: &str| pressed(keys).machine.delays.bottom_type;
    assert_eq!(kind("Func 31 Enter 1 Enter"), BottomDelayType::Input);
    assert_eq!(kind("Func 31 Enter 1 Enter Func 31 Enter 0 Enter"), BottomDelayType::Time);
    assert_eq!(pressed("Func 31 Enter").shows(), ["By input 1 yes 0 no:", "0"]);
    refuses("Func 31 Enter 2 Enter", "0 or 1");
    // No input comes: the job pauses.
    let states = pressed("Func 31 Enter 1 Enter").run(t1()).states();
    assert!(states.contains(&"14.340 paused: no end-of-bottom-delay input".into()), "{states:?}");
}

#[test]
fn pro_console_f32() {
    let paused_at = |keys: &str| {
        let console = pressed(keys);
        let run = kerf_ledger::jobs::JobRun::new(t1()).stop(5.34);
        run.with(|machine| *machine = console.machine.clone()).run().rests()[2]
    };
    assert_eq!(paused_at("Func 32 Enter 0 Enter"), -30.0);
    assert_eq!(paused_at("Func 32 Enter 0 Enter Func 32 Enter 1 Enter"), -10.0);
    refuses("Func 32 Enter 2 Enter", "0 or 1");
}

#[test]
fn pro_console_f34() {
    let ends = |keys: &str| {
        let mut console = HandConsole::at(50.0, 60.0, 0.0);
        console.press(keys);
        let trace = console.run(t1());
        let cut = trace.moves().into_iter().find(|made| made.contains(" x")).unwrap();
        (cut.split_once(' ').unwrap().1.to_owned(), trace.rests())
    };
    assert_eq!(ends("Func 34 Enter 1 Enter"), ("x100".into(), [50.0, 60.0, -10.0]));
    assert_eq!(ends("Func 34 Enter 0 Enter"), ("x0 y0".into(), [0.0, 0.0, -10.0]));
    refuses("Func 34 Enter 2 Enter", "0 or 1");
}

#[test]
fn pro_console_f38() {
    let key = |digit: u8, z: f64| {
        let mut console = HandConsole::at(500.0, 500.0, z);
        console.press("Func 38 Enter 25 Enter");
        console.hold(digit, 1.0).moves()
    };
    // 50 mm/s, and 12.5: so far in a second and the ramp.
    assert_eq!(key(6, 0.0), ["0.000-1.050 x550"]);
    assert_eq!(key(5, -25.0), ["0.000-1.025 z-12.5"]);
    let mut slow = HandConsole::at(500.0, 0.0, 0.0);
    slow.press("Func 38 Enter 50 Enter");
    assert_eq!(slow.hold(6, 1.0).moves(), ["0.000-1.100 x600"]);
    refuses("Func 38 Enter 0 Enter", "1 to 100");
    refuses("Func 38 Enter 101 Enter", "1 to 100");
}

#[test]
fn pro_console_f39() {
    let key = |digit: u8, z: f64| {
        let mut console = HandConsole::at(500.0, 500.0, z);
        console.press("Func 39 Enter 50 Enter");
        console.hold(digit, 1.0).moves()
    };
    // 500 mm/s² take 0.1 s to 50 mm/s, 250 take 0.05 s to 12.5.
    assert_eq!(key(6, 0.0), ["0.000-1.100 x550"]);
    assert_eq!(key(5, -25.0), ["0.000-1.050 z-12.5"]);
    refuses("Func 39 Enter 0 Enter", "1 to 100");
    refuses("Func 39 Enter 101 Enter", "1 to 100");
}

/// A circle of 20 mm about (20,30), as fast as the axes go otherwise.
fn circle() -> JobShape {
    let half = |x: f64| Vertex { at: Point2::new(x, 30.0), bulge: 1.0 };
    JobShape::through(1, Polyarc { vertices: vec![half(0.0), half(40.0)], closed: true })
}

#[test]
fn pro_console_f40() {
    let seconds = |keys: &str| {
        let mut console = pressed(keys);
        let at = console.run(job([circle()])).moves();
        let cuts = at.iter().filter(|made| made.contains(" x40") || made.contains(" x0"));
        let spans: Vec<f64> = cuts
            .filter_map(|made| made.split(' ').next()?.split_once('-'))
            .map(|(from, to)| to.parse::<f64>().unwrap() - from.parse::<f64>().unwrap())
            .collect();
        spans.iter().sum::<f64>()
    };
    let round = 40.0 * std::f64::consts::PI;
    // 100 mm/s; 141.421 without the function. Both with a ramp at each end.
    let half = seconds("Func 0 Enter 12000 Enter Func 40 Enter 50 Enter");
    assert!((half - (round / 100.0 + 0.1)).abs() < 0.003, "{half}");
    let whole = seconds("Func 0 Enter 12000 Enter");
    assert!((whole - (round / 141.421 + 0.141)).abs() < 0.003, "{whole}");
    refuses("Func 40 Enter 0 Enter", "1 to 100");
    refuses("Func 40 Enter 101 Enter", "1 to 100");
}

#[test]
fn pro_console_f61() {
    let mut console = pressed("Func 61 Enter 3 Enter");
    assert_eq!(console.run(t2()).messages(), ["2 of 3", "3 of 3"]);
    refuses("Func 61 Enter 0 Enter", "1 to 4294967295");
}

#[test]
fn pro_console_f100_2() {
    let seconds = |keys: &str, to: (f64, f64)| {
        let trace = pressed(keys).run(job([line(1, (0.0, 0.0), to)]));
        let moves = trace.moves();
        let cut = moves.iter().find(|made| made.starts_with("4.840-")).unwrap();
        let (from, to) = cut.split(' ').next().unwrap().split_once('-').unwrap();
        ((to.parse::<f64>().unwrap() - from.parse::<f64>().unwrap()) * 1e3).round() / 1e3
    };
    let set = "Func 100.2 Enter 0.8 Enter";
    // 80 mm/s along y, 100 along x, with a ramp at each end.
    assert_eq!((seconds(set, (0.0, 100.0)), seconds(set, (100.0, 0.0))), (1.33, 1.1));
    assert_eq!(seconds("Enter", (0.0, 100.0)), 1.1);
    refuses("Func 100.2 Enter 0 Enter", "greater than 0");
    refuses("Func 100.2 Enter -1 Enter", "greater than 0");
}

#[test]
fn pro_console_stop__stands_where_it_slowed_down_to() {
    let running = View { state: State::Running, shape: 1, ..View::default() };
    let requests = Console::default().press(Key::Stop, &running);
    assert_eq!(requests, [ConsoleRequest::Stop]);
    let paused = requests.iter().fold(JobRun::new(t1()), |run, _| run.stop(5.34)).run();
    assert!(paused.moves().contains(&"4.840-5.440 x50".into()), "{:?}", paused.moves());
    // It stands, then rises.
    assert!(paused.states().contains(&"5.940 paused".into()), "{:?}", paused.states());
}
