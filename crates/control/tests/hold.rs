//! Runs that the operator stops in the middle: resumed, nudged, given up.

use kerf_control::answers::Answers;
use kerf_control::{OperatorRequest, Outcome, RunContext, Script, Session, TextOptions, run_text};
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::Configuration;
use kerf_machine::lines::Input;
use kerf_machine::settings::estop::EmergencyStop;
use kerf_model::{CABLE, Change};
use kerf_program::{Axis, AxisSet};
use kerf_sbp::{POSITION_LOST, Status};
use kerf_trace::{Event, Summary, event::Location};
use kerf_workspace::Workspace;

/// Runs a program in inches that is stopped at a time, with answers.
fn held(program: &str, stop_at_s: f64, answers: &str) -> Outcome {
    let options = TextOptions { stop_at_s: Some(stop_at_s), ..TextOptions::default() };
    run_text(&[("a.sbp", program)], "a.sbp", options.answers(answers))
}

/// Working and base location of an axis at the end, in.
fn places(outcome: &Outcome, axis: Axis) -> (f64, f64) {
    let m = &outcome.session.memory;
    let user = |place| (m.settings.to_user(place)[axis] * 1e6).round() / 1e6;
    (user(m.frame.working(m.position)), user(m.frame.base(m.position)))
}

fn ends(outcome: &Outcome) -> Vec<Location> {
    let to = outcome.events.iter().filter_map(|event| match event {
        Event::Move(made) => Some(made.to),
        Event::Arc(arc) => Some(arc.made.to),
        _ => None,
    });
    to.map(rounded).collect()
}

fn rounded(p: Location) -> Location {
    Location { x: round(p.x), y: round(p.y), z: round(p.z), ..p }
}

