//! Area `homing`, in runs: axes are homed on the machine, before jobs, and bounds follow.

use kerf_ledger::jobs::{JobRun, JobTrace, t1};
use kerf_machine::lines::Input;
use kerf_machine::settings::homing::{BeforeRuns, HomeEnd};
use kerf_machine::{Configuration, Errand, Held};
use kerf_program::{Axis, AxisSet, Status};
use kerf_trace::Event;

fn axes(letters: &str) -> AxisSet {
    letters.chars().filter_map(Axis::from_letter).fold(AxisSet::EMPTY, AxisSet::with)
}

fn home(letters: &str) -> JobRun {
    JobRun::hand(Errand::FindHome(axes(letters))).unhomed()
}

/// Ends of the motions.
fn ends(trace: &JobTrace) -> Vec<String> {
    trace.moves().iter().map(|made| made.split_once(' ').unwrap().1.to_owned()).collect()
}

/// Distance that an axis goes when a key is held.
fn reach(trace: &JobTrace, axis: usize, way: i8, machine: &dyn Fn(&mut Configuration)) -> f64 {
    let mut ways = [0; 6];
    ways[axis] = way;
    let held = Held { way: ways, speed: 1.0, accel: 1.0, sets_bottom: true };
    JobRun::hand(Errand::Held(held)).with(machine).after(trace).run().rests()[axis]
}

fn high(axis: usize) -> impl Fn(&mut Configuration) {
    move |machine| {
        machine.homing.switches[axis].end = HomeEnd::High;
        machine.simulated.switch_at[axis] = Some(120.0);
    }
}

#[test]
fn pro_homing_xhome__in_a_run() {
    let left = home("x").run();
    assert_eq!(ends(&left), ["x-121.25", "x-118.75", "x-120.002", "x-117"]);
    assert_eq!(left.rests()[0], 0.0);
    assert_eq!((reach(&left, 0, -1, &|_| ()), reach(&left, 0, 1, &|_| ())), (0.0, 2500.0));
    let right = home("x").with(high(0)).run();
    assert_eq!(ends(&right), ["x121.25", "x118.75", "x120.002", "x117"]);
    assert_eq!((reach(&right, 0, -1, &high(0)), reach(&right, 0, 1, &high(0))), (-2500.0, 0.0));
}

#[test]
fn pro_homing_yhome__in_a_run() {
    let front = home("y").run();
    assert_eq!(ends(&front)[0], "y-121.25");
    assert_eq!((reach(&front, 1, -1, &|_| ()), reach(&front, 1, 1, &|_| ())), (0.0, 1250.0));
    let back = home("y").with(high(1)).run();
    assert_eq!(ends(&back)[0], "y121.25");
    assert_eq!((reach(&back, 1, -1, &high(1)), reach(&back, 1, 1, &high(1))), (-1250.0, 0.0));
}

#[test]
fn pro_axes_lengths__in_runs() {
    let all = home("xyz").run();
    let ends = |axis| (reach(&all, axis, -1, &|_| ()), reach(&all, axis, 1, &|_| ()));
    assert_eq!([ends(0), ends(1), ends(2)], [(0.0, 2500.0), (0.0, 1250.0), (-150.0, 0.0)]);
}

#[test]
fn pro_homing_diff() {
    let first = home("x").run();
    let again = home("x").after(&first).run();
    assert_eq!(again.homed(), ["x 0 steps"]);
    let moved = |machine: &mut Configuration| machine.simulated.switch_at[0] = Some(-120.0 + 0.012);
    assert_eq!(home("x").with(moved).after(&again).run().homed(), ["x 3 steps"]);
}

/// The axes that were homed, in order.
fn order(trace: &JobTrace) -> String {
    trace.homed().iter().filter_map(|told| told.chars().next()).collect()
}

fn at_start(program: &str, job: &str) -> JobRun {
    JobRun::new(t1()).unhomed().with(|machine| {
        machine.homing.at_program_start = axes(program);
        machine.homing.at_job_start = axes(job);
    })
}

#[test]
fn pro_homing_auto_program() {
    let trace = at_start("xyz", "").run();
    assert_eq!(order(&trace), "zxy");
    assert_eq!(trace.summary.status, Status::Ok);
    let first = trace.events.iter().position(|e| matches!(e, Event::Homed { .. })).unwrap();
    let cut = trace.events.iter().position(|e| matches!(e, Event::Output { .. })).unwrap();
    assert!(first < cut, "before the job");
    let again = at_start("xyz", "").after(&trace).run();
    assert_eq!(order(&again), "", "once a program start");
}

#[test]
fn pro_homing_auto_job() {
    let trace = at_start("", "z").run();
    assert_eq!(order(&trace), "z");
    assert_eq!(order(&at_start("", "z").after(&trace).run()), "z", "at each start");
    assert_eq!(order(&at_start("", "").run()), "");
}

