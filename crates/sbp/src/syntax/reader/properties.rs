//! Tests of what holds for every text: no panic, one node a line, spans inside their lines.

use super::read;
use crate::syntax::tree::{ArgKind, Node, Program, Span, Statement};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Pieces that lines are made of; random rows of them come near to every branch of the reader.
const PIECES: &[&str] = &[
    "[",
    "]",
    "&a[",
    "$b[].x",
    "DIALOG ",
    "FAIL ",
    "OKTEXT=",
    "PZ,",
    "MX",
    "M3",
    "JZ",
    "VS",
    "CC",
    "FP",
    "C#",
    "CN",
    "C9",
    "ZX",
    "MD",
    "IF",
    "THEN",
    "GOTO",
    "GOSUB",
    "END",
    "ALL",
    "RETURN",
    "ON",
    "INPUT",
    "INP",
    "PAUSE",
    "UNTIL",
    "PRINT",
    "WRITE",
    "MSGBOX",
    "OPEN",
    "FOR",
    "OUTPUT",
    "AS",
    "CLOSE",
    "SHELL",
    "SYNC",
    "PLAY",
    "SETUSRVAL",
    "GETUSRVAL",
    "REM",
    "WARNING",
    "OFF",
    "EXIT",
    "AND",
    "OR",
    "NOT",
    "MOD",
    "SQR",
    "RND",
    "word",
    "Label",
    "G1",
    "X1.5",
    "&a",
    "&b_2",
    "&5x",
    "$p",
    "%(1)",
    "%",
    "&",
    "$",
    "#",
    "#1",
    "1",
    "-2.5",
    ".5",
    "5.",
    "1e3",
    "7e",
    "\"text\"",
    "\"",
    "'",
    "(",
    ")",
    ",",
    ";",
    ":",
    ":=",
    "=",
    "==",
    "=>",
    "<>",
    "<",
    "+",
    "-",
    "*",
    "/",
    "\\",
    "^",
    " ",
    "  ",
    "\t",
    "\n",
    "\r\n",
    "\r",
    "é",
    "[&]",
    "[",
    "]",
    ".",
    "!",
    "\u{1a}",
];

pub(crate) fn lines() -> impl Strategy<Value = String> {
    prop::collection::vec(prop::sample::select(PIECES), 0..40).prop_map(|pieces| pieces.concat())
}

/// The same cases in every run; `PROPTEST_RNG_SEED` and `PROPTEST_CASES` ask for others and more.
pub(crate) fn config(cases: u32) -> ProptestConfig {
    let asked = ProptestConfig::default();
    let rng_seed = match asked.rng_seed {
        RngSeed::Random => RngSeed::Fixed(1995),
        seed => seed,
    };
    let cases = cases.max(asked.cases);
    ProptestConfig { cases, rng_seed, failure_persistence: None, ..asked }
}

/// Lines that begin like a statement, so that the rest of the pieces meets its reader.
pub(crate) fn statements() -> impl Strategy<Value = String> {
    (prop::sample::select(PIECES), lines()).prop_map(|(first, rest)| format!("{first} {rest}"))
}

/// The number of lines of a text, counted another way than the reader does.
fn line_count(text: &str) -> usize {
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    text.split('\n').count() - usize::from(text.ends_with('\n') || text.is_empty())
}

fn check_program(text: &str, program: &Program) {
    assert_eq!(program.lines.len(), line_count(text), "{text:?}");
    for (index, line) in program.lines.iter().enumerate() {
        let number = index as u32 + 1;
        let written = program.line_text(number);
        match line.node {
            Node::Statement(at) => check_spans(program, &program.statements[at as usize], written),
            Node::Bad => assert!(
                program.diagnostics.iter().any(|d| d.place.line == number),
                "no reason for {written:?}"
            ),
            Node::Move { command, given, first } => {
                assert!(first as usize + given.count_ones() as usize <= program.numbers.len());
                assert!(u32::from(command.count) >= 8 - given.leading_zeros());
            }
            Node::Label(at) => assert_eq!(program.labels[at as usize].line, number),
            Node::Blank | Node::Comment => {}
        }
    }
    check_diagnostics(program);
    for label in &program.labels {
        let first = program.label_names[label.name.0 as usize].line;
        assert!(first.is_some_and(|first| first <= label.line));
    }
}

