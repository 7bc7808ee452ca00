//! One line while it is read: a cursor over its code, and a place to complain to.

use super::file::File;
use super::text::{code_end, is_blank};
use crate::syntax::tree::{NameId, Span};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};

/// Says that a part of the line could not be read and that a diagnostic tells why.
#[derive(Clone, Copy, Debug)]
pub(super) struct Failed;

/// Result of reading a part of a line.
pub(super) type Read<T> = Result<T, Failed>;

/// More diagnostics than this are not kept for one line.
const MOST_PER_LINE: usize = 20;

/// A line while it is read.
#[derive(Debug)]
pub(super) struct Line<'f, 't> {
    pub(super) file: &'f mut File,
    /// The line without its line end.
    pub(super) text: &'t str,
    /// Place of reading, in bytes.
    pub(super) at: usize,
    /// End of the code; narrowed while a single value is read.
    pub(super) end: usize,
    /// Its number, from 1.
    pub(super) number: u32,
    /// Diagnostics before this line.
    before: usize,
    /// Operators that the present expression may still have.
    pub(super) operators_left: u32,
    /// Depth to which parentheses may still be nested.
    pub(super) depth_left: u32,
    /// The present expression has bare words in it.
    pub(super) words: bool,
    /// Arrays or objects of another dialect were met: no attempt to read it otherwise.
    pub(super) foreign: bool,
    /// A second command was found on the line; the rest is its own.
    pub(super) second_command: bool,
}

impl<'f, 't> Line<'f, 't> {
    pub(super) fn new(file: &'f mut File, text: &'t str, number: u32) -> Self {
        let before = file.program.diagnostics.len();
        let end = code_end(text.as_bytes());
        Self {
            file,
            text,
            at: 0,
            end,
            number,
            before,
            operators_left: 0,
            depth_left: 0,
            words: false,
            foreign: false,
            second_command: false,
        }
    }

    /// The next byte of code; 0 at its end.
    pub(super) fn peek(&self) -> u8 {
        self.byte(self.at)
    }

    /// The byte of code at a place; 0 past the end.
    pub(super) fn byte(&self, at: usize) -> u8 {
        let code = &self.text.as_bytes()[..self.end.min(self.text.len())];
        code.get(at).copied().unwrap_or(0)
    }

    pub(super) fn at_end(&self) -> bool {
        self.at >= self.end
    }

    pub(super) fn skip_blanks(&mut self) {
        while is_blank(self.peek()) {
            self.at += 1;
        }
    }

    /// Skips blanks and then one byte if it is this one.
    pub(super) fn take(&mut self, byte: u8) -> bool {
        self.skip_blanks();
        let found = self.peek() == byte && !self.at_end();
        self.at += usize::from(found);
        found
    }