/// Homing before a job is part of one run: it begins and ends once, and its input is told.
#[test]
fn pro_homing_auto_job__is_one_run() {
    let pressed = |run: JobRun| run.input(Input::EndBottomDelay, 0.5, true);
    let trace = pressed(at_start("", "z")).run();
    let count = |wanted: &dyn Fn(&Event) -> bool| trace.events.iter().filter(|e| wanted(e)).count();
    assert_eq!(count(&|e| matches!(e, Event::Start { dialect, .. } if *dialect == "job")), 1);
    assert_eq!(
        [count(&|e| matches!(e, Event::Start { .. })), count(&|e| matches!(e, Event::End(_)))],
        [1; 2]
    );
    assert_eq!(
        count(&|e| matches!(e, Event::Input { n, .. } if *n == Input::EndBottomDelay.number())),
        1
    );
    let begins = |shown: &String| shown.split('-').next().and_then(|t| t.parse::<f64>().ok());
    let times: Vec<f64> = trace.moves().iter().filter_map(begins).collect();
    assert!(times.is_sorted(), "{times:?}");
    let Some(Event::End(end)) = trace.events.last() else { panic!("no end") };
    assert_eq!((end.moves as usize, end.t), (times.len(), trace.summary.seconds));
    let alone = at_start("", "").run().summary.seconds;
    assert!(end.t > alone + 0.5, "{} is not longer than {alone}", end.t);
    let on = pressed(at_start("", "z")).signals().on("end_bottom_delay");
    assert_eq!(on, [(500, u64::MAX)]);
}

#[test]
fn pro_homing_auto_program__is_one_run() {
    let trace = at_start("xyz", "").run();
    let told = |e: &&Event| matches!(e, Event::Start { .. } | Event::End(_));
    assert_eq!(trace.events.iter().filter(told).count(), 2);
    let time = |event: &Event| match event {
        Event::Homed { t, .. } => Some(*t),
        Event::Output { t, .. } => Some(*t),
        _ => None,
    };
    let times: Vec<f64> = trace.events.iter().filter_map(time).collect();
    assert!(times.is_sorted() && times[0] > 1.0, "{times:?}");
}

#[test]
fn pro_homing_auto_job__before_it_waits() {
    let twice = at_start("", "z").with(|machine| machine.misc.double_start = true);
    let trace = twice.say("start").run();
    let place = |wanted: &dyn Fn(&Event) -> bool| trace.events.iter().position(wanted).unwrap();
    let homed = place(&|event| matches!(event, Event::Homed { axis, .. } if *axis == "z"));
    let waits = place(
        &|event| matches!(event, Event::State { state, .. } if state.to_string() == "waiting"),
    );
    assert!(homed < waits, "{:?}", trace.states());
    assert_eq!(order(&trace), "z");
}

#[test]
fn pro_homing_pair__steps_of_one_motor_alone() {
    let run = || {
        home("x").with(|machine| {
            machine.motors.x2 = Some(kerf_machine::settings::motors::FreeMotor::Q);
            machine.homing.separate_x = true;
            machine.simulated.switch_at[4] = Some(-119.6);
        })
    };
    let moves = run().run().moves();
    assert_eq!(moves.len(), 12, "four legs together, four of each alone");
    let begins = |leg: usize| moves[leg].split('-').next().and_then(|t| t.parse::<f64>().ok());
    let [first_ms, second_ms] = [4, 8].map(|leg| (begins(leg).expect("a time") * 1e3) as u64);
    let signals = run().signals();
    let stepped = |motor: &str| {
        let mut rounds = [false; 3];
        for (t_ms, level) in signals.changes(&format!("{motor}step")) {
            let round = usize::from(t_ms > first_ms) + usize::from(t_ms > second_ms);
            rounds[round] |= level == "1";
        }
        rounds
    };
    assert_eq!((stepped("x"), stepped("q")), ([true, true, false], [true, false, true]));
}

#[test]
fn a_home_that_was_found_makes_no_steps_of_its_own() {
    let signals = at_start("x", "").signals();
    let made = signals.changes("xstep").into_iter().filter(|(_, level)| level == "1").count();
    // To the switch and beyond, back, once more, to the new home; 100 mm there and back.
    let mm = 121.25 + 2.5 + 1.252 + 3.002 + 200.0;
    assert!((made as f64 - mm * 250.0).abs() < 10.0, "{made} steps for {mm} mm");
}

#[test]
fn pro_misc_autohome() {
    let both = at_start("xyz", "z").run();
    assert_eq!(order(&both), "zxy");
    assert_eq!(order(&at_start("xyz", "z").after(&both).run()), "z");
    let fresh = Configuration::default().homing;
    assert!(fresh.at_program_start.is_empty() && fresh.at_job_start.is_empty());
}

#[test]
fn pro_options_home_program() {
    assert_eq!(order(&at_start("xz", "").run()), "zx");
}

#[test]
fn pro_options_home_job() {
    assert_eq!(order(&at_start("", "z").run()), "z");
    assert_eq!(order(&at_start("", "").run()), "");
}

