//! A run that the operator stops and gives up is taken up where it stood.

use crate::taking_up::{
    GivesUp, PowerCut, PowerCutBehind, PowerCutIn, PowerCutTold, READY, RELEASE, asked, job,
    middle, motion, near, part, press, resume, resume_with, run, run_in, run_work, same_rest,
    uninterrupted,
};
use kerf_control::answers::{Answers, Operator};
use kerf_control::{OperatorRequest, RunContext, Script, StopAt};
use kerf_journal::Journal;
use kerf_machine::Configuration;
use kerf_machine::lines::Input;
use kerf_program::MoveKind;
use kerf_sbp::Status;
use kerf_trace::Event;
use tempfile::tempdir;

#[test]
fn a_run_that_was_given_up_goes_on_where_it_stood() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        let (begun, status) = run(&folder, &mut StopAt(middle(&whole, line)), "hold=Quit");
        assert_eq!(status, Some(Status::Stopped), "line {line}");
        let stood = begun.iter().filter_map(motion).rfind(|made| made.kind == MoveKind::Cut);
        let (rest, status) = resume(&folder, "");
        assert_eq!(status, Status::Ok);
        let first = same_rest(&whole, &rest, line);
        assert!(near(&first.from, &stood.unwrap().to), "line {line}: {first:?}");
        let (journal, _) = Journal::open(folder.path()).unwrap();
        assert!(journal.runs.cut_short().unwrap().is_none(), "it is done");
    }
}

/// A job that is given up in a pause goes on from there; one that was not begun is over.
#[test]
fn a_job_that_was_given_up_in_a_pause_is_taken_up() {
    let given_up = |answers, machine: fn(&mut Configuration)| {
        let folder = tempdir().unwrap();
        let mut answers = Answers::read(answers);
        let (_, status) = run_work(&folder, job(machine), &mut StopAt(5.4), &mut answers);
        assert_eq!(status, Some(Status::Stopped));
        let (journal, _) = Journal::open(folder.path()).unwrap();
        (folder, journal.runs.cut_short().unwrap())
    };
    // Also when he has moved the tool before.
    for answers in ["paused=abort", "jog 0,30,0,0,0,0 1\njog 5,30,0,0,0,0 1\nabort"] {
        let (folder, cut) = given_up(answers, |_| ());
        assert!(cut.is_some_and(|cut| cut.stopped()));
        let (rest, status) = resume(&folder, "hold=Resume\npaused=Resume");
        assert_eq!(status, Status::Ok, "{rest:#?}");
        let cuts = rest.iter().filter_map(motion);
        let cuts = cuts.filter(|made| made.from.x < made.to.x && made.to.z < -15.0);
        let along: Vec<_> = cuts.map(|made| (made.from.x, made.to.x)).collect();
        let (from, to) = (along[0].0, along[along.len() - 1].1);
        assert!(from > 5.0 && from < 95.0 && (to - 100.0).abs() < 1e-9, "{along:?}");
    }
    let (_, cut) = given_up("paused=abort", |machine| machine.misc.double_start = true);
    assert!(cut.is_none(), "it has not begun");
}

/// The power fails when he has said so and the job is not given up yet: he is asked again.
#[test]
fn a_job_that_was_about_to_be_given_up_asks_again() {
    let folder = tempdir().unwrap();
    let operator = &mut Answers::read("paused=abort");
    let context = RunContext {
        sink: &mut PowerCutTold("abort"),
        operator,
        requests: &mut StopAt(5.4),
        machine: kerf_control::simulated(),
    };
    assert_eq!(run_in(&folder, job(|_| ()), context), None, "the power failed");
    let (said, status) = resume(&folder, "paused=abort");
    assert_eq!((asked(&said).len(), status), (1, Status::Stopped), "{said:#?}");
    let (rest, status) = resume(&folder, "hold=Resume\npaused=Resume");
    assert_eq!(status, Status::Ok, "{rest:#?}");
    let to = rest.iter().filter_map(motion).map(|made| made.to.x);
    assert!(to.fold(0.0, f64::max) > 99.9, "the rest is cut");
}

/// A script that says nothing but Resume while a stop is active does not hold a job for ever; it can be taken up.
#[test]
fn a_job_that_is_told_to_go_on_again_and_again_while_a_stop_is_active_is_given_up() {
    for (number, on) in [(4, false), (Input::EmergencyStop.number(), true)] {
        let folder = tempdir().unwrap();
        let mut pace = Script::new(vec![(5.4, OperatorRequest::Input { number, on })], Vec::new());
        let mut says = Answers::read("paused=Resume");
        let (_, status) = run_work(&folder, job(|_| ()), &mut pace, &mut says);
        assert_eq!(status, Some(Status::Stopped), "input {number}");
        press(&folder, number, !on);
        let (rest, status) = resume(&folder, "hold=Resume\npaused=Resume");
        assert_eq!(status, Status::Ok, "input {number}: {rest:#?}");
        let to = rest.iter().filter_map(motion).map(|made| made.to.x);
        assert!(to.fold(0.0, f64::max) > 99.9, "the rest is cut");
    }
}

#[test]
fn who_is_not_ready_can_take_it_up_later() {
    let whole = uninterrupted();
    let folder = tempdir().unwrap();
    run(&folder, &mut StopAt(middle(&whole, 6)), "hold=Quit");
    let (_, status) = resume(&folder, "hold=Quit");
    assert_eq!(status, Status::Stopped);
    let (rest, status) = resume(&folder, "");
    assert_eq!(status, Status::Ok);
    same_rest(&whole, &rest, 6);
}

