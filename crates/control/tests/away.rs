//! A tool that the operator takes out of the cut while a program waits for him.

use kerf_control::{Outcome, TextOptions, run_text};
use kerf_sbp::Status;
use kerf_trace::{Event, event::Location};

/// Everything that shows what the machine did, in order: `z 1`, `1+`, `wait`.
fn did(outcome: &Outcome) -> Vec<String> {
    let round = |v: f64| (v * 1e4).round() / 1e4;
    let shown = |event: &Event| match event {
        Event::Move(made) => {
            let Location { x, y, z, .. } = made.to;
            Some(format!("{} {} {}", round(x), round(y), round(z)))
        }
        Event::Output { n, on, .. } if *n != 4 => {
            Some(format!("{n}{}", if *on { '+' } else { '-' }))
        }
        Event::Wait { .. } => Some("wait".into()),
        Event::Ask(_) => Some("asked".into()),
        _ => None,
    };
    outcome.events.iter().filter_map(shown).collect()
}

fn run(file: &str, program: &str, answers: &str) -> Outcome {
    run_text(&[(file, program)], file, TextOptions::default().answers(answers))
}

const IN_THE_CUT: &str = "SO,1,1\nMZ,-.5\nMX,2\nPAUSE\nMX,4\nSO,1,0\n";

#[test]
fn a_tool_is_lifted_in_a_pause_and_goes_back() {
    let away =
        run("a.sbp", IN_THE_CUT, "spindle=OK\nlift\njog 1,0,0,0,0,0 1\njog 0,1,0,0,0,0 1\nOK");
    assert_eq!(away.summary.status, Status::Ok, "{:?}", away.summary.error);
    // What turns stops before the tool rises, and turns before it goes down. A jog by an inch is 25.4 mm.
    let by = 1.0 / 25.4;
    let there = (2.0 + by, by);
    let round = |v: f64| (v * 1e4).round() / 1e4;
    let expected = [
        "asked".into(),
        "1+".into(),
        "0 0 -0.5".into(),
        "2 0 -0.5".into(),
        "asked".into(),
        "1-".into(),
        "2 0 1".into(),
        "asked".into(),
        format!("{} 0 1", round(there.0)),
        "asked".into(),
        format!("{} {} 1", round(there.0), round(there.1)),
        "asked".into(),
        "1+".into(),
        "2 0 1".into(),
        "2 0 -0.5".into(),
        "4 0 -0.5".into(),
        "1-".into(),
    ];
    assert_eq!(did(&away), expected);
}

#[test]
fn a_tool_that_was_not_lifted_goes_back_at_safe_z() {
    let away = run("a.sbp", IN_THE_CUT, "spindle=OK\njog 0,25.4,0,0,0,0 1\nOK");
    let made = did(&away);
    let behind = made.iter().position(|it| it == "2 1 -0.5").unwrap();
    assert_eq!(made[behind + 2..behind + 5], ["2 1 1", "2 0 1", "2 0 -0.5"], "{made:?}");
}

#[test]
fn whoever_cancels_leaves_the_tool_where_it_is() {
    let over = run("a.sbp", IN_THE_CUT, "spindle=OK\nlift\nCancel");
    assert_eq!(did(&over).last().map(String::as_str), Some("asked"), "{:?}", did(&over));
    // A program that goes on all the same has its tool back before it moves.
    let goes_on = "SO,1,1\nMZ,-.5\nMX,2\nMSGBOX(Change the tool, OKCancel)\nSO,3,1\nMX,4\n";
    let made = did(&run("a.sbp", goes_on, "spindle=OK\nlift\nCancel"));
    let lifted = made.iter().position(|it| it == "2 0 1").unwrap();
    assert_eq!(made[lifted + 1..lifted + 6], ["asked", "3+", "1+", "2 0 -0.5", "4 0 -0.5"]);
}

#[test]
fn a_tool_change_of_g_code_offers_it_too() {
    let program = "G20 G90 F60\nG1 Z-.5\nG1 X2 M0\nG1 X4\nM2\n";
    let made = did(&run("a.nc", program, "lift\nOK"));
    assert_eq!(made, ["0 0 -0.5", "2 0 -0.5", "asked", "2 0 1", "asked", "2 0 -0.5", "4 0 -0.5"]);
}

#[test]
fn a_script_that_only_lifts_ends() {
    let made = did(&run("a.sbp", IN_THE_CUT, "spindle=OK\npause=lift"));
    assert!(made.last().is_some(), "it comes to an end");
}
