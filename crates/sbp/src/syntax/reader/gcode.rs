//! Lines of G-code between OpenSBP lines.

use super::line::{Failed, Line};
use super::moves::number;
use super::text::is_blank;
use crate::syntax::tree::Statement;
use kerf_diag::Code;

/// The rest of the line as G-code.
pub(super) fn gcode(l: &mut Line<'_, '_>) -> Statement {
    let text = l.rest();
    l.at = l.end;
    Statement::Gcode(text.into())
}

/// True when the code consists of G-code words: a letter and a number each.
pub(super) fn is_gcode(l: &Line<'_, '_>, start: usize) -> bool {
    gcode_words(l, start) > 0
}

/// `M3 S12000`: a command of a letter and a digit with another word behind it is G-code.
pub(super) fn is_gcode_words(l: &Line<'_, '_>, start: usize, word: &str) -> bool {
    let numbered = word.as_bytes().get(1).is_some_and(u8::is_ascii_digit);
    numbered && gcode_words(l, start) > 1
}

/// Counts the G-code words that the code consists of; 0 when it is something else.
pub(super) fn gcode_words(l: &Line<'_, '_>, start: usize) -> usize {
    const LETTERS: &[u8] = b"NGMXYZABCFSTIJKRPQLHDUVWE";
    let bytes = &l.text.as_bytes()[..l.end];
    let (mut at, mut words) = (start, 0);
    while at < bytes.len() {
        if is_blank(bytes[at]) {
            at += 1;
            continue;
        }
        if matches!(bytes[at], b'(' | b';') {
            break;
        }
        let letter = bytes[at].to_ascii_uppercase();
        at += 1;
        while at < bytes.len() && is_blank(bytes[at]) {
            at += 1;
        }
        at += usize::from(matches!(bytes.get(at), Some(b'-' | b'+')));
        let valued = number(bytes, &mut at).is_some() || computed(bytes, &mut at);
        if !valued || !LETTERS.contains(&letter) {
            return 0;
        }
        words += 1;
    }
    // A line begins with the words that row SBP-GCODE-MIX lists.
    let first = l.byte(start).to_ascii_uppercase();
    if words > 0 && !b"NGMXYZABCFST".contains(&first) { 0 } else { words }
}

/// True for `#… = …`, which sets a parameter of G-code.
pub(super) fn is_gcode_setting(l: &Line<'_, '_>, start: usize) -> bool {
    let bytes = &l.text.as_bytes()[..l.end];
    let mut at = start;
    computed(bytes, &mut at) && bytes[at..].trim_ascii_start().starts_with(b"=")
}

/// Reports what is wrong with an O-word: it needs the lines around it.
pub(super) fn o_word(l: &mut Line<'_, '_>, start: usize) -> Option<Failed> {
    let rest = l.text.as_bytes().get(start..l.end)?;
    if !matches!(rest, [b'O' | b'o', b'0'..=b'9' | b'<' | b'[' | b'#', ..]) {
        return None;
    }
    let message = "O-words do not run between lines of OpenSBP";
    let hint = "put the G-code into a file of its own (.nc) and run that with FP";
    l.at = l.end;
    let span = l.span_from(start);
    Some(l.fault(Code::UnknownStatement, span, message, hint))
}

/// Goes behind a value of G-code that is computed: a parameter, or an expression in brackets.
fn computed(bytes: &[u8], at: &mut usize) -> bool {
    let start = *at;
    while bytes.get(*at) == Some(&b'#') {
        *at += 1;
    }
    match bytes.get(*at) {
        Some(b'[') => enclosed(bytes, at, b'[', b']'),
        Some(b'<') if *at > start => enclosed(bytes, at, b'<', b'>'),
        _ => *at > start && number(bytes, at).is_some(),
    }
}

/// Goes behind a bracket and what it encloses.
fn enclosed(bytes: &[u8], at: &mut usize, open: u8, close: u8) -> bool {
    let mut depth = 0;
    while let Some(byte) = bytes.get(*at).copied() {
        *at += 1;
        depth += i32::from(byte == open) - i32::from(byte == close);
        if depth == 0 {
            return true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use crate::syntax::read;
    use crate::syntax::tree::{Node, Statement};

    fn is_gcode(line: &str) -> bool {
        let program = read("a.sbp".into(), line.as_bytes());
        let statement = match program.lines[0].node {
            Node::Statement(at) => program.statements.get(at as usize),
            _ => None,
        };
        matches!(statement, Some(Statement::Gcode(_)))
    }

    #[test]
    fn g_code_between_the_lines_may_compute() {
        for line in ["G1 X#1", "#1=5", "#<_a b> = [1+2]", "G1 X[2+[3]] F50", "M3 S#2", "G1X##<a>Y1"]
        {
            assert!(is_gcode(line), "{line}");
        }
        for line in ["MX,#1", "G1 X#", "#1", "# = 5", "G1 X[2", "M2,[1]"] {
            assert!(!is_gcode(line), "{line}");
        }
    }

    #[test]
    fn o_words_need_a_file_of_their_own() {
        for line in ["O100 call", "o<name> if [1]", "O[1] call"] {
            let program = read("a.sbp".into(), line.as_bytes());
            let found: Vec<&str> = program.diagnostics.iter().map(|d| d.message.as_str()).collect();
            assert_eq!(found, ["O-words do not run between lines of OpenSBP"], "{line}");
        }
    }
}
