//! Stop inputs and the emergency stop while a part file waits: nothing turns and nothing moves before they are
//! released and somebody says so.

use kerf_control::answers::Operator;
use kerf_control::{OperatorRequest, Requests, RunContext, Script, Session};
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::lines::Input;
use kerf_model::Change;
use kerf_program::settings::LinearUnit;
use kerf_program::{Axis, Question, QuestionKind, Status};
use kerf_trace::{Event, Summary};
use kerf_workspace::Workspace;
use std::collections::VecDeque;

/// Says one thing after the other, whatever is asked.
struct Says(VecDeque<&'static str>);

impl Operator for Says {
    fn answer(&mut self, question: &Question, _: u32) -> Option<String> {
        // A program that wants to start its spindle may.
        if question.kind == QuestionKind::Spindle {
            return Some("OK".into());
        }
        self.0.pop_front().map(str::to_owned)
    }
}

/// A run in inches.
#[derive(Default)]
struct Run {
    inputs: Vec<Change>,
    requests: Vec<(f64, OperatorRequest)>,
    resumes: Vec<f64>,
    says: Vec<&'static str>,
    spin_up_s: f64,
    warning_s: f64,
    /// Input 4 cuts the power of the motors.
    cuts_power: bool,
    /// The spindle's output follows the file (VO).
    by_mode: bool,
}

struct Ran {
    summary: Summary,
    events: Vec<Event>,
    session: Session,
}

impl Run {
    fn input(mut self, input: u8, at_s: f64, on: bool) -> Self {
        self.inputs.push(Change { input, at_s, on });
        self
    }

    fn request(mut self, at_s: f64, request: OperatorRequest) -> Self {
        self.requests.push((at_s, request));
        self
    }

    fn says(mut self, words: &[&'static str]) -> Self {
        self.says = words.to_vec();
        self
    }

    fn of(self, program: &str) -> Ran {
        let mut session = Session::default();
        session.memory.settings.use_linear_unit(LinearUnit::Inch);
        session.memory.settings.warning_s = self.warning_s;
        if self.by_mode {
            session.memory.settings.io.outputs[0] = 3;
        }
        let mut machine = (*session.machine_is).clone();
        machine.delays.router_start_s = self.spin_up_s;
        machine.estop.cuts_power = self.cuts_power;
        session.machine_is = machine.into();
        let mut workspace = Workspace::in_memory(MemoryDisk::default());
        let mut events = Vec::new();
        let mut operator = Says(self.says.into());
        let mut pace = Script::new(self.requests, self.resumes);
        let context = RunContext {
            sink: &mut events,
            operator: &mut operator,
            requests: &mut pace,
            machine: kerf_control::simulated(),
        };
        let options = RunOptions { inputs: self.inputs, ..RunOptions::default() };
        let program = kerf_sbp::read("part.sbp".into(), program.as_bytes());
        let summary = session.run(program, options, &mut workspace, context);
        Ran { summary, events, session }
    }
}

impl Ran {
    /// Times at which the spindle was switched, s, and to what.
    fn spindle(&self) -> Vec<(f64, bool)> {
        let switched = self.events.iter().filter_map(|event| match event {
            Event::Output { n: 1, on, t, .. } => Some((*t, *on)),
            _ => None,
        });
        switched.collect()
    }

    fn turns_at(&self, t_s: f64) -> bool {
        self.spindle().iter().rfind(|(t, _)| *t <= t_s + 1e-9).is_some_and(|it| it.1)
    }

    /// Begin and end of each move, s.
    fn moves(&self) -> Vec<(f64, f64)> {
        let made = self.events.iter().filter_map(|event| match event {
            Event::Move(made) => Some((made.t0, made.t1)),
            _ => None,
        });
        made.collect()
    }

    fn x_in(&self) -> f64 {
        self.session.memory.position[Axis::X] / 25.4
    }

    /// Events in order: an input, the spindle, a move, an answer.
    fn story(&self) -> Vec<String> {
        let told = self.events.iter().filter_map(|event| match event {
            Event::Input { n, on, .. } => Some(format!("input {n} {}", u8::from(*on))),
            Event::Output { n: 1, on, .. } => Some(format!("spindle {}", u8::from(*on))),
            Event::Move(_) => Some("move".into()),
            Event::Ask(ask) if ask.kind != QuestionKind::Spindle => Some(ask.answer.clone()),
            _ => None,
        });
        told.collect()
    }
}

/// The contact of input 4 opens: it is pressed.
const PRESS: &str = "switch 4 0";
const RELEASE: &str = "switch 4 1";

#[test]
fn no_spindle_starts_while_the_stop_circuit_is_open() {
    let ran = Run::default().input(4, 0.0, false).of("SO,1,1\nPAUSE 3\nMX,1\n");
    assert_eq!((ran.spindle(), ran.summary.status), (vec![], Status::Stopped));
    assert!(ran.summary.error.unwrap().message.contains("stop input 4 is active"));
    // One that was to start within a program waits.
    let ran = Run::default().input(4, 6.0, false).input(4, 8.0, true);
    let ran = ran.says(&["Resume"; 9]).of("MX,1\nPAUSE 12\nSO,1,1\nMX,2\n");
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 2.0));
    let pressed = Run::default().input(4, 30.0, true).input(4, 5.0, false);
    let ran = pressed.says(&["Resume"; 99]).of("MX,1\nPAUSE 5\nSO,1,1\nMX,2\n");
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 2.0));
    assert!(ran.spindle()[0].0 >= 30.0, "{:?}", ran.spindle());
}

