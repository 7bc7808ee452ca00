//! Long stacks move while they are read; the operator holds, resumes and overrides.

use kerf_control::answers::Answers;
use kerf_control::{OperatorRequest, RunContext, Script, Session, TextOptions, run_text};
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_program::Status;
use kerf_trace::{Event, Summary, event::MoveEvent};
use kerf_workspace::Workspace;
use std::fmt::Write;

/// More moves than are read ahead.
const MANY: usize = 40_000;

/// A long wavy cut, a hundredth of an inch a move, with an output in it now and then.
fn long_cut(moves: usize, end: &str) -> String {
    let mut text = String::from("VS,4,1\n");
    for k in 0..moves {
        let x = k as f64 * 0.01;
        writeln!(text, "M2,{x:.4},{:.4}", (x * 0.5).sin()).unwrap();
        if k % 1000 == 999 {
            writeln!(text, "SO,3,1\nVS,{}", 2 + k / 1000 % 5).unwrap();
        }
    }
    text + end
}

fn run(text: &str, options: TextOptions) -> (Vec<Event>, Summary) {
    let outcome = run_text(&[("long.sbp", text)], "long.sbp", options);
    (outcome.events, outcome.summary)
}

fn scripted(
    text: &str,
    requests: Vec<(f64, OperatorRequest)>,
    resumes: Vec<f64>,
) -> (Vec<Event>, Summary) {
    let program = kerf_sbp::read("long.sbp".into(), text.as_bytes());
    let mut events = Vec::new();
    let mut pace = Script::new(requests, resumes);
    let context = RunContext {
        sink: &mut events,
        operator: &mut Answers::default(),
        requests: &mut pace,
        machine: kerf_control::simulated(),
    };
    let mut workspace = Workspace::in_memory(MemoryDisk::new([]));
    let summary = Session::default().run(program, RunOptions::default(), &mut workspace, context);
    (events, summary)
}

fn made(events: &[Event]) -> Vec<&MoveEvent> {
    let made = events.iter().filter_map(|event| match event {
        Event::Move(made) => Some(made),
        Event::Arc(arc) => Some(&arc.made),
        _ => None,
    });
    made.collect()
}

fn codes(events: &[Event]) -> Vec<String> {
    let diags = events.iter().filter_map(|event| match event {
        Event::Diag(diagnostic) => Some(diagnostic.code.to_string()),
        _ => None,
    });
    diags.collect()
}

#[test]
fn how_many_lines_are_read_at_once_does_not_show_in_a_long_stack() {
    let text = long_cut(MANY, "MX,500\nPAUSE,1\nMX,0\n");
    let (usual, _) = run(&text, TextOptions::default());
    for lines_at_once in [1, 777, 1_000_000] {
        let options = TextOptions {
            run: RunOptions { lines_at_once, ..RunOptions::default() },
            ..TextOptions::default()
        };
        assert!(run(&text, options).0 == usual, "{lines_at_once} lines at once");
    }
}

#[test]
fn the_first_move_is_made_before_the_program_was_read_to_its_end() {
    // The last line fails when it is reached: had it been reached first, nothing would have moved.
    let text = long_cut(MANY, "MX,&nothing\n");
    let (events, summary) = run(&text, TextOptions::default());
    assert_eq!(summary.status, Status::Failed);
    let moves = made(&events);
    assert_eq!(moves.len(), MANY - 1);
    // What was read was made, and the machine came to rest behind it.
    assert!(summary.seconds > 0.0 && (moves[MANY - 2].to.x - 399.99).abs() < 1e-9);
}

#[test]
fn a_stack_that_is_not_long_does_not_start_when_an_error_is_in_it() {
    let text = long_cut(1000, "MX,&nothing\n");
    let (events, summary) = run(&text, TextOptions::default());
    assert_eq!((summary.status, made(&events).len()), (Status::Failed, 0));
}

