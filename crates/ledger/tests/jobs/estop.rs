//! Area `estop`: the emergency stop in jobs.

use kerf_ledger::jobs::{JobRun, JobTrace, t1};
use kerf_machine::lines::Input;
use kerf_machine::settings::delays::BottomDelayType;
use kerf_machine::wiring::bit;
use kerf_machine::{Errand, Held};
use kerf_program::{Axis, AxisSet};
use kerf_sbp::Status;
use kerf_trace::Event;

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

#[test]
fn pro_estop_trigger__in_moves_by_hand() {
    let held = Held { way: [1, 0, 0, 0, 0, 0], speed: 1.0, accel: 1.0, sets_bottom: false };
    let errands = [
        Errand::Held(held),
        Errand::FindHome(AxisSet::EMPTY.with(Axis::X)),
        Errand::To {
            place: [Some(90.0), None, None, None, None, None],
            relative: true,
            flat: true,
        },
    ];
    for errand in errands {
        let run = JobRun::hand(errand.clone()).at(300.0, 0.0, 0.0);
        let trace = run.input(Input::EmergencyStop, 0.2, true).run();
        let last = trace.events.iter().rev().find_map(|event| match event {
            Event::Move(made) => Some(made.t1),
            _ => None,
        });
        // It slows down from the very moment, which takes as long as it took to get up to its speed.
        assert!(last.is_some_and(|t1| t1 <= 0.4 + 1e-3), "{errand:?} {last:?}");
        assert_eq!(trace.summary.status, Status::Stopped, "{errand:?}");
        let why = trace.summary.error.unwrap();
        assert_eq!(why.message, "emergency stop", "{errand:?}");
    }
}

/// JOB-T1 with input 2 as a limit that comes at a time.
fn limited(say: &str) -> JobTrace {
    let run = JobRun::new(t1()).with(|machine| machine.program.io.inputs[1] = 1);
    run.raw_input(2, 5.34, true).say(say).run()
}

#[test]
fn a_job_at_a_limit_cuts_nothing_until_somebody_says_so() {
    let ended = limited("");
    let states = ended.states();
    assert_eq!(
        states[states.len() - 2..],
        ["5.340 limit: stopped by limit input 2", "5.340 alarm: stopped by limit input 2"]
    );
    assert_eq!(ended.summary.status, Status::Limit);
    assert!(ended.edges().contains(&"5.340 cut1-".into()), "{:?}", ended.edges());
    let on = limited("Continue");
    assert_eq!(on.summary.status, Status::Ok);
    let cuts: Vec<_> = on.edges().into_iter().filter(|edge| edge.contains("cut1")).collect();
    assert_eq!(cuts.len(), 4, "off and on again: {cuts:?}");
    assert!(on.moves().iter().any(|made| made.ends_with("x100")), "{:?}", on.moves());
}

#[test]
fn a_job_that_a_stop_input_stopped_waits_until_it_is_released() {
    let run = |say: &str| {
        let run = JobRun::new(t1()).with(|machine| machine.program.io.inputs[4] = 3);
        run.raw_input(5, 5.34, true).raw_input(5, 6.5, false).say(say).run()
    };
    let states = |trace: &JobTrace| -> Vec<String> {
        let names = trace.states().into_iter();
        names.map(|state| state.split_once(' ').unwrap().1.to_owned()).collect()
    };
    let trace = run("resume ⏎ resume ⏎ resume ⏎ resume ⏎ resume");
    let seen = states(&trace);
    let first = seen.iter().position(|state| state.starts_with("blocked")).unwrap();
    let expected = ["blocked: stop input 5", "paused: stop input 5 released", "running", "idle"];
    assert_eq!(seen[first..], expected, "{seen:?}");
    let moves = trace.moves();
    let stopped = moves.iter().position(|made| made == "4.840-5.440 x50").unwrap();
    let next = moves[stopped + 1].split('-').next().unwrap().parse::<f64>().unwrap();
    assert!(next >= 6.4, "nothing moves before it is released: {moves:?}");
    assert_eq!(trace.summary.status, Status::Ok);
    assert!(states(&run("")).last().unwrap().starts_with("idle"));
}

#[test]
fn pro_estop_outputs__every_bit_of_both_ports() {
    let tools = |job: &mut kerf_program::job::Job| {
        let mut shapes = job.shapes.to_vec();
        (shapes[0].tool, shapes[0].cut) = (3, 2);
        job.shapes = shapes.into();
    };
    let jig = |machine: &mut kerf_machine::Configuration| {
        (machine.job.two_jigs, machine.job.divider_mm) = (true, 500.0);
    };
    let run = JobRun::new(t1()).job(tools).with(jig).input(Input::Jig1, 0.0, true);
    let signals = run.input(Input::EmergencyStop, 5.34, true).signals();
    let by = |port: &str, t_ms: u64| {
        let before = signals.changes(port).into_iter().rev().find(|(t, _)| *t <= t_ms);
        before.map(|(t, byte)| format!("{t} {byte}")).expect("a byte")
    };
    // Jig 1 was on; of port B the cut bit goes first, then tool 3, the router and Job Running with the jig.
    assert_eq!([by("port_c", 5339), by("port_c", 9999)], ["0 b00000001", "5440 b00000000"]);
    assert_eq!(by("port_b", 5339), "3840 b11011000");
    assert_eq!([by("port_b", 5439), by("port_b", 9999)], ["5340 b11010000", "5440 b00000000"]);
}

#[test]
fn pro_estop_outputs__intensity_in_the_same_tick() {
    let run = JobRun::new(t1()).with(|machine| {
        machine.intensity.output = true;
        machine.intensity.scale_percent = 60.0;
    });
    let trace = run.input(Input::EmergencyStop, 5.34, true).run();
    let (t, value, byte) = *trace.intensities().last().unwrap();
    assert_eq!((value, byte), (0, 0), "{:?}", trace.intensities());
    assert!((t - 5.34).abs() < 1e-9, "{t}");
    let cut = trace.edges().into_iter().find(|edge| edge.ends_with("cut1-"));
    assert_eq!(cut.as_deref(), Some("5.340 cut1-"));
}
