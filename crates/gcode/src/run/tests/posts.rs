//! Lines that real posts write, and those that are told.

use super::*;

fn generic(text: &str) -> Ran {
    let options = Options { dialect: Dialect::Generic, ..Options::default() };
    run_with(&format!("G21 F100⏎{text}"), FakeHost::default(), metric(), options)
}

/// The path in the generic dialect, and the codes of what is told.
#[track_caller]
fn takes(text: &str, expected: &str, codes: &str) {
    let ran = generic(text);
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    assert_eq!((ran.path().as_str(), ran.codes().as_str()), (expected, codes), "{text}");
}

#[track_caller]
fn refuses(text: &str, dialect: Dialect, expected: &str) {
    let options = Options { dialect, ..Options::default() };
    let ran = run_with(&format!("G21 F100⏎{text}"), FakeHost::default(), metric(), options);
    let found = ran.error.map(|e| format!("{} {} | {}", e.code, e.message, e.hint));
    assert!(found.as_ref().is_some_and(|f| f.contains(expected)), "{text}: {found:?}");
}

#[test]
fn a_place_behind_g80_goes_on_as_before_the_cycle() {
    let text = "G0 Z5⏎G81 X1 R2 Z-1⏎G80⏎Z15⏎Z16";
    takes(text, "J0,0,5 J1,0,5 J1,0,2 L1,0,-1 J1,0,5 J1,0,15 J1,0,16", "W014");
    refuses(text, Dialect::LinuxCnc, "Z without a motion");
    refuses(text, Dialect::Grbl, "grbl has no G81");
    // Without a motion before it nothing goes on.
    refuses("G80⏎Z15", Dialect::Generic, "Z without a motion");
}

#[test]
fn a_retract_of_fanuc_goes_home() {
    for text in ["G1 Z-5⏎G0 G91 G28 Z0", "G1 Z-5⏎G28 G91 Z0 G0"] {
        takes(text, "L0,0,-5 J0,0,0", "");
        refuses(text, Dialect::LinuxCnc, "G28 and G30 beside a motion");
    }
    refuses("G92 X1 G0", Dialect::Generic, "two codes of the block need the axis words");
}

#[test]
fn codes_that_cancel_what_is_never_on_do_nothing() {
    takes("G0 G49 G40 G17 G80 G50 G90⏎G69 G15⏎G49.1 G13.1 G50.1 G40.1⏎X1", "J1,0,0", "");
    refuses("G69", Dialect::LinuxCnc, "LinuxCNC has no G69");
    refuses("G68", Dialect::Generic, "G68 cannot be carried out");
}

#[test]
fn the_fan_of_a_printer_is_told_once() {
    takes("M106 S255⏎G1 X1⏎M107⏎M106 S9⏎X2", "L1,0,0 L2,0,0", "W014");
}

#[test]
fn text_behind_the_end_is_told_and_stops_nothing() {
    let notes = "G1 X1⏎M30⏎Post Process Timed at 12:05⏎{ \"a\": 1 }⏎?";
    takes(notes, "L1,0,0", "");
    let program = crate::testing::program(notes);
    assert!(!program.has_errors() && program.diagnostics.len() >= 2, "{:?}", program.diagnostics);
    // What a call can reach is read.
    assert!(crate::testing::program("O1 call⏎M2⏎O1 sub⏎Post⏎O1 endsub").has_errors());
    assert!(crate::testing::program("G1 X1⏎/M2⏎Post").has_errors());
}

#[test]
fn a_line_for_a_senders_console_is_left_out() {
    takes("?⏎G1 X1⏎!⏎~", "L1,0,0", "G020");
}

#[test]
fn q0_is_one_peck_and_no_q_is_told_apart() {
    takes("G83 X1 R2 Z-1 Q0", "J0,0,2 J1,0,2 L1,0,-1 J1,0,2", "");
    refuses("G83 X1 R2 Z-1 Q0", Dialect::LinuxCnc, "G83 with a Q of 0");
    refuses("G83 X1 R2 Z-1", Dialect::Generic, "G83 without Q");
}

#[test]
fn macros_of_fanuc_are_told_as_that() {
    for line in ["IF [#1 LT 5] GOTO 10", "WHILE [#1 LT 3] DO1", "END1", "GOTO 10"] {
        refuses(
            line,
            Dialect::Generic,
            "this is Fanuc's macro language | Kerf knows LinuxCNC's: O100 while",
        );
    }
    refuses("#1=#1+1", Dialect::Generic, "calculations stand in brackets");
}

#[test]
fn axes_that_are_not_there_are_errors() {
    for dialect in [Dialect::Generic, Dialect::LinuxCnc, Dialect::Grbl] {
        refuses("G1 U1", dialect, "there is no axis U");
    }
}

#[test]
fn g88_asks_before_the_tool_goes_up() {
    let text = "M3 S9⏎G0 Z5⏎G88 X1 R2 Z-1⏎G80";
    let ran = generic(text);
    assert_eq!(ran.path(), "J0,0,5 J1,0,5 J1,0,2 L1,0,-1 J1,0,5");
    assert_eq!(ran.host.asked.len(), 1);
    assert_eq!(ran.host.asked[0].text, "G88: retract by hand, then go on");
    assert_eq!(ran.others(), "rpm=9 clockwise out1=1 off out1=0 clockwise out1=1");
    // Cancel leaves the tool where it is.
    let host = FakeHost { answers: vec![Answer::Button(Button::Cancel)], ..FakeHost::default() };
    let options = Options { dialect: Dialect::Generic, ..Options::default() };
    let ran = run_with(&format!("G21 F100⏎{text}"), host, metric(), options);
    assert_eq!((ran.end().as_str(), ran.status), ("1,0,-1", Status::Stopped));
    refuses("M3⏎G88 X1 R2 Z-1 L2", Dialect::Generic, "G88 is repeated by L");
}

#[test]
fn words_that_mean_nothing_sensible_are_told() {
    for dialect in [Dialect::Generic, Dialect::LinuxCnc, Dialect::Grbl] {
        refuses("G4 P-1", dialect, "G4 with a time below zero");
    }
    takes("G2⏎G1 X1", "L1,0,0", "W014");
    refuses("G2", Dialect::LinuxCnc, "G2 without a place or a centre");
    refuses("M66 P0 E0 L0", Dialect::Generic, "M66 with P and E");
}
