//! Drawings from the motion of programs: rows of the Profiler ledger are in `crates/kerf/tests/nc.rs`,
//! from the file on; here what commands alone show.

use kerf_formats::motion;
use kerf_program::{AXES, At, Axes, Command, Feed, Line, MoveKind, Sourced};

fn line(kind: MoveKind, x: f64, y: f64, z: f64) -> Sourced {
    let mut to = [0.0; AXES];
    (to[0], to[1], to[2]) = (x, y, z);
    let command = Command::Line(Line { kind, to: Axes(to), feed: Feed::Axis });
    Sourced { at: At::default(), command }
}

#[test]
fn plunges_and_lifts_are_no_part_of_a_shape() {
    let (cut, jog) = (MoveKind::Cut, MoveKind::Jog);
    let commands = [
        line(jog, 5.0, 5.0, 2.0),
        line(cut, 5.0, 5.0, -3.0),
        line(cut, 15.0, 5.0, -3.0),
        line(cut, 15.0, 5.0, 2.0),
        line(jog, 0.0, 0.0, 2.0),
    ];
    let read = motion::read(&commands, Axes::default());
    assert_eq!(read.drawing.shapes.len(), 1);
    assert_eq!(read.drawing.shapes[0].z_mm, None);
    assert_eq!(read.findings[0].text, "cut at Z -3 mm");
}
