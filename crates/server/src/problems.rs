//! The problem log: what went wrong, kept in the data folder for whoever is asked for help (HN).

use crate::to_wire;
use kerf_journal::Started;
use kerf_wire::{Call, Change, Message, Tone};
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::PathBuf;

/// Its name in the data folder.
pub const FILE: &str = "problem.log";
/// Size of what is kept of it when the server starts, bytes.
const KEPT: usize = 64 * 1024;

/// Writes it. Without a clock nothing is written: then nothing else is on record either.
#[derive(Debug)]
pub struct ProblemLog {
    path: PathBuf,
    now: fn() -> Option<Started>,
}

impl ProblemLog {
    /// That of a data folder; what is too old is left out.
    pub fn begin(data: &std::path::Path, now: fn() -> Option<Started>) -> Self {
        let path = data.join(FILE);
        let text = fs::read(&path).unwrap_or_default();
        if text.len() > KEPT {
            let last = &text[text.len() - KEPT..];
            let begin = last.iter().position(|byte| *byte == b'\n').map_or(0, |at| at + 1);
            // A log that cannot be shortened only grows.
            drop(fs::write(&path, &last[begin..]));
        }
        Self { path, now }
    }

    /// Notes the warnings and errors among changes that pages are told.
    pub fn note(&self, changes: &[Change]) {
        let lines: String = changes.iter().map(|change| self.lines(change)).collect();
        // Where the disk refuses, pages have been told all the same.
        drop(self.append(&lines));
    }

    fn lines(&self, change: &Change) -> String {
        let Change::Messages { messages } = change else { return String::new() };
        let wrong = messages.iter().filter(|m| matches!(m.tone, Tone::Warning | Tone::Error));
        let line = |message: &Message| {
            let Started { date, time } = (self.now)()?;
            let tone = if message.tone == Tone::Error { "error" } else { "warning" };
            let Message { text, hint, place, .. } = message;
            let place = place.as_ref().map(|Call { file, line }| format!("{file}, line {line}: "));
            let words = place.unwrap_or_default() + &to_wire::with_hint(text, hint);
            Some(format!("{date} {time} {tone}: {}\n", words.replace('\n', " ")))
        };
        wrong.filter_map(line).collect()
    }

    fn append(&self, lines: &str) -> io::Result<()> {
        if lines.is_empty() {
            return Ok(());
        }
        let mut file = OpenOptions::new().append(true).create(true).open(&self.path)?;
        file.write_all(lines.as_bytes())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_message_is_on_record_with_its_place() {
        let folder = tempfile::tempdir().unwrap();
        let log = ProblemLog::begin(folder.path(), || {
            Some(Started { date: "1-2-2026".into(), time: "3:04".into() })
        });
        let place = Some(Call { file: "a.sbp".into(), line: 2 });
        let (text, hint) = ("it fails".into(), "mend it".into());
        let message = Message { tone: Tone::Error, text, hint, place, ..Message::default() };
        log.note(&[Change::Messages { messages: vec![message] }]);
        let text = fs::read_to_string(folder.path().join(FILE)).unwrap();
        assert_eq!(text, "1-2-2026 3:04 error: a.sbp, line 2: it fails (mend it)\n");
    }
}
