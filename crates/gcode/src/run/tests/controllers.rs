//! Tests of what each controller refuses, as its own parser does.

use super::*;
use Dialect::{Generic, Grbl, GrblHal, LinuxCnc, Mach3};

/// The error of a program in a dialect; nothing when it runs.
fn error(text: &str, dialect: Dialect) -> Option<String> {
    let options = Options { dialect, ..Options::default() };
    let ran = run_with(&format!("G21 F100⏎{text}"), FakeHost::default(), metric(), options);
    ran.error.map(|e| format!("{} | {}", e.message, e.hint))
}

#[track_caller]
fn only(text: &str, refusing: &[Dialect], expected: &str) {
    for dialect in [Grbl, GrblHal, Mach3, LinuxCnc, Generic] {
        let found = error(text, dialect);
        let refused = found.as_ref().is_some_and(|f| f.contains(expected));
        assert_eq!(refused, refusing.contains(&dialect), "{text} as {dialect:?}: {found:?}");
        assert!(refused || found.is_none(), "{text} as {dialect:?}: {found:?}");
    }
}

#[test]
fn grbl_refuses_what_its_parser_refuses() {
    for (text, expected) in [
        ("G2 I5", "arcs without an end in their plane"),
        ("G17 G2 Z-1 I5", "arcs without an end in their plane"),
        ("G3 X10 Y0 I5 P2", "arcs of several turns (P)"),
        ("G10 L2 P1 R30", "turned coordinate systems"),
        ("G10 L1 P1 Z3", "tools of G10"),
        ("G0 @10 ^45", "polar places"),
        ("G97 S9", "grbl has no G97"),
        ("M48", "grbl has no M48"),
        ("M7", "grbl has no M7 | grblHAL has it"),
        ("#<x>=5", "grbl has no named parameters"),
        ("#1=5", "grbl has no parameters"),
        ("G80 G0 X1", "G80 beside another motion"),
        ("G4 X1", "G4 without P"),
        ("G1 A1", "axes A, B and C"),
        ("M10", "grbl has no M10"),
    ] {
        let found = error(text, Grbl);
        assert!(found.as_ref().is_some_and(|f| f.contains(expected)), "{text}: {found:?}");
        assert_eq!(error(text, Generic), None, "{text}");
    }
    // What grbl takes: G0 is in force from the start, G91.1 is what it does anyway.
    for text in [
        "X5 Y5",
        "G91.1 G0 X1",
        "G2 X10 I5",
        "G4 P0",
        "G18 G2 X1 Z1 I1",
        "T3",
        "G43.1 Z1",
        "G38.3 Z-1",
    ] {
        assert_eq!(error(text, Grbl), None, "{text}");
    }
}

#[test]
fn controllers_differ_in_their_codes() {
    only("G81 X1 R2 Z-1", &[Grbl], "grbl has no G81");
    only("M64 P0", &[Grbl, Mach3], "has no M64");
    only("G41.1 D2", &[Grbl, GrblHal], "has no G41.1");
    only("G38.3 Z-1", &[Mach3], "Mach3 has no G38.3");
    only("O1 repeat [2]⏎O1 endrepeat", &[Grbl, Mach3], "has no O-words");
    only("#<x>=5", &[Grbl, Mach3], "has no named parameters");
    only("#1=[2+3]", &[Grbl], "grbl has no parameters");
    only("X5", &[Mach3, LinuxCnc, Generic], "X without a motion");
    only("G0 G28 Z0", &[Grbl, GrblHal, LinuxCnc], "G28 and G30 beside a motion");
}