/// A stop that is told while the machine slows down for a hold comes after it; who gives the run up then takes it up
/// where it stood.
#[test]
fn a_run_that_was_given_up_at_a_stop_in_the_ramp_of_a_hold_goes_on_where_it_stood() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let (folder, at_s) = (tempdir().unwrap(), middle(&whole, line));
        let requests = vec![(at_s, OperatorRequest::Hold), (at_s + 0.02, OperatorRequest::Stop)];
        let mut pace = Script::new(requests, vec![at_s + 2.0]);
        let (begun, status) = run(&folder, &mut pace, "hold=Quit");
        assert_eq!(status, Some(Status::Stopped), "line {line}");
        let held = |event: &Event| matches!(event, Event::Hold { .. });
        assert!(begun.iter().any(held), "line {line}: {begun:#?}");
        assert!(asked(&begun).last().unwrap().starts_with("Stopped."), "line {line}");
        let (rest, status) = resume(&folder, "hold=Resume");
        assert_eq!((asked(&rest), status), (vec![READY], Status::Ok), "line {line}");
        same_rest(&whole, &rest, line);
    }
}

/// A run that is taken up again does not meet the input that stopped it once more.
#[test]
fn a_run_that_was_given_up_at_a_stop_input_goes_on_where_it_stood() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        let pressed = OperatorRequest::Input { number: 4, on: false };
        let mut pace = Script::new(vec![(middle(&whole, line), pressed)], Vec::new());
        let (_, status) = run(&folder, &mut pace, "hold=Quit");
        assert_eq!(status, Some(Status::Stopped), "line {line}");
        // Whoever is asked is asked behind the line before. He is not ready yet.
        let before = line - 1;
        let released = format!("{before}:switch 4 1\n{before}:Resume\n{before}:Quit");
        let (rest, status) = resume(&folder, &released);
        assert_eq!(status, Status::Stopped, "line {line}: {rest:#?}");
        assert_eq!(asked(&rest), [RELEASE, READY], "line {line}");
        let (rest, status) = resume(&folder, "hold=Resume");
        assert_eq!(status, Status::Ok, "line {line}: {rest:#?}");
        assert_eq!(asked(&rest), [READY], "line {line}");
        same_rest(&whole, &rest, line);
    }
}

/// A run that is stopped on the way back and given up has lost nothing of the cut.
#[test]
fn a_run_that_was_given_up_on_the_way_back_goes_on_where_it_stood() {
    let whole = uninterrupted();
    let cut_short = |line| {
        let folder = tempdir().unwrap();
        run(&folder, &mut PowerCut(middle(&whole, line)), "");
        folder
    };
    for line in [5, 6, 7] {
        let (back, _) = resume(&cut_short(line), "");
        let down = back.iter().filter_map(motion).find(|made| made.kind == MoveKind::Cut).unwrap();
        let folder = cut_short(line);
        let mut stop = StopAt(0.5 * (down.t0 + down.t1));
        let (begun, status) =
            resume_with(&folder, &mut stop, &mut PowerCutBehind(&["Resume", "Quit"]));
        assert_eq!(status, Some(Status::Stopped));
        assert!(!begun.iter().any(|event| matches!(event, Event::Resume { .. })), "too late");
        let (rest, status) = resume(&folder, "");
        assert_eq!(status, Status::Ok);
        let [rest, back] = [rest, back].map(|events| same_rest(&whole, &events, line).from);
        assert!(near(&rest, &back), "line {line}: {rest:?}");
    }
}

/// The power fails when a held run is given up, and that is not on record yet.
#[test]
fn a_held_run_that_was_about_to_be_given_up_goes_on() {
    let whole = uninterrupted();
    let (folder, at_s) = (tempdir().unwrap(), middle(&whole, 5));
    let pace = &mut Script::new(vec![(at_s, OperatorRequest::Hold)], Vec::new());
    let context = RunContext {
        sink: &mut PowerCutIn("idle"),
        operator: &mut (),
        requests: pace,
        machine: kerf_control::simulated(),
    };
    assert_eq!(run_in(&folder, part(), context), None, "the power failed");
    let (rest, status) = resume(&folder, "hold=Resume");
    assert_eq!((asked(&rest), status), (vec![READY], Status::Ok), "{rest:#?}");
    same_rest(&whole, &rest, 5);
}

/// Whoever gives a run up while it asks him something, or behind that at a stop input, can take it up there.
#[test]
fn a_run_that_was_given_up_at_a_question_is_taken_up() {
    const STILL: &str = "MX,1\nPAUSE\nMX,5\n";
    const TURNS: &str = "SO,1,1\nMX,1\nPAUSE\nMX,5\n";
    let pressed = &mut Answers::read("3:switch 4 0\n3:OK\nhold=Quit");
    let runs: [(&str, &mut dyn Operator); 2] = [(STILL, &mut GivesUp), (TURNS, pressed)];
    for (text, operator) in runs {
        let (folder, work) = (tempdir().unwrap(), kerf_part::read("a.sbp".into(), text.as_bytes()));
        assert_eq!(run_work(&folder, work, &mut (), operator).1, Some(Status::Stopped), "{text}");
        press(&folder, 4, true);
        let (rest, status) = resume(&folder, "pause=OK\nhold=Resume");
        assert_eq!(status, Status::Ok, "{text}: {rest:#?}");
        let to: Vec<f64> = rest.iter().filter_map(motion).map(|made| made.to.x).collect();
        assert_eq!(to.last(), Some(&5.0), "{text}");
        let turns = rest.iter().any(|it| matches!(it, Event::Output { n: 1, on: true, .. }));
        assert_eq!(turns, text == TURNS, "{text}: {rest:#?}");
    }
}