/// Nor does an axis that turns beside the others.
#[test]
fn nothing_moves_by_itself_while_the_stop_circuit_is_open() {
    let by_itself =
        |ran: &Ran| ran.events.iter().any(|event| matches!(event, Event::Independent { .. }));
    for pressed in [4, kerf_machine::lines::Input::EmergencyStop.number()] {
        let run = || Run::default().input(pressed, 0.0, pressed != 4);
        let ran = run().of("VD,,5\nMI,B,1,10\nPAUSE 3\n");
        assert_eq!((by_itself(&ran), ran.summary.status), (false, Status::Stopped), "{pressed}");
        let released = Run::default().input(pressed, 0.0, pressed == 4);
        let ran = released.of("VD,,5\nMI,B,1,10\nPAUSE 3\nMI,B,1,0\n");
        assert_eq!((by_itself(&ran), ran.summary.status), (true, Status::Ok), "{pressed}");
        // To stop it is no start.
        let ran = run().of("VD,,5\nMI,B,1,0\n");
        assert_eq!(ran.summary.status, Status::Ok, "{pressed}");
    }
}

/// An output that comes on with the file does not while a stop input is active: the file does not start.
#[test]
fn nothing_comes_on_with_a_file_while_the_stop_circuit_is_open() {
    let program = "PAUSE 3\nMX,1\n";
    let open = Run { by_mode: true, ..Run::default() }.input(4, 0.0, false).input(4, 1.0, true);
    let ran = open.of(program);
    assert_eq!((ran.spindle(), ran.summary.status), (vec![], Status::Stopped));
    assert_eq!((ran.summary.seconds, ran.x_in()), (0.0, 0.0));
    assert!(ran.summary.error.unwrap().message.contains("stop input 4 is active"));
    let ran = Run { by_mode: true, ..Run::default() }.of(program);
    assert_eq!((ran.summary.status, ran.spindle()[0]), (Status::Ok, (0.0, true)));
}

