//! SP and SM: commands that are only drawn, and the way back.
//!
//! A preview moves nothing: SM brings back the frames and the place. What was set meanwhile stays, as whoever sets up a
//! machine in preview wants it (readings, A-127); a file that is only looked at sets nothing.

use super::{BeforePreview, Context};
use kerf_program::settings::Mode;
use kerf_program::{Axis, AxisSet, Command};

impl Context<'_> {
    /// SP outside preview.
    pub(crate) fn enter_preview(&mut self) {
        let core = &mut *self.core;
        core.place.before_preview = Some(Box::new(BeforePreview {
            frame: core.place.frame,
            position: core.place.position,
            offset_applied: core.place.offset_applied,
        }));
        self.change_settings(|s| s.mode = Mode::Preview);
        if !self.settings().view.start_actual {
            for axis in [Axis::X, Axis::Y] {
                self.core.place.position[axis] = self.core.place.frame.working_zero[axis];
                self.core.place.offset_applied[axis] = 0.0;
            }
        }
    }

    /// SM.
    pub(crate) fn leave_preview(&mut self) {
        let Some(before) = self.core.place.before_preview.take() else {
            return self.change_settings(|s| s.mode = Mode::Move);
        };
        self.core.place.frame = before.frame;
        self.core.place.position = before.position;
        self.core.place.offset_applied = before.offset_applied;
        self.change_settings(|s| s.mode = Mode::Move);
        self.core.refresh_scale();
        self.location_changed(AxisSet::first(6), AxisSet::first(6));
    }
    /// The file that the operator looks at is over: what it set is not the machine's.
    pub(crate) fn end_look(&mut self) {
        let Some(settings) = self.core.values.looked_at.take() else { return };
        if self.core.place.before_preview.is_some() && self.core.values.settings != settings {
            self.core.values.settings = settings.clone();
            self.emit(Command::Settings(settings));
        }
    }
}
