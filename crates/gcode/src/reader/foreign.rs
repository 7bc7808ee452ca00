//! Files in another language: said once, not in every line.

use crate::tree::{Node, Program};
use kerf_diag::{Code, Diagnostic, Place};

/// Whether a line is OpenSBP and surely no G-code: a command with commas, a comment behind an
/// apostrophe, a variable, a statement.
pub fn looks_like_opensbp(line: &str) -> bool {
    let line = line.trim();
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
    let code = program.lines.iter().filter(|l| l.node() != Node::Blank).count();
    let bad = program.lines.iter().filter(|l| l.node() == Node::Bad).count();
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
    let place = Place::line(program.name.clone(), line);
    program.diagnostics = vec![Diagnostic::new(Code::NotGcode, place, message).hint(hint)];
}

/// What a text is by the way it begins.
fn other_language(text: &str) -> Option<(&'static str, &'static str)> {
    let head = text.trim_start();
    let begins = |mark: &str| head.get(..mark.len()).is_some_and(|h| h.eq_ignore_ascii_case(mark));
    let dxf = head.lines().next().is_some_and(|l| l.trim() == "0")
        && head.lines().nth(1).is_some_and(|l| l.trim().eq_ignore_ascii_case("SECTION"));
    if dxf {
        return Some((
            "this file is a DXF drawing, not G-code",
            "kerf convert makes a program of it",
        ));
    }
    if begins("IN;") || begins("SP1;") || begins("PU;") || begins("PA;") {
        return Some((
            "this file is a plot (HPGL), not G-code",
            "kerf convert makes a program of it",
        ));
    }
    if begins("<svg") || begins("<?xml") || begins("<!doctype") {
        return Some(("this file is a web or SVG document, not G-code", ""));
    }
    None
}
