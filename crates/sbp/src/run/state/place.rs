//! Where the machine has been sent, and what places are called.

use crate::run::session::BeforePreview;
use kerf_program::Axis;
use kerf_program::{AXES, Axes, AxisSet, Frame, Host};
use serde::{Deserialize, Serialize};

/// Place and frames of a run.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct RunPosition {
    pub(crate) frame: Frame,
    /// Place to which the machine has been sent, machine frame.
    pub(crate) position: Axes,
    /// The part of `position` that the tool offset of VO contributes.
    pub(crate) offset_applied: Axes,
    /// Internal units (mm, degrees) of one unit in the file, per axis: unit times proportion.
    pub(crate) scale: [f64; AXES],
    /// Axes that MI keeps moving.
    pub(crate) independent: AxisSet,
    /// Axes that moved by themselves: where they are only the machine knows.
    pub(crate) adrift: AxisSet,
    /// SC,0 of FabMo's dialect: the zero of the working locations, which SC,1 brings back.
    pub(crate) working_aside: Option<Axes>,
    /// In preview mode: what SM returns to.
    pub(crate) before_preview: Option<Box<BeforePreview>>,
}

impl RunPosition {
    /// Working location, mm.
    pub(crate) fn working(&self) -> Axes {
        self.frame.working(self.position)
    }

    /// Returns the place of an axis without the part that the tool offset contributes, machine frame.
    pub(crate) fn free(&self, axis: Axis) -> f64 {
        self.position[axis] - self.offset_applied[axis]
    }

    /// Takes over where axes really are, for those that moved by themselves or by hand.
    pub(crate) fn take_position(&mut self, axes: AxisSet, host: &mut dyn Host) {
        let real = Axes(host.machine_position());
        for axis in axes.iter() {
            // A controller that counts steps is a hair off; that is no motion.
            if (real[axis] - self.position[axis]).abs() > 1e-6 {
                self.position[axis] = real[axis];
                self.offset_applied[axis] = 0.0;
            }
        }
    }

    /// The workpiece lies elsewhere by so much.
    pub(crate) fn nudge(&mut self, by: Axes) {
        self.frame.working_zero = self.frame.working_zero.plus(by);
        self.position = self.position.plus(by);
    }
}
