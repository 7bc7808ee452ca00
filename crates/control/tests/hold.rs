//! Runs that the operator stops in the middle: resumed, nudged, given up.

#![allow(clippy::unwrap_used, non_snake_case)]

use kerf_control::event::Place;
use kerf_control::{Event, Outcome, TextOptions, run_text};
use kerf_program::Axis;
use kerf_sbp::Status;

/// Runs a program in inches that is stopped at a time, with answers.
fn held(program: &str, stop_at_s: f64, answers: &str) -> Outcome {
    let options = TextOptions { stop_at_s: Some(stop_at_s), ..TextOptions::default() };
    run_text(&[("a.sbp", program)], "a.sbp", options.answers(answers))
}

/// Where the tool is at the end: working and base location of an axis, in.
fn places(outcome: &Outcome, axis: Axis) -> (f64, f64) {
    let m = &outcome.session.memory;
    let user = |place| (m.settings.to_user(place)[axis] * 1e6).round() / 1e6;
    (user(m.frame.working(m.position)), user(m.frame.base(m.position)))
}

fn ends(outcome: &Outcome) -> Vec<Place> {
    let to = outcome.events.iter().filter_map(|event| match event {
        Event::Move(made) => Some(made.to),
        Event::Arc(arc) => Some(arc.made.to),
        _ => None,
    });
    to.map(|p| Place { x: round(p.x), y: round(p.y), z: round(p.z), ..p }).collect()
}

fn round(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

fn xyz(x: f64, y: f64, z: f64) -> Place {
    Place { x, y, z, ..Place::default() }
}

const SQUARE: &str = "MZ,-.5\nMX,10\nMY,5\nMX,0\nMY,0\nPRINT %(1);\" \";%(2)\n";

#[test]
fn nobody_answers_the_run_is_over() {
    let given_up = held(SQUARE, 2.0, "");
    assert_eq!(given_up.summary.status, Status::Stopped);
    assert_eq!(places(&given_up, Axis::Z).0, 1.0, "the tool was lifted");
}

#[test]
fn sbp_lim_stop_resume() {
    let resumed = held(SQUARE, 2.0, "hold=Resume");
    assert_eq!(resumed.summary.status, Status::Ok);
    let ends = ends(&resumed);
    let stood = ends[1];
    let lifted = Place { z: 1.0, ..stood };
    assert!(stood.x > 0.5 && stood.x < 9.5 && stood.z == -0.5, "{ends:?}");
    assert_eq!(ends[1..5], [stood, lifted, stood, xyz(10.0, 0.0, -0.5)]);
    assert!(resumed.events.iter().any(|e| matches!(e, Event::Resume { .. })));
}

#[test]
fn sbp_cmd_mn_infile() {
    let nudged = held(SQUARE, 2.0, "nudge y .05\nResume");
    assert_eq!(nudged.summary.status, Status::Ok);
    assert_eq!(places(&nudged, Axis::Y), (0.0, 0.05), "the path is shifted");
    assert_eq!(places(&nudged, Axis::X), (0.0, 0.0));
    let corners = [xyz(10.0, 0.0, -0.5), xyz(10.0, 5.0, -0.5), xyz(0.0, 5.0, -0.5)];
    assert!(ends(&nudged).windows(3).any(|w| w == corners), "{:?}", ends(&nudged));
    assert!(
        nudged.events.iter().any(|e| matches!(e, Event::Print { text, .. } if &**text == "0 0"))
    );
}

#[test]
fn sbp_cmd_mn_infile__wherever_the_run_stops() {
    // Repetitions of an arc lift and jog within one line; a pause; a file that calls another.
    let programs = [
        "MZ,-.1\nCC,2,T,1,90,180,0,1,1,1,-.1,3\nM2,1,1\n",
        "VB,.1,4,1,.5\nVB,,,,,0\nFP,b.sbp,2,2,1,2,1,-.1,1\nM2,1,1\n",
        "MX,1\nPAUSE 3\nM2,1,1\n",
        "MH\nSR\nM2,3,3\nM2,-2,-2\nSA\n",
        "&n=0\nL:\nM2,&n,1\nJ2,0,0\n&n=&n+1\nIF &n<5 THEN GOTO L\nM2,1,1\n",
        "M2,3,3\nZX\nM2,0,1\nVA,1\n",
    ];
    for program in programs {
        let files = [("a.sbp", program), ("b.sbp", "M2,4,0\nM2,4,2\nJ2,0,0\n")];
        let straight = run_text(&files, "a.sbp", TextOptions::default());
        for tenths in 1..60 {
            let options =
                TextOptions { stop_at_s: Some(f64::from(tenths) / 10.0), ..TextOptions::default() };
            let nudged = run_text(&files, "a.sbp", options.answers("nudge y .05\nResume"));
            if !nudged.events.iter().any(|e| matches!(e, Event::Resume { .. })) {
                continue;
            }
            let (y, base) = places(&nudged, Axis::Y);
            let (y0, base0) = places(&straight, Axis::Y);
            assert_eq!((y, round(base)), (y0, round(base0 + 0.05)), "{program} at {tenths}");
            assert_eq!(places(&nudged, Axis::X), places(&straight, Axis::X), "{program} {tenths}");
            assert_eq!(places(&nudged, Axis::Z), places(&straight, Axis::Z), "{program} {tenths}");
            assert_eq!(nudged.summary.status, straight.summary.status);
        }
    }
}

#[test]
fn a_pause_that_is_held_goes_on_for_the_rest_of_its_time() {
    let (straight, resumed) = (held("PAUSE 3\n", 99.0, ""), held("PAUSE 3\n", 1.0, "hold=Resume"));
    assert!((straight.summary.seconds - 3.0).abs() < 1e-9);
    let lift_s = resumed.summary.seconds - 3.0;
    assert!(lift_s > 0.0 && lift_s < 5.0, "{lift_s}");
}

#[test]
fn a_nudge_off_the_table_is_refused() {
    let program = "VL,0,20,0,20,-5,5\nSF,1\nMX,10\n";
    let refused = held(program, 2.0, "nudge y 99\nResume");
    assert_eq!((refused.summary.status, places(&refused, Axis::Y)), (Status::Ok, (0.0, 0.0)));
    let told =
        refused.events.iter().any(|e| matches!(e, Event::Diag(d) if d.message.contains("Y")));
    assert!(told);
}

#[test]
fn outputs_that_follow_a_stop_come_back() {
    // Off with a stop and on again: mode 2 when it was on before, mode 5 always.
    let check = |program: &str, expected: &[bool]| {
        let resumed = held(program, 2.0, "hold=Resume");
        assert_eq!(resumed.summary.status, Status::Ok);
        let switched = resumed.events.iter().filter_map(|e| match e {
            Event::Output { n: 3, on, .. } => Some(*on),
            _ => None,
        });
        assert_eq!(switched.collect::<Vec<bool>>(), expected, "{program}");
    };
    check("VN,,,,,,,,,,,,,,,,,2\nSO,3,1\nMX,10\n", &[true, false, true, false]);
    check("VN,,,,,,,,,,,,,,,,,2\nMX,10\n", &[]);
    check("VN,,,,,,,,,,,,,,,,,5\nMX,10\n", &[true, false]);
}
