//! The console as a value: what keys request and what the screen shows, without a machine.

#![allow(clippy::unwrap_used, non_snake_case)]

use kerf_handconsole::functions::{FUNCTIONS, function};
use kerf_handconsole::{COLUMNS, Console, ConsoleRequest, Key, OpenJob, View, Waits};
use kerf_wire::{Asked, State};
use proptest::prelude::*;

/// Presses keys, `E` for Enter; gives what they request.
fn press(console: &mut Console, keys: &str, view: &View) -> Vec<ConsoleRequest> {
    let key = |key| Key::of(if key == 'E' { '\r' } else { key }).unwrap();
    keys.chars().flat_map(|it| console.press(key(it), view)).collect()
}

/// Display of a new console after some keys.
fn shown(keys: &str, view: &View) -> [String; 2] {
    let mut console = Console::default();
    press(&mut console, keys, view);
    console.screen(view).lines
}

fn sample() -> View {
    let job = OpenJob {
        name: "SAMPLE.RSM".into(),
        size_mm: Some([720.0, 360.0]),
        shapes: 16,
        ..OpenJob::default()
    };
    View { job: Some(job), ..View::default() }
}

#[test]
fn a_long_name_and_a_long_size_fit_the_screen() {
    let check = |name: &str, size_mm, shapes, expected: [&str; 2]| {
        let job = Some(OpenJob { name: name.into(), size_mm, shapes, ..OpenJob::default() });
        assert_eq!(shown("", &View { job, ..View::default() }), expected);
    };
    check("A.RSM", Some([720.04, 359.96]), 16, ["JOB: A.RSM", "720x360mm #16"]);
    check("A.RSM", Some([90.5, 0.25]), 1, ["JOB: A.RSM", "90.5x0.3mm #1"]);
    let long = ["JOB: A-LONG-NAME-OF-A", "1235x2469mm #12345"];
    check("A-LONG-NAME-OF-A-JOB.RSM", Some([1234.56, 2468.91]), 12345, [&long[0][..20], long[1]]);
    check("part.sbp", None, 0, ["JOB: part.sbp", "part file"]);
}

fn folder(count: usize) -> View {
    let files = (1..=count).map(|n| format!("{n}.RSM")).collect();
    View { files, ..View::default() }
}

#[test]
fn pro_console_file_step() {
    let files = ["A.RSM", "B.RSM", "C.RSM"].map(String::from).into();
    let view = View { files, ..View::default() };
    let check = |keys: &str, expected: &str| assert_eq!(shown(keys, &view)[1], expected, "{keys}");
    check("F", "A.RSM");
    check("F2", "B.RSM");
    check("F28", "A.RSM");
    check("F288", "A.RSM");
    check("F22", "C.RSM");
    check("F222", "C.RSM");
}

#[test]
fn pro_console_file_page() {
    let view = folder(12);
    let check = |keys: &str, expected: &str| assert_eq!(shown(keys, &view)[1], expected, "{keys}");
    check("F", "1.RSM");
    check("F3", "6.RSM");
    check("F33", "11.RSM");
    check("F333", "12.RSM");
    check("F3339", "7.RSM");
    check("F9", "1.RSM");
    assert_eq!(shown("F", &folder(2839))[0], "Select File (2839):");
    assert_eq!(shown("F", &folder(0)), ["Select File (0):", "no RSM files"]);
    let mut console = Console::default();
    assert_eq!(press(&mut console, "FE", &folder(0)), []);
    assert_eq!(press(&mut console, "F3E", &view), [ConsoleRequest::Open("6.RSM".into())]);
}

#[test]
fn pro_console_stop() {
    let running = View { state: State::Running, shape: 1, ..sample() };
    let mut console = Console::default();
    assert_eq!(press(&mut console, "P", &running), [ConsoleRequest::Stop]);
    assert_eq!(press(&mut console, "P", &sample()), [], "idle");
    assert_eq!(press(&mut console, "U15P", &sample()), []);
    assert_eq!(console.screen(&sample()).lines[1], "1 Plunge speed");
    // What moves is stopped, whatever is typed.
    assert_eq!(press(&mut console, "P", &running), [ConsoleRequest::Stop]);
}

#[test]
fn pro_console_func_number() {
    assert_eq!(shown("U18F1", &sample()), ["Enter function:", "18.1 X set point"]);
    assert_eq!(shown("U100F2", &sample())[1], "100.2 Y speed factor");
    assert_eq!(shown("U18F", &sample())[1], "18. XY set point");
    assert_eq!(shown("U18F1PP", &sample())[1], "18 XY set point");
    assert_eq!(shown("U18FF1", &sample())[1], "18.1 X set point", "one point is enough");
}