    /// Text between two places of the line.
    pub(super) fn slice(&self, start: usize, end: usize) -> &'t str {
        self.text.get(start..end).unwrap_or("")
    }

    /// The code from here on, without blanks around it.
    pub(super) fn rest(&mut self) -> &'t str {
        self.skip_blanks();
        self.slice(self.at, self.end)
    }

    /// From a place to here, trailing blanks left out.
    pub(super) fn span_from(&self, start: usize) -> Span {
        let mut end = self.at.min(self.end);
        while end > start && is_blank(self.text.as_bytes()[end - 1]) {
            end -= 1;
        }
        Span { start: start as u32, end: end as u32 }
    }

    /// From here to the end of the code.
    pub(super) fn span_to_end(&mut self) -> Span {
        self.skip_blanks();
        Span { start: self.at as u32, end: self.end as u32 }
    }

    /// Returns the end of the word at `from`: letters, digits, underscores.
    pub(super) fn word_end(&self, from: usize) -> usize {
        let mut at = from;
        while is_name(self.byte(at)) {
            at += 1;
        }
        at
    }

    /// Returns `true` if a word ends at a place as a command does: with a comma, a blank or the code.
    pub(super) fn separated(&self, at: usize) -> bool {
        at >= self.end || self.byte(at) == b',' || is_blank(self.byte(at))
    }

    /// Takes a word if it stands here, in any case.
    pub(super) fn take_word(&mut self, word: &str) -> bool {
        self.skip_blanks();
        let end = self.word_end(self.at);
        let found = self.slice(self.at, end).eq_ignore_ascii_case(word);
        if found {
            self.at = end;
        }
        found
    }

    /// Reads a part of the line as if the code ended there, and comes back.
    pub(super) fn within<T>(&mut self, span: Span, read: impl FnOnce(&mut Self) -> T) -> T {
        let (at, end) = (self.at, self.end);
        self.at = span.start as usize;
        self.end = (span.end as usize).min(end);
        let result = read(self);
        self.at = at;
        self.end = end;
        result
    }

    /// Returns the end of the field at the cursor: at a comma outside quotes, or with the code.
    pub(super) fn field_end(&self, from: usize) -> usize {
        self.until(from, b',')
    }

    /// The next place of a byte outside quotes, or the end of the code.
    pub(super) fn until(&self, from: usize, byte: u8) -> usize {
        self.until_within(from, self.end, byte)
    }

    /// The next place of a byte outside quotes before `end`, or `end`.
    pub(super) fn until_within(&self, from: usize, end: usize, byte: u8) -> usize {
        let bytes = &self.text.as_bytes()[..end];
        let mut at = from;
        while let Some(found) = memchr::memchr2(byte, b'"', bytes.get(at..).unwrap_or(&[])) {
            at += found;
            if bytes[at] == byte {
                return at;
            }
            match memchr::memchr(b'"', &bytes[at + 1..]) {
                Some(length) => at += length + 2,
                None => break,
            }
        }
        end
    }

    /// The field at the cursor without blanks around it; the cursor goes to its end.
    pub(super) fn field(&mut self) -> Span {
        self.skip_blanks();
        let start = self.at;
        self.at = self.field_end(start);
        let span = self.span_from(start);
        Span { start: span.start.min(span.end), end: span.end }
    }

    /// The number of a variable's name.
    pub(super) fn name(&mut self, start: usize, end: usize) -> NameId {
        let text = self.slice(start, end);
        self.file.name_id(text)
    }

    /// Diagnostics of this line so far; [`Self::forget`] goes back to it.
    pub(super) fn mark(&self) -> usize {
        self.file.program.diagnostics.len()
    }

    /// Drops diagnostics of an attempt that did not count.
    pub(super) fn forget(&mut self, mark: usize) {
        self.file.program.diagnostics.truncate(mark);
    }

    /// An error of this line.
    pub(super) fn fault(
        &mut self,
        code: Code,
        span: Span,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) -> Failed {
        self.tell(code, span, message.into(), hint.into(), None);
        Failed
    }

    /// A warning of this line.
    pub(super) fn warn(
        &mut self,
        code: Code,
        span: Span,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) {
        self.tell(code, span, message.into(), hint.into(), Some(Severity::Warning));
    }

    fn tell(
        &mut self,
        code: Code,
        span: Span,
        message: String,
        hint: String,
        severity: Option<Severity>,
    ) {
        if self.file.program.diagnostics.len() - self.before >= MOST_PER_LINE {
            return;
        }
        let chars = |text: &str| text.chars().count() as u32;
        let (start, end) = (span.start as usize, span.end.max(span.start) as usize);
        let place = SourcePlace {
            file: self.file.program.name.clone(),
            line: self.number,
            column: chars(self.slice(0, start)) + 1,
            length: chars(self.slice(start, end)),
        };
        let mut diagnostic = Diagnostic::new(code, place, message).hint(hint);
        if let Some(severity) = severity {
            diagnostic = diagnostic.severity(severity);
        }
        self.file.program.diagnostics.push(diagnostic);
    }
}

/// True for what names are made of; bytes of letters beyond ASCII count.
pub(super) const fn is_name(byte: u8) -> bool {
    NAMES[byte as usize]
}

/// [`is_name`] of each byte: asked for nearly every byte of a file.
static NAMES: [bool; 256] = {
    let mut names = [false; 256];
    let mut byte = 0;
    while byte < 256 {
        let sign = byte as u8;
        names[byte] = sign.is_ascii_alphanumeric() || sign == b'_' || sign >= 0x80;
        byte += 1;
    }
    names
};
