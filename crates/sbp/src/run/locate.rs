//! From what a file says to machine positions, and what the present place is called.
//!
//! ```text
//! absolute: working = file offset + proportion · value        machine = working + working zero
//! relative: working = present location + proportion · value
//! ```
//!
//! The temporary tool offset of VO is added last, to commanded axes only; the part of it that an
//! axis already carries is remembered so that it is never added twice.
//!
//! **Base coordinates.** The reference calls `%(6)` to `%(10)` and the second five values of VA
//! table base locations. The tool-change files shipped with machines use both as *base minus
//! working*: `JX,&x-%(6)` goes to a place in base coordinates, `VA,,,%(3)+%(8),,,,,0` returns from a
//! tool's own zero to the base. Those files move real machines, so that is what holds, for reading
//! and for setting alike; the dialect strict and [`Options::base_locations`](super::Options) follow
//! the reference. Both agree wherever working is 0.

use super::{Context, Core, registry};
use crate::syntax::Dialect;
use kerf_diag::Code;
use kerf_program::settings::Distance;
use kerf_program::{Axes, Axis, AxisSet};

impl Core {
    /// Machine position of one axis when a program gives it a value.
    ///
    /// `value` is in internal units (mm, degrees) before the proportion of the file.
    pub(crate) fn target(&mut self, axis: Axis, value: f64) -> f64 {
        self.target_scaled(axis, value * self.flow.proportion(axis))
    }

    /// The same with the proportion already applied.
    pub(crate) fn target_scaled(&mut self, axis: Axis, value: f64) -> f64 {
        match self.values.settings.distance {
            Distance::Absolute => self.with_tool_offset(axis, self.file_zero(axis) + value),
            Distance::Relative => self.shifted(axis, value),
        }
    }

    /// Machine position so far from where the axis is.
    pub(crate) fn shifted(&mut self, axis: Axis, distance: f64) -> f64 {
        self.with_tool_offset(axis, self.place.free(axis) + distance)
    }

    /// Machine position for a place that does not contain the tool offset yet.
    pub(crate) fn with_tool_offset(&mut self, axis: Axis, free: f64) -> f64 {
        let shift = self.values.settings.tool_offset;
        let wanted = if shift.on { shift.offset[axis] } else { 0.0 };
        self.place.offset_applied[axis] = wanted;
        free + wanted
    }

    /// Machine position of the file's own zero.
    pub(crate) fn file_zero(&self, axis: Axis) -> f64 {
        let offset = self.flow.level().map_or(0.0, |level| level.offset(axis));
        self.place.frame.working_zero[axis] + offset
    }

    /// Returns the lead of a base coordinate of the program over the base location: see the head of the file.
    fn base_ahead(&self, axis: Axis) -> f64 {
        if self.reads_base() { 0.0 } else { self.place.working()[axis] }
    }

    fn reads_base(&self) -> bool {
        self.options.dialect == Dialect::Strict || self.options.base_locations
    }

    /// Base coordinate of an axis as programs read it, mm or degrees; the axis is so far from where
    /// the program sent it.
    pub(crate) fn base_coordinate(&self, axis: Axis, drift: f64) -> f64 {
        let drift = if self.reads_base() { drift } else { 0.0 };
        self.place.frame.base(self.place.position)[axis] - self.base_ahead(axis) + drift
    }
}

/// Machine position when the program gives values for some axes.
pub(crate) fn targets(c: &mut Context<'_>, values: impl IntoIterator<Item = (Axis, f64)>) -> Axes {
    let mut to = c.core.place.position;
    for (axis, value) in values {
        to[axis] = c.core.target(axis, value);
    }
    to
}

/// Takes over where some axes really are, once the machine is at rest.
pub(crate) fn take_machine_position(c: &mut Context<'_>, axes: AxisSet) {
    c.core.place.take_position(axes, c.host);
}

/// Returns the place of the machine, with the true place of an axis that may have moved by itself. The
/// machine is at rest.
fn real_position(c: &mut Context<'_>, axis: Axis) -> Axes {
    let mut position = c.core.place.position;
    if c.core.wanders(axis) {
        position[axis] = c.host.machine_position()[axis.index()];
    }
    position
}

/// Calls the present place of an axis so, in working locations.
pub(crate) fn set_working(c: &mut Context<'_>, axis: Axis, value: f64) {
    let position = real_position(c, axis);
    match &mut c.core.place.working_aside {
        Some(zero) => zero[axis] = position[axis] - value,
        None => c.core.place.frame.set_working(axis, position, value),
    }
}

/// Gives the present place of an axis the base coordinate that programs read.
pub(crate) fn set_base(c: &mut Context<'_>, axis: Axis, value: f64) {
    let location = value + c.core.base_ahead(axis);
    let position = real_position(c, axis);
    c.core.place.frame.set_base(axis, position, location);
    if c.core.place.working_aside.is_some() {
        c.core.place.frame.working_zero[axis] = c.core.place.frame.base_zero[axis];
    }
}

/// Working and base locations of these axes were set: tells it, and ends the zero that the
/// file has of its own for the working ones (readings, A-85, A-128).
pub(crate) fn location_set(c: &mut Context<'_>, working: AxisSet, base: AxisSet) {
    let mut ended = String::new();
    for axis in working.iter() {
        if c.core.flow.levels.iter().any(|l| l.offset.get(axis.index()).is_some_and(|o| *o != 0.0))
        {
            ended.push(axis.letter());
        }
        for offset in c.core.flow.levels.iter_mut().filter_map(|l| l.offset.get_mut(axis.index())) {
            *offset = 0.0;
        }
    }
    if !ended.is_empty() {
        let message = format!("the offset of the file for {ended} ends here");
        c.warn(Code::Unusual, message, "locations that follow count from the new zero");
    }
    is_certain_of(c, base);
    c.location_changed(working, base);
}

/// Somebody has said where these axes are: their locations count again.
pub(crate) fn is_certain_of(c: &mut Context<'_>, axes: AxisSet) {
    let lost = registry::lost_axes(c.host).iter().filter(|axis| !axes.contains(*axis));
    let lost = lost.fold(AxisSet::EMPTY, AxisSet::with);
    registry::remember_lost(c, lost);
}

/// A move without any location.
pub(crate) fn warn_no_motion(c: &mut Context<'_>) {
    c.warn(Code::NoMotion, "no location is given", "give at least one value");
}

/// SC,0: locations are those of the table base until SC,1 or the end of the run. What is set meanwhile as a working
/// location is one of the working locations that come back.
pub(super) fn use_table_base(c: &mut Context<'_>) {
    let frame = &mut c.core.place.frame;
    c.core.place.working_aside.get_or_insert(frame.working_zero);
    frame.working_zero = frame.base_zero;
    c.location_changed(AxisSet::first(6), AxisSet::EMPTY);
}

/// SC,1: locations are the working ones again.
pub(super) fn use_working_locations(c: &mut Context<'_>) {
    let Some(zero) = c.core.place.working_aside.take() else { return };
    c.core.place.frame.working_zero = zero;
    c.location_changed(AxisSet::first(6), AxisSet::EMPTY);
}
