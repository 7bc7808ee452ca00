//! The place to which the program has sent the tool.

use super::compensation::Compensator;
use super::stop::{Refused, fail};
use kerf_diag::Code;
use kerf_program::Axes;
use serde::{Deserialize, Serialize};

/// The place on the programmed path, and that of the tool beside it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct PathPosition {
    /// Place to which the program has sent the machine, machine frame; with compensation the place on
    /// the programmed path.
    pub(super) programmed: Axes,
    /// Place at which G40 left the tool, until the next move brings it to the path.
    pub(super) beside: Option<Axes>,
    pub(super) compensator: Option<Compensator>,
}

impl PathPosition {
    pub(super) const fn at(position: Axes) -> Self {
        Self { programmed: position, beside: None, compensator: None }
    }

    /// Returns the place to which the tool has been sent.
    pub(super) fn tool(&self) -> Axes {
        let beside = self.beside.unwrap_or(self.programmed);
        self.compensator.as_ref().map_or(beside, Compensator::tool)
    }

    /// The tool went to a place of the path.
    pub(super) const fn arrive(&mut self, to: Axes) {
        self.programmed = to;
        self.beside = None;
    }

    /// Goes on from where the tool really is, without compensation.
    pub(super) fn abandon(&mut self) {
        *self = Self::at(self.tool());
    }

    /// The workpiece lies elsewhere by so much, machine frame.
    pub(super) fn nudge(&mut self, by: Axes) {
        self.programmed = self.programmed.plus(by);
        self.beside = self.beside.map(|place| place.plus(by));
        self.compensator.iter_mut().for_each(|c| c.nudge(by));
    }

    /// Refuses something that compensation does not allow.
    pub(super) fn need_uncompensated(&self, what: &str) -> Result<(), Refused> {
        if self.compensator.is_none() {
            return Ok(());
        }
        let message = format!("{what} while cutter compensation is on");
        Err(fail(Code::Compensation, message, "write G40 before it"))
    }

    /// Refuses a curve while the tool is still beside the path.
    pub(super) fn need_on_path(&self) -> Result<(), Refused> {
        if self.beside.is_none() {
            return Ok(());
        }
        let message = "the first move after G40 is no straight one";
        Err(fail(Code::Compensation, message, "lead the tool off the path by G0 or G1"))
    }
}