#[test]
fn a_stop_that_is_pressed_while_somebody_is_asked_stops_the_spindle_at_once() {
    let says = ["OK", PRESS, "OK", "Resume", RELEASE, "Resume"];
    for program in
        ["SO,1,1\nMX,1\nPAUSE\nPAUSE\nMX,5\n", "SO,1,1\nMX,1\nPAUSE\nMSGBOX(\"go on?\")\nMX,5\n"]
    {
        let ran = Run::default().says(&says).of(program);
        let story = ran.story();
        let at = story.iter().position(|it| it == "input 4 1").unwrap();
        assert_eq!(story[at + 1], "spindle 0", "{story:?}");
        let released = story.iter().position(|it| it == "input 4 0").unwrap();
        let between = &story[at + 2..released];
        assert!(!between.iter().any(|it| it == "move" || it == "spindle 1"), "{story:?}");
        let on = story.iter().rposition(|it| it == "spindle 1").unwrap();
        assert!(on > released && story[on..].contains(&"move".into()), "{story:?}");
        assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 5.0), "{story:?}");
    }
}

#[test]
fn a_stop_that_is_pressed_while_a_run_is_stopped_lets_nothing_come_on() {
    // Output 1 goes off with a stop and comes back when the run goes on.
    let program = "VN,,,,,,,,,,,,,,,2\nSO,1,1\nMX,10\n";
    let stopped = || Run::default().request(2.0, OperatorRequest::Stop);
    let ran = stopped().says(&[PRESS, "Resume", "Quit"]).of(program);
    assert_eq!(ran.story().iter().filter(|it| *it == "spindle 1").count(), 1, "{:?}", ran.story());
    assert_eq!(ran.summary.status, Status::Stopped);
    let ran = stopped().says(&[PRESS, "Resume", RELEASE, "Resume"]).of(program);
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 10.0));
    let story = ran.story();
    let released = story.iter().position(|it| it == "input 4 0").unwrap();
    let on = story.iter().rposition(|it| it == "spindle 1").unwrap();
    assert!(on > released, "{story:?}");
}

#[test]
fn a_spindle_that_turns_while_a_run_is_stopped_stops_with_a_stop_input() {
    let stopped = Run::default().request(2.0, OperatorRequest::Stop);
    let ran = stopped.says(&[PRESS, RELEASE, "Resume"]).of("SO,1,1\nMX,10\n");
    let story = ran.story();
    let at = story.iter().position(|it| it == "input 4 1").unwrap();
    assert_eq!(story[at + 1], "spindle 0", "{story:?}");
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 10.0));
    let on = story.iter().rposition(|it| it == "spindle 1").unwrap();
    assert!(story[on..].contains(&"move".into()), "it turns when it cuts: {story:?}");
}

#[test]
fn no_key_moves_the_tool_while_a_stop_is_pressed() {
    const KEY: &str = "jog 0,100,0,0,0,0 1";
    let y_mm = |ran: &Ran| ran.session.memory.position[Axis::Y];
    let stopped = || Run::default().request(2.0, OperatorRequest::Stop);
    assert!(y_mm(&stopped().says(&[KEY, "Quit"]).of("MX,10\n")) > 99.0, "as it should");
    assert_eq!(y_mm(&stopped().says(&[PRESS, KEY, "Quit"]).of("MX,10\n")), 0.0);
    assert_eq!(y_mm(&Run::default().says(&[PRESS, KEY, "OK"]).of("SK\n")), 0.0);
}

#[test]
fn a_held_machine_does_not_go_on_while_a_stop_is_pressed() {
    let held = |released_s| {
        let mut run = Run::default().request(2.0, OperatorRequest::Hold).input(4, 3.0, false);
        run = run.input(4, released_s, true).says(&["Resume"; 40]);
        run.resumes = vec![4.0];
        run.of("SO,1,1\nPAUSE 20\nMX,5\n")
    };
    let ran = held(12.0);
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 5.0));
    assert!(!ran.turns_at(5.0) && !ran.turns_at(11.9), "{:?}", ran.spindle());
    assert!(ran.turns_at(ran.moves()[0].0), "{:?} {:?}", ran.spindle(), ran.moves());
}

