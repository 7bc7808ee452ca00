//! Reports to a person at a terminal while a program runs.

use crate::sources::FileLines;
use kerf_diag::{Diagnostic, Repetitions, render_text};
use kerf_trace::{Event, Sink, event::AskEvent};
use std::io::{IsTerminal, Write};
use std::sync::Arc;
use std::{env, io};

/// Writes diagnostics to the error stream, drawn like a compiler does.
///
/// Findings that a loop makes again at a line are told once, and at the end counted.
#[derive(Default)]
pub struct Diagnostics {
    lines: FileLines,
    again: Repetitions,
}

impl Diagnostics {
    /// With the lines of what runs.
    pub fn with(lines: FileLines) -> Self {
        Self { lines, again: Repetitions::default() }
    }

    /// Writes one.
    pub fn show(&self, diagnostic: &Diagnostic) {
        eprintln!("{}\n", render_text(diagnostic, &self.lines, colour(&io::stderr())));
    }
}

impl Sink for Diagnostics {
    fn event(&mut self, event: &Event) {
        if let Event::Diag(diagnostic) = event
            && self.again.is_new(diagnostic)
        {
            self.show(diagnostic);
        }
    }

    fn looks_at_motion(&self) -> bool {
        false
    }
}

impl Drop for Diagnostics {
    fn drop(&mut self) {
        self.again.diagnostics().iter().for_each(|diagnostic| self.show(diagnostic));
    }
}

/// Returns `true` if colours are wanted: on a terminal, unless NO_COLOR says otherwise.
pub fn colour(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}

/// Writes what a program says to the operator to standard output.
///
/// A comment is shown when the program pauses right after it, as the message of the pause.
#[derive(Debug, Default)]
pub struct Talk {
    comment: Option<Arc<str>>,
    all: bool,
}

impl Talk {
    /// Writes every message: the operator typed what asks for it.
    pub const fn all() -> Self {
        Self { comment: None, all: true }
    }

    /// A job has no comments: whatever it says is for the operator.
    pub fn of(job: bool) -> Self {
        Self { all: job, ..Self::default() }
    }
}

impl Sink for Talk {
    fn event(&mut self, event: &Event) {
        let comment = self.comment.take();
        match event {
            Event::Print { text, .. } => say(text),
            Event::Message { text, .. } if self.all => say(text),
            Event::Message { text, .. } => self.comment = Some(text.clone()),
            Event::Wait { seconds, .. } => {
                if let Some(text) = comment {
                    say(&format!("· {text} ({})", crate::out::duration(*seconds)));
                }
            }
            Event::Ask(ask) => say(&asked(ask)),
            Event::Sound { .. } => ring(),
            _ => {}
        }
    }
}

/// A question with its answer.
pub fn asked(ask: &AskEvent) -> String {
    let by = if ask.scripted { "" } else { " (default)" };
    format!("? {} → {}{by}", ask.text, ask.answer)
}

/// Rings the bell of the terminal where nothing plays sounds.
fn ring() {
    let mut terminal = io::stdout();
    if terminal.is_terminal() {
        let _ = terminal.write_all(b"\x07").and_then(|()| terminal.flush());
    }
}

/// Writes a line. A reader that went away is no reason to complain.
fn say(text: &str) {
    let _ = writeln!(io::stdout(), "{text}");
}
