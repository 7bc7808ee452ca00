//! `kerf fmt`: the same program, tidy.
//!
//! The rules, few on purpose:
//!
//! - Letters of words in capitals, nothing between a letter and its value, one blank between words:
//!   `g1x 10y[#1eq2]` becomes `G1 X10 Y[#1 EQ 2]`.
//! - O-words as `O100 sub`, their keyword in small letters; settings as `#1 = 5`.
//! - Numbers, names and comments stay as written: `G01 X.5` stays so.
//! - Lines keep their indentation; a comment at the end keeps its distance, at least one blank;
//!   blanks at line ends go.
//! - Line ends, blank lines, `$` lines, doubtful lines (a number with a gap, a comment within a
//!   word) and lines that cannot be read stay as they are.
//!
//! Formatting twice gives what formatting once gives, and the program means what it meant.

mod line;
#[cfg(test)]
mod tests;
mod value;

use crate::syntax::reader::read;
use crate::syntax::text::{is_blank, next_line};
use crate::syntax::tree::{Node, Program};

/// Formats G-code.
///
/// ```
/// assert_eq!(kerf_gcode::format("  g1x 10 y-5;go\r\no1call[ 2 ]\r\n"),
///            "  G1 X10 Y-5 ;go\r\nO1 call [2]\r\n");
/// ```
pub fn format(text: &str) -> String {
    let program = read("".into(), text.as_bytes());
    if program.line_count() == 0 {
        return text.to_string();
    }
    let mut out = String::with_capacity(text.len() + text.len() / 8);
    if text.starts_with('\u{feff}') {
        out.push('\u{feff}');
    }
    for line in program.lines.iter(&program.text) {
        let start = line.start as usize;
        let next = next_line(program.text.as_bytes(), start);
        let whole = program.text.get(start..next).unwrap_or_default();
        let written = whole.trim_end_matches(['\r', '\n']);
        push_line(&program, line.node(), written, &mut out);
        push_line_end(&whole[written.len()..], &mut out);
    }
    out
}

fn push_line(program: &Program, node: Node, written: &str, out: &mut String) {
    match node {
        Node::Bad | Node::Console => out.push_str(written),
        Node::Blank => {}
        Node::Percent => out.push_str(trim_end(written)),
        Node::Move => line::Pieces::of_move(written).push(written, out),
        Node::Block(at) => match program.blocks.get(at as usize) {
            Some(block) => line::Pieces::of_block(program, block).push(written, out),
            None => out.push_str(written),
        },
    }
}

/// An emptied line between CR and LF would make one line end of the two.
fn push_line_end(line_end: &str, out: &mut String) {
    if line_end.starts_with('\n') && out.ends_with('\r') {
        out.push(' ');
    }
    out.push_str(line_end);
}

fn blank(c: char) -> bool {
    u8::try_from(c).is_ok_and(is_blank)
}

fn trim_end(text: &str) -> &str {
    text.trim_end_matches(blank)
}
