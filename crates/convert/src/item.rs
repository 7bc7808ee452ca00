//! The items that a program came to while it was followed.

use kerf_diag::Diagnostic;
use kerf_program::settings::LinearUnit;
use kerf_program::{At, Axes, Axis, AxisSet, Command, Hold, Lost, Settings, Sourced, Status};
use std::sync::Arc;

/// A thing to write.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// A command.
    Command(Sourced),
    /// The comment behind the code of a line; it belongs to the commands that come next.
    Beside(Arc<str>),
    /// A place where the operator goes on.
    Hold(Hold),
    /// The tool that the change that just began puts in.
    NextTool(String),
    /// Something that only the run knew.
    Lost(Lost),
}

/// A program followed to its end.
#[derive(Debug, Default)]
pub struct Passage {
    /// Place where it began, machine frame.
    pub start: Axes,
    /// Items of what it does, in order.
    pub items: Vec<Item>,
    /// Status at the end; nothing when it was not even begun.
    pub status: Option<Status>,
    /// Diagnostics that were found on the way.
    pub diagnostics: Vec<Diagnostic>,
    /// Names of the files that places speak of.
    pub files: Vec<Arc<str>>,
    /// Of each change of zero, in order, its line and the axes whose zero comes to lie at a place of the machine while the
    /// program has not said yet where the tool is.
    pub zeros: Vec<(At, AxisSet)>,
    /// The unit and the settings in force where it first moved.
    pub at_motion: Option<(LinearUnit, Arc<Settings>)>,
}

impl Passage {
    /// Its commands.
    pub fn commands(&self) -> impl Iterator<Item = &Sourced> {
        self.items.iter().filter_map(|item| match item {
            Item::Command(sourced) => Some(sourced),
            _ => None,
        })
    }

    /// The name of the file of a place.
    pub fn file(&self, at: At) -> Arc<str> {
        self.files.get(at.file as usize).cloned().unwrap_or_default()
    }

    /// The last axis that moves.
    pub fn last_axis(&self) -> Option<Axis> {
        let ends = self.commands().filter_map(|s| match &s.command {
            Command::Line(line) => Some(line.to),
            Command::Arc(arc) => Some(arc.to),
            _ => None,
        });
        let moved = |to: Axes| Axis::ALL.into_iter().rev().find(|a| to[*a] != self.start[*a]);
        ends.filter_map(moved).max()
    }
}
