//! The stepped interpreter.
//!
//! An [`Interpreter`] executes one line a step and appends [`Command`](kerf_program::Command)s to a
//! list. It runs ahead of the machine as far as the language allows: a statement that ends the
//! stack of moves, or reads an input, first asks [`Host::settle`]. While ON INPUT handlers are
//! armed it keeps, for each move it has given, the state right after that move; so an interrupt in
//! the middle of a stack continues exactly as if nothing behind the interrupted move had been read.
//!
//! Everything inside is millimetres, degrees and seconds; the user's units are converted where
//! parameters are read ([`Arguments`]) and where values are shown.

mod arguments;
mod commands;
mod comments;
mod context;
mod cutting;
mod dialogs;
mod eval;
mod fabmo;
mod fast;
mod fields;
mod gcode;
mod interrupt;
mod jumps;
mod language;
mod levels;
mod lifecycle;
mod locate;
mod members;
mod message_box;
mod outward;
mod past;
mod pauses;
mod preview;
mod printing;
mod programs;
mod questions;
mod recorder;
mod registry;
mod saving;
mod session;
mod state;
mod statements;
mod step;
mod stepping;
mod sysvar;
#[cfg(test)]
mod tests;
mod tool_changes;
mod user_files;
mod z_moves;

pub(crate) use arguments::Arguments;
pub(crate) use context::{Context, Stop};
pub use gcode::{FilePlace, GcodeDone, GcodeDue};
pub use kerf_program::{Status, Step, Watch};
pub use recorder::{RECORDED, RECORDING, Replay, with_recorded};
pub use registry::{EDITOR, LAST_ERROR, PART_FILE, POSITION_LOST, SPINDLE_STATUS, USER_VALUE};
pub use session::{BeforePreview, FileParameters, Options, Session};
pub(crate) use state::Core;
pub use state::Variables;
pub use sysvar::{SystemVariable, VERSION, system_variables};

use crate::tree::Span;
use crate::{Program, Value};
use kerf_program::{At, Axes, FileCall, Frame, Host, Settings, Sourced};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// States kept behind moves that may be interrupted; some tens of megabytes.
const MOST_BEHIND: usize = 20_000;

/// A program being run.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(from = "saving::Saved", into = "saving::Saved")]
pub struct Interpreter {
    core: Core,
    /// States that an interrupt goes back to.
    past: past::Past,
}

impl Interpreter {
    /// Prepares to run a program from the state of a session.
    pub fn new(program: Program, session: Session, options: Options) -> Self {
        Self { core: Core::new(Arc::new(program), session, options), past: past::Past::default() }
    }

