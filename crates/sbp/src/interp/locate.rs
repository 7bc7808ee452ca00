//! From what a file says to machine positions.
//!
//! ```text
//! absolute: working = file offset + proportion · value        machine = working + working zero
//! relative: working = present location + proportion · value
//! ```
//!
//! The temporary tool offset of VO is added last, to commanded axes only; the part of it that an
//! axis already carries is remembered so that it is never added twice.

use super::{Context, Core};
use kerf_program::settings::Distance;
use kerf_program::{Axes, Axis};

impl Core {
    /// Machine position of one axis when a program gives it a value.
    ///
    /// `value` is in internal units (mm, degrees) before the proportion of the file.
    pub(crate) fn target(&mut self, axis: Axis, value: f64) -> f64 {
        let i = axis.index();
        let (proportion, offset) = self.level().map_or((1.0, 0.0), |l| {
            (l.proportion.get(i).copied().unwrap_or(1.0), l.offset.get(i).copied().unwrap_or(0.0))
        });
        self.target_scaled(axis, value * proportion, offset)
    }

    /// The same with the proportion already applied; `offset` is the file's, in working mm.
    #[inline]
    pub(crate) fn target_scaled(&mut self, axis: Axis, value: f64, offset: f64) -> f64 {
        let shift = self.settings.tool_offset;
        let wanted = if shift.on { shift.offset[axis] } else { 0.0 };
        let free = match self.settings.distance {
            Distance::Absolute => self.frame.working_zero[axis] + offset + value,
            Distance::Relative => self.position[axis] - self.offset_applied[axis] + value,
        };
        self.offset_applied[axis] = wanted;
        free + wanted
    }

    /// Machine position of an absolute place in the file's frame, without the proportion.
    pub(crate) fn file_zero(&self, axis: Axis) -> f64 {
        let offset = self.level().and_then(|l| l.offset.get(axis.index()).copied()).unwrap_or(0.0);
        self.frame.working_zero[axis] + offset
    }
}

impl Context<'_> {
    /// Machine position when the program gives values for some axes.
    pub(crate) fn targets(&mut self, values: impl IntoIterator<Item = (Axis, f64)>) -> Axes {
        let mut to = self.core.position;
        for (axis, value) in values {
            to[axis] = self.core.target(axis, value);
        }
        to
    }

    /// Working zero of an axis was set: the file's temporary zero for it is gone.
    pub(crate) fn cancel_file_offset(&mut self, axis: Axis) {
        for level in &mut self.core.levels {
            if let Some(offset) = level.offset.get_mut(axis.index()) {
                *offset = 0.0;
            }
        }
    }
}
