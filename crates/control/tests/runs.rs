//! Runs where machine, planner and program meet.

use kerf_control::{OperatorRequest, Outcome, RunContext, Script, Session, TextOptions, run_text};
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_program::Settings;
use kerf_sbp::Status;
use kerf_trace::Event;
use kerf_workspace::Workspace;

fn run(program: &str, options: TextOptions) -> Outcome {
    run_text(&[("a.sbp", program)], "a.sbp", options)
}

/// The speeds and ends in X of the moves made.
fn moves(outcome: &Outcome) -> Vec<(f64, f64)> {
    let made = outcome.events.iter().filter_map(|event| match event {
        Event::Move(made) => Some((made.speed, (made.to.x * 1e6).round() / 1e6)),
        _ => None,
    });
    made.collect()
}

fn messages(outcome: &Outcome) -> Vec<&str> {
    let told = outcome.events.iter().filter_map(|event| match event {
        Event::Message { text, .. } => Some(&**text),
        _ => None,
    });
    told.collect()
}

#[test]
fn settings_read_behind_an_interrupted_move_are_forgotten() {
    let program = "ON INPUT(3,1) GOTO HIT\nMX,10\nVS,.5\nMX,20\nEND\nHIT:\nMX,0\n";
    let outcome = run(program, TextOptions::default().input(3, 1.0, true));
    let speeds: Vec<f64> = moves(&outcome).iter().map(|(speed, _)| *speed).collect();
    assert_eq!(speeds, [2.0, 2.0], "{:?}", outcome.events);
}

#[test]
fn what_was_done_before_a_stop_is_not_done_again_when_motion_goes_on() {
    let program = "VN,,,,,1\nMX,5\n'halfway\nMX,10\n'at the end\n";
    let options = TextOptions::default().answers("Continue");
    let after = run(program, options.clone().input(2, 4.0, true));
    let before = run(program, options.input(2, 1.0, true));
    for outcome in [&after, &before] {
        assert_eq!(outcome.summary.status, Status::Ok);
        assert_eq!(messages(outcome), ["halfway", "at the end"], "{:?}", outcome.events);
        assert_eq!(moves(outcome).last(), Some(&(2.0, 10.0)));
    }
}

#[test]
fn output_4_follows_motion_and_no_mode() {
    let mut options = TextOptions::default();
    options.settings.io.outputs[3] = 3;
    let outcome = run("PAUSE 1\nMX,1\n", options);
    let switched = outcome.events.iter().filter_map(|event| match event {
        Event::Output { n: 4, on, t, .. } => Some((*on, *t)),
        _ => None,
    });
    let switched: Vec<_> = switched.collect();
    assert_eq!(switched.first(), Some(&(true, 1.0)), "{switched:?}");
    assert_eq!(switched.len(), 2);
}

#[test]
fn a_finding_in_a_loop_is_told_once() {
    let program = "L:\nSO,4,1\n&n=&n+1\nIF &n<5 THEN GOTO L\n";
    let options = TextOptions::default().set("n", kerf_sbp::Value::Number(0.0));
    let outcome = run(program, options);
    let told = outcome.events.iter().filter(|e| matches!(e, Event::Diag(_))).count();
    assert_eq!((outcome.summary.status, told), (Status::Ok, 1), "{:?}", outcome.events);
}

#[test]
fn the_warning_before_motion_counts_as_waiting() {
    let settings = Settings { warning_s: 2.0, ..Settings::default() };
    let outcome = run("MX,1\nJX,0\n", TextOptions { settings, ..TextOptions::default() });
    let (summary, tally) = (&outcome.summary, &outcome.summary.tally);
    assert_eq!(tally.wait_s, 2.0);
    assert!((summary.seconds - tally.cut_s - tally.jog_s - 2.0).abs() < 1e-9);
}

#[test]
fn an_answer_waits_for_its_input_and_a_handler_comes_first() {
    let program = "ON INPUT(2,1) PRINT \"handled\"\nPAUSE UNTIL 5,1\nMX,1\n";
    let options = TextOptions::default().input(2, 1.0, true).input(5, 3.0, true);
    let outcome = run(program, options);
    let printed =
        outcome.events.iter().position(|e| matches!(e, Event::Print { t, .. } if *t == 1.0));
    let asked = outcome.events.iter().position(|e| matches!(e, Event::Ask(ask) if ask.t == 3.0));
    assert!(printed.is_some() && printed < asked, "{:?}", outcome.events);
    assert_eq!(moves(&outcome), [(2.0, 1.0)]);
}