#[test]
fn pro_homing_first() {
    let unhomed = JobRun::new(t1()).unhomed().run();
    assert_eq!(unhomed.messages()[0], "not homed: x, y, z");
    let homed = home("xz").run();
    assert_eq!(homed.session.homed, axes("xz"));
    assert_eq!(JobRun::new(t1()).after(&homed).run().messages()[0], "not homed: y");
    let all = home("y").after(&homed).run();
    assert_eq!(JobRun::new(t1()).after(&all).run().messages(), [""; 0]);
}

#[test]
fn a_run_may_need_homing() {
    let set = |how| move |machine: &mut Configuration| machine.homing.before_runs = how;
    let refused = JobRun::new(t1()).unhomed().with(set(BeforeRuns::Refuse)).run();
    assert_eq!(
        (refused.refused(), refused.moves().len()),
        ("x, y, z must be homed first".into(), 0)
    );
    let asked = |say: &str| JobRun::new(t1()).unhomed().with(set(BeforeRuns::Ask)).say(say).run();
    assert_eq!(asked("msgbox=Cancel").summary.status, Status::Stopped);
    assert_eq!(asked("msgbox=No").summary.status, Status::Ok);
    let yes = asked("msgbox=Yes");
    assert_eq!((order(&yes), yes.summary.status), ("zxy".into(), Status::Ok));
}

#[test]
fn a_switch_that_does_not_come_is_told_and_nothing_follows() {
    let broken = |machine: &mut Configuration| machine.simulated.switch_at[0] = None;
    let trace = at_start("xyz", "").with(broken).run();
    assert_eq!(
        (trace.refused(), trace.summary.status),
        ("x home not found".into(), Status::Failed)
    );
    assert_eq!(order(&trace), "z", "what was found before is homed");
    assert_eq!(trace.session.homed, axes("z"));
    assert_eq!(trace.edges(), [""; 0]);
}

#[test]
fn homing_can_be_stopped() {
    let trace = home("x").stop(1.0).run();
    assert_eq!((trace.summary.status, order(&trace)), (Status::Stopped, String::new()));
    assert!(trace.session.homed.is_empty());
}

/// The states of a line during the homing of an axis.
fn line(letters: &str, n: u8, machine: &dyn Fn(&mut Configuration)) -> Vec<bool> {
    let trace = home(letters).with(machine).run();
    let told = |event: &Event| match event {
        Event::Input { n: number, on, .. } if *number == n => Some(*on),
        _ => None,
    };
    trace.events.iter().filter_map(told).collect()
}

/// On at the switch, off on the way back, on and off again at the slow search.
const PRESSED: [bool; 4] = [true, false, true, false];

#[test]
fn pro_io_ina0() {
    assert_eq!(line("z", kerf_machine::lines::Input::ZHome.number(), &|_| ()), PRESSED);
    let second = |machine: &mut Configuration| {
        machine.motors.z2 = Some(kerf_machine::settings::motors::FreeMotor::Q);
        machine.homing.switches[3] = machine.homing.switches[2];
        machine.simulated.switch_at[4] = Some(5.0);
    };
    assert_eq!(line("a", kerf_machine::lines::Input::ZHome.number(), &second), PRESSED);
}

#[test]
fn pro_io_ina2() {
    assert_eq!(line("x", kerf_machine::lines::Input::XHome.number(), &|_| ()), PRESSED);
}

#[test]
fn pro_io_ina3() {
    assert_eq!(line("y", kerf_machine::lines::Input::YHome.number(), &|_| ()), PRESSED);
}

#[test]
fn two_motors_of_an_axis_are_homed_apart_in_a_run() {
    let pair = |machine: &mut Configuration| {
        machine.motors.w = None;
        machine.motors.x2 = Some(kerf_machine::settings::motors::FreeMotor::R);
        machine.homing.separate_x = true;
        machine.simulated.switch_at[5] = Some(-119.5);
    };
    let trace = home("x").with(pair).run();
    assert_eq!(trace.homed().len(), 3, "together, then each alone: {:?}", trace.homed());
    let truth = trace.session.truth()[0].clone();
    assert!((truth[0] + 117.0).abs() < 0.01 && (truth[1] + 116.5).abs() < 0.01, "{truth:?}");
}

#[test]
fn pro_job_origin_saved__after_power_up_elsewhere() {
    // Wherever the machine was switched on: homed, it cuts at the same place of the table.
    let ends_at = |start: [f64; 2]| {
        let trace = JobRun::new(kerf_ledger::jobs::t1())
            .unhomed()
            .with(|machine| {
                machine.simulated.start_at[..2].copy_from_slice(&start);
                machine.homing.at_job_start = AxisSet::first(2);
            })
            .job(|job| job.origin = Some(kerf_geom::Point2::new(300.0, 200.0)))
            .run();
        assert_eq!(trace.rests()[..2], [300.0, 200.0]);
        [trace.session.truth()[0][0], trace.session.truth()[1][0]]
    };
    let (one, other) = (ends_at([500.0, 300.0]), ends_at([40.0, 700.0]));
    let apart = one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart <= 0.004 + 1e-9, "{one:?} {other:?}: more than a step");
}
