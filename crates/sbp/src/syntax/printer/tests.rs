#![allow(clippy::unwrap_used)]

use super::{Printing, print};
use kerf_program::settings::LinearUnit;
use kerf_program::{Arc, At, Axes, Command, Feed, Line, MoveKind, Sourced};
use std::f64::consts::{PI, TAU};

fn sourced(command: Command) -> Sourced {
    Sourced { at: At { file: 0, line: 1 }, command }
}

fn cut(x: f64, y: f64, z: f64, mm_s: f64) -> Sourced {
    let (kind, to, feed) = (MoveKind::Cut, Axes::xyz(x, y, z), Feed::Path(mm_s));
    sourced(Command::Line(Line { kind, to, feed }))
}

fn jog(x: f64, y: f64, z: f64) -> Sourced {
    let (kind, to, feed) = (MoveKind::Jog, Axes::xyz(x, y, z), Feed::Axis);
    sourced(Command::Line(Line { kind, to, feed }))
}

fn arc(centre: [f64; 2], sweep_rad: f64, to: [f64; 3]) -> Sourced {
    let [x, y, z] = to;
    sourced(Command::Arc(Arc {
        kind: MoveKind::Cut,
        centre,
        sweep_rad,
        to: Axes::xyz(x, y, z),
        feed: Feed::Path(10.0),
        chords: 1,
        small: false,
    }))
}

/// The lines between head and end, parted by `⏎`, of a file in mm.
#[track_caller]
fn check(commands: &[Sourced], expected: &str) {
    let printing = Printing { unit: LinearUnit::Mm, ..Printing::default() };
    let text = print(commands, &printing).text;
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[3..lines.len() - 4].join("⏎"), expected);
}

#[test]
fn moves_name_what_changes() {
    check(
        &[
            jog(1.0, 2.0, 0.0),
            cut(1.0, 2.0, -1.25, 10.0),
            cut(5.0, 2.0, -1.25, 10.0),
            jog(5.0, 2.0, 5.0),
        ],
        "J2,1,2⏎VS,,10⏎MZ,-1.25⏎VS,10⏎MX,5⏎JZ,5",
    );
}

#[test]
fn slopes_are_as_slow_as_the_feed_says() {
    // At 45° both would be 41 % too fast.
    check(&[cut(10.0, 0.0, -10.0, 10.0)], "VS,7.071068,10⏎M3,10,,-10");
    // A shallow slope stays at the feed.
    check(
        &[cut(10.0, 0.0, -0.5, 10.0), cut(20.0, 0.0, 0.0, 10.0)],
        "VS,10,10⏎M3,10,,-0.5⏎M3,20,,0",
    );
}

#[test]
fn arcs_are_cg() {
    check(&[arc([2.0, 0.0], -PI, [4.0, 0.0, 0.0])], "VS,10⏎CG,,4,0,2,0,T,1");
    check(&[arc([2.0, 0.0], TAU, [0.0, 0.0, 0.0])], "VS,10⏎CG,,0,0,2,0,T,-1");
    // A helix of two turns.
    check(
        &[arc([2.0, 0.0], 2.0 * TAU, [0.0, 0.0, -3.0])],
        "VS,9.929511,10⏎CG,,0,0,2,0,T,-1,-1.5,1,,,3,1⏎CG,,0,0,2,0,T,-1,-1.5,1,,,3,1",
    );
}

#[test]
fn a_feed_that_vs_cannot_say_is_told() {
    let written = print(
        &[cut(10.0, 0.0, 0.0, 0.5)],
        &Printing { unit: LinearUnit::Mm, ..Printing::default() },
    );
    assert_eq!(written.lost.len(), 1);
    assert!(written.text.contains("VS,1.27\n"), "{}", written.text);
}