#[test]
fn a_stop_input_is_heeded_while_the_spindle_comes_to_speed() {
    // Stopped at 2 s, released at 3 s and resumed: the spindle has 10 s. Pressed again at 8 s.
    let run = || {
        let run = Run { spin_up_s: 10.0, ..Run::default() };
        let run = run.input(4, 2.0, false).input(4, 3.0, true).says(&["Resume"; 60]);
        run.input(4, 8.0, false).input(4, 12.0, true)
    };
    let ran = run().of("SO,1,1\nMX,10\n");
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 10.0));
    assert!(ran.turns_at(7.9) && !ran.turns_at(8.0) && !ran.turns_at(11.9), "{:?}", ran.spindle());
    assert!(ran.turns_at(ran.moves().last().unwrap().0), "{:?}", ran.spindle());
    let (last, _) = *ran.spindle().iter().rfind(|it| it.1).unwrap();
    let first = ran.moves().iter().map(|it| it.0).find(|t| *t > last).unwrap();
    assert!(first >= last + 10.0, "it has its whole time again: {last} {first}");
    // The operator is heard as well.
    let ran = run().request(6.0, OperatorRequest::Stop).of("SO,1,1\nMX,10\n");
    let stops = ran.events.iter().filter_map(|event| match event {
        Event::Stop { by: "operator", t, .. } => Some(*t),
        _ => None,
    });
    assert_eq!(stops.collect::<Vec<_>>(), [6.0]);
}

#[test]
fn the_emergency_stop_of_jobs_stops_a_part_file_too() {
    let pressed = Input::EmergencyStop.number();
    for program in ["SO,1,1\nMX,10\nMX,0\n", "SO,1,1\nPAUSE 9\nMX,10\n"] {
        let ran = Run::default().input(pressed, 2.0, true).of(program);
        assert_eq!(ran.summary.status, Status::Stopped, "{program}");
        assert_eq!(ran.summary.error.as_ref().unwrap().message, "emergency stop");
        assert!(!ran.turns_at(2.7), "{program}: {:?}", ran.spindle());
        let x_in = ran.x_in();
        assert!(x_in < 6.0, "{program}: {x_in}");
    }
    let ran = Run::default().input(pressed, 0.0, true).of("SO,1,1\nMX,10\n");
    assert_eq!((ran.spindle(), ran.moves().len()), (vec![], 0));
    assert_eq!(ran.summary.status, Status::Stopped);
}

#[test]
fn a_limit_that_has_nothing_to_stop_does_not_hide_a_stop() {
    let run = Run::default().input(2, 2.0, true).input(4, 4.0, false);
    let ran = run.of("VN,,,,,1\nSO,1,1\nPAUSE 10\nMX,1\n");
    assert_eq!(ran.summary.status, Status::Stopped);
    assert!(ran.turns_at(3.9) && !ran.turns_at(4.0), "{:?}", ran.spindle());
}

#[test]
fn what_stops_the_machine_while_it_warns_stops_it_before_it_moves() {
    let warned = || Run { warning_s: 3.0, ..Run::default() };
    // Pressed and kept; pressed for a moment; the emergency stop of jobs.
    let presses: [&[(u8, f64, bool)]; 3] = [
        &[(4, 1.0, false)],
        &[(4, 1.0, false), (4, 1.5, true)],
        &[(Input::EmergencyStop.number(), 1.0, true)],
    ];
    for press in presses {
        let run = press.iter().fold(warned(), |run, (n, t, on)| run.input(*n, *t, *on));
        let ran = run.of("MX,5\nMX,0\n");
        assert_eq!((ran.summary.status, ran.moves()), (Status::Stopped, vec![]), "{press:?}");
    }
    let ran = warned().input(4, 1.0, false).input(4, 6.0, true).says(&["Resume"; 40]);
    let ran = ran.of("MX,5\n");
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 5.0));
    assert!(ran.moves()[0].0 >= 9.0, "it warns again: {:?}", ran.moves());
    let ran = warned().request(1.0, OperatorRequest::Stop).of("MX,5\n");
    let moved = ran.x_in();
    assert_eq!((ran.summary.status, moved), (Status::Stopped, 0.0));
    assert!(ran.summary.seconds < 2.5, "{}", ran.summary.seconds);
    // What a program waits for comes as well.
    let program = "ON INP(1,1) GOTO HIT\nMX,5\nEND\nHIT:\nMY,1\nEND\n";
    let ran = warned().input(1, 1.0, true).of(program);
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 0.0));
    assert_eq!(ran.session.memory.position[Axis::Y], 25.4);
    // Nothing of that: it moves after the warning.
    assert_eq!(warned().of("MX,5\n").moves()[0].0, 3.0);
}