#[test]
fn a_stop_while_the_program_waits_ends_it() {
    let options = TextOptions { stop_at_s: Some(1.5), ..TextOptions::default() };
    let outcome = run("MX,1\nPAUSE 5\nMX,2\n", options);
    assert_eq!(outcome.summary.status, Status::Stopped);
    let lifted = outcome.session.memory.position.0;
    assert!((lifted[0] - 25.4).abs() < 1e-9 && (lifted[2] - 25.4).abs() < 1e-9, "{lifted:?}");
}

#[test]
fn the_next_run_starts_where_the_last_one_stopped() {
    let options = TextOptions { stop_at_s: Some(1.0), ..TextOptions::default() };
    let first = run("MX,10\n", options);
    let stood = first.session.memory.position.0[0] / 25.4;
    assert!(stood > 1.0 && stood < 10.0, "{stood}");
    let failed = run("MX,3\nPAUSE 0\nMX,9\nMY,1/0\n", TextOptions::default());
    assert!((failed.session.memory.position.0[0] / 25.4 - 3.0).abs() < 1e-9);
}

/// A table of ten inches whose limits are checked, with switches on input 2; the first file leaves it on the way.
const LEAVES: &str = "VL,0,10\nSF,1\nVN,1,0,0,0,1\nMX,5\nMX,12\nMX,20\n";

#[test]
fn going_on_beyond_the_table_leaves_the_switches() {
    let options = TextOptions::default().answers("limit=Continue");
    let outcome = run(LEAVES, options.clone());
    assert_eq!(moves(&outcome).last(), Some(&(2.0, 20.0)), "it goes beyond the table");
    let asked = |outcome: &Outcome| {
        let asked = outcome.events.iter().filter_map(|event| match event {
            Event::Ask(ask) => Some(ask.text.clone()),
            _ => None,
        });
        asked.collect::<Vec<_>>()
    };
    let switched = run(LEAVES, options.input(2, 8.0, true));
    let [table, switch] = &asked(&switched)[..] else { panic!("{:?}", asked(&switched)) };
    assert!(table.contains("table limit") && switch.contains("limit input 2"), "{table} {switch}");
}

#[test]
fn a_switch_that_is_on_before_anything_moves_is_noticed() {
    // Normally closed, with a broken wire: it is on from the beginning.
    let broken = |answers: &str| {
        let options = TextOptions::default().answers(answers).input(2, 0.0, false);
        run("VN,,,,,2\nPAUSE 1\nMX,5\nMX,10\n", options)
    };
    let refused = broken("");
    assert_eq!(refused.summary.status, Status::Limit);
    let told = refused.summary.error.as_ref().expect("why").message.clone();
    assert_eq!(told, "limit input 2 is active before anything moves");
    assert!(moves(&refused).is_empty());
    let goes_on = broken("limit=Continue");
    assert_eq!((goes_on.summary.status, moves(&goes_on).len()), (Status::Ok, 2));
}

#[test]
fn an_output_that_follows_motion_comes_back_after_a_hold() {
    for (mode, expected) in [
        (-1, vec![true, false]),
        (-2, vec![true, false, true, false]),
        (-3, vec![true, false, true, false]),
    ] {
        let mut events = Vec::new();
        let mut pace = Script::new(vec![(2.0, OperatorRequest::Hold)], vec![4.0]);
        let context = RunContext {
            sink: &mut events,
            operator: &mut (),
            requests: &mut pace,
            machine: kerf_control::simulated(),
        };
        let text = format!("SO,4,{mode}\nMX,10\n");
        let program = kerf_sbp::read("a.sbp".into(), text.as_bytes());
        let mut workspace = Workspace::in_memory(MemoryDisk::default());
        let summary =
            Session::default().run(program, RunOptions::default(), &mut workspace, context);
        assert_eq!(summary.status, Status::Ok);
        let switched = events.iter().filter_map(|event| match event {
            Event::Output { n: 4, on, .. } => Some(*on),
            _ => None,
        });
        assert_eq!(switched.collect::<Vec<_>>(), expected, "SO,4,{mode}");
    }
}