    /// Executes one line. Commands are appended to `out`.
    pub fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        if self.past.len() >= MOST_BEHIND {
            // The stack is cut here so that memory stays bounded.
            if host.settle().is_pending() {
                return Step::Waiting;
            }
            self.core.given.settled = true;
            self.past.clear();
        }
        let number = self.core.given.steps;
        let step = step::step(&mut self.core, host, out);
        self.core.given.steps += u64::from(step != Step::Waiting);
        self.past.keep(&mut self.core, number, &step);
        step
    }

    /// Executes lines until the host is needed, the run is over, a stack of moves has ended (so that
    /// the machine is never more than one stack behind), or so many lines are done.
    pub fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        let bound = self.core.given.lines.saturating_add(lines);
        // Steps that are no line (a file ends, a handler's action) count too, so that this ends.
        for _ in 0..lines {
            let left = bound.saturating_sub(self.core.given.lines);
            if left == 0 {
                break;
            }
            // What is typed goes through the recorder, line by line.
            if self.core.handlers.watches.is_empty() && !self.core.options.typed {
                let jogged = fast::run_moves(&mut self.core, out, left);
                if jogged || self.core.given.lines >= bound {
                    break;
                }
            }
            let given = out.len();
            match self.step(host, out) {
                Step::Ran => {}
                other => return other,
            }
            let new = out.get(given..).unwrap_or_default();
            if new.iter().any(|s| s.command.ends_stack()) || self.gcode_due().is_some() {
                break;
            }
        }
        Step::Ran
    }

    /// Tells that a watched input changed and the machine stopped for it.
    ///
    /// `motion` is the number (as [`Interpreter::motions`] counts) of the motion command that was
    /// interrupted, or of the first one not yet begun; it and all later ones were dropped. `None`
    /// when none was left to do. `position` is where the machine stopped, machine frame. The
    /// handler's action runs in the next step; a pause that was under way is over, a question that
    /// was open is asked again unless the action goes elsewhere.
    pub fn interrupt(&mut self, watch: &Watch, motion: Option<u64>, position: Axes) {
        if let Some(state) = motion.and_then(|number| self.past.after(number)) {
            self.core = state.clone();
        }
        self.past.clear();
        interrupt::arrive(&mut self.core, watch, position);
    }

    /// Tells that the machine, stopped in the middle, was nudged by so much, machine frame.
    pub fn nudge(&mut self, by: Axes) {
        self.core.nudge(by);
        self.past.states_mut().for_each(|core| core.nudge(by));
    }

    /// Tells that the operator ended the run.
    pub fn stop(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        lifecycle::finish(&mut self.core, host, out);
        Step::Done(Status::Stopped, None)
    }

    /// Tells that a bound of the machine ended the run (table limits).
    pub fn limit(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        lifecycle::finish(&mut self.core, host, out);
        Step::Done(Status::Limit, None)
    }

    /// The ON INPUT handlers that are armed.
    pub fn watches(&self) -> impl Iterator<Item = &Watch> {
        self.core.handlers.watches.iter().map(|w| &w.watch)
    }

    /// Name of a file of [`At`].
    pub fn file_name(&self, file: u32) -> Arc<str> {
        self.core
            .files
            .programs
            .get(file as usize)
            .map_or_else(|| Arc::from(""), |p| p.name.clone())
    }

    /// Returns the last call of a file of [`At`].
    pub fn file_call(&self, file: u32) -> Option<FileCall> {
        self.core.flow.calls.get(&file).copied()
    }

    /// The program of a file of [`At`].
    pub fn program(&self, file: u32) -> Option<&Program> {
        self.core.files.programs.get(file as usize).map(AsRef::as_ref)
    }

    /// The open files and the line that runs next in each, outermost first.
    pub fn call_stack(&self) -> impl Iterator<Item = At> {
        self.core.flow.levels.iter().map(|l| At { file: l.file, line: l.next + 1 })
    }

    /// Number of the last motion command given, counted from 1. After an interrupt the count goes
    /// on behind the motions of the interrupted line.
    pub fn motions(&self) -> u64 {
        self.core.given.motions
    }

    /// Tells that all motion up to this number has been carried out: nothing before it can be
    /// interrupted any more, so the states kept for that are forgotten.
    pub fn carried_out(&mut self, motion: u64) {
        self.past.forget(motion);
    }

    /// Lines executed so far.
    pub fn lines(&self) -> u64 {
        self.core.given.lines
    }

    /// The settings in force.
    pub fn settings(&self) -> &Arc<Settings> {
        &self.core.values.settings
    }

    /// The frames in force.
    pub fn frame(&self) -> &Frame {
        &self.core.place.frame
    }

    /// Returns the place to which the program has sent the machine, machine frame.
    pub fn position(&self) -> Axes {
        self.core.place.position
    }

    /// The user's variables.
    pub fn variables(&self) -> &Variables {
        &self.core.memory.variables
    }

    /// A system variable as a program would read it now; `None` while the machine is still busy.
    pub fn system_variable(&mut self, host: &mut dyn Host, number: u8) -> Option<Value> {
        let mut out = Vec::new();
        let (at, span) = (At::default(), Span::default());
        let program = &self.core.files.program(at.file);
        let core = &mut self.core;
        let mut context = Context { core, program, host, out: &mut out, at, span };
        sysvar::system_variable(&mut context, f64::from(number), span).ok()
    }

    /// Returns the state that stays after the run: settings, frames, position, variables.
    pub fn into_session(self) -> Session {
        self.core.into_session()
    }
}
