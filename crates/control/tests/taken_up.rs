//! A run that was killed is taken up at the exact place: nothing is cut twice, nothing is left out,
//! and the path is that of the uninterrupted run.

use crate::taking_up::{
    PowerCut, PowerCutBehind, PowerCutHeld, PowerCutSaid, READY, RELEASE, asked,
    asked_and_switched, behind, middle, motion, near, part, press, resume, resume_with, run,
    run_work, same_rest, stands, uninterrupted, workspace,
};
use kerf_control::answers::Answers;
use kerf_control::{AtRest, OperatorRequest, Requests, RunContext, Script, Session, StopAt};
use kerf_journal::{Journal, Press, RunOptions};
use kerf_machine::lines::Input;
use kerf_program::{Axes, Axis, Dynamics, MoveKind, Settings};
use kerf_sbp::Status;
use kerf_trace::{Event, event::Location};
use kerf_workspace::Workspace;
use std::panic::{AssertUnwindSafe, catch_unwind};
use tempfile::{TempDir, tempdir};

#[test]
fn after_a_power_cut_nothing_is_cut_twice() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        let at_s = middle(&whole, line);
        let (_, status) = run(&folder, &mut PowerCut(at_s), "");
        assert_eq!(status, None, "the power failed");
        let (rest, status) = resume(&folder, "");
        assert_eq!(status, Status::Ok);
        let first = same_rest(&whole, &rest, line);
        let made = whole.iter().filter_map(motion).find(|made| made.line == line).unwrap();
        let way = |a: &Location, b: &Location| (a.x - b.x).hypot(a.y - b.y);
        let share = way(&made.from, &first.from) / way(&made.from, &made.to);
        assert!((0.3..0.7).contains(&share), "line {line} goes on at {share} of its way");
    }
}

#[test]
fn the_way_back_is_safe() {
    let whole = uninterrupted();
    let folder = tempdir().unwrap();
    run(&folder, &mut PowerCut(middle(&whole, 6)), "");
    let (rest, _) = resume(&folder, "");
    let steps: Vec<String> = rest
        .iter()
        .skip_while(|e| !matches!(e, Event::Message { .. }))
        .take_while(|e| !matches!(e, Event::Resume { .. }))
        .filter_map(|event| match event {
            Event::Ask(asked) => Some(format!("ask {}", asked.text)),
            Event::Output { n: 1, on, .. } => Some(format!("output {on}")),
            _ => motion(event).map(|made| match made.kind {
                MoveKind::Jog => format!("up to {:.1}", made.to.z),
                MoveKind::Cut => format!("down to {:.1}", made.to.z),
            }),
        })
        .collect();
    let ready =
        "ask Output 1 comes on, the tool goes back to where the cut ended. Is everything ready?";
    assert_eq!(steps, ["up to 1.0", ready, "output true", "down to -0.2"]);
}

#[test]
fn whoever_takes_up_a_job_is_told_what_comes_on() {
    // In the delay of the router, on the way down, along the path.
    for at_s in [1.0, 3.3, 5.4] {
        let (asked, on) = asked_and_switched(at_s);
        let told = "Outputs job_running, router, tool1, cut1 come on, the tool goes back";
        assert!(asked.starts_with(told), "{asked}");
        assert_eq!(on, ["job_running", "router", "tool1", "cut1"], "cut short at {at_s} s");
    }
}

#[test]
fn a_switch_that_was_moved_at_rest_is_on_record() {
    let folder = tempdir().unwrap();
    let open = |folder: &TempDir| {
        let (journal, _) = Journal::open(folder.path()).unwrap();
        let mut workspace = workspace(&journal, folder);
        let (session, _) = Session::recall(&journal, &mut workspace).unwrap();
        (session, workspace)
    };
    let part = b"IF %(53)=0 THEN GOTO OFF\nMX,1\nMX,5\nMX,9\nEND\nOFF:\nMX,-5\n";
    let start = |session: &mut Session, workspace: &mut Workspace, pace: &mut dyn Requests| {
        let context = RunContext {
            sink: &mut (),
            operator: &mut (),
            requests: pace,
            machine: kerf_control::simulated(),
        };
        let program = kerf_part::read("a.sbp".into(), part);
        session.run_on_record(program, RunOptions::default(), None, workspace, context).map(drop)
    };
    let (mut session, mut workspace) = open(&folder);
    start(&mut session, &mut workspace, &mut ()).unwrap();
    assert!(session.memory.position[Axis::X] < 0.0, "the switch is open");
    AtRest(&mut session).press(Press { number: 3, on: true }, &mut workspace);
    drop((session, workspace));
    // Kerf is started anew.
    let (mut session, mut workspace) = open(&folder);
    assert!(session.look(|machine| machine.input(3)), "it stays as it was put");
    let cut =
        catch_unwind(AssertUnwindSafe(|| start(&mut session, &mut workspace, &mut PowerCut(6.0))));
    assert!(cut.is_err(), "the power failed");
    drop((session, workspace));
    let (events, status) = resume(&folder, "hold=Resume");
    let last = events.iter().rev().find_map(|event| match event {
        Event::Move(made) => Some(made.to.x),
        _ => None,
    });
    assert_eq!((status, last), (Status::Ok, Some(9.0)), "{events:?}");
}

