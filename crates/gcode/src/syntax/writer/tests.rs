#![allow(clippy::unwrap_used)]

use super::{Writing, write};
use crate::testing::run;
use crate::{Dialect, Options};
use kerf_program::settings::LinearUnit;
use kerf_program::{At, Command, Sourced};

/// A program run and written again, lines parted by `⏎`, without the first and the last.
#[track_caller]
fn check(dialect: Dialect, text: &str, expected: &str) {
    let ran = run(&format!("G21 F600⏎{text}"));
    assert!(ran.error.is_none(), "{:?}", ran.error);
    let text = write(&ran.commands, &Writing { dialect, ..Writing::default() }).text;
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[1..lines.len() - 1].join("⏎"), expected);
}

#[test]
fn moves_and_arcs_stay_what_they_are() {
    check(
        Dialect::LinuxCnc,
        "G0 X1 Y2⏎G1 Z-1.25⏎X5⏎G2 X9 I2⏎G3 I-2⏎G0 Z5",
        "G0 X1 Y2⏎G1 Z-1.25 F600⏎X5⏎G2 X9 Y2 I2 J0⏎G3 I-2 J0⏎G0 Z5",
    );
    check(
        Dialect::LinuxCnc,
        "G3 I-2 Z6 P2⏎G93 G1 X1 F2⏎G94 F5 X2",
        "G3 Z3 I-2 J0 F600⏎G3 Z6 I-2 J0⏎G1 X1 G93 F2⏎X2 G94 F5",
    );
    check(Dialect::LinuxCnc, "G1 X0.1⏎X0.3⏎X-0.00000001", "G1 X0.1 F600⏎X0.3⏎X0");
}

#[test]
fn what_is_no_motion() {
    let text = "(a (b) c)⏎M3 S1000⏎M8⏎G4 P1.5⏎M64 P2⏎G64 P0.1⏎T2 M6⏎G92 X5⏎G0 X6⏎M49⏎(PRINT,done)";
    check(
        Dialect::LinuxCnc,
        text,
        "(a [b] c)⏎S1000⏎M3⏎M8⏎G4 P1.5⏎M64 P2⏎G64 P0.1 Q0.1⏎M5⏎T2 M6⏎G92 X5⏎G0 X6⏎M49⏎(PRINT,done)⏎M9",
    );
    check(
        Dialect::Grbl,
        text,
        "(a [b] c)⏎S1000⏎M3⏎M8⏎G4 P1.5⏎(not in G-code: output 3 on)⏎(not in G-code: how closely the path is followed)⏎M5⏎(tool T2)⏎M0⏎G92 X5⏎G0 X6⏎(not in G-code: whether the operator's overrides hold)⏎(done)⏎M9",
    );
}

#[test]
fn inches_titles_and_the_spindle_of_an_output() {
    let on = |on| Sourced { at: At::default(), command: Command::Output { number: 1, on } };
    let writing = Writing {
        unit: LinearUnit::Inch,
        title: Some("part (one)\nline two".into()),
        ..Writing::default()
    };
    assert_eq!(
        write(&[on(true), on(true)], &writing).text,
        "(part [one])\n(line two)\nG20 G17 G40 G49 G80 G90 G94\nM3\nM5\nM2\n"
    );
    assert_eq!(Options::default().spindle_output, writing.spindle_output);
}

#[test]
fn moves_without_a_feed_take_the_speeds_of_the_settings() {
    use kerf_program::{Axes, Feed, Line, MoveKind};
    let to = |x, z| {
        let line = Line { kind: MoveKind::Cut, to: Axes::xyz(x, 0.0, z), feed: Feed::Axis };
        Sourced { at: At::default(), command: Command::Line(line) }
    };
    // XY at 2 in/s; Z alone at 1 in/s; both: XY slowed so that Z keeps to 1 in/s.
    let text = write(&[to(25.4, 0.0), to(25.4, 25.4), to(50.8, 50.8)], &Writing::default()).text;
    let lines: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(lines, ["G1 X25.4 F3048", "Z25.4 F1524", "X50.8 Z50.8 F2155.261469", "M2"]);
}
