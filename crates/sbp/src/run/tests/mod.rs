//! Tests of the interpreter, named after the rows of the ledger where there is one.
#![allow(clippy::unwrap_used)]

mod corpus;
mod dialogs;
mod fabmo;
mod fast;
mod file_parameters;
mod files;
mod flow;
mod handlers;
mod lang;
mod output;
mod registry;
mod rig;
mod saving;
mod user_files;

use crate::testing::{FakeHost, Ran, run_with};
use crate::{Session, Status};
use kerf_program::{Answer, Button, Command, FileOp};

/// A host that holds files; `⏎` separates lines.
fn host_with(files: &[(&str, &str)]) -> FakeHost {
    let lines = |text: &str| text.split('⏎').map(str::trim).collect::<Vec<_>>().join("\n");
    let files = files.iter().map(|(name, text)| (name.to_lowercase(), lines(text))).collect();
    FakeHost { files, ..FakeHost::default() }
}

/// Runs a program that may call other files.
fn run_files(text: &str, files: &[(&str, &str)]) -> Ran {
    run_with(text, host_with(files), Session::default())
}

/// Runs a program that gets these answers.
fn run_answered(text: &str, answers: &[Answer]) -> Ran {
    let host = FakeHost { answers: answers.to_vec(), ..FakeHost::default() };
    run_with(text, host, Session::default())
}

fn typed(text: &str) -> Answer {
    Answer::Text(text.into())
}

const fn press(button: Button) -> Answer {
    Answer::Button(button)
}

impl Ran {
    /// Checks how the run ended.
    #[track_caller]
    fn ended(&self, status: Status) -> &Self {
        assert_eq!(self.status, status, "{:?}", self.error);
        self
    }

    /// Checks that the run failed at a line, with a message that contains a text.
    #[track_caller]
    fn fails_at(&self, line: u32, part: &str) -> &Self {
        self.ended(Status::Failed).fails_with(part);
        assert_eq!(self.error.as_ref().map(|e| e.place.line), Some(line));
        self
    }

    /// Warnings and notes that were told while running, and those of the reader.
    fn told(&self) -> String {
        let told = self.commands.iter().filter_map(|c| match &c.command {
            Command::Diagnostic(d) => Some(format!("{}: {} {}", d.place.line, d.message, d.hint)),
            _ => None,
        });
        told.collect::<Vec<_>>().join("\n")
    }

    /// Everything given but settings and messages, a word or two each.
    fn order(&self) -> String {
        let words = self.commands.iter().filter_map(|c| match &c.command {
            Command::Line(l) => Some(format!("{}", (l.to.0[0] / 25.4 * 1e3).round() / 1e3)),
            Command::Wait { seconds } => Some(format!("wait {seconds}")),
            Command::Print { text, .. } => Some(format!("print {text}")),
            Command::Sound { path } => Some(format!("sound {path}")),
            Command::File { op: FileOp::Open, path } => Some(format!("open {path}")),
            Command::File { op: FileOp::Close, path } => Some(format!("close {path}")),
            Command::File { op: FileOp::Write, path } => Some(format!("write {path}")),
            Command::File { op: FileOp::Read, path } => Some(format!("read {path}")),
            Command::WarningOff => Some("warning off".into()),
            Command::ToolChange { begin } => Some(format!("tool change {begin}")),
            _ => None,
        });
        words.collect::<Vec<_>>().join(", ")
    }
}
