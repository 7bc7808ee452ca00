//! SP and SM: commands that are only drawn, and the way back.
//!
//! A preview works on the state as it is and changes nothing of it: SM brings back the settings, the
//! frames and the place. (The notes would keep settings changed in preview, A-127; the readings
//! above them do not.)

use super::{BeforePreview, Context};
use kerf_program::settings::Mode;
use kerf_program::{Axis, AxisSet, Command};

impl Context<'_> {
    /// SP outside preview.
    pub(crate) fn enter_preview(&mut self) {
        let core = &mut *self.core;
        core.before_preview = Some(Box::new(BeforePreview {
            settings: core.settings.clone(),
            kept: core.kept.clone(),
            frame: core.frame,
            position: core.position,
            offset_applied: core.offset_applied,
        }));
        self.change_settings(|s| s.mode = Mode::Preview);
        if !self.settings().view.start_actual {
            for axis in [Axis::X, Axis::Y] {
                self.core.position[axis] = self.core.frame.working_zero[axis];
                self.core.offset_applied[axis] = 0.0;
            }
        }
    }

    /// SM.
    pub(crate) fn leave_preview(&mut self) {
        let Some(before) = self.core.before_preview.take() else {
            return self.change_settings(|s| s.mode = Mode::Move);
        };
        self.core.frame = before.frame;
        self.core.position = before.position;
        self.core.offset_applied = before.offset_applied;
        self.core.kept = before.kept;
        self.core.settings = before.settings;
        self.core.refresh_scale();
        let settings = self.core.settings.clone();
        self.emit(Command::Settings(settings));
        self.location_changed(AxisSet::first(6), AxisSet::first(6));
    }
}
