//! The end of a statement, and what begins another.

use super::keywords::Keyword;
use super::line::{Line, Read, is_name};
use kerf_diag::Code;

/// Behind a value: nothing may follow. Says what is wrong when something does.
pub(super) fn expect_end(l: &mut Line<'_, '_>) -> Read<()> {
    l.skip_blanks();
    if l.at_end() {
        return Ok(());
    }
    let span = l.span_to_end();
    if is_command(l, l.at) || (is_name(l.peek()) && is_statement(l)) {
        l.second_command = true;
        let hint = "put it on a line of its own";
        return Err(l.fault(Code::OneCommandPerLine, span, "a second command", hint));
    }
    let found = l.slice(span.start as usize, span.end as usize);
    let shown: String = found.chars().take(20).collect();
    let hint = match found.as_bytes().first() {
        Some(b'0'..=b'9' | b'.' | b'&' | b'%' | b'-') => "values are separated by commas",
        Some(b';' | b'#' | b'/' | b'(') => "a comment begins with an apostrophe",
        _ if found.get(..4).is_some_and(|word| word.eq_ignore_ascii_case("ELSE")) => {
            "there is no ELSE: write another IF for the other case, or GOTO past it"
        }
        _ => "",
    };
    Err(l.fault(Code::Syntax, span, format!("'{shown}' does not belong here"), hint))
}

/// Skips empty fields at the end of the code.
pub(super) fn trailing_commas(l: &mut Line<'_, '_>) {
    let start = l.at;
    while l.take(b',') {}
    l.skip_blanks();
    if !l.at_end() {
        l.at = start;
    }
}

/// Returns `true` if the code at the cursor begins with a command and its separator.
pub(super) fn is_command(l: &Line<'_, '_>, at: usize) -> bool {
    let end = l.word_end(at);
    l.separated(end) && l.file.commands.find(l.slice(at, end)).is_some()
}

/// Returns `true` if the words at the cursor begin a statement or a command.
pub(super) fn is_statement(l: &Line<'_, '_>) -> bool {
    let word = l.slice(l.at, l.word_end(l.at));
    Keyword::find(word).is_some() || l.file.commands.find(word).is_some()
}
