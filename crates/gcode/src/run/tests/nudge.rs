//! A nudge in the middle of a program: every place in the machine frame follows the workpiece.

use crate::testing::FakeHost;
use crate::{Interpreter, Options, Session, read};
use kerf_program::{Axes, Axis, Command};

/// Runs a head, nudges Y by half a millimetre, goes to Y 2: where the machine is sent.
fn check(head: &str, y_mm: f64) {
    let program = read("a.nc".into(), format!("G21 {head}\nG1 Y2 F10\n").as_bytes());
    let mut run = Interpreter::new(program, Session::default(), Options::default());
    let (mut host, mut out) = (FakeHost::default(), Vec::new());
    while run.lines() < 1 {
        run.step(&mut host, &mut out);
    }
    let before = run.frame().working(run.position());
    run.nudge(Axes::xyz(0.0, 0.5, 0.0));
    assert_eq!(run.frame().working(run.position()), before, "{head}");
    while run.lines() < 2 {
        run.step(&mut host, &mut out);
    }
    let to = out.iter().rev().find_map(|s| match &s.command {
        Command::Line(line) => Some(line.to[Axis::Y]),
        _ => None,
    });
    assert_eq!(to, Some(y_mm), "{head}");
}

#[test]
fn places_keep_their_names() {
    check("", 2.5);
    check("G55", 2.5);
    check("G92 X3 Y4", -1.5);
    check("G52 X1 Y1", 3.5);
}
