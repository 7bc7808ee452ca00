//! Files in another language: said once, not in every line.

use crate::syntax::tree::{Node, Program};
use kerf_diag::{Code, Diagnostic, SourcePlace};

/// Returns `true` for a line of Fanuc's macro language: a condition in brackets, a jump to a line's number.
pub fn looks_like_fanuc(line: &str) -> bool {
    let line: String = line.chars().filter(|c| !c.is_whitespace()).take(40).collect();
    let line = line.to_ascii_uppercase();
    let numbered = |word: &str| {
        let rest = line.strip_prefix(word).unwrap_or_default();
        rest.starts_with(|c: char| c.is_ascii_digit())
    };
    line.starts_with("IF[")
        || line.starts_with("WHILE[")
        || ["GOTO", "END", "DO"].into_iter().any(numbered)
}

/// Returns `true` if a line is OpenSBP and surely no G-code: a command with commas, a comment behind an
/// apostrophe, a variable, a statement.
pub fn looks_like_opensbp(line: &str) -> bool {
    let line = line.trim();
    if looks_like_fanuc(line) {
        return false;
    }
    let bytes = line.as_bytes();
    match bytes {
        [b'\'' | b'&', ..] => return true,
        [a, b, b',', ..] => return a.is_ascii_alphabetic() && b.is_ascii_alphanumeric(),
        _ => {}
    }
    let word: String =
        line.chars().take_while(|c| c.is_ascii_alphabetic()).collect::<String>().to_uppercase();
    matches!(
        word.as_str(),
        "IF" | "GOTO"
            | "GOSUB"
            | "RETURN"
            | "END"
            | "PAUSE"
            | "MSGBOX"
            | "INPUT"
            | "PRINT"
            | "SHELLX"
    ) || line.ends_with(':') && word.len() > 1
}

/// A file that is mostly something else gets one diagnostic instead of one a line.
pub(super) fn judge(program: &mut Program, foreign: usize) {
    let others = || program.lines.others().map(|(_, node)| node);
    let moves = program.lines.len() as usize - others().count();
    let code = moves + others().filter(|n| !matches!(n, Node::Blank | Node::Percent)).count();
    let bad = others().filter(|n| *n == Node::Bad).count();
    let other = other_language(&program.text);
    let sbp = foreign > 0 && foreign * 2 >= code;
    if !(sbp || other.is_some() && bad * 2 >= code) {
        return;
    }
    let line = program.diagnostics.first().map_or(1, |d| d.place.line);
    let (message, hint) = match other {
        Some(found) if !sbp => found,
        _ => ("this file is OpenSBP, not G-code", "give it the ending .sbp"),
    };
    let place = SourcePlace::line(program.name.clone(), line);
    program.diagnostics = vec![Diagnostic::new(Code::NotGcode, place, message).hint(hint)];
    if !sbp {
        // No line of it is meant for a machine.
        program.lines = Default::default();
    }
}

/// Names the language of a text by the way it begins, and what to do with it.
fn other_language(text: &str) -> Option<(&'static str, &'static str)> {
    const CONVERT: &str = "kerf convert makes a program of it";
    let head = text.trim_start();
    let begins = |mark: &str| head.get(..mark.len()).is_some_and(|h| h.eq_ignore_ascii_case(mark));
    let second = head.lines().nth(1).unwrap_or_default().trim();
    let is_second =
        |mark: &str| second.get(..mark.len()).is_some_and(|h| h.eq_ignore_ascii_case(mark));
    let first = head.lines().next().unwrap_or_default().trim();
    if first == "999" {
        let hint = "give it the ending it had: .rsg, .rsm or .dxf";
        return Some(("this file is a drawing (RSG, DXF) or a job (RSM), not G-code", hint));
    }
    if first == "0" && is_second("SECTION") {
        return Some(("this file is a DXF drawing, not G-code", CONVERT));
    }
    if ["IN;", "SP1;", "PU;", "PA;"].into_iter().any(begins) {
        return Some(("this file is a plot (HPGL), not G-code", CONVERT));
    }
    if ["<svg", "<?xml", "<!doctype", "<html"].into_iter().any(begins) {
        let hint = "kerf convert makes a program of an SVG drawing; give it the ending .svg";
        return Some(("this file is a web or SVG document, not G-code", hint));
    }
    if begins("solid") && is_second("facet") {
        let hint = "a CAM program makes a program from a solid";
        return Some(("this file is a solid (STL), not G-code", hint));
    }
    if begins("%PDF-") || begins("%!PS") {
        let hint = "export the drawing as DXF or SVG; kerf convert makes a program of it";
        return Some(("this file is a printed page (PDF, PostScript), not G-code", hint));
    }
    if head.starts_with(['{', '[']) {
        let hint = "was it saved by a program that keeps its projects so? export G-code there";
        return Some(("this file is data (JSON), not G-code", hint));
    }
    None
}
