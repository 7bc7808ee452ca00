#![allow(clippy::unwrap_used)]

use crate::syntax::tree::{Node, PlainMove, Program};
use crate::testing::program;

/// The diagnostics of a program: code, line, column and length.
#[track_caller]
fn finds(text: &str, expected: &[&str]) {
    let program = program(text);
    let found: Vec<String> = program
        .diagnostics
        .iter()
        .map(|d| {
            let p = &d.place;
            format!("{} {}:{}+{} {}", d.code, p.line, p.column, p.length, d.message)
        })
        .collect();
    assert_eq!(found.len(), expected.len(), "{text:?}: {found:#?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.starts_with(expected), "{text:?}: {found} is not {expected}");
    }
}

/// A first line that is a move, as text.
fn shown(program: &Program) -> String {
    let Some(plain) = program.move_of(1) else {
        return format!("{:?}", program.line(1).unwrap().node());
    };
    let known = plain.motion < PlainMove::MODAL;
    let mut text = if known { format!("G{}", plain.motion) } else { "-".into() };
    for (letter, value) in plain.words() {
        text.push_str(&format!(" {}{value}", letter as char));
    }
    text
}

#[track_caller]
fn moves(text: &str, expected: &str) {
    let program = program(text);
    assert!(program.diagnostics.is_empty(), "{:?}", program.diagnostics);
    assert_eq!(shown(&program), expected, "{text:?}");
}

#[test]
fn plain_moves_in_every_spelling() {
    moves("G1 X1 Y2.5 Z-3", "G1 X1 Y2.5 Z-3");
    moves("g01x1y2.5z-3", "G1 X1 Y2.5 Z-3");
    moves("N10 G00 X.5 F100.", "G0 X0.5 F100");
    moves("  z-.25  y+1", "- Y1 Z-0.25");
    moves("G 2 X 1 I-0.5 J 0", "G2 X1 I-0.5 J0");
    moves("X1 S500", "- X1 S500");
    moves("X1.23456789012345678", "- X1.2345678901234567");
}

#[test]
fn what_is_no_plain_move_is_a_block() {
    for text in [
        "G4 P1",
        "G1 X[1+2]",
        "G1 X1 (here)",
        "G1 X1 ; there",
        "M3",
        "G90 G1 X1",
        "G10 L2 P1 X0",
        "/G1 X1",
        "G1 X#1",
        "T1 M6",
        "#1=5",
        "O1 sub ⏎ O1 endsub",
        "G38.2 Z-1",
        "F100",
        "N5",
    ] {
        let program = program(text);
        assert!(program.diagnostics.is_empty(), "{text}: {:?}", program.diagnostics);
        let node = program.line(1).unwrap().node();
        let is_move = node == Node::Move;
        assert_eq!(is_move, text == "F100", "{text}: {node:?}");
    }
}

#[test]
fn faults_have_place_and_code() {
    finds("G1 X1 X2", &["G006 1:7+2 X stands twice"]);
    finds("G0 G1 X1", &["G007 1:4+2 G0 and G1 exclude"]);
    finds("G20 G21", &["G007 1:5+3"]);
    finds("M3 M5", &["G007 1:4+2 M3 and M5"]);
    finds("G123", &["G002 1:1+4 unknown code G123"]);
    finds("G1.5 X1", &["G002 1:1+4"]);
    finds("M77", &["G003 1:1+3 unknown code M77"]);
    finds("M101", &["G003 1:1+4"]);
    finds("G76 P1", &["R017 1:1+3 G76 cannot be carried out"]);
    finds("G1 X", &["G005 1:4+1 X without a number"]);
    finds("G1 X1 Y-", &["G011 1:9+0 a value is missing"]);
    finds("G1 é", &["G004 1:4+1"]);
    finds("G1 X1 (open", &["G010 1:7+5"]);
    finds("G4", &["G008 1:1+2 G4 without P"]);
    finds("G10 P1 X0", &["G008 1:1+9 G10 without L"]);
    finds("M66 L3", &["G008 1:1+6"]);
    finds("G1 X1 F-5", &["R009 1:1+9 F may not be negative"]);
    finds("G92 X0 G1 Y1", &["G007 1:1+12"]);
    finds("G1 X[1+]", &["G011 1:8+1 a value is missing"]);
    finds("G1 X[1 2]", &["G022 1:8+1"]);
    finds("G1 X[[1]", &["G011 1:9+0 an operator or ] is missing"]);
    finds("G1 X[ATAN[1]]", &["G011 1:6+7 ATAN needs two"]);
    finds("#1", &["G004 1:1+2 = expected"]);
    finds("#<a=1", &["G011 1:2+"]);
    finds("G1 X1 0 Y2", &["G022 1:7+1"]);
    finds("G1 X1e-5 Y2", &["G004 1:4+5 a number with an exponent"]);
    finds("F1.5E3", &["G004 1:1+6 a number with an exponent"]);
    finds("M67 E0 Q.5⏎M67E0Q.5⏎M68Q5E0⏎M66E1L0", &[]);
    finds("(a (b) c)", &["W003 1:4+1"]);
    finds("G1 X1 ⏎ G1 Q⏎G2 X1 X1⏎G999", &["G005 2:4+1", "G006 3:7+2", "G002 4:1+4"]);
    finds("X1 M3 X2 M4 G999", &["G006 1:7+2", "G007 1:10+2", "G002 1:13+4"]);
}

#[test]
fn a_number_that_goes_on_behind_a_comment_is_told() {
    finds("G0 X1(one)2", &["G022 1:11+1 a number goes on behind a blank or a comment"]);
    finds("G0 X(one)12(two) Y3", &[]);
}

