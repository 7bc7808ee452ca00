//! A program and the world it runs in.

use crate::Run;
use kerf_control::answers::Answers;
use kerf_control::{RunContext, Session, StopAt};
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::Configuration;
use kerf_machine::settings::estop::EmergencyStop;
use kerf_model::Change;
use kerf_program::settings::LinearUnit;
use kerf_program::{Axis, Settings};
use kerf_sim::Push;
use kerf_trace::{Event, json};
use kerf_workspace::Workspace;
use std::sync::Arc;

/// Names of the program that a case runs.
const MAIN: &str = "main.sbp";
const MAIN_GCODE: &str = "main.nc";

/// A program with everything that its row says about the start.
#[derive(Clone, Debug)]
pub struct Case {
    name: &'static str,
    program: String,
    /// Programs that ran before, and when the operator stopped each, seconds.
    before: Vec<(String, f64)>,
    files: Vec<(String, String)>,
    answers: Vec<String>,
    options: RunOptions,
    session: Session,
    stop_at_s: f64,
}

/// A program in the state S0; `⏎` separates lines as `\n` does.
pub fn sbp(program: &str) -> Case {
    Case {
        name: MAIN,
        program: lines(program),
        before: Vec::new(),
        files: Vec::new(),
        answers: Vec::new(),
        options: RunOptions::default(),
        session: Session::default(),
        stop_at_s: f64::INFINITY,
    }
}

/// A program of G-code in the state S0.
pub fn gcode(program: &str) -> Case {
    Case { name: MAIN_GCODE, ..sbp(program) }
}

/// Runs a program from the state S0.
pub fn run(program: &str) -> Run {
    sbp(program).run()
}

/// Runs a program with the tool at a place, working and base locations alike.
pub fn at<const N: usize>(location: [f64; N], program: &str) -> Run {
    sbp(program).at(location).run()
}

impl Case {
    /// Another program ran before on the same machine.
    #[must_use]
    pub fn after(self, program: &str) -> Self {
        self.after_stop(program, f64::INFINITY)
    }

    /// Another program ran before, which the operator stopped at a machine time, seconds.
    #[must_use]
    pub fn after_stop(mut self, program: &str, seconds: f64) -> Self {
        self.before.push((lines(program), seconds));
        self
    }

    /// A file in the part folder.
    #[must_use]
    pub fn file(mut self, name: &str, text: &str) -> Self {
        self.files.push((name.to_owned(), lines(text)));
        self
    }

    /// Answers to the questions, in order.
    #[must_use]
    pub fn answers(mut self, answers: &[&str]) -> Self {
        self.answers.extend(answers.iter().map(|answer| (*answer).to_owned()));
        self
    }

    /// An input changes at a machine time, seconds.
    #[must_use]
    pub fn input(mut self, input: u8, at_s: f64, on: bool) -> Self {
        self.options.inputs.push(Change { input, at_s, on });
        self
    }

    /// An axis is pushed by hand at a machine time, seconds; inches or degrees.
    #[must_use]
    pub fn pushed(mut self, axis: Axis, at_s: f64, by: f64) -> Self {
        let by = by * self.session.memory.settings.axis_scale(axis);
        self.options.pushes.push(Push { axis, at_s, by });
        self
    }

    /// The operator stops the machine at a machine time, seconds.
    #[must_use]
    pub const fn stopped_at(mut self, seconds: f64) -> Self {
        self.stop_at_s = seconds;
        self
    }

    /// The machine has so many axes.
    #[must_use]
    pub const fn axes(mut self, count: u8) -> Self {
        self.session.memory.settings.axis_count = count;
        self
    }

    /// The machine's stack takes so many moves.
    #[must_use]
    pub const fn stack_limit(mut self, limit: u32) -> Self {
        self.session.memory.settings.stack_limit = Some(limit);
        self
    }

    /// An input of the machine is the interlock of its enclosure.
    #[must_use]
    pub const fn interlock(mut self, input: u8) -> Self {
        self.session.memory.settings.io.interlock = Some(input);
        self
    }

    /// The emergency stop of the machine cuts its power.
    #[must_use]
    pub fn alpha(mut self) -> Self {
        let estop = EmergencyStop { cuts_power: true, ..EmergencyStop::default() };
        self.session.machine_is = Arc::new(Configuration { estop, ..Configuration::default() });
        self
    }

    /// The lines are typed, not read from a file.
    #[must_use]
    pub const fn typed(mut self) -> Self {
        self.options.program.typed = true;
        self
    }

    /// Other settings at the start.
    #[must_use]
    pub fn settings(mut self, change: impl FnOnce(&mut Settings)) -> Self {
        change(&mut self.session.memory.settings);
        self
    }

    /// The machine is set to millimetres.
    #[must_use]
    pub const fn millimetres(mut self) -> Self {
        self.session.memory.settings.linear_unit = LinearUnit::Mm;
        self
    }

    /// The tool is at a place, working and base locations alike; the first axes, in their units.
    #[must_use]
    pub fn at<const N: usize>(mut self, location: [f64; N]) -> Self {
        for (axis, value) in Axis::ALL.into_iter().zip(location) {
            let scale = self.session.memory.settings.axis_scale(axis);
            self.session.memory.position[axis] = value * scale;
        }
        self
    }

    /// Runs it.
    pub fn run(mut self) -> Run {
        let mut files = self.files.clone();
        files.push((self.name.to_owned(), self.program.clone()));
        let files = files.iter().map(|(name, text)| (name.as_str(), text.as_bytes()));
        let mut workspace = Workspace::in_memory(MemoryDisk::new(files));
        for (program, stop_at_s) in std::mem::take(&mut self.before) {
            self.one(&program, RunOptions::default(), &mut workspace, stop_at_s);
        }
        let memory = &self.session.memory;
        let start = memory.settings.to_user(memory.frame.working(memory.position)).0;
        let (program, options) = (self.program.clone(), self.options.clone());
        let events = self.one(&program, options, &mut workspace, self.stop_at_s);
        let trace: Vec<String> = events.iter().map(json::to_string).collect();
        Run::new(&trace.join("\n"), start, workspace)
    }

    /// Runs it as a preview.
    pub fn preview(mut self) -> Run {
        self.options.program.preview = true;
        self.run()
    }

    fn one(
        &mut self,
        program: &str,
        options: RunOptions,
        workspace: &mut Workspace,
        stop_at_s: f64,
    ) -> Vec<Event> {
        let mut events = Vec::new();
        let mut operator = Answers::read(&self.answers.join("\n"));
        let mut pace = StopAt(stop_at_s);
        let context = RunContext {
            sink: &mut events,
            operator: &mut operator,
            requests: &mut pace,
            machine: kerf_control::simulated(),
        };
        let program = kerf_part::read(self.name.into(), program.as_bytes());
        self.session.run(program, options, workspace, context);
        events
    }
}

/// The text with `⏎` and the blanks around it turned into line ends.
fn lines(program: &str) -> String {
    let lines: Vec<&str> = program.split('⏎').map(|line| line.trim_matches(' ')).collect();
    if lines.len() == 1 { program.to_owned() } else { lines.join("\n") }
}
