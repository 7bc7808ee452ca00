//! SP and SM: commands that are only drawn, and the way back.
//!
//! A preview moves nothing: SM brings back the frames and the place. What was set meanwhile stays, as whoever sets up a
//! machine in preview wants it (readings, A-127); a file that is only looked at sets nothing.

use super::{BeforePreview, Context};
use kerf_program::settings::Mode;
use kerf_program::{Axis, AxisSet, Command};

/// SP outside preview.
pub(crate) fn enter_preview(c: &mut Context<'_>) {
    let core = &mut *c.core;
    core.place.before_preview = Some(Box::new(BeforePreview {
        frame: core.place.frame,
        position: core.place.position,
        offset_applied: core.place.offset_applied,
    }));
    c.change_settings(|s| s.mode = Mode::Preview);
    if !c.settings().view.start_actual {
        for axis in [Axis::X, Axis::Y] {
            c.core.place.position[axis] = c.core.place.frame.working_zero[axis];
            c.core.place.offset_applied[axis] = 0.0;
        }
    }
}

/// SM.
pub(crate) fn leave_preview(c: &mut Context<'_>) {
    let Some(before) = c.core.place.before_preview.take() else {
        return c.change_settings(|s| s.mode = Mode::Move);
    };
    c.core.place.frame = before.frame;
    c.core.place.position = before.position;
    c.core.place.offset_applied = before.offset_applied;
    c.change_settings(|s| s.mode = Mode::Move);
    c.core.refresh_scale();
    c.location_changed(AxisSet::first(6), AxisSet::first(6));
}

/// The file that the operator looks at is over: what it set is not the machine's.
pub(crate) fn end_look(c: &mut Context<'_>) {
    let Some(settings) = c.core.values.looked_at.take() else { return };
    if c.core.place.before_preview.is_some() && c.core.values.settings != settings {
        c.core.values.settings = settings.clone();
        c.emit(Command::Settings(settings));
    }
}
