//! The interpreter as its users see it.

use super::core::Core;
use super::session::{Options, Session};
use super::state::State;
use super::{fast, probe, step};
use crate::syntax::reader::read_text;
use crate::syntax::tree::Program;
use kerf_program::{At, Axes, Frame, Host, Settings, Sourced, Status, Step, ToolTable, Watch};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A program being run.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(from = "Saved", into = "Saved")]
pub struct Interpreter {
    core: Core,
}

impl Interpreter {
    /// Prepares to run a program from the state of a session.
    pub fn new(program: impl Into<Arc<Program>>, session: Session, options: Options) -> Self {
        Self { core: Core::new(program.into(), session, options) }
    }

    /// Prepares to execute one line alone, with the modes in force: lines that stand among those of
    /// another language. The next steps carry it out with whatever it calls; then the run is done.
    pub fn enter_line(&mut self, line: u32) {
        self.core.enter_line(line);
    }

    /// Takes over what another language did to the machine since the last step.
    pub fn adopt(&mut self, settings: &Arc<Settings>, frame: &Frame, position: Axes) {
        self.core.adopt(settings, frame, position);
    }

    /// Returns the tool that has to be put in before the next step; nothing comes before
    /// [`tool_is_in`](Self::tool_is_in).
    pub const fn tool_due(&self) -> Option<u32> {
        self.core.under_way.due_tool
    }

    /// Takes over the tools that another language has changed.
    pub fn use_tools(&mut self, table: &ToolTable) {
        self.core.state.use_tools(table);
    }

    /// The tool that was due is in the spindle.
    pub const fn tool_is_in(&mut self) {
        self.core.under_way.due_tool = None;
    }

    /// Returns `true` while cutter compensation is on: the tool is beside the path, and moves are held back.
    pub const fn compensates(&self) -> bool {
        self.core.place.compensator.is_some()
    }

    /// Returns `true` if the program came to its end (M2, M30).
    pub fn is_over(&self) -> bool {
        self.core.progress.over
    }

    /// Executes one line. Commands are appended to `out`.
    pub fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        step::step(&mut self.core, host, out)
    }

    /// Executes lines until the host is needed, the run is over, or so many lines are done.
    pub fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        let bound = self.core.progress.lines.saturating_add(lines);
        // Steps that are no line (a probe move ends) count too, so that this ends.
        for _ in 0..lines {
            let left = bound.saturating_sub(self.core.progress.lines);
            if left == 0 {
                break;
            }
            fast::run_moves(&mut self.core, out, left);
            if self.core.progress.lines >= bound {
                break;
            }
            match self.step(host, out) {
                Step::Ran if self.tool_due().is_none() => {}
                other => return other,
            }
        }
        Step::Ran
    }

    /// Tells that a watched input changed and the machine stopped for it: the probe made contact.
    pub fn interrupt(&mut self, _: &Watch, _: Option<u64>, position: Axes) {
        probe::contact(&mut self.core, position);
    }

    /// Tells that the machine, stopped in the middle, was nudged by so much, machine frame.
    pub fn nudge(&mut self, by: Axes) {
        self.core.nudge(by);
    }

    /// Tells that the operator ended the run.
    pub fn stop(&mut self, _: &mut dyn Host, _: &mut Vec<Sourced>) -> Step {
        self.core.abandon();
        Step::Done(Status::Stopped, None)
    }

    /// Tells that a bound of the machine ended the run (table limits).
    pub fn limit(&mut self, _: &mut dyn Host, _: &mut Vec<Sourced>) -> Step {
        self.core.abandon();
        Step::Done(Status::Limit, None)
    }

    /// The changes of inputs that the program waits for: those of a probe.
    pub fn watches(&self) -> impl Iterator<Item = &Watch> {
        self.core.under_way.probing.iter().map(|p| &p.watch)
    }

    /// Name of a file of [`At`].
    pub fn file_name(&self, file: u32) -> Arc<str> {
        self.core
            .calls
            .programs
            .get(file as usize)
            .map_or_else(|| Arc::from(""), |p| p.name.clone())
    }

    /// The program of a file of [`At`].
    pub fn program(&self, file: u32) -> Option<&Program> {
        self.core.calls.programs.get(file as usize).map(AsRef::as_ref)
    }

    /// The open files and subroutines and the line that runs next in each, outermost first.
    pub fn call_stack(&self) -> impl Iterator<Item = At> {
        self.core.calls.open.iter().map(|c| At { file: c.file, line: c.next + 1 })
    }

    /// Number of the last motion command given, counted from 1.
    pub fn motions(&self) -> u64 {
        self.core.progress.motions
    }

    /// Lines executed so far.
    pub fn lines(&self) -> u64 {
        self.core.progress.lines
    }

    /// The settings in force.
    pub fn settings(&self) -> &Arc<Settings> {
        &self.core.settings
    }

    /// The frames in force.
    pub fn frame(&self) -> &Frame {
        &self.core.frame
    }

    /// Returns the place to which the program has sent the machine, machine frame.
    pub fn position(&self) -> Axes {
        self.core.place.tool()
    }

    /// Modes, offsets, parameters and tools in force.
    pub fn state(&self) -> &State {
        &self.core.state
    }

    /// Returns `true` while the operator is asked before each line.
    pub const fn is_stepped(&self) -> bool {
        self.core.progress.stepping.asks
    }

    /// The parameters of the program by name, in order: numbered ones above zero, named ones.
    pub fn variables(&self) -> Vec<(String, f64)> {
        self.core.parameters().all()
    }

    /// Returns the state that stays after the run: settings, frames, position, offsets, parameters.
    pub fn into_session(self) -> Session {
        self.core.into_session()
    }
}

