//! The state and options from which a run starts, and the state that stays after it.

use super::state::State;
use crate::syntax::dialect::Dialect;
use kerf_program::{Axes, Frame, GoTo, Settings};
use serde::{Deserialize, Serialize};

/// The state of the machine's memory between runs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Session {
    /// The settings.
    pub settings: Settings,
    /// The frames. The working zero is the one of the coordinate system in force: where another
    /// language moved it, the system's offset follows.
    pub frame: Frame,
    /// Place of the machine, machine frame.
    pub position: Axes,
    /// State of G-code alone: offsets, parameters, tools, modes.
    pub state: State,
}

/// Options with which a program is run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Options {
    /// Which reading of the language.
    pub dialect: Dialect,
    /// Bound on executed lines; 0 is none.
    pub max_lines: u64,
    /// Errors found while running are told as diagnostics, and the run goes on in the next line.
    pub keep_going: bool,
    /// This run is a preview: a probe that meets nothing counts as meeting it at its end.
    pub preview: bool,
    /// Lines that begin with `/` are left out (of this level and below; 0 runs them all).
    pub block_delete: u8,
    /// M1 stops.
    pub optional_stop: bool,
    /// Lines that count as executed before the first.
    pub lines_before: u64,
    /// The unit at the start is the right one: no doubt is told where the program does not say it.
    pub unit_known: bool,
    /// A cut without F goes at the move speeds of the settings, as in OpenSBP, with a warning: for lines
    /// that stand among OpenSBP and for files that become OpenSBP. Elsewhere it is an error.
    #[serde(default)]
    pub speeds_known: bool,
    /// The operator is asked before the spindle starts, unless it counts as active.
    pub ask_spindle: bool,
    /// Whoever owns the run changes the tool at M6 (`tool_due`).
    #[serde(default)]
    pub changes_elsewhere: bool,
    /// Modes of the state hold from the start, as for lines typed one by one; otherwise a program
    /// begins with the usual ones.
    pub keep_modes: bool,
    /// M4 drives a laser whose power follows the speed (grbl's laser mode).
    pub laser: bool,
    /// Comments become messages.
    pub comments: bool,
    /// The output that follows the spindle, for machines that switch it so; 0 for none.
    pub spindle_output: u8,
    /// The input that a probe is wired to.
    pub probe_input: u8,
    /// Only the path counts, as for a drawing: cycles of drilling, dwells, changes of tools, spindle and
    /// coolant do nothing.
    #[serde(default)]
    pub path_only: bool,
    /// Largest distance of chords from a curve that is no circle in XY, mm.
    pub tolerance_mm: f64,
    /// Factors by which X, Y and Z of the file are multiplied (FP).
    pub proportion: [f64; 3],
    /// Working location that is zero for the file, mm (FP).
    pub temporary_zero_mm: [f64; 3],
    /// The operator is asked before each line (FG).
    #[serde(default)]
    pub stepped: bool,
    /// Start of the program; its first line when nothing is given.
    #[serde(default)]
    pub from: Option<GoTo>,
}

impl Options {
    /// Returns `true` if the proportions turn the plane over: left is right then, and clockwise the other way.
    pub(super) fn mirrors(&self) -> bool {
        self.proportion[0] * self.proportion[1] < 0.0
    }

    /// Returns `true` if a circle in XY stays one.
    pub(super) fn keeps_circles(&self) -> bool {
        self.proportion[0].abs() == self.proportion[1].abs()
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            dialect: Dialect::LinuxCnc,
            max_lines: 50_000_000,
            keep_going: false,
            preview: false,
            block_delete: 0,
            optional_stop: false,
            lines_before: 0,
            unit_known: false,
            speeds_known: false,
            ask_spindle: false,
            changes_elsewhere: false,
            keep_modes: false,
            laser: false,
            comments: true,
            spindle_output: 1,
            probe_input: 1,
            path_only: false,
            tolerance_mm: 0.005,
            proportion: [1.0; 3],
            temporary_zero_mm: [0.0; 3],
            stepped: false,
            from: None,
        }
    }
}
