//! Both languages together.

use crate::{Interpreter, Options, Session, read};
use kerf_program::testing::Bystander;
use kerf_program::{
    Axes, Command, FileMode, FileRequest, HostError, Interpreter as _, SourceFile, Sourced, Status,
    Step,
};

/// A machine that is always at rest, and some files.
#[derive(Default)]
struct Shop {
    files: Vec<(String, String)>,
}

impl Bystander for Shop {
    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        let found = self.files.iter().find(|(name, _)| *name == request.name);
        let (name, text) = found.ok_or_else(|| HostError::NotFound(request.name.clone()))?;
        Ok(SourceFile { name: name.as_str().into(), bytes: text.as_bytes().into() })
    }
    fn open(&mut self, _: u8, path: &str, _: FileMode) -> Result<String, HostError> {
        Ok(path.into())
    }
}

/// Outcome of a run.
struct Ran {
    out: Vec<Sourced>,
    status: Status,
    error: String,
    interpreter: Interpreter,
}

/// Runs the first file; lines are separated by `⏎`. With `saved` the state is written and read again
/// before each step.
fn run(files: &[(&str, &str)], saved: bool) -> Ran {
    run_from(Session::default(), files, saved)
}

fn run_from(session: Session, files: &[(&str, &str)], saved: bool) -> Ran {
    let text = |t: &str| t.split('⏎').map(str::trim).collect::<Vec<_>>().join("\n");
    let (name, first) = files[0];
    let program = read(name.into(), text(first).into_bytes());
    let mut options = Options::default();
    options.sbp.max_lines = 1000;
    let mut interpreter = Interpreter::new(program, session, options);
    let files = files.iter().map(|(n, t)| (n.to_string(), text(t))).collect();
    let (mut host, mut out) = (Shop { files }, Vec::new());
    for _ in 0..5000 {
        if saved {
            let bytes = serde_json::to_vec(&interpreter).expect("written");
            interpreter = serde_json::from_slice(&bytes).expect("read");
        }
        let mut given = Vec::new();
        let step = interpreter.run(&mut host, &mut given, if saved { 1 } else { 100 });
        out.append(&mut given);
        match step {
            Step::Done(status, error) => {
                let error = error.map_or_else(String::new, |e| e.message.clone());
                return Ran { out, status, error, interpreter };
            }
            Step::Ran => {}
            Step::Waiting => panic!("nothing to wait for"),
        }
    }
    panic!("no end after {out:?}");
}

/// Runs and compares where it moved, in inches, as `file:line X,Y,Z`.
#[track_caller]
fn check(files: &[(&str, &str)], expected: &[&str]) {
    for saved in [false, true] {
        let ran = run(files, saved);
        assert_eq!((ran.status, &*ran.error), (Status::Ok, ""), "{files:?}");
        let shown: Vec<String> =
            ran.out.iter().filter_map(|s| shown(&ran.interpreter, s)).collect();
        assert_eq!(shown, expected, "saved {saved}: {files:?}");
    }
}

fn shown(interpreter: &Interpreter, sourced: &Sourced) -> Option<String> {
    let to = match &sourced.command {
        Command::Line(line) => line.to,
        Command::Arc(arc) => arc.to,
        _ => return None,
    };
    let Axes([x, y, z, ..]) = to;
    let [x, y, z] = [x, y, z].map(|v| (v / 25.4 * 1e6).round() / 1e6 + 0.0);
    let file = interpreter.file_name(sourced.at.file).unwrap_or_default();
    Some(format!("{file}:{} {x},{y},{z}", sourced.at.line))
}

#[test]
fn a_file_of_g_code_runs_alone() {
    check(
        &[("a.nc", "G1 X1 Y1 F60 ⏎ G2 X2 Y0 I0 J-1 ⏎ M2 ⏎ G0 X9")],
        &["a.nc:1 1,1,0", "a.nc:2 2,0,0"],
    );
}

