//! Interlocks of a job or a move by hand: stops that come while it is stopped already, stop inputs and the emergency
//! stop while somebody is asked, homing that does not come to its end.

use kerf_ledger::jobs::{JobRun, JobTrace, job, square, t1};
use kerf_machine::lines::Input;
use kerf_machine::{Configuration, Errand};
use kerf_model::STOP_INPUT;
use kerf_program::{AXES, Axis, AxisSet, Status};

fn axes(letters: &str) -> AxisSet {
    letters.chars().filter_map(Axis::from_letter).fold(AxisSet::EMPTY, AxisSet::with)
}

/// Input 5 is a normally open stop.
fn fifth_stops(machine: &mut Configuration) {
    machine.program.io.inputs[4] = 3;
}

/// From (0, 0, -25) to (100, 0, -25) by hand, stopped at 0.3 s: it stands at 0.5 s, and rises until 1.1 s.
fn by_hand() -> JobRun {
    let mut place = [None; AXES];
    (place[0], place[1], place[2]) = (Some(100.0), Some(0.0), Some(-25.0));
    let errand = Errand::To { place, relative: false, flat: false };
    JobRun::hand(errand).with(fifth_stops).at(0.0, 0.0, -25.0).stop(0.3)
}

#[test]
fn a_stop_while_the_tool_rises_ends_the_rise_of_a_move_by_hand() {
    assert_eq!(by_hand().run().rests()[2], -10.0);
    let stands = by_hand().stop(0.6).run();
    assert!(stands.rests()[2] < -15.0, "it rose on after the second stop: {:?}", stands.rests());
    let resumed = by_hand().stop(0.6).say("resume").run();
    assert_eq!((resumed.summary.status, resumed.rests()), (Status::Ok, [100.0, 0.0, -25.0]));
}

#[test]
fn a_stop_input_while_the_tool_rises_holds_a_move_by_hand_until_it_is_released() {
    let pressed = || by_hand().raw_input(5, 0.6, true);
    assert!(pressed().run().rests()[2] < -15.0);
    let released = pressed().raw_input(5, 3.0, false).say(&["resume"; 8].join(" ⏎ ")).run();
    assert_eq!((released.summary.status, released.rests()), (Status::Ok, [100.0, 0.0, -25.0]));
    let begins = |made: &String| made.split('-').next().unwrap().parse::<f64>().unwrap();
    let between = released.moves().iter().map(begins).filter(|t| (0.7..3.0).contains(t)).count();
    assert_eq!(between, 0, "nothing moves before it is released: {:?}", released.moves());
}

/// Times at which the router goes on, s.
fn router_on(trace: &JobTrace) -> Vec<f64> {
    let edges = trace.edges().into_iter().filter(|edge| edge.ends_with("router+"));
    edges.map(|edge| edge.split(' ').next().unwrap().parse().unwrap()).collect()
}

#[test]
fn a_stop_input_while_the_tool_rises_holds_a_job_until_it_is_released() {
    // The job stands at 5.44 s and rises until 5.94 s.
    let pressed = || JobRun::new(t1()).with(fifth_stops).stop(5.34).raw_input(5, 5.6, true);
    let trace = pressed().say("resume").run();
    assert_eq!(router_on(&trace).len(), 1, "{:?}", trace.edges());
    assert_eq!(trace.summary.status, Status::Stopped);
    let released = pressed().raw_input(5, 8.0, false).say(&["resume"; 9].join(" ⏎ ")).run();
    assert_eq!(released.summary.status, Status::Ok, "{:?}", released.refused());
    assert!(router_on(&released)[1] > 8.0, "{:?}", released.edges());
}

/// A job that stands where it was stopped, with what is said then.
fn asked(say: &str) -> JobTrace {
    let run = JobRun::new(t1()).with(fifth_stops).with(|machine| machine.pause.raise = false);
    run.stop(5.34).say(say).run()
}

