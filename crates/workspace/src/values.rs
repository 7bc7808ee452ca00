//! Values that the machine itself keeps: which locations are in doubt, the spindle's question, where a job ended.

use crate::Workspace;
use crate::stored::LAST_SHAPE;
use kerf_journal::facts::Fact;
use kerf_program::{Axis, AxisSet};
use kerf_sbp::{POSITION_LOST, SPINDLE_STATUS};

/// The value that says of which axes the location is to be confirmed before anything is cut: letters.
pub const CONFIRM: &str = Fact::ConfirmLocation.key();

impl Workspace {
    /// The machine is a fresh simulated one, not that of the data folder: what is in doubt of either does not
    /// concern the other.
    pub fn has_fresh_machine(&mut self) {
        self.stored.keep_apart(&[POSITION_LOST, CONFIRM]);
    }

    /// Puts the location of these axes in doubt: whoever cuts next is asked to confirm it.
    pub fn doubts_location(&mut self, axes: AxisSet) {
        let letters: String = axes.iter().map(Axis::letter).collect();
        self.set_value(POSITION_LOST, Some(&letters));
        self.set_value(CONFIRM, Some(&letters));
    }

    /// These axes are where they are believed to be: they were homed.
    pub fn trusts_location(&mut self, axes: AxisSet) {
        let doubted = unverified(self).without(axes);
        let letters: String = doubted.iter().map(Axis::letter).collect();
        self.set_value(POSITION_LOST, Some(&*letters).filter(|it| !it.is_empty()));
        confirm(self, axes);
    }

    /// The same known here, and not yet on record: whoever only looks keeps nothing.
    pub fn learns_doubt(&mut self, axes: AxisSet) {
        let letters: String = axes.iter().map(Axis::letter).collect();
        self.stored.learn(POSITION_LOST, Some(&letters));
        self.stored.learn(CONFIRM, Some(&letters));
    }

    /// Which locations are in doubt is on record.
    pub fn keep_doubts(&mut self) {
        self.stored.keep(POSITION_LOST);
        self.stored.keep(CONFIRM);
    }

    /// Kerf starts: whoever starts the spindle next is asked again, whatever was answered before.
    pub fn asks_for_spindle_anew(&mut self) {
        if self.stored.get(SPINDLE_STATUS).is_some_and(|status| status != "0") {
            self.set_value(SPINDLE_STATUS, Some("0"));
        }
    }

    /// The shape of a job at which its last run ended early; 0 before the first.
    pub fn last_shape(&self, job: &str) -> Option<u32> {
        let (shape, name) = self.stored.get(LAST_SHAPE)?.split_once(' ')?;
        shape.parse().ok().filter(|_| name == job)
    }

    /// Keeps at which shape a job ended early; nothing for one that came to its end.
    pub fn keep_last_shape(&mut self, ended: Option<(&str, u32)>) {
        let kept = ended.map(|(job, shape)| format!("{shape} {job}"));
        self.stored.set(LAST_SHAPE, kept.as_deref());
    }
}

/// The axes whose locations are not verified.
pub fn unverified(workspace: &Workspace) -> AxisSet {
    let letters = workspace.stored.get(POSITION_LOST).unwrap_or_default();
    letters.chars().filter_map(Axis::from_letter).fold(AxisSet::EMPTY, AxisSet::with)
}

/// Axes whose location is to be confirmed before anything is cut.
pub fn unconfirmed(workspace: &Workspace) -> AxisSet {
    let letters = workspace.stored.get(CONFIRM).unwrap_or_default();
    letters.chars().filter_map(Axis::from_letter).fold(AxisSet::EMPTY, AxisSet::with)
}

/// The location of these axes is right, or was set.
pub fn confirm(workspace: &mut Workspace, axes: AxisSet) {
    let left: String = unconfirmed(workspace).without(axes).iter().map(Axis::letter).collect();
    workspace.set_value(CONFIRM, Some(&*left).filter(|left| !left.is_empty()));
}