#[test]
fn lines_of_both_languages_follow_each_other() {
    let text = "MX,1 ⏎ G91 ⏎ G1 X1 F60 ⏎ IF 1 = 1 THEN G1 Y2 ⏎ MZ,3 ⏎ G1 Z1 ⏎ X5";
    let moves = ["1 1,0,0", "3 2,0,0", "4 2,2,0", "5 2,2,3", "6 2,2,4", "7 7,2,4"];
    check(&[("a.sbp", text)], &moves.map(|m| format!("a.sbp:{m}")).each_ref().map(|m| m.as_str()));
}

#[test]
fn a_line_that_could_be_either_goes_by_the_ending() {
    check(&[("a.nc", "G1 X1 F60 ⏎ MY,2 ⏎ M2 ⏎ MX,9")], &["a.nc:1 1,0,0", "a.nc:2 1,2,0"]);
    check(&[("a.sbp", "G1 X1 F60 ⏎ M2 ⏎ MX,9")], &["a.sbp:1 1,0,0", "a.sbp:3 9,0,0"]);
}

#[test]
fn opensbp_does_not_move_beside_a_compensated_path() {
    let begins = "G20 G17 ⏎ G41.1 D.5 G1 X1 Y1 F60 ⏎ G1 Y3 ⏎ ";
    for line in ["MZ,-.5", "JZ,1", "MH", "FP,s.sbp"] {
        let text = format!("{begins}PRINT 1 ⏎ {line} ⏎ G1 X3 ⏎ G40 G1 X7 Y0");
        let ran = run(&[("a.nc", &text), ("s.sbp", "MZ,-1")], false);
        assert_eq!(ran.status, Status::Failed, "{line}");
        assert!(ran.error.contains("cutter compensation is on"), "{line}: {}", ran.error);
        let low = ran.out.iter().filter_map(|it| match &it.command {
            Command::Line(moved) => Some(moved.to.0[2]),
            _ => None,
        });
        assert!(low.into_iter().all(|z| z == 0.0), "{line}: nothing moves up or down");
    }
    let ended = format!("{begins}G40 ⏎ MZ,-.5");
    assert_eq!(run(&[("a.nc", &ended)], false).status, Status::Ok);
}

#[test]
fn files_call_files_and_places_name_them() {
    let files = [
        ("a.sbp", "FP,b.nc ⏎ FP,c.sbp ⏎ FP,b.nc ⏎ MX,9"),
        ("b.nc", "G91 G1 X1 F60 ⏎ O<s> call ⏎ M30"),
        ("c.sbp", "MY,1 ⏎ G1 Y2 F60"),
        ("s.ngc", "G1 Z1"),
    ];
    let expected = [
        "b.nc:1 1,0,0",
        "s.ngc:1 1,0,1",
        "c.sbp:1 1,1,1",
        "c.sbp:2 1,2,1",
        "b.nc:1 2,2,1",
        "s.ngc:1 2,2,2",
        "a.sbp:4 9,2,2",
    ];
    check(&files, &expected);
}

#[test]
fn repetitions_and_plunges_hold_for_g_code() {
    let files = [("a.sbp", "FP,b.nc,2,1,1,2,0,-.5"), ("b.nc", "G1 X1 F60 ⏎ X0")];
    let expected = [
        "a.sbp:1 0,0,-0.5",
        "b.nc:1 2,0,-0.5",
        "b.nc:2 0,0,-0.5",
        "b.nc:1 0,0,-1",
        "b.nc:1 2,0,-1",
        "b.nc:2 0,0,-1",
        "b.nc:1 0,0,0",
    ];
    check(&files, &expected);
}

#[test]
fn offsets_of_g_code_move_the_working_zero_of_both() {
    check(&[("a.sbp", "G92 X10 ⏎ MX,11 ⏎ G1 X12 F60")], &["a.sbp:2 1,0,0", "a.sbp:3 2,0,0"]);
    check(
        &[("a.sbp", "MX,1 ⏎ ZX ⏎ G1 X1 F60 ⏎ MX,2")],
        &["a.sbp:1 1,0,0", "a.sbp:3 2,0,0", "a.sbp:4 3,0,0"],
    );
}