#[test]
fn a_stop_while_it_warns_before_the_way_back_holds_the_tool() {
    let run = || {
        let run = Run { warning_s: 3.0, ..Run::default() };
        // Stopped at 5 s on its way and resumed at once: it warns anew.
        run.input(4, 5.0, false).input(4, 5.2, true)
    };
    let ran = run().says(&["Resume"; 9]).of("MZ,-.5\nMX,10\n");
    let back = ran.moves().iter().map(|it| it.0).find(|t| *t > 5.1).unwrap();
    assert!(back >= 8.2, "{:?}", ran.moves());
    let again = run().input(4, 7.0, false).input(4, 12.0, true).says(&["Resume"; 60]);
    let ran = again.of("MZ,-.5\nMX,10\n");
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 10.0));
    let between = ran.moves().iter().filter(|(from, to)| *from < 12.0 && *to > 7.0).count();
    assert_eq!(between, 0, "{:?}", ran.moves());
}

/// The emergency stop of jobs.
fn emergency() -> u8 {
    Input::EmergencyStop.number()
}

/// It ended the run at that time: nothing turned or moved from then on.
fn ended_by_press(ran: &Ran, at_s: f64) {
    let error = ran.summary.error.as_ref().map(|error| &*error.message);
    assert_eq!((ran.summary.status, error), (Status::Stopped, Some("emergency stop")));
    assert!(!ran.turns_at(at_s), "{at_s}: {:?}", ran.spindle());
    assert!(ran.spindle().iter().all(|(t, on)| !on || *t < at_s), "{:?}", ran.spindle());
    assert!(ran.moves().iter().all(|(from, _)| *from < at_s), "{:?}", ran.moves());
    assert!(ran.summary.seconds <= at_s + 0.1, "{}", ran.summary.seconds);
}

#[test]
fn nothing_comes_on_with_a_file_while_the_emergency_stop_is_pressed() {
    let pressed = Run { by_mode: true, ..Run::default() }.input(emergency(), 0.0, true);
    let ran = pressed.of("PAUSE 3\nMX,1\n");
    ended_by_press(&ran, 0.0);
    assert_eq!(ran.spindle(), vec![]);
}

#[test]
fn the_emergency_stop_is_heeded_while_the_machine_is_held() {
    // While it slows down, and while it stands.
    for at_s in [2.1, 5.0] {
        let run = Run { resumes: vec![10.0], ..Run::default() }.request(2.0, OperatorRequest::Hold);
        let ran = run.input(emergency(), at_s, true).of("SO,1,1\nMX,10\n");
        ended_by_press(&ran, at_s.max(2.2));
    }
}

#[test]
fn the_emergency_stop_is_heeded_while_the_machine_slows_down_for_another_stop() {
    let run = Run::default().request(2.0, OperatorRequest::Stop).input(emergency(), 2.1, true);
    let ran = run.says(&["Resume"; 6]).of("MZ,-.5\nSO,1,1\nMX,10\n");
    ended_by_press(&ran, 2.2);
}