#[test]
fn nothing_comes_on_while_a_stop_is_pressed_that_was_not_when_the_job_was_stopped() {
    for pressed in [5, STOP_INPUT, Input::EmergencyStop.number()] {
        // The contact of input 4 opens when it is pressed.
        let on = u8::from(pressed != STOP_INPUT);
        let press = format!("switch {pressed} {on}");
        for word in ["resume", "move y 20"] {
            let trace = asked(&format!("{press} ⏎ {word}"));
            assert_eq!(router_on(&trace).len(), 1, "{pressed} {word}: {:?}", trace.edges());
            assert_eq!(trace.rests()[..2], [50.0, 0.0], "{pressed} {word}");
            assert!(trace.messages().iter().any(|it| it.starts_with("release the")), "{pressed}");
        }
        let release = format!("switch {pressed} {}", 1 - on);
        let trace = asked(&format!("{press} ⏎ resume ⏎ {release} ⏎ resume ⏎ resume"));
        assert_eq!(trace.summary.status, Status::Ok, "{pressed}");
        assert_eq!(router_on(&trace).len(), 2, "{pressed}: {:?}", trace.edges());
    }
}

/// A job that waits for its door, while stop input 5 is pressed for a moment.
fn at_the_door(closes_s: f64) -> JobTrace {
    let run = JobRun::new(t1()).with(fifth_stops).with(|machine| machine.job.external_start = true);
    let run = run.raw_input(5, 1.0, true).raw_input(5, 1.5, false);
    run.input(Input::WHome, closes_s, true).say(&["resume"; 6].join(" ⏎ ")).run()
}

#[test]
fn a_stop_input_does_not_begin_a_job_that_waits_for_its_door() {
    let trace = at_the_door(30.0);
    assert_eq!(trace.summary.status, Status::Ok);
    let first = trace.moves()[0].clone();
    assert!(first.starts_with("30.000-"), "the door is closed at 30 s: {first}");
    assert!(router_on(&trace)[0] > 30.0, "{:?}", trace.edges());
}

#[test]
fn a_stop_input_does_not_begin_a_job_that_waits_for_a_jig() {
    let jigs = JobRun::new(job([square(1, (100.0, 0.0), 500.0), square(2, (1300.0, 0.0), 700.0)]));
    let jigs = jigs.with(fifth_stops);
    let jigs = jigs.with(|m| (m.job.two_jigs, m.job.divider_mm) = (true, 1250.0));
    let jigs = jigs.raw_input(5, 1.0, true).raw_input(5, 1.5, false);
    let trace = jigs.input(Input::Jig2, 30.0, true).say(&["resume"; 9].join(" ⏎ ")).run();
    let first = trace.moves()[0].clone();
    assert!(first.starts_with("30.000-"), "the jig is ready at 30 s: {first}");
    assert!(trace.edges().contains(&"30.000 jig2+".into()), "{:?}", trace.edges());
    assert!(!trace.edges().iter().any(|edge| edge.ends_with("jig1+")), "{:?}", trace.edges());
}

#[test]
fn the_output_of_a_jig_is_on_again_after_an_emergency() {
    let jigs = JobRun::new(job([square(1, (100.0, 0.0), 500.0), square(2, (1300.0, 0.0), 700.0)]));
    let jigs = jigs.with(|m| (m.job.two_jigs, m.job.divider_mm) = (true, 1250.0));
    let jigs = jigs.input(Input::Jig1, 1.0, true);
    let jigs = jigs.input(Input::EmergencyStop, 8.0, true).input(Input::EmergencyStop, 9.0, false);
    let trace = jigs.say(&["continue"; 6].join(" ⏎ ")).run();
    let edges = trace.edges();
    let jig: Vec<&String> = edges.iter().filter(|edge| edge.contains("jig1")).collect();
    let signs: String = jig.iter().filter_map(|edge| edge.chars().last()).collect();
    assert_eq!(signs, "+-+-", "{edges:?}");
    let cuts = edges.iter().rposition(|edge| edge.ends_with("cut1+")).unwrap();
    let on = edges.iter().rposition(|edge| edge.ends_with("jig1+")).unwrap();
    assert!(on < cuts, "{edges:?}");
}