#[test]
fn an_error_in_g_code_ends_the_run_with_its_callers() {
    let ran = run(&[("a.sbp", "MX,1 ⏎ FP,b.nc ⏎ MX,2"), ("b.nc", "G1 X3 F60 ⏎ G1 X[1/0]")], false);
    assert_eq!(ran.status, Status::Failed);
    assert!(ran.error.contains("zero"), "{}", ran.error);
    assert_eq!(run(&[("a.sbp", "FP,b.nc"), ("b.nc", "G1 X3 F60 ⏎ G777")], false).out.len(), 0);
}

/// Moves and changes of tools of a run in which M6 runs C9, in order.
#[track_caller]
fn changes(files: &[(&str, &str)], expected: &str) -> Interpreter {
    let mut session = Session::default();
    session.sbp.settings.m6_runs_c9 = true;
    for saved in [true, false] {
        let ran = run_from(session.clone(), files, saved);
        assert_eq!((ran.status, &*ran.error), (Status::Ok, ""), "{files:?}");
        let told = ran.out.iter().filter_map(|s| match &s.command {
            Command::ToolChange { begin: true } => Some("change".into()),
            Command::ToolChange { begin: false } => Some("changed".into()),
            Command::ToolPath(path) => path.tool.as_ref().map(ToString::to_string),
            _ => shown(&ran.interpreter, s),
        });
        assert_eq!(told.collect::<Vec<String>>().join(" | "), expected, "saved {saved}: {files:?}");
        if !saved {
            return ran.interpreter;
        }
    }
    panic!("run twice")
}

#[test]
fn m6_runs_the_tool_change_of_the_owner() {
    let c9 = ("Custom9.sbc", "JZ,1 ⏎ J2,&Tool,0 ⏎ VA,,,&Tool ⏎ G1 Z4 F60");
    let file = "G20 F60 ⏎ G1 X1 ⏎ T3 M6 ⏎ T3 M6 ⏎ G1 Z0 ⏎ G55 Z0 ⏎ M2";
    let moved =
        "change | Custom9.sbc:1 1,0,1 | Custom9.sbc:2 3,0,1 | Custom9.sbc:4 3,0,2 | changed";
    // Z reads 3 at 1 behind it: its zero is 2 lower, in every coordinate system.
    let told = format!("a.nc:2 1,0,0 | {moved} | T3 | T3 | a.nc:5 3,0,-2");
    let ran = changes(&[("a.nc", file), c9], &told);
    let zero_mm = ran.into_session().gcode.systems[5].offset.0[2];
    assert!((zero_mm + 50.8).abs() < 1e-9, "{zero_mm}");
    // As a line among those of OpenSBP, and in a file that one calls.
    let told = format!("a.sbp:1 1,0,0 | {} | T3 | a.sbp:3 9,0,2", moved);
    changes(&[("a.sbp", "MX,1 ⏎ T3 M6 ⏎ MX,9"), c9], &told);
    changes(&[("a.sbp", "MX,1 ⏎ FP,b.nc ⏎ MX,9"), ("b.nc", "T3 M6"), c9], &told);
    // Taking a tool out is asked for, and without the file nothing is changed.
    changes(&[("a.nc", "G20 F60 ⏎ T3 M6 ⏎ M2"), ("Custom9.sbc", "")], "change | changed | T3");
    let ran = run(&[("a.nc", "G20 F60 ⏎ T3 M6 ⏎ M2")], false);
    assert_eq!(ran.status, Status::Ok, "it is asked for where the setting is off: {}", ran.error);
}

#[test]
fn empty_files_that_repeat_end() {
    assert_eq!(
        run(&[("a.sbp", "FP,b.nc,,,,4000000000"), ("b.nc", "")], false).status,
        Status::Limit
    );
}
