//! Text to tree. Never fails: a bad line becomes [`Node::Bad`](crate::syntax::tree::Node::Bad) with diagnostics.
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
#[cfg(test)]
mod tests;

pub use foreign::looks_like_opensbp;

use crate::syntax::tree::Program;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use std::sync::Arc;

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
    let diagnostic = Diagnostic::new(Code::NotText, SourcePlace::line(name.clone(), line), message)
        .hint("save it as plain text, UTF-8 or Windows-1252");
    Program { name, diagnostics: vec![diagnostic], ..Program::default() }
}
