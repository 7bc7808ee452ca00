//! `kerf fmt`: the same program, tidy.
//!
//! The rules, few on purpose:
//!
//! - Commands and statements in capitals, a comma behind the command, no blanks around commas,
//!   trailing empty fields dropped: `m2  3, 4 ,` becomes `M2,3,4`.
//! - `=` and `:=` of an assignment, THEN and the statement behind it have one blank on each side.
//! - Labels stand at column 1; other lines keep their indentation.
//! - Names, labels, texts, expressions and numbers stay as written: `.5` stays `.5`.
//! - A comment keeps its distance, at least one blank; blanks at line ends go.
//! - Line ends, blank lines, what stands behind Ctrl-Z, G-code and lines that cannot be read stay as they are.
//!
//! Formatting twice gives what formatting once gives, and the program means what it meant.

mod statement;
#[cfg(test)]
pub(crate) mod tests;

use crate::syntax::reader::{END_OF_FILE, blank, code_end};
use crate::syntax::tree::{Node, Program};
use crate::syntax::{Dialect, read_as};

/// Formats a part file.
///
/// ```
/// assert_eq!(kerf_sbp::format("  mx, 1.50  'go\r\nif &a=1 then goto Done\r\n"),
///            "  MX,1.50  'go\r\nIF &a=1 THEN GOTO Done\r\n");
/// ```
pub fn format(text: &str) -> String {
    format_as(text, Dialect::Sb3)
}

/// Formats a part file written in a dialect.
pub fn format_as(text: &str, dialect: Dialect) -> String {
    match text.find(END_OF_FILE) {
        Some(end) => format_code(&text[..end], dialect) + &text[end..],
        None => format_code(text, dialect),
    }
}

fn format_code(text: &str, dialect: Dialect) -> String {
    let program = read_as("".into(), text.as_bytes(), dialect);
    if program.lines.is_empty() {
        return text.to_string();
    }
    let mut out = String::with_capacity(text.len() + 16);
    if text.starts_with('\u{feff}') {
        out.push('\u{feff}');
    }
    for (index, line) in program.lines.iter().enumerate() {
        let written = program.line_text(index as u32 + 1);
        push_line(&program, line.node, written, &mut out);
        let end = line.start as usize + written.len();
        let next = program.lines.get(index + 1).map_or(program.text.len(), |l| l.start as usize);
        let line_end = program.text.get(end..next).unwrap_or("");
        // An emptied line between CR and LF would make one line end of the two.
        if line_end.starts_with('\n') && out.ends_with('\r') {
            out.push(' ');
        }
        out.push_str(line_end);
    }
    out
}

fn push_line(program: &Program, node: Node, written: &str, out: &mut String) {
    match node {
        Node::Bad => return out.push_str(written),
        Node::Blank => return,
        Node::Comment => return out.push_str(trim_end(written)),
        _ => {}
    }
    let end = code_end(written.as_bytes());
    let start = written.len() - written.trim_start_matches(blank).len();
    let code = written.get(start..end).unwrap_or("");
    match node {
        Node::Label(_) => {
            out.push_str(trim_end(code.trim_end_matches(':')));
            out.push(':');
        }
        Node::Move { .. } => {
            out.push_str(&written[..start]);
            push_move(code, out);
        }
        Node::Statement(at) => {
            out.push_str(&written[..start]);
            if let Some(statement) = program.statements.get(at as usize) {
                statement::Code { program, line: written, start, end }.push(statement, out);
            }
        }
        Node::Blank | Node::Comment | Node::Bad => {}
    }
    push_comment(&written[end..], out);
}

/// A comment with the blanks before it.
fn push_comment(rest: &str, out: &mut String) {
    let rest = trim_end(rest);
    if rest.starts_with('\'') {
        out.push(' ');
    }
    out.push_str(rest);
}

/// A plain move: letters and literal values.
fn push_move(code: &str, out: &mut String) {
    let (letters, values) = code.split_at_checked(2).unwrap_or((code, ""));
    out.push_str(&letters.to_uppercase());
    let values = values.strip_prefix(',').unwrap_or(values);
    push_fields(values.split(',').map(|field| field.trim_matches(blank)), out);
}

/// Fields behind commas, trailing empty ones left out.
fn push_fields<'a>(fields: impl Iterator<Item = &'a str>, out: &mut String) {
    let mut full = out.len();
    for field in fields {
        out.push(',');
        out.push_str(field);
        if !field.is_empty() {
            full = out.len();
        }
    }
    out.truncate(full);
}

fn trim_end(text: &str) -> &str {
    text.trim_end_matches(blank)
}
