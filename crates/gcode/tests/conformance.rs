//! Rows of the ledger that this crate shows by itself.

use crate::support::Quiet;
use kerf_gcode::{Interpreter, Options, Session, read};
use kerf_program::settings::LinearUnit;
use kerf_program::{Axis, Command, Feed, Sourced, Status, Step};

/// Runs lines parted by `⏎` on a machine in inches.
fn run(text: &str, session: Session) -> (Vec<Sourced>, Status, String, [f64; 3]) {
    let text = text.split('⏎').map(str::trim).collect::<Vec<_>>().join("\n");
    let mut interpreter =
        Interpreter::new(read("row.nc".into(), text.as_bytes()), session, Options::default());
    let mut out = Vec::new();
    loop {
        if let Step::Done(status, error) = interpreter.run(&mut Quiet::default(), &mut out, 1000) {
            let told = error.map_or(String::new(), |e| format!("{} line {}", e.code, e.place.line));
            let settings = interpreter.settings().clone();
            let place = settings.to_user(interpreter.frame().working(interpreter.position()));
            return (out, status, told, place.first3());
        }
    }
}

#[track_caller]
fn ends_at(text: &str, place: [f64; 3]) {
    let (_, status, told, found) = run(text, Session::default());
    assert_eq!(status, Status::Ok, "{text}: {told}");
    let near = found.iter().zip(place).all(|(a, b)| (a - b).abs() < 1e-6);
    assert!(near, "{text}: at {found:?}, not {place:?}");
}

#[test]
fn sbp_gcode_set() {
    ends_at("G20 G90⏎G0 X1⏎G1 Y1 F10⏎G2 X2 Y0 I0 J-1⏎G3 X3 Y1 R1", [3.0, 1.0, 0.0]);
    ends_at("G20 G4 P1⏎G0 X1⏎G10 L20 P1 X0⏎G0 X1", [1.0, 0.0, 0.0]);
    ends_at("G20 F9 G18⏎G2 X1 Z1 I1⏎G19⏎G3 Y1 Z2 J1⏎G17⏎G2 X2 I.5", [2.0, 1.0, 2.0]);
    ends_at("G20 G0 X4 Y4⏎G28 X5⏎G0 Z1", [0.0, 4.0, 1.0]);
    ends_at("G20 F9 G41.1 D.5⏎G1 X2⏎X4⏎G40⏎G1 X5 Y0", [5.0, 0.0, 0.0]);
    ends_at("G20 G43.1 Z1⏎G0 Z2⏎G49", [0.0, 0.0, 3.0]);
    for code in ["G54", "G55", "G56", "G57", "G58", "G59"] {
        ends_at(
            &format!("G20⏎{code}⏎G10 L2 P0 X3⏎G0 X1⏎G53 G0 X1⏎G54⏎G52 X2⏎G0 X1"),
            [1.0, 0.0, 0.0],
        );
    }
    ends_at("G20 G61⏎G64 P.01⏎G0 X1", [1.0, 0.0, 0.0]);
    ends_at("G20 F9 G99 G81 X1 R1 Z-1⏎G98⏎G82 X2 P.1 R1 Z-1⏎G83 X3 Q1 R1 Z-1⏎G80", [3.0, 0.0, 1.0]);
    ends_at("G20 G91 G0 X1⏎X1⏎G90 X3⏎G92 X0⏎G0 X1", [1.0, 0.0, 0.0]);
    ends_at("G20 G93 G1 X1 F2⏎G94 F5 X2", [2.0, 0.0, 0.0]);
    ends_at("G20 M0⏎M1⏎M3 S100⏎M4⏎M5⏎T1 M6⏎M7⏎M8⏎M9⏎G0 X1⏎M2⏎G0 X2", [1.0, 0.0, 0.0]);
    ends_at("G20 G0 X1⏎M30⏎G0 X2", [1.0, 0.0, 0.0]);
    let (_, status, told, _) = run("G20⏎G0 X1⏎G345", Session::default());
    assert_eq!((status, told.as_str()), (Status::Failed, "G002 line 3"));
}

#[test]
fn sbp_gcode_units() {
    ends_at("G21⏎G0 X25.4", [1.0, 0.0, 0.0]);
    ends_at("G21 F100⏎G1 X25.4", [1.0, 0.0, 0.0]);
    let mut session = Session::default();
    session.settings.linear_unit = LinearUnit::Mm;
    assert_eq!(run("G20⏎G0 X1", session).3, [25.4, 0.0, 0.0]);
}

#[test]
fn sbp_gcode_feed() {
    let (out, ..) = run("G20⏎G1 X5 F120⏎X6⏎G0 X0⏎G1 Y1⏎F60⏎Y2", Session::default());
    let speeds: Vec<f64> = out
        .iter()
        .filter_map(|s| match &s.command {
            Command::Line(l) => match l.feed {
                Feed::Path(mm_s) => Some((mm_s / 25.4 * 1e9).round() / 1e9),
                _ => Some(0.0),
            },
            _ => None,
        })
        .collect();
    assert_eq!(speeds, [2.0, 2.0, 0.0, 2.0, 1.0]);
}

#[test]
fn sbp_gcode_arc() {
    for text in ["G20 F9⏎G2 X2 Y-2 I0 J-2", "G20 F9⏎G2 X2 Y-2 R2"] {
        let (out, ..) = run(text, Session::default());
        let arc = out.iter().find_map(|s| match &s.command {
            Command::Arc(arc) => Some(*arc),
            _ => None,
        });
        let arc = arc.unwrap();
        // CG,,2,-2,0,-2,T,1: clockwise about (0,-2) by a quarter.
        let centre = arc.centre.map(|v| (v / 25.4 * 1e9).round() / 1e9);
        assert_eq!((centre, arc.sweep_rad.to_degrees().round()), ([0.0, -2.0], -90.0), "{text}");
        let end = [arc.to[Axis::X], arc.to[Axis::Y]].map(|v| (v / 25.4 * 1e9).round() / 1e9);
        assert_eq!(end, [2.0, -2.0]);
    }
}