#[test]
fn the_emergency_stop_is_heeded_on_the_way_back_and_before_it() {
    let press = "switch 19 1";
    let resumes = || Run { spin_up_s: 10.0, ..Run::default() }.says(&["Resume"; 60]);
    let stopped = || resumes().input(4, 2.0, false).input(4, 3.0, true);
    // While the spindle comes to speed, and on the way down.
    for at_s in [8.0, 14.0] {
        let ran = stopped().input(emergency(), at_s, true).of("MZ,-.5\nSO,1,1\nMX,10\n");
        ended_by_press(&ran, at_s + 0.1);
    }
    // While it warns before the way back nothing has come on yet.
    let warned = || Run { warning_s: 3.0, ..Run::default() }.says(&[PRESS, RELEASE, "Resume"]);
    let warned = || warned().request(5.0, OperatorRequest::Stop);
    let ran = warned().of("SO,1,1\nMX,10\n");
    let goes_on = |event: &Event| match event {
        Event::State { state, t, .. } if &**state == "running" => Some(*t),
        _ => None,
    };
    let at_s = ran.events.iter().find_map(goes_on).unwrap() + 1.0;
    let ran = warned().input(emergency(), at_s, true).of("SO,1,1\nMX,10\n");
    ended_by_press(&ran, at_s);
    assert_eq!(ran.story().iter().filter(|it| *it == "spindle 1").count(), 1, "{:?}", ran.story());
    // While somebody is asked what follows on a stop, and while the program asks.
    let asked = Run::default().request(2.0, OperatorRequest::Stop).says(&[press, "Resume", "Quit"]);
    let ran = asked.of("SO,1,1\nMX,10\n");
    ended_by_press(&ran, 2.7);
    let ran = Run::default().says(&[press, "OK"]).of("SO,1,1\nMX,1\nPAUSE\nPAUSE 5\nMX,5\n");
    ended_by_press(&ran, 0.7);
}

#[test]
fn a_stop_input_is_heeded_while_the_machine_slows_down_to_be_held() {
    let pressed = [(4, 2.1, false), (4, 9.0, true)];
    let scripted = pressed.iter().fold(Run::default(), |run, (n, t, on)| run.input(*n, *t, *on));
    let moved = pressed.iter().take(1).fold(Run::default(), |run, (number, t, on)| {
        run.request(*t, OperatorRequest::Input { number: *number, on: *on })
    });
    for (run, says) in [(scripted, vec!["Resume"; 9]), (moved, vec![RELEASE, "Resume"])] {
        let run = Run { resumes: vec![10.0], ..run }.request(2.0, OperatorRequest::Hold);
        let ran = run.says(&says).of("SO,1,1\nMX,10\n");
        assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 10.0), "{:?}", ran.story());
        assert!(!ran.turns_at(2.2) && !ran.turns_at(9.9), "{:?}", ran.spindle());
        let again = ran.moves().iter().map(|it| it.0).find(|t| *t > 2.2).unwrap();
        assert!(again >= 10.0 && ran.turns_at(again), "{:?} {:?}", ran.spindle(), ran.moves());
        assert!(ran.story().contains(&"Resume".into()), "somebody says so: {:?}", ran.story());
    }
}

#[test]
fn a_switch_that_is_moved_while_the_machine_slows_down_is_moved_then() {
    let run = Run::default().request(2.0, OperatorRequest::Stop);
    let run = run.request(2.1, OperatorRequest::Input { number: 4, on: false });
    let ran = run.says(&["Resume", RELEASE, "Resume", "Resume"]).of("SO,1,1\nMX,10\n");
    let story = ran.story();
    let stopped: Vec<&str> = story.iter().map(String::as_str).collect();
    assert_eq!(stopped[..4], ["spindle 1", "move", "input 4 1", "spindle 0"], "{story:?}");
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 10.0));
}

