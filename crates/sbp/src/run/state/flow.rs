//! The open part files and the line that runs next in each.

use super::files::Files;
use crate::run::session::FileParameters;
use crate::syntax::Language;
use crate::syntax::tree::Span;
use kerf_diag::SourcePlace;
use kerf_program::{At, Axis, FileCall, GoTo};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Where a run is in its files.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Flow {
    /// Open files, outermost first.
    pub(crate) levels: Vec<Level>,
    /// Last call of each file.
    pub(crate) calls: BTreeMap<u32, FileCall>,
    /// The first file has been opened.
    pub(crate) started: bool,
    /// The operator let the line that is next run, of a file that is stepped through.
    pub(crate) granted: bool,
    /// A line of G-code that has to run before the next step.
    pub(crate) gcode_line: Option<At>,
    /// EXIT SHOPBOT was reached.
    pub(crate) closes: bool,
}

impl Flow {
    /// The innermost open file.
    pub(crate) fn level(&self) -> Option<&Level> {
        self.levels.last()
    }

    /// Chooses the line (by index) that the innermost file goes on at.
    pub(crate) fn go_on_at(&mut self, index: u32) {
        if let Some(level) = self.levels.last_mut() {
            level.next = index;
        }
    }

    /// Proportion of the innermost file for an axis.
    pub(crate) fn proportion(&self, axis: Axis) -> f64 {
        self.level().map_or(1.0, |level| level.proportion(axis))
    }

    /// The innermost file runs on without questions, and so do those that called it.
    pub(crate) fn run_on(&mut self) {
        self.levels.iter_mut().for_each(|level| level.stepped = false);
    }

    /// The lines that called the innermost file, innermost first.
    pub(crate) fn callers(&self, files: &Files) -> Vec<SourcePlace> {
        let place = |level: &Level| Some(files.get(level.file)?.place(level.next, Span::default()));
        self.levels.iter().rev().skip(1).filter_map(place).collect()
    }
}

/// An open part file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Level {
    /// Index of its program.
    pub(crate) file: u32,
    /// Index of the line that runs next.
    pub(crate) next: u32,
    /// Lines to return to, innermost last.
    pub(crate) gosubs: Vec<u32>,
    /// A GOTO was carried out while a GOSUB was open: it may have left it for good.
    #[serde(default)]
    pub(crate) gosub_left: bool,
    /// Proportions of this file and of all that called it.
    pub(crate) proportion: [f64; 3],
    /// Temporary zero, working location in mm.
    pub(crate) offset: [f64; 3],
    /// Its plunge is already multiplied by the caller's Z proportion.
    pub(crate) parameters: FileParameters,
    /// Repetitions still to come after this one.
    pub(crate) repetitions_left: u32,
    /// Z to return to after plunges, machine frame.
    pub(crate) start_z: Option<f64>,
    /// The operator is asked before each line (FG), also in files that it calls.
    #[serde(default)]
    pub(crate) stepped: bool,
    /// Lines before this index are passed over, but for settings and assignments.
    #[serde(default)]
    pub(crate) skip_to: Option<u32>,
    /// The line of G-code that goes on when this file, which changes the tool for it, is over.
    #[serde(default)]
    pub(crate) goes_on: Option<At>,
    /// Tabs hold here (own or inherited), on the last repetition.
    pub(crate) tabs: bool,
    pub(crate) purpose: Purpose,
}

/// Purpose for which a file was opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Purpose {
    /// To be run, by the operator, FP or a custom cut.
    Run,
    /// To change the tool (C9).
    ToolChange,
    /// Only for a subroutine that a handler of ON INPUT called from within a nested file. The
    /// number is the depth at which the file itself is open.
    Handler(usize),
}

impl Level {
    /// Returns `true` if its cuts get tabs now, and those of files it calls.
    pub(crate) fn tabs_hold(&self) -> bool {
        self.tabs && self.repetitions_left == 0
    }

    /// Goes on at another line.
    pub(crate) fn go_to(&mut self, to: GoTo) {
        (self.next, self.skip_to) = to.way_from(self.next);
    }

    /// Returns its proportion for an axis.
    pub(crate) fn proportion(&self, axis: Axis) -> f64 {
        self.proportion.get(axis.index()).copied().unwrap_or(1.0)
    }

    /// Returns its temporary zero for an axis, mm.
    pub(crate) fn offset(&self, axis: Axis) -> f64 {
        self.offset.get(axis.index()).copied().unwrap_or(0.0)
    }

    /// Returns `true` if its lines have to be looked at one by one.
    pub(crate) const fn watched(&self) -> bool {
        self.stepped || self.skip_to.is_some()
    }
}

impl Files {
    /// Returns `true` if a file is G-code.
    pub(crate) fn is_gcode(&self, level: &Level) -> bool {
        self.get(level.file).is_some_and(|p| p.language == Language::Gcode)
    }
}
