//! One file run as the command line runs it, and how it ended.

use crate::corpus::row::Row;
use crate::corpus::tree::Tree;
use kerf_control::answers::Answers;
use kerf_control::{RunContext, Session};
use kerf_files::RealDisk;
use kerf_journal::{RunOptions, Shell};
use kerf_sbp::Status;
use kerf_trace::{Event, json};
use kerf_workspace::{Workspace, stored::Stored};
use std::path::PathBuf;

/// Result of a run.
pub struct Ended {
    /// `ok`, `ended`, `stopped`, `failed CODE LINE` or `limit CODE`.
    pub told: String,
    /// The message of the error that ended it.
    pub message: String,
    /// The trace, an event an entry.
    pub trace: Vec<String>,
}

impl Ended {
    /// It ended as its line says, and showed what it had to.
    pub fn is_as(&self, row: &Row) -> bool {
        let shown = |event: &String| event.contains(row.shows);
        self.told == row.expected && self.trace.iter().any(shown)
    }

    /// In what it differs from what its line says.
    pub fn difference(&self, row: &Row) -> String {
        format!("{}, expected {} {} ({})", self.told, row.expected, row.shows, self.message)
    }
}

/// Runs a file as its line says.
pub fn run(tree: &Tree, row: &Row) -> Ended {
    run_with(tree, row, RunOptions::default())
}

/// The same, with the program's state saved and restored whenever its commands are looked at.
pub fn run_restored(tree: &Tree, row: &Row) -> Ended {
    let options = RunOptions { restore: true, lines_at_once: 50, ..RunOptions::default() };
    run_with(tree, row, options)
}

fn run_with(tree: &Tree, row: &Row, options: RunOptions) -> Ended {
    let mut session = Session::default();
    session.memory.settings.axis_count = row.axes;
    for (name, value) in &row.set {
        session.memory.variables.set(name, value.clone());
    }
    let stored = Stored::in_memory(std::iter::empty().collect());
    let mut workspace =
        Workspace::preview(RealDisk, tree.folders(row.file), &stored, PathBuf::new())
            .with_shell(Shell::Skipped);
    for line in &row.before {
        one(&mut session, "before", line.as_bytes(), RunOptions::default(), row, &mut workspace);
    }
    let path = tree.path(row.file);
    let mut options = RunOptions { inputs: row.inputs.clone(), ..options };
    options.program.preview = !row.moves;
    options.program.max_lines = row.max_lines;
    options.program.dialect = row.dialect;
    one(
        &mut session,
        &path.display().to_string(),
        tree.bytes(row.file),
        options,
        row,
        &mut workspace,
    )
}

fn one(
    session: &mut Session,
    name: &str,
    bytes: &[u8],
    options: RunOptions,
    row: &Row,
    workspace: &mut Workspace,
) -> Ended {
    let mut events: Vec<Event> = Vec::new();
    let mut operator = Answers::read(&row.answers);
    let context = RunContext {
        sink: &mut events,
        operator: &mut operator,
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    let program = kerf_part::read_as(name.into(), bytes, row.dialect);
    let summary = session.run(program, options, workspace, context);
    let (code, line, message) = summary
        .error
        .map(|e| (e.code.to_string(), e.place.line, e.message.clone()))
        .unwrap_or_default();
    let told = match summary.status {
        Status::Ok => "ok".to_owned(),
        Status::Ended => "ended".to_owned(),
        Status::Stopped => "stopped".to_owned(),
        Status::Limit => format!("limit {code}"),
        Status::Failed => format!("failed {code} {line}"),
    };
    Ended { told, message, trace: events.iter().map(json::to_string).collect() }
}