#[test]
fn the_number_of_a_tool_is_whole() {
    finds("T1.5 M6", &["R009 1:1+7 T is the number of a tool, a whole one"]);
    finds("G43 H2.5", &["R009 1:1+8 H is the number of a tool"]);
    finds("T[3 / 1] M6⏎T3. M6⏎G41.1 D2.5", &[]);
}

#[test]
fn what_stands_behind_the_last_percent_is_no_reason_not_to_run() {
    let text = "(head)⏎%⏎G0 X1⏎%⏎G0 X9⏎this is no code";
    finds(text, &["G005 6:1+1 T without a number"]);
    let ended = program(text);
    assert!(!ended.has_errors());
    assert_eq!(ended.diagnostics[0].hint, "never reached: it stands behind the % of line 4");
    assert!(program("%⏎G0 X1⏎this is no code⏎%").has_errors());
    assert!(program("G0 X1⏎%⏎this is no code").diagnostics.iter().all(|d| !d.is_error()));
}

#[test]
fn a_hint_says_what_was_probably_meant() {
    for (text, hint) in [
        ("G0 X1,5", "write 1.5 for 1,5"),
        ("G0 X1,", "a block is made of letters"),
        ("G1 X10 E5", "printers have E"),
        ("G1 X10E5", "write 0.00001 for 1e-5"),
        ("G68 X0 Y0 R30", "G10 L2 P0 R30 turns"),
        ("G51 X2", "proportions of FP"),
        ("G16", "@10 ^45"),
        ("G65 P100", "O<name> call"),
    ] {
        let found = program(text).diagnostics;
        assert!(found[0].hint.contains(hint), "{text}: {found:?}");
    }
}

#[test]
fn codes_that_may_stand_together() {
    for text in
        ["G17 G20 G90 G94 G54 G64 P0.01", "M7 M8", "G53 G0 X0", "G80 G0 X1", "M3 S100 M8 T1"]
    {
        finds(text, &[]);
    }
}

#[test]
fn o_words_find_their_partners() {
    finds("O1 sub⏎G0 X1", &["G014 1:1+6 O1 sub is never ended"]);
    finds("O1 if [1]⏎O2 while [1]⏎O1 endif", &["G014 2:1+12 O2 while is never ended"]);
    finds("O1 endif", &["G014 1:1+8 this ends nothing"]);
    finds("O1 else", &["G014 1:1+7 else without its if"]);
    finds("O1 break", &["G014 1:1+8 break and continue"]);
    finds("O1 wend", &["G014 1:1+2 no such O-word"]);
    finds("O1 if", &["G014 1:1+5 this O-word takes 1 values"]);
    finds("O1 sub⏎O1 endsub⏎O1 sub⏎O1 endsub", &["G014 3:1+6 O1 is already defined"]);
    finds("O1 do⏎O1 while [0]⏎O<a b> repeat [2]⏎o<AB> endrepeat", &[]);
}

#[test]
fn other_languages_are_said_once() {
    finds("'a part⏎M3,1,2,3⏎MX,4⏎&a=1⏎IF &a=1 THEN GOTO x", &["G001 1:1+0 this file is OpenSBP"]);
    finds("0⏎SECTION⏎2⏎HEADER⏎9⏎$ACADVER", &["G001 1:1+0 this file is a DXF"]);
    finds("999⏎KERF {\"version\":1}⏎0⏎SECTION⏎2⏎HEADER⏎9", &["G001 1:1+0 this file is a drawing"]);
    finds("IN;SP1;PU0,0;PD100,0;", &["G001 1:1+0 this file is a plot"]);
    finds(
        "solid cube⏎ facet normal 0 0 1⏎ outer loop⏎ vertex 1 2 3",
        &["G001 1:1+0 this file is a solid"],
    );
    finds("%PDF-1.4⏎%âã⏎1 0 obj⏎<< /Type /Page >>", &["G001 1:1+0 this file is a printed page"]);
    finds("{⏎\"layers\": [1, 2]⏎}", &["G001 1:1+0 this file is data (JSON)"]);
    finds("G1 X1⏎G0 Y2⏎G0 Y3⏎MX,4", &["G005 4:1+1"]);
    let program = crate::read("x".into(), b"G1 X1\nG1 \0");
    assert_eq!(program.diagnostics[0].code.as_str(), "S001");
}

#[test]
fn files_in_old_and_wide_encodings() {
    let wide: Vec<u8> =
        "\u{FEFF}G1 X1 (é)\r\nG999".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let program = crate::read("x".into(), &wide);
    assert_eq!(shown_codes(&program), ["G002 2"]);
    let program = crate::read("x".into(), b"G1 X1 (caf\xE9)\rG999");
    assert_eq!(shown_codes(&program), ["G002 2"]);
    assert!(program.text.contains("café"));
}

fn shown_codes(program: &Program) -> Vec<String> {
    program.diagnostics.iter().map(|d| format!("{} {}", d.code, d.place.line)).collect()
}

#[test]
fn long_lines_and_deep_brackets_are_refused() {
    finds(&"X1 ".repeat(50_000), &["S015 1:1+0"]);
    finds(&format!("X{}1{}", "[".repeat(500), "]".repeat(500)), &["G011"]);
    finds(&format!("X[1{}]", "+1".repeat(500)), &["G011"]);
    finds(&format!("X{}1", "-".repeat(500)), &["G011"]);
    finds(&format!("X{}1", "#".repeat(500)), &["G011"]);
}

#[test]
fn millions_of_mistakes_are_counted_and_not_kept() {
    let program = crate::read("t".into(), "G999\n".repeat(30_000).as_bytes());
    assert_eq!(program.diagnostics.len(), super::file::MOST_DIAGNOSTICS + 1);
    assert!(program.diagnostics.last().unwrap().message.contains("20000 more"));
}