#[test]
fn settings_with_an_axis_whose_jerk_is_free_can_be_read_again() {
    // A jerk limit of 0 leaves an axis free: that is infinite, which a record has no number for.
    let mut jerk = Axes::splat(5000.0);
    jerk[Axis::Y] = f64::INFINITY;
    let mut settings = Settings::default();
    let usual = Dynamics::usual(&settings.speeds);
    settings.dynamics = Some(Dynamics { jerk_mm_s3: Some(jerk), ..usual });
    let text = serde_json::to_string(&settings).unwrap();
    assert_eq!(serde_json::from_str::<Settings>(&text).unwrap(), settings);
}

/// The power fails while somebody is asked what follows on a stop: he is asked once, before the tool goes back.
#[test]
fn a_question_that_was_open_is_settled_when_the_tool_goes_back() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let at_s = middle(&whole, line);
        // The stop input opens its circuit.
        let pressed = OperatorRequest::Input { number: 4, on: false };
        let stops: [&mut dyn Requests; 4] = [
            &mut StopAt(at_s),
            &mut Script::new(vec![(at_s, OperatorRequest::Stop)], Vec::new()),
            &mut Script::new(vec![(at_s, pressed)], Vec::new()),
            &mut PowerCutHeld(at_s),
        ];
        for (n, pace) in stops.into_iter().enumerate() {
            let folder = tempdir().unwrap();
            let (_, status) = run_work(&folder, part(), pace, &mut PowerCutBehind(&[]));
            assert_eq!(status, None, "the power failed");
            // And again when he is asked whether all is ready.
            let (_, status) = resume_with(&folder, &mut (), &mut PowerCutBehind(&[]));
            assert_eq!(status, None, "the power failed");
            let released = format!("{line}:switch 4 1\nhold=Resume");
            let answers = if n == 2 { &released } else { "hold=Resume" };
            let (rest, status) = resume(&folder, answers);
            assert_eq!(status, Status::Ok, "line {line}, stop {n}: {rest:#?}");
            let pressed: &[&str] = if n == 2 { &[RELEASE] } else { &[] };
            assert_eq!(asked(&rest), [pressed, &[READY]].concat(), "line {line}, stop {n}");
            same_rest(&whole, &rest, line);
        }
    }
}

/// Counts the cut from before the power failed: only the way back down is more than without it.
#[test]
fn the_whole_cut_is_counted() {
    let whole = uninterrupted();
    let cut = |events: &[Event]| match events.last() {
        Some(Event::End(end)) => end.cut,
        _ => panic!("no end"),
    };
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        run(&folder, &mut PowerCut(middle(&whole, line)), "");
        let (rest, _) = resume(&folder, "");
        let down = rest.iter().filter_map(motion).find(|made| made.kind == MoveKind::Cut).unwrap();
        let back = down.from.z - down.to.z;
        let more = cut(&rest) - cut(&whole);
        assert!((more - back).abs() < 1e-6, "line {line}: {more} more, {back} down again");
    }
}

/// The program asks something before the tool goes back, and the power fails once more.
#[test]
fn a_question_of_the_program_behind_one_that_was_open_is_asked_once() {
    const ASKS: &str = "SA\nMX,1\nPAUSE 5\nINPUT \"How far\" &far\nMX,&far\nMX,3\n";
    let (folder, asks) = (tempdir().unwrap(), kerf_part::read("a.sbp".into(), ASKS.as_bytes()));
    let (whole, _) = run_work(&tempdir().unwrap(), asks, &mut (), &mut Answers::read("2"));
    let waits = |event: &Event| match event {
        Event::Wait { t, .. } => Some(t + 1.0),
        _ => None,
    };
    let mut stop = StopAt(whole.iter().find_map(waits).unwrap());
    let asks = kerf_part::read("a.sbp".into(), ASKS.as_bytes());
    assert_eq!(run_work(&folder, asks, &mut stop, &mut PowerCutBehind(&[])).1, None);
    let (begun, status) = resume_with(&folder, &mut (), &mut PowerCutSaid("2"));
    assert_eq!((asked(&begun).len(), status), (1, None), "{begun:#?}");
    let (rest, status) = resume(&folder, "hold=Resume");
    assert_eq!(status, Status::Ok, "{rest:#?}");
    assert!(asked(&rest)[0].ends_with("Is everything ready?"), "{rest:#?}");
    let along: Vec<_> = behind(&rest).iter().filter_map(motion).map(|made| made.to.x).collect();
    assert_eq!(along[along.len() - 2..], [2.0, 3.0]);
}