fn check_diagnostics(program: &Program) {
    let mut before = 0;
    for d in &program.diagnostics {
        let length = program.line_text(d.place.line).chars().count() as u32;
        assert!(d.place.line >= before, "diagnostics out of order");
        assert!(d.place.column >= 1 && d.place.column - 1 + d.place.length <= length, "{d:?}");
        assert!(!d.message.is_empty());
        if d.is_error() {
            let node = program.lines[d.place.line as usize - 1].node;
            assert_eq!(node, Node::Bad, "{d:?}");
        }
        before = d.place.line;
    }
}

fn check_spans(program: &Program, statement: &Statement, line: &str) {
    let inside = |span: Span| {
        assert!(line.get(span.start as usize..span.end as usize).is_some(), "{span:?} {line:?}");
    };
    for statement in statement.with_inner() {
        statement.expressions(program, &mut |expr| {
            program.expressions.each(expr, &mut |e| inside(e.span));
        });
        if let Statement::Command { args, span, .. } = statement {
            inside(*span);
            let args = &program.args[*args];
            args.iter().for_each(|arg| inside(arg.span));
            assert!(args.last().is_none_or(|arg| arg.kind != ArgKind::Blank));
        }
        if let Some(target) = statement.target() {
            inside(target.span);
        }
    }
}

proptest! {
    #![proptest_config(config(2000))]

    #[test]
    fn any_bytes_are_read(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let program = read("p".into(), &bytes);
        if !bytes.contains(&0) {
            let text = program.text.clone();
            check_program(&text, &program);
        }
    }

    #[test]
    fn any_lines_are_read(text in lines()) {
        check_program(&text, &read("p".into(), text.as_bytes()));
    }

    #[test]
    fn any_statements_are_read(text in prop::collection::vec(statements(), 1..6)) {
        let text = text.join("\n");
        check_program(&text, &read("p".into(), text.as_bytes()));
    }

    #[test]
    fn any_lines_are_read_in_the_dialect_of_fabmo(
        text in prop::collection::vec(prop_oneof![lines(), statements()], 1..6),
    ) {
        let text = text.join("\n");
        check_program(&text, &crate::syntax::read_as("p".into(), text.as_bytes(), crate::syntax::Dialect::Fabmo));
    }

    /// The fast road and the careful one give the same values: a comment-free line of literals is
    /// the same as the line with its first value in parentheses.
    #[test]
    fn both_roads_lead_to_the_same_place(
        values in prop::collection::vec("[-+]?[0-9]{1,7}(\\.[0-9]{0,9})?|\\.[0-9]{1,5}", 3),
        blank in " {0,2}",
    ) {
        let line = |first: String| {
            format!("M3,{blank}{first},{blank}{},{blank}{}", values[1], values[2])
        };
        let fast = read("p".into(), line(values[0].clone()).as_bytes());
        let slow = read("p".into(), line(format!("({})", values[0])).as_bytes());
        let Node::Statement(0) = slow.lines[0].node else { panic!("{:?}", slow.diagnostics) };
        let mut numbers = Vec::new();
        slow.statements[0].expressions(&slow, &mut |e| {
            if let crate::syntax::ExprNode::Number(n) = e.node { numbers.push(n); }
        });
        let parsed: Vec<f64> = values.iter().map(|v| v.parse().expect("digits")).collect();
        prop_assert_eq!(&fast.numbers, &parsed);
        prop_assert_eq!(&numbers, &parsed);
    }

    #[test]
    fn numbers_are_those_of_the_standard_library(text in "[0-9]{1,12}(\\.[0-9]{0,12})?|\\.[0-9]{1,22}") {
        let program = read("p".into(), format!("MX,{text}").as_bytes());
        prop_assert_eq!(program.numbers.first().copied(), text.parse().ok(), "{}", text);
    }
}