fn round(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

fn xyz(x: f64, y: f64, z: f64) -> Location {
    Location { x, y, z, ..Location::default() }
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
    let lifted = Location { z: 1.0, ..stood };
    assert!(stood.x > 0.5 && stood.x < 9.5 && stood.z == -0.5, "{ends:?}");
    assert_eq!(ends[1..5], [stood, lifted, stood, xyz(10.0, 0.0, -0.5)]);
    assert!(resumed.events.iter().any(|e| matches!(e, Event::Resume { .. })));
}

/// A run that is stopped at 2 s and resumed; the operator wants more, and an input changes.
fn stopped_again(
    requests: &[(f64, OperatorRequest)],
    inputs: &[Change],
    answers: &str,
) -> (Summary, Vec<Event>) {
    let mut events = Vec::new();
    let mut session = Session::default();
    session.memory.settings.warning_s = 0.0;
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let mut operator = Answers::read(answers);
    let requests = [&[(2.0, OperatorRequest::Stop)], requests].concat();
    let mut pace = Script::new(requests, Vec::new());
    let context = RunContext {
        sink: &mut events,
        operator: &mut operator,
        requests: &mut pace,
        machine: kerf_control::simulated(),
    };
    let options = RunOptions { inputs: inputs.to_vec(), ..RunOptions::default() };
    let program = kerf_sbp::read("a.sbp".into(), format!("SO,1,1\n{SQUARE}").as_bytes());
    let summary = session.run(program, options, &mut workspace, context);
    (summary, events)
}

/// Moves of a run: when they begin and end, where they lead.
fn moves(events: &[Event]) -> Vec<(f64, f64, Location)> {
    let made = events.iter().filter_map(|event| match event {
        Event::Move(made) => Some((made.t0, made.t1, made.to)),
        _ => None,
    });
    made.collect()
}

/// Moments within the lift and the way back of a run that is stopped at 2 s and resumed.
fn lift_and_way_back() -> Vec<f64> {
    let (_, events) = stopped_again(&[], &[], "hold=Resume");
    let beside = &moves(&events)[2..4];
    assert!(beside[0].2.z == 1.0 && beside[1].2.z == -0.5, "{beside:?}");
    let share =
        |(from, to, _): &(f64, f64, Location)| [0.1, 0.5, 0.9].map(|s| from + (to - from) * s);
    beside.iter().flat_map(share).collect()
}

#[test]
fn the_operator_stops_the_lift_and_the_way_back() {
    for at_s in lift_and_way_back() {
        let (summary, events) = stopped_again(&[(at_s, OperatorRequest::Stop)], &[], "hold=Resume");
        assert_eq!(summary.status, Status::Ok, "{at_s}");
        let stops: Vec<f64> = events
            .iter()
            .filter_map(|event| match event {
                Event::Stop { t, .. } => Some(*t),
                _ => None,
            })
            .collect();
        assert_eq!(stops.len(), 2, "{at_s}");
        assert!((stops[1] - at_s).abs() < 0.3, "it stands at {} and not at {at_s}", stops[1]);
        let mut made = moves(&events);
        let corners: Vec<Location> =
            made.split_off(made.len() - 4).into_iter().map(|(.., to)| rounded(to)).collect();
        let square =
            [(10.0, 0.0), (10.0, 5.0), (0.0, 5.0), (0.0, 0.0)].map(|(x, y)| xyz(x, y, -0.5));
        assert_eq!(corners, square, "{at_s}");
        let given_up = stopped_again(&[(at_s, OperatorRequest::Stop)], &[], "Resume\nQuit\nQuit").0;
        assert!([Status::Stopped, Status::Ok].contains(&given_up.status), "{at_s}");
    }
}

#[test]
fn a_stop_input_stops_the_lift_and_the_way_back() {
    for at_s in lift_and_way_back() {
        let pressed =
            [(at_s, false), (at_s + 3.0, true)].map(|(at_s, on)| Change { input: 4, at_s, on });
        let (summary, events) = stopped_again(&[], &pressed, "hold=Resume");
        assert_eq!(summary.status, Status::Ok, "{at_s}");
        for (from, to, _) in moves(&events) {
            let apart = to <= at_s + 1e-6 || from >= at_s + 3.0 - 1e-6;
            assert!(apart, "it moves from {from} to {to} although stopped at {at_s}");
        }
        let spindle: Vec<(f64, bool)> = events
            .iter()
            .filter_map(|event| match event {
                Event::Output { n: 1, on, t, .. } => Some((*t, *on)),
                _ => None,
            })
            .collect();
        let during =
            |t: f64| spindle.iter().rfind(|(when, _)| *when <= t + 1e-6).is_some_and(|it| it.1);
        assert!(during(at_s - 0.01) && !during(at_s) && !during(at_s + 2.9), "{at_s}: {spindle:?}");
        let last = moves(&events).last().unwrap().0;
        assert!(during(last), "it turns when it cuts again: {spindle:?}");
        let corner =
            |at: Location| moves(&events).iter().any(|it| (it.2.x, it.2.y) == (at.x, at.y));
        assert!(corner(xyz(10.0, 5.0, 0.0)) && corner(xyz(0.0, 5.0, 0.0)), "{at_s}");
        let given_up = stopped_again(&[], &pressed, "Resume\nQuit\nQuit").0;
        assert_eq!(given_up.status, Status::Stopped, "{at_s}");
    }
}

/// A run that an input stops, with a request of the operator a moment later: what comes of it.
fn stopped_by_both(input: u8, by_hand: OperatorRequest, answers: &str) -> (Summary, Vec<Event>) {
    let mut events = Vec::new();
    let mut session = Session::default();
    session.memory.settings.warning_s = 0.0;
    // Input 7 stops too, with a ramp; input 4 stops at once, and is closed until then.
    session.memory.settings.io.inputs[6] = 3;
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let mut operator = Answers::read(answers);
    let mut pace = Script::new(vec![(2.01, by_hand)], Vec::new());
    let context = RunContext {
        sink: &mut events,
        operator: &mut operator,
        requests: &mut pace,
        machine: kerf_control::simulated(),
    };
    let pressed = |at_s, stops: bool| Change { input, at_s, on: stops == (input != 4) };
    let inputs = vec![pressed(2.0, true), pressed(9.0, false)];
    let options = RunOptions { inputs, ..RunOptions::default() };
    let program = kerf_sbp::read("a.sbp".into(), b"MS,4,4\nMX,20\n");
    let summary = session.run(program, options, &mut workspace, context);
    (summary, events)
}

#[test]
fn a_stop_of_the_operator_that_comes_with_one_of_an_input_is_the_same() {
    for (input, by_hand) in [
        (4, OperatorRequest::Stop),
        (7, OperatorRequest::Stop),
        (4, OperatorRequest::Hold),
        (7, OperatorRequest::Hold),
    ] {
        let (summary, events) = stopped_by_both(input, by_hand, "hold=Resume");
        assert_eq!(summary.status, Status::Ok, "{input} {by_hand:?}");
        let stops = |event: &&Event| matches!(event, Event::Stop { .. } | Event::Hold { .. });
        assert_eq!(events.iter().filter(stops).count(), 1, "{input} {by_hand:?}: {events:?}");
        assert_eq!(moves(&events).last().unwrap().2, xyz(20.0, 0.0, 0.0), "{input} {by_hand:?}");
        let (given_up, events) = stopped_by_both(input, by_hand, "hold=Quit");
        assert_eq!(given_up.status, Status::Stopped, "{input} {by_hand:?}");
        assert!(moves(&events).last().unwrap().1 < 5.0, "{input} {by_hand:?}");
    }
}

#[test]
fn a_lost_link_ends_the_lift_and_the_way_back() {
    for at_s in lift_and_way_back() {
        let pulled = [Change { input: CABLE, at_s, on: false }];
        let (summary, events) = stopped_again(&[], &pulled, "hold=Resume");
        assert_eq!(summary.status, Status::Failed, "{at_s}");
        assert!(moves(&events).iter().all(|(_, to, _)| *to < at_s + 0.5), "{at_s}");
    }
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

#[test]
fn a_nudge_stays_when_the_run_is_given_up() {
    let given_up = held(SQUARE, 2.0, "nudge y .05\nQuit");
    assert_eq!(given_up.summary.status, Status::Stopped);
    assert_eq!(places(&given_up, Axis::Y), (0.0, 0.05), "the workpiece lies elsewhere");
}

/// A workshop in which one run comes after another.
struct Shop {
    session: Session,
    workspace: Workspace,
}

impl Shop {
    fn new(machine: Configuration) -> Self {
        let mut session = Session::default();
        session.machine_is = machine.into();
        Self { session, workspace: Workspace::in_memory(MemoryDisk::default()) }
    }

    /// A machine that cuts its power with the emergency stop, whose X and Y have home switches.
    fn alpha() -> Self {
        let estop = EmergencyStop { cuts_power: true, ..EmergencyStop::default() };
        let sim = kerf_machine::profile::profile("sim").unwrap();
        let sim = kerf_machine::file::read(&"sim".into(), sim.text).unwrap();
        let mut machine = Configuration { estop, ..sim };
        machine.homing.switches[Axis::Z.index()].fitted = false;
        Self::new(machine)
    }

    fn run(
        &mut self,
        program: &str,
        input: Option<Change>,
        answers: &str,
    ) -> (Summary, Vec<Event>) {
        let mut events = Vec::new();
        let mut operator = Answers::read(answers);
        let context = RunContext {
            sink: &mut events,
            operator: &mut operator,
            requests: &mut (),
            machine: kerf_control::simulated(),
        };
        let options = RunOptions { inputs: input.into_iter().collect(), ..RunOptions::default() };
        let program = kerf_sbp::read("a.sbp".into(), program.as_bytes());
        let summary = self.session.run(program, options, &mut self.workspace, context);
        (summary, events)
    }

    /// Lines typed at the command line, and what is told.
    fn types(&mut self, lines: &str) -> String {
        let mut options = RunOptions::default();
        options.program.typed = true;
        let mut events: Vec<Event> = Vec::new();
        let context = RunContext {
            sink: &mut events,
            operator: &mut (),
            requests: &mut (),
            machine: kerf_control::simulated(),
        };
        let typed = kerf_sbp::read_typed("command".into(), lines);
        self.session.run(typed, options, &mut self.workspace, context);
        let told = events.iter().filter_map(|event| match event {
            Event::Message { text, .. } => Some(&**text),
            _ => None,
        });
        told.collect::<Vec<_>>().join("\n")
    }

    fn lost(&self) -> &str {
        self.workspace.stored.get(POSITION_LOST).unwrap_or_default()
    }
}

fn asked(events: &[Event]) -> Vec<&str> {
    let mut texts = Vec::new();
    for event in events {
        if let Event::Ask(ask) = event {
            texts.push(&*ask.text);
        }
    }
    texts
}

#[test]
fn sbp_lim_estop_rezero() {
    let pressed = Some(Change { input: 4, at_s: 1.0, on: false });
    let estop = || {
        let mut shop = Shop::alpha();
        assert_eq!(shop.run("MX,10\n", pressed, "").0.status, Status::Stopped);
        assert_eq!(shop.lost(), "XYZ");
        shop
    };
    // Without an answer nothing is cut.
    let mut shop = estop();
    let (summary, events) = shop.run("MX,1\n", None, "");
    assert_eq!(summary.status, Status::Stopped);
    assert!(asked(&events)[0].contains("Position unverified: x, y, z"), "{events:?}");
    assert!(!events.iter().any(|event| matches!(event, Event::Move(_))), "{events:?}");
    // X and Y are homed, Z is confirmed.
    let (summary, events) = shop.run("MX,1\n", None, "0:Yes\n0:Continue");
    assert_eq!((summary.status, shop.lost(), asked(&events).len()), (Status::Ok, "", 2));
    assert_eq!(shop.session.homed, AxisSet::EMPTY.with(Axis::X).with(Axis::Y));
    assert!(asked(&shop.run("MX,2\n", None, "").1).is_empty());
    // The location is right as it is.
    let mut shop = estop();
    let (summary, events) = shop.run("MX,1\n", None, "location=Continue");
    assert_eq!((summary.status, shop.lost(), asked(&events).len()), (Status::Ok, "", 1));
    // It is set, and then nobody says any more that it is not verified; an axis alone leaves the others.
    let mut shop = estop();
    assert!(shop.types("UD\n").contains("not verified: X Y Z"));
    shop.types("ZX\n");
    assert_eq!(shop.lost(), "YZ");
    assert!(shop.types("UD\n").contains("not verified: Y Z"));
    assert!(asked(&shop.run("MX,1\n", None, "").1)[0].contains("Position unverified: y, z"));
    shop.types("ZY\nZZ\n");
    assert_eq!(shop.lost(), "");
    let told = shop.types("UD\n");
    assert!(!told.is_empty() && !told.contains("verified"), "{told}");
    let (summary, events) = shop.run("MX,1\n", None, "");
    assert_eq!((summary.status, asked(&events).len()), (Status::Ok, 0));
}

#[test]
fn sbp_lim_error_driver__confirmed_when_it_is_connected_again() {
    let mut shop = Shop::new(Configuration::default());
    let pulled = Some(Change { input: CABLE, at_s: 1.0, on: false });
    let (summary, _) = shop.run("MX,10\n", pulled, "");
    assert_eq!((summary.status, shop.lost()), (Status::Failed, "XYZ"));
    let here = shop.session.memory.position;
    assert!(here[Axis::X] > 0.0);
    let (summary, events) = shop.run("PRINT %(1)\n", None, "location=Continue");
    assert_eq!((summary.status, shop.session.memory.position), (Status::Ok, here));
    assert!(asked(&events)[0].contains("Position unverified"), "{events:?}");
}

/// The outputs that are on at the end, and how far X has come, inches.
fn left_on(shop: &Shop, events: &[Event]) -> (Vec<u8>, f64) {
    let mut on = Vec::new();
    for event in events {
        if let Event::Output { n, on: is_on, .. } = event {
            on.retain(|other| other != n);
            on.extend(is_on.then_some(*n));
        }
    }
    (on, shop.session.memory.position[Axis::X] / 25.4)
}

#[test]
fn the_emergency_stop_ends_a_part_file_wherever_it_is() {
    let pressed = |at_s| Some(Change { input: Input::EmergencyStop.number(), at_s, on: true });
    let moving = "SO,1,1\nSO,3,1\nMX,10\nMX,0\n";
    for (what, program, at_s, [low, high]) in [
        ("a cut", moving, 1.0, [0.5, 2.5]),
        ("a jog", "SO,1,1\nSO,3,1\nJX,10\n", 1.0, [0.5, 6.5]),
        ("a pause", "SO,1,1\nSO,3,1\nMX,1\nPAUSE 9\nMX,10\n", 5.0, [1.0, 1.0]),
        ("before the first move", moving, 0.0, [0.0, 0.0]),
    ] {
        let mut shop = Shop::new(Configuration::default());
        let (summary, events) = shop.run(program, pressed(at_s), "");
        assert_eq!(summary.status, Status::Stopped, "{what}");
        let why = summary.error.unwrap();
        assert!(why.message.contains("emergency stop"), "{what}: {}", why.message);
        let (on, x) = left_on(&shop, &events);
        assert!(on.is_empty(), "{what}: {on:?} are on");
        assert!(x >= low && x <= high, "{what}: it came to {x}");
        assert_eq!(shop.lost(), "", "{what}: it ramped down, and lost no step");
        // Nobody presses it any more.
        assert_eq!(shop.run("MX,0\n", None, "").0.status, Status::Ok, "{what}");
    }
    // A line that is typed, and an input that a broken wire presses.
    let mut wired = Configuration::default();
    wired.estop.active = false;
    let mut shop = Shop::new(wired);
    let released = Some(Change { input: Input::EmergencyStop.number(), at_s: 1.0, on: false });
    assert_eq!(shop.run("MX,10\n", released, "").0.status, Status::Stopped);
}
