//! G-code within a run of OpenSBP: where it is due, and what it leaves behind.
//!
//! This crate does not know G-code. Where a line or a file of it comes, the run stands still until
//! whoever owns both languages has carried it out:
//!
//! ```text
//!  step … gcode_due() ──► (the other interpreter runs) ──► gcode_done(after) ──► step …
//! ```

use super::state::Level;
use super::{Context, Core, Interpreter, lifecycle, programs};
use crate::tree::Span;
use kerf_diag::SourcePlace;
use kerf_program::{At, Axes, Axis, Frame, GoTo, Host, Sourced, Step, ToolTable};
use std::sync::Arc;

/// G-code that has to run before the program goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum GcodeDue {
    /// The innermost file, by its number in [`At`].
    File(u32),
    /// One line of a file.
    Line(At),
}

/// Placement of what is in the file at hand (FP).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilePlace {
    /// Proportions of X, Y and Z, those of its callers included.
    pub proportion: [f64; 3],
    /// Working location that counts as zero in the file, mm.
    pub zero_mm: [f64; 3],
    /// Tabs are wanted in it, this time.
    pub tabs: bool,
    /// The operator is asked before each line (FG).
    pub stepped: bool,
    /// Start of the file, this time.
    pub from: Option<GoTo>,
}

impl Default for FilePlace {
    fn default() -> Self {
        Self { proportion: [1.0; 3], zero_mm: [0.0; 3], tabs: false, stepped: false, from: None }
    }
}

impl FilePlace {
    fn of(level: &Level) -> Self {
        let first = level.repetitions_left + 1 >= level.parameters.repetitions;
        Self {
            proportion: level.proportion,
            zero_mm: level.offset,
            tabs: level.tabs_hold(),
            stepped: level.stepped,
            from: level.parameters.from.filter(|_| first),
        }
    }
}

/// State that G-code left behind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GcodeDone {
    /// Place to which it has sent the machine, machine frame.
    pub position: Axes,
    /// The frames in force.
    pub frame: Frame,
    /// Motion commands it gave.
    pub motions: u64,
    /// Lines it executed.
    pub lines: u64,
    /// It ended the file that its line stands in (M2, M30).
    pub ended: bool,
    /// The operator let a file that was stepped through run on.
    pub runs_on: bool,
}

impl Core {
    /// The G-code that is due now; none while something else comes first.
    pub(super) fn gcode_due(&self) -> Option<GcodeDue> {
        let other = !self.flow.started || self.handlers.pausing || !self.handlers.fired.is_empty();
        if other || !self.place.adrift.is_empty() {
            return None;
        }
        if let Some(at) = self.flow.gcode_line {
            return Some(GcodeDue::Line(at));
        }
        let level = self.flow.levels.last()?;
        let due = level.next == 0 && self.files.is_gcode(level);
        due.then_some(GcodeDue::File(level.file))
    }

    /// M2 or M30 in a line: the file that it stands in is over.
    fn end_file_at(&mut self, at: At) {
        let lines = self.files.programs.get(at.file as usize).map_or(0, |p| p.lines.len());
        if let Some(level) = self.flow.levels.last_mut().filter(|l| l.file == at.file) {
            level.next = lines as u32;
        }
    }

    /// The machine stands where G-code has left it.
    fn gcode_stands(&mut self, done: &GcodeDone) {
        for axis in Axis::ALL {
            if self.place.position[axis] != done.position[axis] {
                self.place.position[axis] = done.position[axis];
                self.place.offset_applied[axis] = 0.0;
            }
        }
        self.place.frame = done.frame;
        self.given.settled = false;
    }

    fn gcode_done(&mut self, due: GcodeDue, done: &GcodeDone) {
        self.gcode_stands(done);
        self.given.motions += done.motions;
        self.given.lines += if matches!(due, GcodeDue::File(_)) { done.lines } else { 0 };
        self.flow.gcode_line = None;
        if done.runs_on {
            self.flow.run_on();
        }
        if let (GcodeDue::File(_), Some(level)) = (due, self.flow.levels.last_mut()) {
            level.next = 1;
        }
    }
}

impl Interpreter {
    /// The G-code that has to run before the next step; see the head of this file.
    pub fn gcode_due(&self) -> Option<GcodeDue> {
        self.core.gcode_due()
    }

    /// Tells that the G-code that was due is done.
    pub fn gcode_done(&mut self, done: &GcodeDone) {
        let Some(due) = self.core.gcode_due() else { return };
        self.core.gcode_done(due, done);
        self.past.clear();
        if done.ended
            && let GcodeDue::Line(at) = due
        {
            self.core.end_file_at(at);
        }
    }

    /// Begins the change of tools that G-code at hand waits for: runs the owner's file, from where G-code stands.
    pub fn change_tool(
        &mut self,
        tool: u32,
        done: &GcodeDone,
        host: &mut dyn Host,
        out: &mut Vec<Sourced>,
    ) -> Step {
        let Some(due) = self.core.gcode_due() else { return Step::Ran };
        self.core.gcode_stands(done);
        self.past.clear();
        let at = match due {
            GcodeDue::File(file) => At { file, line: 1 },
            GcodeDue::Line(at) => at,
        };
        let program = &self.core.files.program(at.file);
        let core = &mut self.core;
        let mut context = Context { core, program, host, out, at, span: Span::default() };
        let outcome = programs::change_tool(&mut context, tool);
        lifecycle::after(&mut self.core, host, out, outcome)
    }

    /// Returns the tools that are known, and the one in the spindle.
    pub fn tools(&self) -> &ToolTable {
        &self.core.memory.tools
    }

    /// Takes over the tools as whoever owns both languages knows them.
    pub fn use_tools(&mut self, table: ToolTable) {
        if *self.core.memory.tools != table {
            self.core.memory.tools = Arc::new(table);
        }
    }

    /// Returns the placement of what is in the innermost file.
    pub fn file_place(&self) -> FilePlace {
        self.core.flow.level().map(FilePlace::of).unwrap_or_default()
    }

    /// Returns `true` if the program ended with EXIT SHOPBOT: what runs it is to close, too.
    pub const fn closes(&self) -> bool {
        self.core.flow.closes
    }

    /// Returns the number of files that are open within each other.
    pub fn depth(&self) -> usize {
        self.core.flow.levels.len()
    }

    /// The lines that led to the innermost file, innermost first.
    pub fn callers(&self) -> Vec<SourcePlace> {
        self.core.flow.callers(&self.core.files)
    }

    /// Ends the run as an error does: what G-code did cannot go on.
    pub fn abandon(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) {
        self.core.flow.gcode_line = None;
        lifecycle::finish(&mut self.core, host, out);
    }
}
