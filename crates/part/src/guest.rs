//! G-code that runs while OpenSBP stands still.

use crate::files::{Files, translated};
use kerf_program::{At, Axes, Host, Sourced, Step};
use kerf_sbp::{GcodeDone, GcodeDue};
use serde::{Deserialize, Serialize};

/// G-code under way: a file, or the line of a file that is due.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Guest {
    pub(crate) interpreter: kerf_gcode::Interpreter,
    pub(crate) due: GcodeDue,
    /// Number of OpenSBP files that are open around it.
    pub(crate) depth: usize,
    /// The numbers of its files in the table of the run.
    files: Vec<u32>,
    /// Motions and lines that count before it.
    motions: u64,
    lines: u64,
    /// OpenSBP ran since: the machine may be elsewhere.
    pub(crate) stale: bool,
    /// OpenSBP changes the tool for it.
    #[serde(default)]
    changing: bool,
    /// The operator was asked before its first line.
    stepped: bool,
    /// It has given motion that an armed handler may interrupt.
    unsettled: bool,
}

impl Guest {
    pub(crate) fn new(
        interpreter: kerf_gcode::Interpreter,
        due: GcodeDue,
        depth: usize,
        file: u32,
    ) -> Self {
        let (motions, lines) = (interpreter.motions(), interpreter.lines());
        let (files, stepped) = (vec![file], interpreter.is_stepped());
        let (stale, changing, unsettled) = (false, false, true);
        Self { interpreter, due, depth, files, motions, lines, stale, changing, stepped, unsettled }
    }

    /// Runs some lines. While an input may interrupt (`watched`) the machine makes each line before
    /// the next is read: what is interrupted is always the present line.
    pub(crate) fn run(
        &mut self,
        host: &mut dyn Host,
        out: &mut Vec<Sourced>,
        lines: u64,
        watched: bool,
        files: &mut Files,
    ) -> Step {
        if watched && self.unsettled {
            if host.settle().is_pending() {
                return Step::Waiting;
            }
            self.unsettled = false;
        }
        let (given, before) = (out.len(), self.interpreter.motions());
        let step = if watched {
            self.interpreter.step(host, out)
        } else {
            self.interpreter.run(host, out, lines)
        };
        self.unsettled |= self.interpreter.motions() > before;
        files.learn_gcode(&mut self.files, &self.interpreter);
        for sourced in &mut out[given..] {
            sourced.at = translated(&self.files, sourced.at);
        }
        step
    }

    /// Motion commands that it gave.
    pub(crate) fn motions(&self) -> u64 {
        self.interpreter.motions() - self.motions
    }

    /// Lines that it executed.
    pub(crate) fn lines(&self) -> u64 {
        self.interpreter.lines() - self.lines
    }

    /// The files it has open, outermost first.
    pub(crate) fn call_stack(&self) -> impl Iterator<Item = At> {
        self.interpreter.call_stack().map(|at| translated(&self.files, at))
    }

    /// Takes over where OpenSBP left the machine, if it ran since.
    pub(crate) fn catch_up(&mut self, sbp: &kerf_sbp::Interpreter) {
        if std::mem::take(&mut self.stale) {
            self.interpreter.adopt(sbp.settings(), sbp.frame(), sbp.position());
            self.interpreter.use_tools(sbp.tools());
        }
    }

    /// Has OpenSBP change the tool that it waits for, and goes on when that is done; nothing where it waits for none.
    pub(crate) fn changes_tool(
        &mut self,
        sbp: &mut kerf_sbp::Interpreter,
        host: &mut dyn Host,
        out: &mut Vec<Sourced>,
    ) -> Option<Step> {
        let tool = self.interpreter.tool_due()?;
        if self.changing {
            self.changing = false;
            self.interpreter.tool_is_in();
            return None;
        }
        sbp.use_tools(self.interpreter.state().tool_table());
        let step = sbp.change_tool(tool, &self.done(), host, out);
        self.changing = step == Step::Ran;
        Some(step)
    }

    /// The machine stopped for a handler of OpenSBP.
    pub(crate) fn interrupted(&mut self, position: Axes) {
        let (settings, frame) = (self.interpreter.settings().clone(), *self.interpreter.frame());
        self.interpreter.adopt(&settings, &frame, position);
        (self.stale, self.unsettled) = (true, false);
    }

    /// Returns what it leaves behind.
    pub(crate) fn done(&self) -> GcodeDone {
        GcodeDone {
            position: self.interpreter.position(),
            frame: *self.interpreter.frame(),
            motions: self.motions(),
            lines: self.lines(),
            ended: self.interpreter.is_over(),
            runs_on: self.stepped && !self.interpreter.is_stepped(),
        }
    }
}