#[test]
fn an_input_that_is_not_waited_for_at_all_is_looked_at_all_the_same() {
    let run = |machine: fn(&mut Configuration)| {
        let run = JobRun::new(t1()).with(|machine| {
            machine.plasma.use_sequence = true;
            machine.plasma.arc_timeout_s = 0.0;
        });
        run.with(machine).sheet(kerf_sim::Sheet::flat(-20.0))
    };
    let none = run(|_| ()).run();
    assert!(none.states().iter().any(|it| it.ends_with("no arc")), "{:?}", none.states());
    let burns = run(|_| ()).input(Input::EndBottomDelay, 0.5, true).run();
    assert_eq!(burns.summary.status, Status::Ok, "{:?}", burns.states());
}

#[test]
fn a_torch_that_found_no_sheet_does_not_light_where_it_gave_up() {
    let run = JobRun::new(t1()).with(|machine| {
        machine.plasma.use_sequence = true;
        machine.pause.raise = false;
    });
    let trace = run.input(Input::EndBottomDelay, 0.1, true).say("resume ⏎ resume").run();
    let edges = trace.edges();
    assert!(!edges.iter().any(|edge| edge.ends_with("cut1+")), "{edges:?}");
    let lost = trace.states().iter().filter(|it| it.ends_with("surface not found")).count();
    assert!(lost >= 3, "{:?}", trace.states());
}

fn home(letters: &str) -> JobRun {
    JobRun::hand(Errand::FindHome(axes(letters))).unhomed()
}

/// The working location of Z.
fn z_mm(trace: &JobTrace) -> f64 {
    let memory = &trace.session.memory;
    memory.frame.working(memory.position)[Axis::Z]
}

#[test]
fn an_axis_that_was_homed_before_homing_was_stopped_is_where_it_is_said_to_be() {
    let alone = home("z").run();
    assert!(z_mm(&alone) > 1.0, "Z has moved away from its zero: {}", z_mm(&alone));
    let stopped = home("xz").stop(alone.summary.seconds + 0.5).run();
    assert_eq!(stopped.summary.status, Status::Stopped);
    assert_eq!(stopped.homed().len(), 1, "{:?}", stopped.homed());
    assert!((z_mm(&stopped) - z_mm(&alone)).abs() < 1e-9, "{} {}", z_mm(&stopped), z_mm(&alone));
    assert_eq!(stopped.session.homed, axes("z"));
}

#[test]
fn an_axis_whose_switch_does_not_come_any_more_is_not_homed() {
    let before = home("xyz").run();
    let broken = |machine: &mut Configuration| machine.simulated.switch_at[0] = None;
    let failed = JobRun::hand(Errand::FindHome(axes("xyz"))).after(&before).with(broken).run();
    assert_eq!(failed.refused(), "x home not found");
    assert_eq!(failed.session.homed, axes("yz"));
    // Stopped before anything was found, it still knows its home.
    let again = JobRun::hand(Errand::FindHome(axes("xyz"))).after(&before).stop(0.05).run();
    assert_eq!(again.session.homed, axes("xyz"));
}

#[test]
fn nothing_goes_home_while_a_stop_is_pressed() {
    for (input, on) in [(STOP_INPUT, false), (5, true), (Input::EmergencyStop.number(), true)] {
        let trace = home("x").with(fifth_stops).raw_input(input, 0.0, on).run();
        assert_eq!(trace.moves(), [""; 0], "input {input}");
        assert_eq!(trace.summary.status, Status::Stopped, "input {input}");
        assert!(trace.session.homed.is_empty());
    }
}
