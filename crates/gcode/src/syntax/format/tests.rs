#![allow(clippy::unwrap_used)]

use super::format;
use crate::read;
use crate::syntax::tree::{Node, Program};
use proptest::prelude::*;

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(format(text), expected, "{text:?}");
    assert_eq!(format(expected), expected, "formatting twice: {text:?}");
}

/// Describes the meaning of a line, without the places of its parts.
fn meaning(program: &Program, index: u32) -> String {
    match program.line(index + 1).unwrap().node() {
        Node::Move => {
            let plain = program.move_of(index + 1).unwrap();
            format!("{} {:?}", plain.motion, plain.words().collect::<Vec<_>>())
        }
        Node::Block(at) => {
            let block = &program.blocks[at as usize];
            let words = program.words_of(block).iter().map(|w| match w.value {
                crate::syntax::tree::Value::Number(n) => format!("{} {n}", char::from(w.letter)),
                crate::syntax::tree::Value::Computed(e) => {
                    format!("{} {:?}", char::from(w.letter), program.exprs[e as usize])
                }
            });
            let words: Vec<_> = words.collect();
            let extra = program.extra_of(block).cloned().unwrap_or_default();
            let settings: Vec<_> =
                extra.settings.iter().map(|s| format!("{:?} {:?}", s.target, s.value)).collect();
            let flow = extra.flow.map(|f| {
                format!(
                    "{:?} {:?} {:?} {:?} {}",
                    f.label, f.computed, f.keyword, f.values, f.target
                )
            });
            format!("{} {words:?} {settings:?} {flow:?} {:?}", block.delete, extra.comments)
        }
        node => format!("{node:?}"),
    }
}

/// Formatting keeps what every line means and what is found in it, and is done after one round.
#[track_caller]
fn keeps_meaning(text: &str) {
    let once = format(text);
    assert_eq!(format(&once), once, "formatting twice\n{text:?}");
    let (before, after) = (read("".into(), text.as_bytes()), read("".into(), once.as_bytes()));
    let count = after.line_count();
    assert!(
        (count + 1..=before.line_count()).all(|l| before.line(l).unwrap().node() == Node::Blank),
        "{text:?}\n{once:?}"
    );
    for index in 0..count {
        assert_eq!(meaning(&before, index), meaning(&after, index), "{text:?}\n{once:?}");
    }
    let found = |p: &Program| {
        p.diagnostics.iter().map(|d| (d.code, d.place.line, d.message.clone())).collect::<Vec<_>>()
    };
    assert_eq!(found(&before), found(&after), "{text:?}\n{once:?}");
}

#[test]
fn words() {
    check("g1x 10y-.5f 100", "G1 X10 Y-.5 F100");
    check("N10G01X+1.0", "N10 G01 X+1.0");
    check("  m3s12000  m8", "  M3 S12000 M8");
    check("\tG1\tX1", "\tG1 X1");
    check("%  \r\nG0 X1 \r\n", "%\r\nG0 X1\r\n");
    check("@10^90", "@10 ^90");
    check("/g1x1", "/G1 X1");
    check("/2g1x1", "/2 G1 X1");
    check("$H  ", "$H  ");
}

#[test]
fn comments() {
    check("g1x1(go)y2;  there  ", "G1 X1 (go) Y2 ;  there");
    check("g1x1   ( go )", "G1 X1   ( go )");
    check("(a)g1x1", "(a) G1 X1");
    check("  (only) ", "  (only)");
    check("; only ", "; only");
    check("/(a)g1x1(b)(c)", "/(a) G1 X1 (b)(c)");
    check("(msg,  two  blanks ) m0", "(msg,  two  blanks ) M0");
}

#[test]
fn computing() {
    check("#1=5#<Two words>=-#1", "#1 = 5 #<Two words> = -#1");
    check("x[ 1+ #2mod3 ]y-sin[#<a b>]", "X[1+#2 MOD 3] Y-SIN[#<a b>]");
    check("x##1 y atan[1]/[2]", "X##1 YATAN[1]/[2]");
    check("#3=[1**2eq3and4xor5]", "#3 = [1**2 EQ 3 AND 4 XOR 5]");
    check("#4=exists[#<_x=y>]", "#4 = EXISTS[#<_x=y>]");
}

#[test]
fn flow() {
    check("o100SUB", "O100 sub");
    check("O<Name>Call[1][#2]  (go)", "O<Name> call [1] [#2]  (go)");
    check("n5o1 if[#1lt2]", "N5 O1 if [#1 LT 2]");
    check("o1if[1]\no1endif", "O1 if [1]\nO1 endif");
    check("o[#1+1]call[2]\no#<x>call", "O[#1+1] call [2]\nO#<x> call");
    check("O12 (name)", "O12 (name)");
}

#[test]
fn what_is_doubtful_stays() {
    check("g1x1 0", "g1x1 0");
    check("g1x(a)10", "g1x(a)10");
    check("g1(a(b))x10", "g1(a(b))x10");
    check("g1 x", "g1 x");
    check("g1x1(never closed", "g1x1(never closed");
    check("\u{feff}g1x1", "\u{feff}G1 X1");
}

#[test]
fn keeps_the_meaning_of_odd_lines() {
    for text in ["/ 1g1x1", "g1\rx1\n", "g1x1;(\n", "x1%\n", "o1 do\no1 while[0]", "g0x1\u{1a}"] {
        keeps_meaning(text);
    }
}

fn piece() -> impl Strategy<Value = String> {
    let pieces = [
        "g1",
        "G0 ",
        "x",
        "Y 1",
        "z-.5",
        "f+10",
        "1",
        ".",
        " ",
        "\t",
        "(",
        ")",
        "(a b)",
        ";c ",
        "/",
        "%",
        "#1",
        "#<A b>",
        "=",
        "[",
        "]",
        " eq ",
        "and",
        "mod",
        "sin[",
        "atan[1]/[2]",
        "exists[#<q>]",
        "o1 ",
        "o<N>",
        "sub",
        "endsub",
        "if[1]",
        "endif",
        "call[2]",
        "\n",
        "\r\n",
        "\r",
        "n10",
        "m3s5",
        "**",
        "-",
        "é",
        "$H",
        "(msg, x )",
    ];
    proptest::sample::select(pieces.to_vec()).prop_map(String::from)
}

proptest! {
    #[test]
    fn keeps_the_meaning_of_any_text(pieces in proptest::collection::vec(piece(), 0..40)) {
        keeps_meaning(&pieces.concat());
    }
}

/// Files of the project's own, and real ones of the workshop where they are at hand.
#[test]
fn keeps_the_meaning_of_real_files() {
    for file in crate::testing::find::all("gcode") {
        let mut bytes = std::fs::read(&file).unwrap();
        bytes.truncate(60_000);
        keeps_meaning(&bytes.iter().map(|b| char::from(*b)).collect::<String>());
    }
}
