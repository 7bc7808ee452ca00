//! `kerf fmt`: the same program, tidy.
//!
//! The rules, few on purpose:
//!
//! - Commands and statements in capitals, a comma behind the command, no blanks around commas,
//!   trailing empty fields dropped: `m2  3, 4 ,` becomes `M2,3,4`.
//! - `=` and `:=` of an assignment, THEN and the statement behind it have one blank on each side.
//! - Labels stand at column 1; other lines keep their indentation.
//! - Names, labels, texts, expressions and numbers stay as written: `.5` stays `.5`.
//! - Comments that stand one below the other keep one column; a comment alone keeps its distance, at least one blank.
//! - Blanks at line ends go.
//! - Line ends, blank lines, what stands behind Ctrl-Z, G-code and lines that cannot be read stay as they are.
//!
//! Formatting twice gives what formatting once gives, and the program means what it meant.

mod comments;
mod statement;
#[cfg(test)]
pub(crate) mod tests;

use self::comments::Line;
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
    let numbered = (1..).zip(&program.lines);
    let lines: Vec<Line<'_>> = numbered.map(|(n, line)| tidy(&program, line.node, n)).collect();
    for (index, (line, column)) in lines.iter().zip(comments::columns(&lines)).enumerate() {
        line.push(column, &mut out);
        let line_end = line_end(&program, index);
        // An emptied line between CR and LF would make one line end of the two.
        if line_end.starts_with('\n') && out.ends_with('\r') {
            out.push(' ');
        }
        out.push_str(line_end);
    }
    out
}

/// The characters that end a line, by its index.
fn line_end(program: &Program, index: usize) -> &str {
    let start = program.lines.get(index).map_or(0, |line| line.start as usize);
    let end = start + program.line_text(index as u32 + 1).len();
    let next = program.lines.get(index + 1).map_or(program.text.len(), |l| l.start as usize);
    program.text.get(end..next).unwrap_or("")
}

/// A line with its code tidy, by its number from 1.
fn tidy(program: &Program, node: Node, number: u32) -> Line<'_> {
    let written = program.line_text(number);
    match node {
        Node::Bad => return Line::plain(written),
        Node::Blank => return Line::plain(""),
        Node::Comment => return Line::plain(trim_end(written)),
        _ => {}
    }
    let end = code_end(written.as_bytes());
    let start = written.len() - written.trim_start_matches(blank).len();
    let code = written.get(start..end).unwrap_or("");
    let mut out = String::with_capacity(written.len() + 8);
    match node {
        Node::Label(_) => {
            out.push_str(trim_end(code.trim_end_matches(':')));
            out.push(':');
        }
        Node::Move { .. } => {
            out.push_str(&written[..start]);
            push_move(code, &mut out);
        }
        Node::Statement(at) => {
            out.push_str(&written[..start]);
            if let Some(statement) = program.statements.get(at as usize) {
                statement::Code { program, line: written, start, end }.push(statement, &mut out);
            }
        }
        Node::Blank | Node::Comment | Node::Bad => {}
    }
    Line::new(out, written, end)
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
