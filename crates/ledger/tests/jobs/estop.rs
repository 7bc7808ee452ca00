//! Area `estop`: the emergency stop in jobs.

use kerf_ledger::jobs::{JobRun, JobTrace, t1};
use kerf_machine::lines::Input;
use kerf_machine::settings::delays::BottomDelayType;
use kerf_machine::wiring::bit;

/// JOB-T1 with the emergency stop at a time.
fn stopped(at_s: f64) -> JobTrace {
    JobRun::new(t1()).input(Input::EmergencyStop, at_s, true).run()
}

/// The tool stood where it slowed down to.
fn stands_at_50(trace: &JobTrace) {
    assert!(trace.moves().contains(&"4.840-5.440 x50".into()), "{:?}", trace.moves());
}

#[test]
fn pro_estop_trigger__in_jobs() {
    assert_eq!(stopped(0.15).moves()[0], "0.000-0.250 z-7.5");
    assert!(stopped(1.0).edges().contains(&"1.000 router-".into()));
    assert_eq!(stopped(3.0).moves()[1], "2.800-3.040 z-14");
    stands_at_50(&stopped(5.34));
}

#[test]
fn pro_estop_decel() {
    stands_at_50(&stopped(5.34));
}

#[test]
fn pro_estop_outputs() {
    let edges = stopped(5.34).edges();
    assert_eq!(
        edges[edges.len() - 4..],
        ["5.340 cut1-", "5.440 tool1-", "5.440 router-", "5.440 job_running-"]
    );
}

#[test]
fn pro_estop_raise() {
    assert!(stopped(5.34).moves().contains(&"5.440-5.940 z-10".into()));
    let down = JobRun::new(t1()).with(|machine| machine.pause.raise = false);
    assert_eq!(down.input(Input::EmergencyStop, 5.34, true).run().rests(), [50.0, 0.0, -30.0]);
}

/// A wire that breaks: the input was 1 and goes to 0.
fn wire_breaks() -> JobTrace {
    let run = JobRun::new(t1()).with(|machine| machine.estop.active = false);
    run.input(Input::EmergencyStop, 5.34, false).run()
}

#[test]
fn pro_estop_level() {
    stands_at_50(&wire_breaks());
}

#[test]
fn pro_io_ina6() {
    stands_at_50(&stopped(5.34));
    stands_at_50(&wire_breaks());
}

#[test]
fn pro_estop_stopname() {
    for name in ["stop", "estop", "in.stop"] {
        assert_eq!(Input::named(name), Some(Input::EmergencyStop), "{name}");
        assert_eq!(bit(name).unwrap().1.address(), "A6", "{name}");
    }
}

#[test]
fn pro_io_pci_i_stop() {
    stands_at_50(&stopped(5.34));
}

#[test]
fn pro_io_io_in_stop() {
    stands_at_50(&stopped(5.34));
}

#[test]
fn pro_io_ina5() {
    let waits = || {
        JobRun::new(t1()).with(|machine| {
            machine.delays.bottom_type = BottomDelayType::Input;
            machine.delays.bottom_s = 0.2;
        })
    };
    let during = waits().input(Input::EndBottomDelay, 4.64, true).run();
    assert!(during.moves().contains(&"4.840-5.940 x100".into()));
    let before = waits().input(Input::EndBottomDelay, 3.0, true).run();
    assert!(before.moves().contains(&"4.040-5.140 x100".into()));
}

#[test]
fn pro_estop_operator() {
    let run = |words: &str| {
        let pressed = JobRun::new(t1()).input(Input::EmergencyStop, 5.34, true);
        pressed.input(Input::EmergencyStop, 6.2, false).say(words).run()
    };
    let trace = run("move x 10 ⏎ continue ⏎ continue ⏎ continue");
    let states: Vec<String> =
        trace.states().iter().map(|state| state.split_once(' ').unwrap().1.to_owned()).collect();
    let first = states.iter().position(|state| state.starts_with("estop")).unwrap();
    let expected = ["estop: emergency stop", "paused: emergency stop released", "running", "idle"];
    assert_eq!(states[first..], expected, "{states:?}");
    let moves = trace.moves();
    let raised = moves.iter().position(|made| made == "5.440-5.940 z-10").unwrap();
    let next = moves[raised + 1].split('-').next().unwrap().parse::<f64>().unwrap();
    assert!(next > 6.2, "nothing moves before it is released and acknowledged: {moves:?}");
    assert!(moves.iter().any(|made| made.ends_with("x100")), "{moves:?}");
    let given_up = run("abort");
    assert_eq!(given_up.rests(), [50.0, 0.0, -10.0]);
    assert!(given_up.states().last().unwrap().ends_with("idle: emergency stop"));
}