/// Nothing comes on behind a limit while a stop input is active.
#[test]
fn a_stop_that_is_pressed_while_a_limit_is_asked_about_lets_nothing_come_on() {
    let run = Run::default().input(2, 2.0, true);
    let ran = run.says(&[PRESS, "Continue", "Resume", RELEASE, "Resume"]);
    let ran = ran.of("VN,,,,,1\nSO,1,1\nMX,5\n");
    let story = ran.story();
    let released = story.iter().position(|it| it == "input 4 0").unwrap();
    let on = story.iter().rposition(|it| it == "spindle 1").unwrap();
    assert!(on > released, "{story:?}");
    assert_eq!(story.iter().filter(|it| *it == "spindle 1").count(), 2, "{story:?}");
    assert_eq!((ran.summary.status, ran.x_in()), (Status::Ok, 5.0));
}

#[test]
fn a_hold_does_not_delay_what_an_input_is_waited_for() {
    for (resumed_s, goes_on_s) in [(4.0, 5.0), (7.0, 7.0)] {
        let run =
            Run { resumes: vec![resumed_s], ..Run::default() }.request(2.0, OperatorRequest::Hold);
        let ran = run.input(1, 5.0, true).of("PAUSE UNTIL 1,1\nMX,1\n");
        assert_eq!((ran.summary.status, ran.moves()[0].0), (Status::Ok, goes_on_s));
    }
}

/// Whoever is asked meanwhile is asked no more: motors without power may stand anywhere.
#[test]
fn an_emergency_stop_that_cuts_the_power_while_somebody_is_asked_ends_the_run() {
    let cut = || Run { cuts_power: true, ..Run::default() };
    let says = [PRESS, "OK", RELEASE, "Resume", "Resume"];
    let stopped = [PRESS, "Resume", RELEASE, "Resume"];
    let limited = [PRESS, "Continue", RELEASE, "Resume"];
    let runs = [
        cut().says(&says).of("MX,1\nPAUSE\nMX,5\n"),
        cut().says(&says).of("SO,1,1\nMX,1\nPAUSE\nMX,5\n"),
        cut().request(2.0, OperatorRequest::Stop).says(&stopped).of("SO,1,1\nMX,5\n"),
        cut().input(2, 2.0, true).says(&limited).of("VN,,,,,1\nSO,1,1\nMX,5\n"),
    ];
    for ran in runs {
        let error = ran.summary.error.as_ref().map(|error| &*error.message);
        assert_eq!((ran.summary.status, error), (Status::Stopped, Some("emergency stop")));
        let off = ran.events.iter().any(|event| matches!(event, Event::Motors { on: false, .. }));
        assert!(off, "{:?}", ran.story());
        let pressed = ran.story().iter().position(|it| it == "input 4 1").unwrap();
        let after = &ran.story()[pressed..];
        assert!(!after.iter().any(|it| it == "move" || it == "spindle 1"), "{after:?}");
    }
}

/// Tells a feed and later a stop to a program that only computes, while what it gave before waits to move.
struct Busy(u32);

impl Requests for Busy {
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        self.0 += u32::from(from_s == to_s);
        assert!(self.0 < 1000, "it is never stopped");
        match self.0 {
            _ if from_s < to_s => None,
            20 => Some((to_s, OperatorRequest::Feed(0.5))),
            100.. => Some((to_s, OperatorRequest::Stop)),
            _ => None,
        }
    }
}

#[test]
fn a_feed_does_not_keep_a_stop_from_a_program_that_only_computes() {
    let moves = (0..17_000).map(|n| format!("M2,{},{}\n", n % 7, n % 5));
    let program = moves.chain(["&n=0\nA:\n&n=&n+1\nGOTO A\n".to_owned()]).collect::<String>();
    let program = kerf_sbp::read("part.sbp".into(), program.as_bytes());
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let context = RunContext {
        sink: &mut (),
        operator: &mut (),
        requests: &mut Busy(0),
        machine: kerf_control::simulated(),
    };
    let ran = Session::default().run(program, RunOptions::default(), &mut workspace, context);
    assert_eq!(ran.status, Status::Stopped);
}
