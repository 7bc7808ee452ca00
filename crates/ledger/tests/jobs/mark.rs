//! Area `path`: shapes at which the machine halts by itself.

use kerf_ledger::jobs::{JobRun, JobTrace, drawn};
use kerf_machine::lines::Output;
use kerf_program::{Axes, Command, Interpreter, Status, Step};
use kerf_sequence::Sequence;
use std::sync::Arc;

use crate::jobs::patient::Patient;

/// Three lines, the second marked; the job went by way of its RSM.
const MARKED: &str = "line 0,0 100,0; line 100,50 0,50; line 0,100 100,100; select 2; pause on";

fn marked() -> JobRun {
    JobRun::new(drawn(MARKED))
}

/// Lines that are told from a moment on, seconds.
fn from(told: Vec<String>, from_s: f64) -> Vec<String> {
    let time = |text: &String| text.split([' ', '-']).next().and_then(|t| t.parse::<f64>().ok());
    told.into_iter().filter(|text| time(text).is_some_and(|t| t >= from_s)).collect()
}

fn ends(trace: &JobTrace) -> Vec<String> {
    let moves = trace.moves();
    moves.iter().map(|m| m.split_once(' ').map_or("", |(_, end)| end).to_owned()).collect()
}

#[test]
fn pro_path_pause_shape() {
    let trace = marked().say("abort").run();
    assert_eq!(trace.states()[1..2], ["7.640 paused: pause mark of shape 2"]);
    // Shape 1 is cut, the head stands over the start of shape 2 at ZTop, only Job Running is on.
    assert_eq!(ends(&trace), ["z-10", "z-30", "x100", "z-10", "y50"]);
    let before: Vec<_> = trace
        .edges()
        .into_iter()
        .filter(|edge| !from(vec![edge.clone()], 3.8).is_empty())
        .collect();
    assert_eq!(
        before[..5],
        ["3.840 cut1+", "5.940 cut1-", "6.690 tool1-", "7.640 router-", "7.640 job_running-"],
        "the job is given up there"
    );
}

#[test]
fn pro_path_pause_shape__first_one() {
    let trace = JobRun::new(drawn("line 5,0 100,0; select 1; pause on")).say("start").run();
    // The router starts with the job, not before the operator wants it.
    assert_eq!(trace.edges()[..2], ["0.000 job_running+", "0.441 router+"]);
    assert_eq!(trace.summary.status, Status::Ok);
}

#[test]
fn pro_path_pause_go() {
    let trace = marked().say("start").run();
    let edges = from(trace.edges(), 7.0);
    // Router, its delay of 2 s, air, plunge, bottom delay; shape 2 once, then shape 3 without a halt.
    assert_eq!(
        edges[..6],
        [
            "7.640 router-",
            "7.640 router+",
            "9.640 tool1+",
            "11.180 cut1+",
            "13.280 cut1-",
            "14.030 tool1-"
        ]
    );
    let paused = trace.states().iter().filter(|state| state.contains("paused")).count();
    assert_eq!((paused, trace.summary.status), (1, Status::Ok));
    let lines = ends(&trace);
    assert_eq!(lines.iter().filter(|end| *end == "x0").count(), 1, "once: {lines:?}");
}

#[test]
fn pro_path_pause_go__nothing_happens_before() {
    let machine = Arc::new(kerf_ledger::jobs::sim());
    let mut sequence = Sequence::new(Arc::new(drawn(MARKED)), machine, Axes::default());
    let (mut host, mut out) = (Patient::default(), Vec::new());
    let mut step = Step::Ran;
    while host.asked.is_empty() {
        step = sequence.step(&mut host, &mut out);
    }
    assert_eq!((step, host.asked.as_slice()), (Step::Waiting, ["Shape 2".to_owned()].as_slice()));
    let (given, position) = (out.len(), sequence.position());
    // A minute, looked at a hundred times a second.
    for _ in 0..6000 {
        assert_eq!(sequence.step(&mut host, &mut out), Step::Waiting);
    }
    assert_eq!((out.len(), sequence.position()), (given, position));
    host.answer = Some("start".into());
    while out.len() < given + 3 {
        assert_eq!(sequence.step(&mut host, &mut out), Step::Ran);
    }
    let told: Vec<_> = out[given..].iter().map(|sourced| &sourced.command).collect();
    let router = Output::Router.number();
    assert!(matches!(told[0], Command::State { name, .. } if &**name == "running"), "{told:?}");
    assert_eq!(*told[1], Command::Output { number: router, on: true });
    assert_eq!(*told[2], Command::Wait { seconds: 2.0 });
}

#[test]
fn words_at_a_mark_hold_for_what_follows() {
    let trace = marked().say("cut 3000 ⏎ move x 30 ⏎ start").run();
    assert_eq!(trace.cutting_speeds(), [100.0, 50.0, 50.0]);
    // Moved away by hand, and back before the plunge.
    assert_eq!(ends(&trace)[4..8], ["y50", "x130", "x100", "z-30"]);
    assert_eq!(trace.summary.status, Status::Ok);
}
