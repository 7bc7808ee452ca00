//! A line without its blanks and comments, in capitals: what the grammar speaks of.

use crate::syntax::gathered::Fault;
use crate::syntax::text::is_blank;
use crate::syntax::tree::{Comment, CommentKind, Span};
use kerf_diag::Code;

/// A line without blanks and comments.
#[derive(Debug, Default)]
pub(super) struct Compact {
    /// Bytes that are left, in capitals.
    pub(super) bytes: Vec<u8>,
    /// For each byte, where it stands in the line.
    places: Vec<u32>,
    /// The comments, in order.
    pub(super) comments: Vec<Comment>,
    /// Place where a number goes on behind blanks or a comment.
    pub(super) gap: Option<u32>,
    /// Place where a comment holds an opening parenthesis.
    pub(super) nested: Option<u32>,
    length: u32,
}

impl Compact {
    /// Takes a line apart.
    pub(super) fn take(&mut self, text: &str) -> Result<(), Fault> {
        self.bytes.clear();
        self.places.clear();
        self.comments.clear();
        (self.gap, self.nested) = (None, None);
        self.length = text.len() as u32;
        let bytes = text.as_bytes();
        let mut at = 0;
        while let Some(byte) = bytes.get(at).copied() {
            match byte {
                b'(' => {
                    at = self.comment(text, at)?;
                    continue;
                }
                b';' => {
                    self.tell(text[at + 1..].trim_end());
                    break;
                }
                _ if is_blank(byte) || byte == b'\r' => {}
                _ => self.keep(byte, at, bytes),
            }
            at += 1;
        }
        Ok(())
    }

    fn keep(&mut self, byte: u8, at: usize, bytes: &[u8]) {
        let in_number = |b: &u8| b.is_ascii_digit() || *b == b'.';
        let behind_gap = at.checked_sub(1).is_some_and(|i| is_blank(bytes[i]) || bytes[i] == b')');
        if behind_gap && in_number(&byte) && self.bytes.last().is_some_and(in_number) {
            self.gap.get_or_insert(at as u32);
        }
        self.bytes.push(byte.to_ascii_uppercase());
        self.places.push(at as u32);
    }

    /// A comment in parentheses; gives the place behind it.
    fn comment(&mut self, text: &str, start: usize) -> Result<usize, Fault> {
        let mut depth = 0;
        for (i, byte) in text.bytes().enumerate().skip(start) {
            depth += i32::from(byte == b'(') - i32::from(byte == b')');
            if byte == b'(' && depth > 1 {
                self.nested.get_or_insert(i as u32);
            }
            if depth == 0 {
                self.tell(&text[start + 1..i]);
                return Ok(i + 1);
            }
        }
        // With an opening parenthesis too many the first closing one ends it, as on controllers.
        if let Some(length) = text[start..].find(')') {
            self.tell(&text[start + 1..start + length]);
            return Ok(start + length + 1);
        }
        let span = Span { start: start as u32, end: text.len() as u32 };
        let message = "the comment is not closed";
        Err(Fault::new(Code::UnclosedComment, span, message).hint("put ) at its end"))
    }

    fn tell(&mut self, text: &str) {
        let (kind, text) = kind(text);
        self.comments.push(Comment { kind, text: text.into() });
    }

    /// The byte at a place.
    pub(super) fn byte(&self, at: usize) -> u8 {
        self.bytes.get(at).copied().unwrap_or(0)
    }

    /// The place in the line of a stretch of what is left.
    pub(super) fn span(&self, from: usize, to: usize) -> Span {
        let place = |i: usize| self.places.get(i).copied();
        let start = place(from).unwrap_or_else(|| self.places.last().map_or(0, |last| last + 1));
        let end = to.checked_sub(1).and_then(place).map_or(start, |p| p + 1);
        Span { start, end: end.max(start) }
    }

    /// The whole code of the line.
    pub(super) fn whole(&self) -> Span {
        self.span(0, self.bytes.len())
    }
}

/// Returns the request that a comment makes, and its text.
fn kind(text: &str) -> (CommentKind, &str) {
    let Some((word, rest)) = text.split_once(',') else { return (CommentKind::Plain, text.trim()) };
    let word: String = word.chars().filter(|c| !c.is_whitespace()).collect();
    let kind = match word.to_ascii_uppercase().as_str() {
        "MSG" => CommentKind::Msg,
        "PRINT" => CommentKind::Print,
        "DEBUG" => CommentKind::Debug,
        "ABORT" => CommentKind::Abort,
        "LOG" | "LOGOPEN" | "LOGAPPEND" | "LOGCLOSE" | "PROBEOPEN" | "PROBECLOSE" => {
            CommentKind::Log
        }
        _ => return (CommentKind::Plain, text.trim()),
    };
    (kind, if kind == CommentKind::Log { text } else { rest })
}
