//! The trait that every interpreter offers to those who run programs: a value that is stepped.
//!
//! OpenSBP and G-code are two languages and one machine; whoever runs a program, draws it or steps
//! through it works with this trait and need not know which language it is.

use crate::{At, Axes, Frame, Host, Settings, Sourced};
use kerf_diag::Diagnostic;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// It ran to its end.
    Ok,
    /// The program asked to end everything (ENDALL, EXIT SHOPBOT).
    Ended,
    /// An error.
    Failed,
    /// The operator stopped it.
    Stopped,
    /// A bound was reached: lines or table limits.
    Limit,
}

impl Status {
    /// The word for it in traces, on record and on the wire.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Ended => "ended",
            Self::Failed => "failed",
            Self::Stopped => "stopped",
            Self::Limit => "limit",
        }
    }
}

/// Result of a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A line was executed.
    Ran,
    /// The host has to do something first; the step had no effect.
    Waiting,
    /// The run is over. An error is told in the diagnostic.
    Done(Status, Option<Box<Diagnostic>>),
}

/// A change of an input that a program waits for (ON INPUT, a probe).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Watch {
    /// Number of the input.
    pub input: u8,
    /// Fires when the input changes to this state.
    pub on: bool,
    /// Motion ramps down first, else it stops at once.
    pub ramped: bool,
    /// So many seconds after the motion or wait began the state alone fires, and nothing does
    /// before; without this every change to the state fires, at any time.
    #[serde(default)]
    pub level_after_s: Option<f64>,
    /// Outputs that go off, and the intensity with them, the moment it fires; the others wait until
    /// the machine stands.
    #[serde(default)]
    pub drops: Vec<u8>,
}

impl Watch {
    /// Waits for a change.
    pub const fn change(input: u8, on: bool, ramped: bool) -> Self {
        Self { input, on, ramped, level_after_s: None, drops: Vec::new() }
    }

    /// Waits for a state, from so many seconds after the beginning on.
    pub const fn level(input: u8, on: bool, after_s: f64) -> Self {
        Self { input, on, ramped: true, level_after_s: Some(after_s), drops: Vec::new() }
    }
}

/// Place of the motion when something stopped it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Halted {
    /// The number (as [`Interpreter::motions`] counts) of the motion command that was interrupted, or
    /// of the first one not yet begun; it and all later ones were dropped. `None` when none was left
    /// to do.
    pub motion: Option<u64>,
    /// Place of the machine when the stop began, machine frame.
    pub began: Axes,
    /// Place where it stands, machine frame.
    pub stands: Axes,
}

/// Cause of a stop, told to a program that takes stops itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StoppedBy {
    /// The operator: key Stop.
    Operator,
    /// An input that stops motion; its number.
    Input(u8),
    /// An input at the end of an axis; its number.
    Limit(u8),
    /// The power went and came back: nothing is on, the machine stands somewhere, and the run goes on
    /// from the place where [`Halted::began`] says that it was left.
    PowerCut,
}

/// Parameters of a call of a part file (FP).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FileCall {
    /// Proportions X, Y, Z.
    pub proportion: [f64; 3],
    /// 0 none, 1 the present X, Y, Z is the temporary zero, 2 only X and Y.
    pub offset: u8,
    /// Number of times that the file runs.
    pub repetitions: u32,
    /// Change of Z before each repetition, mm.
    #[serde(default)]
    pub plunge_mm: f64,
    /// Tabs are left on the last repetition.
    #[serde(default)]
    pub tabs: bool,
    /// Plunges start from Z 0.
    #[serde(default)]
    pub plunge_from_zero: bool,
}

/// A program being run.
pub trait Interpreter: Send {
    /// Executes one line. Commands are appended to `out`.
    fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step;

    /// Executes lines until the host is needed, the run is over, a stack of moves has ended (see
    /// [`Command::ends_stack`](crate::Command::ends_stack)), or so many lines are done.
    fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step;

    /// Tells that a watched input changed and the machine stopped for it.
    ///
    /// `motion` is the number (as [`Interpreter::motions`] counts) of the motion command that was
    /// interrupted, or of the first one not yet begun; it and all later ones were dropped. `None`
    /// when none was left to do. `position` is where the machine stopped, machine frame.
    fn interrupt(&mut self, watch: &Watch, motion: Option<u64>, position: Axes);

    /// Returns `true` if it carries out stops itself (see [`Interpreter::stopped`]); else whoever runs it
    /// holds the machine and lets it go on.
    fn takes_stops(&self) -> bool {
        false
    }

    /// Tells that a motion or a wait was stopped in the middle and the rest dropped. Only for those
    /// that take stops; what they do about it are the next commands.
    fn stopped(&mut self, _by: StoppedBy, _halted: &Halted) {}

    /// The outputs that its own way back switches on when it is taken up after the power was off there. Only
    /// of those that take stops.
    fn comes_on(&self, _halted: &Halted) -> Vec<u8> {
        Vec::new()
    }

    /// Tells where the machine was when a watched input fired, before the
    /// [`interrupt`](Self::interrupt) that follows.
    fn fired(&mut self, _halted: &Halted) {}

    /// Tells that somebody moved the machine by hand while the program asked something.
    fn moved(&mut self, _position: Axes) {}

    /// Tells that the machine, stopped in the middle, was nudged by so much, machine frame: the working
    /// zero and every place that the program knows lie elsewhere, what it calls them stays.
    fn nudge(&mut self, by: Axes);

    /// Tells that all motion up to this number has been carried out.
    fn carried_out(&mut self, motion: u64);

    /// Tells that the operator ended the run.
    fn stop(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step;

    /// Tells that a bound of the machine ended the run (table limits).
    fn limit(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step;

    /// The changes of inputs that the program waits for.
    fn watches(&self) -> Vec<Watch>;

    /// Name of a file of [`At`]; `None` when so many files were not read.
    fn file_name(&self, file: u32) -> Option<Arc<str>>;

    /// Returns the last call of such a file; nothing where no program calls files.
    fn file_call(&self, _file: u32) -> Option<FileCall> {
        None
    }

    /// The open files and the line that runs next in each, outermost first.
    fn call_stack(&self) -> Vec<At>;

    /// Number of the last motion command given, counted from 1.
    fn motions(&self) -> u64;

    /// Lines executed so far.
    fn lines(&self) -> u64;

    /// The settings in force.
    fn settings(&self) -> &Arc<Settings>;

    /// The frames in force.
    fn frame(&self) -> &Frame;

    /// Returns the place to which the program has sent the machine, machine frame.
    fn position(&self) -> Axes;

    /// The user's variables, name and value as people write them, in order of names.
    fn variables(&self) -> Vec<(String, String)>;
}
