//! Area `console`: functions that move the machine, and those of its heights.

use kerf_ledger::hand_console::HandConsole;
use kerf_ledger::jobs::t1;
use kerf_machine::settings::motors::FreeMotor;
use kerf_program::{Axis, AxisSet};

/// Ends of the motions of the last functions.
fn ends(console: &HandConsole) -> Vec<&str> {
    console.moves.iter().filter_map(|made| made.split_once(' ')).map(|(_, end)| end).collect()
}

/// With the job origin at (300,200).
fn placed(x: f64, y: f64, z: f64) -> HandConsole {
    HandConsole::at(x, y, z).with(|machine| {
        (machine.job.origin_mm, machine.job.finish_mm) = ([300.0, 200.0], [25.0, 20.0]);
    })
}

#[test]
fn pro_console_f2() {
    let mut console = HandConsole::default();
    console.press("Func 2 Enter");
    assert_eq!(console.shows(), ["ZTop: move, Enter", "z -10"]);
    // 12.5 mm/s: 2 mm in 0.16 s.
    console.hold(0, 0.16);
    assert_eq!(console.shows()[1], "z -12");
    console.press("Enter");
    assert_eq!(console.shows(), ["ZSurface: move,Enter", "z -20"]);
    console.hold(0, 0.08);
    console.press("Enter");
    assert_eq!(console.shows(), ["ZBottom: move, Enter", "z -30"]);
    console.hold(0, 0.08);
    assert_eq!(console.machine.zpos.top_mm, -10.0, "nothing is set before all three are known");
    console.press("Enter");
    let z = console.machine.zpos;
    assert_eq!([z.top_mm, z.surface_mm, z.bottom_mm], [-12.0, -21.0, -31.0]);
    assert_eq!(console.found, [""; 0]);
    let travels = console.run(t1()).moves();
    assert!(travels[1].ends_with(" z-12"), "{travels:?}");
    // Homed first where jobs are.
    let home = |machine: &mut kerf_machine::Configuration| {
        machine.homing.at_job_start = AxisSet::EMPTY.with(Axis::Z);
    };
    let mut homed = HandConsole::default().with(home);
    homed.press("Func 2 Enter");
    assert_eq!((homed.found.len(), homed.position()[2]), (1, -10.0));
}

#[test]
fn heights_out_of_order_are_refused_and_the_last_is_asked_for_again() {
    let mut console = HandConsole::default();
    console.press("Func 2 Enter Enter Enter");
    // Up to -18.75, above the surface.
    console.hold(5, 0.9);
    let beeps = console.beeps();
    console.press("Enter");
    assert_eq!(console.shows(), ["order: ZTop,", "ZSurface, ZBottom"]);
    assert_eq!((console.beeps(), console.machine.zpos.bottom_mm), (beeps + 1, -30.0));
}

#[test]
fn pro_console_f3() {
    let mut console = HandConsole::default();
    console.press("Func 3 Enter -0.5 Enter");
    assert_eq!(console.shows(), ["ZBottom adjust", "ZBottom -30.5"]);
    assert!(console.run(t1()).moves().iter().any(|made| made.ends_with(" z-30.5")));
    console.press("Enter Func 3 Enter 0.5 Enter");
    assert_eq!(console.machine.zpos.bottom_mm, -30.0);
    console.press("Enter Func 3 Enter 11 Enter");
    assert_eq!(console.shows(), ["order: ZTop,", "ZSurface, ZBottom"]);
    console.press("Enter Func 3 Enter -121 Enter");
    assert_eq!(console.shows()[0], "below the travel of");
    assert_eq!(console.machine.zpos.bottom_mm, -30.0);
}

#[test]
fn pro_console_f4() {
    let mut console = placed(0.0, 0.0, -25.0);
    console.press("Func 4 Enter");
    assert_eq!(console.position(), [300.0, 200.0, -10.0]);
    assert_eq!(console.shows()[0], "JOB: Untitled");
}

#[test]
fn pro_console_f5() {
    let mut console = placed(0.0, 0.0, -25.0);
    console.press("Func 5 Enter");
    assert_eq!(console.position(), [325.0, 220.0, -10.0]);
}