/// A workpiece that was nudged before the power failed is still nudged afterwards, also when it fails again before
/// the tool is back.
#[test]
fn a_nudge_before_the_power_failed_is_on_record() {
    let whole = uninterrupted();
    let (folder, line) = (tempdir().unwrap(), 6);
    let mut stop = StopAt(middle(&whole, line));
    let nudge = &mut PowerCutBehind(&["nudge y .25"]);
    assert_eq!(run_work(&folder, part(), &mut stop, nudge).1, None, "the power failed");
    let nudge = &mut PowerCutBehind(&["nudge y .5"]);
    assert_eq!(resume_with(&folder, &mut (), nudge).1, None, "the power failed");
    let (rest, status) = resume(&folder, "hold=Resume");
    assert_eq!(status, Status::Ok);
    assert_eq!(asked(&rest), [READY]);
    same_rest(&whole, &rest, line);
    // What is shown stays; the machine is elsewhere.
    let unmoved = tempdir().unwrap();
    run(&unmoved, &mut (), "");
    let by = stands(&folder).minus(stands(&unmoved));
    assert!((by[Axis::Y] - 0.75 * 25.4).abs() < 1e-9, "{by:?}");
}

/// Nothing moves and nothing comes on before the emergency stop is released, and nothing of the cut is lost.
#[test]
fn a_run_is_not_taken_up_while_the_emergency_stop_is_pressed() {
    let whole = uninterrupted();
    let emergency = Input::EmergencyStop.number();
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        let pressed = OperatorRequest::Input { number: emergency, on: true };
        let mut pace = Script::new(vec![(middle(&whole, line), pressed)], Vec::new());
        let (begun, status) = run(&folder, &mut pace, "");
        assert_eq!(status, Some(Status::Stopped));
        let stood = begun.iter().filter_map(motion).next_back().unwrap().to;
        let (said, status) = resume(&folder, "hold=Resume");
        assert_eq!((asked(&said), status), (vec![], Status::Stopped), "line {line}: {said:#?}");
        let comes_on = |event: &Event| matches!(event, Event::Output { on: true, .. });
        assert!(!said.iter().any(|event| comes_on(event) || motion(event).is_some()), "{said:#?}");
        press(&folder, emergency, false);
        let (rest, status) = resume(&folder, "hold=Resume");
        assert_eq!((asked(&rest), status), (vec![READY], Status::Ok), "line {line}");
        let first = same_rest(&whole, &rest, line);
        assert!(near(&first.from, &stood), "line {line}: {first:?}");
    }
}

/// The tool does not go down before it is asked whether all is ready.
#[test]
fn a_run_that_is_taken_up_at_a_stop_input_only_rises_when_that_is_released() {
    let whole = uninterrupted();
    let folder = tempdir().unwrap();
    run(&folder, &mut PowerCut(middle(&whole, 6)), "");
    press(&folder, 4, false);
    let (rest, status) = resume(&folder, "5:switch 4 1\nhold=Resume");
    assert_eq!((asked(&rest), status), (vec![RELEASE, READY], Status::Ok));
    let ready = rest.iter().rposition(|event| matches!(event, Event::Ask(_))).unwrap();
    let kinds: Vec<_> = rest[..ready].iter().filter_map(motion).map(|made| made.kind).collect();
    assert_eq!(kinds, [MoveKind::Jog], "it only rises");
    same_rest(&whole, &rest, 6);
}

/// Whoever moves another switch while the machine slows down for a stop input is not told of that again.
#[test]
fn a_switch_that_is_moved_behind_a_stop_input_does_not_hide_it() {
    const RAMPED: &str = "VN,,,,,,,3\nSA\nMX,1\nMX,9\nMX,12\n";
    let work = || kerf_part::read("a.sbp".into(), RAMPED.as_bytes());
    let (whole, _) = run_work(&tempdir().unwrap(), work(), &mut (), &mut ());
    let (folder, at_s) = (tempdir().unwrap(), middle(&whole, 4));
    let input = |number, after_s, on| (at_s + after_s, OperatorRequest::Input { number, on });
    let mut pace = Script::new(vec![input(5, 0.0, true), input(1, 0.02, true)], Vec::new());
    let (begun, status) = run_work(&folder, work(), &mut pace, &mut Answers::read("hold=Quit"));
    assert_eq!(status, Some(Status::Stopped));
    let stops = |event: &Event| match event {
        Event::Stop { n, .. } => Some(*n),
        _ => None,
    };
    assert_eq!(begun.iter().filter_map(stops).collect::<Vec<_>>(), [5], "{begun:#?}");
    let cut = begun.iter().filter_map(motion).rfind(|made| made.kind == MoveKind::Cut).unwrap();
    press(&folder, 5, false);
    let (rest, status) = resume(&folder, "hold=Resume");
    assert_eq!((asked(&rest).len(), status), (1, Status::Ok), "{rest:#?}");
    let first = behind(&rest).iter().find_map(motion).unwrap();
    assert!(near(&first.from, &cut.to), "{first:?} {cut:?}");
}
