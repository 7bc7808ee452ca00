//! A run in memory: files in, events out. For tests, editors and whoever has no disk.

use crate::StopAt;
use crate::answers::Answers;
use crate::run_context::RunContext;
use crate::session::Session;
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_model::Change;
use kerf_program::Settings;
use kerf_program::settings::LinearUnit;
use kerf_sbp::Value;
use kerf_trace::{Event, Summary};
use kerf_workspace::Workspace;

/// Options of a run in memory.
#[derive(Clone, Debug, Default)]
pub struct TextOptions {
    /// Options of the run itself.
    pub run: RunOptions,
    /// The settings at the start.
    pub settings: Settings,
    /// Answers to questions, one a line, as `--answers` reads them.
    pub answers: String,
    /// Variables set before the start.
    pub variables: Vec<(String, Value)>,
    /// The operator stops the machine at this time, seconds.
    pub stop_at_s: Option<f64>,
}

impl TextOptions {
    /// The same on a machine set to millimetres.
    #[must_use]
    pub fn mm(mut self) -> Self {
        self.settings.use_linear_unit(LinearUnit::Mm);
        self
    }

    /// The same with answers, one a line.
    #[must_use]
    pub fn answers(mut self, answers: &str) -> Self {
        self.answers = answers.into();
        self
    }

    /// The same with an input that changes at a time, seconds.
    #[must_use]
    pub fn input(mut self, input: u8, at_s: f64, on: bool) -> Self {
        self.run.inputs.push(Change { input, at_s, on });
        self
    }

    /// The same with a variable set before the start.
    #[must_use]
    pub fn set(mut self, name: &str, value: Value) -> Self {
        self.variables.push((name.into(), value));
        self
    }

    /// The same as a preview.
    #[must_use]
    pub const fn preview(mut self) -> Self {
        self.run.program.preview = true;
        self
    }
}

/// A run in memory that is over.
#[derive(Debug)]
pub struct Outcome {
    /// Everything that was told, in order.
    pub events: Vec<Event>,
    /// Result of the run.
    pub summary: Summary,
    /// Session that stays: settings, frames, position, variables.
    pub session: Session,
    /// Stored values and files, as the run left them.
    pub workspace: Workspace,
}

/// Runs the file `main` of `files`, which the program sees as its part folder. A missing `main` is
/// an empty program.
pub fn run_text(files: &[(&str, &str)], main: &str, options: TextOptions) -> Outcome {
    let disk = MemoryDisk::new(files.iter().map(|(name, text)| (*name, text.as_bytes())));
    let text = files.iter().find(|(name, _)| *name == main).map_or("", |(_, text)| text);
    let program = kerf_part::read_as(main.into(), text.as_bytes(), options.run.program.dialect);
    let mut session = Session::default();
    session.memory.settings = options.settings;
    for (name, value) in options.variables {
        session.memory.variables.set(&name, value);
    }
    let mut workspace = Workspace::in_memory(disk);
    let mut events = Vec::new();
    let mut operator = Answers::read(&options.answers);
    let mut stop = StopAt(options.stop_at_s.unwrap_or(f64::INFINITY));
    let context = RunContext {
        sink: &mut events,
        operator: &mut operator,
        requests: &mut stop,
        machine: crate::simulated(),
    };
    let summary = session.run(program, options.run, &mut workspace, context);
    Outcome { events, summary, session, workspace }
}
