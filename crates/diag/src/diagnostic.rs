//! The diagnostic itself and the place it points to.

use crate::Code;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::sync::Arc;

/// Severity of a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// The program cannot run, or cannot go on.
    Error,
    /// It runs, but a person should look.
    Warning,
    /// Worth knowing.
    Note,
}

/// A stretch of one line of a file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct SourcePlace {
    /// Name of the file as the user gave it.
    pub file: Arc<str>,
    /// Line, counted from 1.
    pub line: u32,
    /// Column in characters, counted from 1.
    pub column: u32,
    /// Length in characters; 0 points between two characters.
    pub length: u32,
}

impl SourcePlace {
    /// The start of a line.
    pub fn line(file: Arc<str>, line: u32) -> Self {
        Self { file, line, column: 1, length: 0 }
    }

    /// The stretch of a line that some bytes of its text cover; a character of which only a part is covered counts.
    pub fn of_bytes(file: Arc<str>, line: u32, text: &str, bytes: Range<u32>) -> Self {
        let (start, end) = (bytes.start as usize, bytes.end as usize);
        let chars = || text.char_indices().map(|(first, c)| first..first + c.len_utf8());
        let before = chars().filter(|c| c.end <= start).count() as u32;
        let covered = chars().filter(|c| c.end > start && c.start < end).count() as u32;
        Self { file, line, column: before + 1, length: covered }
    }
}

/// One thing a person should know about a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Diagnostic {
    /// Severity.
    pub severity: Severity,
    /// Stable code, explained by `kerf explain`.
    pub code: Code,
    /// Place of the mistake.
    #[serde(flatten)]
    pub place: SourcePlace,
    /// The mistake in one sentence.
    pub message: String,
    /// Way to mend it; empty when nothing useful can be said.
    pub hint: String,
    /// The files that led here, innermost caller first (`B.sbp` called from `A.sbp` line 5).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub callers: Vec<SourcePlace>,
}

impl Diagnostic {
    /// A diagnostic with the severity that its code usually has and no hint.
    pub fn new(code: Code, place: SourcePlace, message: impl Into<String>) -> Self {
        Self {
            severity: code.severity(),
            code,
            place,
            message: message.into(),
            hint: String::new(),
            callers: Vec::new(),
        }
    }

    /// The same with a hint.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = hint.into();
        self
    }

    /// The same with another severity.
    #[must_use]
    pub fn severity(mut self, severity: Severity) -> Self {
        self.severity = severity;
        self
    }

    /// True for an error.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretch_of_bytes_is_told_in_characters() {
        let check = |text: &str, bytes, expected: (u32, u32)| {
            let place = SourcePlace::of_bytes("part".into(), 3, text, bytes);
            assert_eq!((place.column, place.length), expected, "{text}");
        };
        check("MX,5 'weit", 3..4, (4, 1));
        check("'für MX", 6..8, (6, 2));
        check("'für MX", 3..4, (3, 1));
        check("MX", 1..90, (2, 1));
    }
}
