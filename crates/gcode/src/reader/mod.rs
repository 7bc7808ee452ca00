//! Text to tree. Never fails: a bad line becomes [`Node::Bad`](crate::tree::Node::Bad) with diagnostics.
//!
//! ```text
//!  bytes ── decode ──► text ──► a line at a time
//!                                 │ moves::read      plain moves, one pass over the bytes
//!                                 └ compact::Compact  blanks and comments out
//!                                     block        words, settings of parameters
//!                                     expression   precedence climbing
//!                                     flow         O-words
//!                               then link: which O-word belongs to which
//! ```

mod block;
mod compact;
mod ends;
mod expression;
mod file;
mod flow;
mod foreign;
mod link;
pub(crate) mod moves;
#[cfg(test)]
mod tests;

pub(crate) use file::{after_line_end, next_line};
pub use foreign::looks_like_opensbp;

use crate::Program;
use kerf_diag::{Code, Diagnostic, Place};
use std::sync::Arc;

/// Longer lines are refused; no person and no program writes them.
const MOST_LINE_BYTES: usize = 100_000;

/// Diagnostics that are kept; a file that is no program would give millions.
const MOST_DIAGNOSTICS: usize = 10_000;

/// Reads a G-code file, whatever its dialect.
///
/// Every line becomes one node; what is wrong or doubtful stands in [`Program::diagnostics`].
pub fn read(name: Arc<str>, bytes: &[u8]) -> Program {
    match kerf_diag::decode(bytes.into()) {
        Ok(text) => read_text(name, Arc::new(text)),
        Err(line) => refused(name, line, "not a text file"),
    }
}

/// Reads a text that is kept elsewhere too, without a copy of it.
pub fn read_text(name: Arc<str>, text: Arc<String>) -> Program {
    if text.len() >= u32::MAX as usize {
        return refused(name, 1, "the file is larger than 4 GB");
    }
    let mut file = file::File::new(name);
    file.read(&text);
    file.finish(text)
}

/// A program without lines that only says why.
fn refused(name: Arc<str>, line: u32, message: &str) -> Program {
    let diagnostic = Diagnostic::new(Code::NotText, Place::line(name.clone(), line), message)
        .hint("save it as plain text, UTF-8 or Windows-1252");
    Program { name, diagnostics: vec![diagnostic], ..Program::default() }
}

/// True for what separates words: blanks, tabs and the control characters old editors left behind.
pub(crate) const fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0B | 0x0C | 0x1A)
}