#[test]
fn pro_console_listing() {
    let numbers: Vec<&str> =
        "0 1 2 3 4 5 6 7 8 10 11 17 18 18.1 18.2 19 19.1 19.2 20 21 23 30 31 32 34 38 \
        39 40 50 51 52 60 61 70 100.2 300"
            .split_whitespace()
            .collect();
    let mut listed: Vec<&str> = FUNCTIONS.iter().map(|function| function.number).collect();
    listed.sort_by(|a, b| a.parse::<f64>().unwrap().total_cmp(&b.parse().unwrap()));
    assert_eq!(listed, numbers);
    for number in numbers {
        let keys = format!("U{}", number.replace('.', "F"));
        let name = function(number).unwrap().name;
        let line = format!("{number} {name}");
        assert!(!name.is_empty() && line.len() <= COLUMNS, "{line}");
        assert_eq!(shown(&keys, &sample()), ["Enter function:", line.as_str()]);
    }
}

#[test]
fn a_question_is_answered_with_the_digit_of_its_button() {
    let buttons = ["Yes", "No", "Cancel"].map(String::from).to_vec();
    let asked = Asked { text: "Home now?".into(), buttons, ..Asked::default() };
    let waits = Waits::Question(Box::new(asked));
    let view = View { state: State::Asking, waits, ..sample() };
    assert_eq!(shown("", &view), ["Home now?", "1Yes 2No 3Cancel"]);
    let mut console = Console::default();
    assert_eq!(press(&mut console, "049", &view), []);
    assert_eq!(press(&mut console, "2", &view), [ConsoleRequest::Answer("No".into())]);
}

#[test]
fn an_alarm_is_taken_note_of_with_enter() {
    let why = Some("stopped by limit input 3 of the machine".into());
    let view = View { state: State::Alarm, why, ..sample() };
    assert_eq!(shown("", &view), ["stopped by limit", "input 3 of the machi"]);
    let mut console = Console::default();
    assert_eq!(press(&mut console, "8S4U", &view), [], "nothing moves");
    assert_eq!(press(&mut console, "E", &view), [ConsoleRequest::Acknowledge]);
}

fn any_view() -> impl Strategy<Value = View> {
    let states =
        [State::Idle, State::Running, State::Jogging, State::Held, State::Asking, State::Alarm];
    let asked = Asked { text: "What is to be done about all of this?".into(), ..Asked::default() };
    let waits = [Waits::No, Waits::Start(3), Waits::Paused, Waits::Question(Box::new(asked))];
    let job = prop::option::of((".{0,30}", 0.0..1e6, 0u32..2_000_000_000));
    let parts = (prop::sample::select(states.to_vec()), prop::sample::select(waits.to_vec()), job);
    parts.prop_map(|(state, waits, job)| {
        let job = job.map(|(name, size, shapes)| OpenJob {
            name,
            size_mm: Some([size, 1.0 / size]),
            shapes,
            ..OpenJob::default()
        });
        View {
            state,
            waits,
            job,
            files: vec!["a-very-long-name-of-a-file.rsm".into()],
            ..View::default()
        }
    })
}

proptest! {
    /// Sixteen keys, whatever the machine does meanwhile: two lines of twenty characters, no panic, and
    /// Stop stops whatever moves.
    #[test]
    fn pro_console_device(walk in prop::collection::vec((0..16_usize, any_view()), 1..60)) {
        let mut console = Console::default();
        for (key, view) in walk {
            let key = Key::ALL[key];
            prop_assert_eq!(Key::of(key.character()), Some(key));
            let requests = console.press(key, &view);
            let stops = key == Key::Stop && view.is_moving();
            prop_assert_eq!(requests == [ConsoleRequest::Stop], stops);
            let screen = console.screen(&view);
            for line in &screen.lines {
                prop_assert!(line.chars().count() <= COLUMNS, "{line}");
            }
            prop_assert_eq!(screen.bytes().len(), 41);
            console.told(if requests.len() % 2 == 0 { Ok(String::new()) } else { Err("no, not at all, never ever".into()) });
        }
    }
}

#[test]
fn pro_console_entry() {
    let view = sample();
    let mut console = Console::default();
    press(&mut console, "U3E-0F5", &view);
    assert_eq!(console.screen(&view).lines, ["ZBottom adjust mm:", "-0.5"]);
    press(&mut console, "-", &view);
    assert_eq!(console.screen(&view).lines[1], "0.5");
    press(&mut console, "-", &view);
    let lowered = view.machine.zpos.bottom_mm - 0.5;
    let wanted = ConsoleRequest::Set(vec![("zpos.bottom_mm", lowered.to_string())]);
    assert_eq!(press(&mut console, "E", &view), [wanted]);
    // A sign alone is no number.
    press(&mut console, "U3E-E", &view);
    assert_eq!(console.screen(&view).lines[1], "-");
    press(&mut console, "PP7F5PE", &view);
    assert_eq!(console.beeps(), 1);
}