impl kerf_program::Interpreter for Interpreter {
    fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        Self::step(self, host, out)
    }
    fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        Self::run(self, host, out, lines)
    }
    fn interrupt(&mut self, watch: &Watch, motion: Option<u64>, position: Axes) {
        Self::interrupt(self, watch, motion, position);
    }
    fn nudge(&mut self, by: Axes) {
        Self::nudge(self, by);
    }
    fn carried_out(&mut self, _: u64) {}
    fn stop(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        Self::stop(self, host, out)
    }
    fn limit(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        Self::limit(self, host, out)
    }
    fn watches(&self) -> Vec<Watch> {
        Self::watches(self).cloned().collect()
    }
    fn file_name(&self, file: u32) -> Option<Arc<str>> {
        self.program(file).map(|p| p.name.clone())
    }
    fn call_stack(&self) -> Vec<At> {
        Self::call_stack(self).collect()
    }
    fn motions(&self) -> u64 {
        Self::motions(self)
    }
    fn lines(&self) -> u64 {
        Self::lines(self)
    }
    fn settings(&self) -> &Arc<Settings> {
        Self::settings(self)
    }
    fn frame(&self) -> &Frame {
        Self::frame(self)
    }
    fn position(&self) -> Axes {
        Self::position(self)
    }
    fn variables(&self) -> Vec<(String, String)> {
        Self::variables(self).into_iter().map(|(n, v)| (n, v.to_string())).collect()
    }
}

/// Saved form: programs as name and text, read again when restored.
#[derive(Serialize, Deserialize)]
struct Saved {
    programs: Vec<(String, String)>,
    core: Core,
}

impl From<Interpreter> for Saved {
    fn from(interpreter: Interpreter) -> Self {
        let core = interpreter.core;
        let programs =
            core.calls.programs.iter().map(|p| (p.name.to_string(), p.text.to_string())).collect();
        Self { programs, core }
    }
}

impl From<Saved> for Interpreter {
    fn from(saved: Saved) -> Self {
        let Saved { programs, mut core } = saved;
        core.calls.programs = programs
            .into_iter()
            .map(|(name, text)| Arc::new(read_text(name.into(), Arc::new(text))))
            .collect();
        Self { core }
    }
}