#[test]
fn pro_console_f6() {
    let mut console = HandConsole::at(100.0, 100.0, -10.0);
    console.press("Func 6 Enter");
    assert_eq!(console.shows(), ["Move by x mm:", "0"]);
    console.press("10 Enter -5 Enter 0 Enter");
    assert_eq!(console.position(), [110.0, 95.0, -10.0]);
    // Enter alone stays there; z rises before x and y move, and sinks behind them.
    console.press("Func 6 Enter 1 Enter Enter 5 Enter Func 6 Enter 1 Enter Enter -5 Enter");
    assert_eq!(ends(&console), ["x110 y95", "z-5", "x111", "x112", "z-10"]);
}

#[test]
fn a_move_out_of_bounds_is_refused() {
    let mut console = HandConsole::at(100.0, 100.0, -10.0);
    console.press("Func 6 Enter -101 Enter Enter Enter");
    assert_eq!(console.shows(), ["Out of bounds: x", "would reach -1.000"]);
    assert_eq!((console.position(), console.beeps()), ([100.0, 100.0, -10.0], 1));
}

#[test]
fn pro_console_f20() {
    let mut console = HandConsole::at(500.0, 300.0, -25.0);
    console.press("Func 20 Enter");
    assert_eq!((console.position(), ends(&console)), ([0.0; 3], vec!["z0", "x0 y0"]));
}

#[test]
fn pro_console_f21() {
    let mut console = placed(320.0, 200.0, -10.0);
    console.press("Func 21 Enter");
    assert_eq!(console.shows(), ["Move to x mm:", "20"], "from the origin");
    console.press("10 Enter 20 Enter -5 Enter");
    assert_eq!(console.position(), [310.0, 220.0, -5.0]);
    assert_eq!(ends(&console), ["z-5", "x310 y220"]);
}

#[test]
fn pro_console_f50() {
    let find = |tangential: bool, fitted: bool| {
        let mut console = HandConsole::default().unhomed().with(|machine| {
            machine.misc.tangential = tangential;
            machine.homing.switches[5].fitted = fitted;
            machine.simulated.switch_at[3] = Some(5.0);
        });
        console.press("Func 50 Enter");
        console
    };
    let z = find(false, true);
    // Steps 1 to 5 up at the switch, which is at 5.
    let steps = ends(&z).iter().all(|end| end.starts_with('z'));
    assert_eq!((steps, ends(&z).len(), z.found.len()), (true, 4, 1), "{:?}", z.moves);
    let axes = |console: &HandConsole| -> String {
        console.found.iter().filter_map(|told| told.chars().next()).collect()
    };
    assert_eq!(
        (axes(&z), axes(&find(true, false)), axes(&find(true, true))),
        ("z".into(), "z".into(), "zw".into())
    );
    let mut none = HandConsole::default().with(|machine| machine.homing.switches[2].fitted = false);
    none.press("Func 50 Enter");
    assert_eq!((none.shows()[0].as_str(), none.beeps()), ("no z home switch", 1));
}

#[test]
fn pro_console_f51() {
    let mut console = HandConsole::at(500.0, 300.0, -25.0);
    console.press("Func 51 Enter");
    assert_eq!(ends(&console)[0], "z-10", "up first");
    let order: String = console.found.iter().filter_map(|told| told.chars().next()).collect();
    assert_eq!((order.as_str(), console.position()), ("xy", [0.0, 0.0, -10.0]));
    let mut high = HandConsole::at(500.0, 300.0, -5.0);
    high.press("Func 51 Enter");
    assert_eq!(high.position(), [0.0, 0.0, -5.0]);
}

#[test]
fn a_function_that_finds_no_switch_says_so() {
    let broken = |machine: &mut kerf_machine::Configuration| machine.simulated.switch_at[0] = None;
    let mut console = HandConsole::default().unhomed().with(broken);
    console.press("Func 51 Enter");
    assert_eq!((console.shows()[0].as_str(), console.beeps()), ("x home not found", 1));
}

#[test]
fn a_second_head_is_moved_home_as_well() {
    let z2 = |machine: &mut kerf_machine::Configuration| machine.motors.z2 = Some(FreeMotor::Q);
    let mut console = HandConsole::at(10.0, 0.0, -5.0).with(z2);
    console.press("Func 20 Enter");
    assert_eq!(console.position(), [0.0; 3]);
}