#[test]
fn far_ahead_in_a_long_stack_the_limits_are_asked_about_where_they_are_left() {
    let text = "VL,-10,300,-10,10,-10,10,,,1\n".to_owned() + &long_cut(MANY, "");
    let (events, summary) = run(&text, TextOptions::default());
    assert_eq!(summary.status, Status::Limit, "{:?}", codes(&events));
    let last = made(&events).last().unwrap().to.x;
    assert!((last - 300.0).abs() < 0.011, "{last}");
}

#[test]
fn an_input_interrupts_a_long_stack_where_the_tool_is() {
    let text = "ON INPUT(2,1) GOSUB hit\n".to_owned()
        + &long_cut(MANY, "END\nhit:\nPRINT \"hit at \"; %(1)\nEND\n");
    let at = |lines_at_once| {
        let options = TextOptions {
            run: RunOptions { lines_at_once, ..RunOptions::default() },
            ..TextOptions::default()
        };
        run(&text, options.input(2, 40.0, true)).0
    };
    let events = at(0);
    let printed =
        events.iter().any(|e| matches!(e, Event::Print { text, .. } if text.contains("hit at")));
    assert!(printed);
    let end = made(&events).last().unwrap().t1;
    assert!((40.0..41.0).contains(&end), "{end}");
    assert!(at(1) == events);
}

#[test]
fn hold_and_resume_give_the_same_path() {
    let text = long_cut(MANY, "");
    let (plain, summary) = run(&text, TextOptions::default());
    let (held, after) = scripted(
        &text,
        vec![(20.0, OperatorRequest::Hold), (60.0, OperatorRequest::Hold)],
        vec![30.0, 65.0],
    );
    assert_eq!((after.status, held.len() > plain.len()), (Status::Ok, true));
    assert!((after.tally.cut_mm - summary.tally.cut_mm).abs() < 1e-6 * summary.tally.cut_mm);
    let stands: Vec<f64> = held
        .iter()
        .filter_map(|event| match event {
            Event::Hold { t } | Event::Resume { t } => Some(*t),
            _ => None,
        })
        .collect();
    assert!((20.0..21.0).contains(&stands[0]) && stands[1] == 30.0 && stands[3] == 65.0);
    let waited = stands[1] - stands[0] + stands[3] - stands[2];
    let longer = after.seconds - summary.seconds;
    assert!((waited..waited + 1.0).contains(&longer), "{longer} for {waited}");
    assert_eq!(after.tally.wait_s, waited);
}

#[test]
fn a_hold_that_nobody_ends_ends_the_run() {
    let (events, summary) =
        scripted(&long_cut(1000, ""), vec![(1.0, OperatorRequest::Hold)], vec![]);
    assert_eq!(summary.status, Status::Stopped);
    assert!(events.iter().any(|e| matches!(e, Event::Hold { .. })));
}

#[test]
fn the_feed_is_overridden_from_then_on_and_moves_join() {
    let text = long_cut(MANY, "");
    let (_, plain) = run(&text, TextOptions::default());
    let (events, slow) = scripted(&text, vec![(0.5, OperatorRequest::Feed(0.5))], vec![]);
    assert!(slow.seconds > 1.9 * plain.seconds, "{} {}", slow.seconds, plain.seconds);
    for pair in made(&events).windows(2) {
        assert!((pair[1].t0 - pair[0].t1).abs() < 1e-9 && pair[1].from == pair[0].to);
    }
    let (_, fast) = scripted(
        &text,
        vec![(0.5, OperatorRequest::Feed(2.0)), (9.0, OperatorRequest::Feed(1.0))],
        vec![],
    );
    assert!(fast.seconds < plain.seconds - 4.0, "{} {}", fast.seconds, plain.seconds);
    // Nothing is ever told to be run at more than was asked for: the speed told is the program's.
    assert!(made(&events).iter().all(|m| m.speed <= 6.0));
}

#[test]
fn a_wait_is_held_too() {
    let (events, summary) =
        scripted("PAUSE 5\nMX,1\n", vec![(2.0, OperatorRequest::Hold)], vec![10.0]);
    assert_eq!(summary.status, Status::Ok);
    let first = made(&events)[0].t0;
    assert!((first - 13.0).abs() < 1e-9, "{first}");
}
