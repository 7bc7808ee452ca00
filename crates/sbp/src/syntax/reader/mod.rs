//! Text to tree. Never fails: a bad line becomes [`Node::Bad`](crate::syntax::tree::Node::Bad) with diagnostics.
//!
//! ```text
//!  bytes ── text::decode ──► text ──► a line at a time
//!                                       │ moves::read        plain moves, one pass over the bytes
//!                                       └ lines::read        everything else
//!                                           lines       comments, labels
//!                                           statements  which statement is it
//!                                           commands    two letters and their values, by the table
//!                                           assign flow output dialog files   one family each
//!                                           expression  precedence climbing
//! ```

mod assign;
mod commands;
mod dialog;
mod ends;
mod expression;
mod fabmo;
mod file;
mod files;
mod flow;
mod gcode;
mod index;
mod keywords;
mod labels;
mod language;
mod line;
mod lines;
mod members;
mod moves;
mod names;
mod output;
#[cfg(test)]
pub(crate) mod properties;
#[cfg(test)]
pub(crate) mod shown;
mod statements;
mod text;

pub(crate) use kerf_diag::did_you_mean;
pub use keywords::statement_words;
pub(crate) use language::read_language;
pub use language::{
    GCODE_ENDINGS, PART_ENDINGS, is_gcode_name, is_part_name, read_part, read_part_as,
};
pub(crate) use lines::END_OF_FILE;
pub(crate) use text::{blank, code_end};

use crate::syntax::{Dialect, Program};
use kerf_diag::{Code, Diagnostic, SourcePlace};
use std::borrow::Cow;
use std::sync::Arc;

/// Reads a part file.
///
/// Every line becomes one node; what is wrong or doubtful stands in [`Program::diagnostics`].
/// Bytes that are given away (a `Vec`) become the program's text without a copy.
pub fn read<'a>(name: Arc<str>, bytes: impl Into<Cow<'a, [u8]>>) -> Program {
    read_bytes(name, bytes.into(), Dialect::Sb3)
}

/// Reads a part file written in a dialect.
pub fn read_as<'a>(name: Arc<str>, bytes: impl Into<Cow<'a, [u8]>>, dialect: Dialect) -> Program {
    read_bytes(name, bytes.into(), dialect)
}

fn read_bytes(name: Arc<str>, bytes: Cow<'_, [u8]>, dialect: Dialect) -> Program {
    let text = match kerf_diag::decode(bytes) {
        Ok(text) if text.len() < u32::MAX as usize => text,
        Ok(_) => return refused(name, 1, "the file is larger than 4 GB"),
        Err(line) => return refused(name, line, "not a text file"),
    };
    let mut file = file::File::new(name, dialect);
    lines::read_all(&mut file, &text);
    file.finish(text)
}

/// A program without lines that only says why.
fn refused(name: Arc<str>, line: u32, message: &str) -> Program {
    let diagnostic = Diagnostic::new(Code::NotText, SourcePlace::line(name.clone(), line), message)
        .hint("save it as plain text, UTF-8 or Windows-1252");
    Program { name, diagnostics: vec![diagnostic], ..Program::default() }
}
