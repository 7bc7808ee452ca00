//! Place of the machine, from reports in whatever frame and unit the controller is set to.

use crate::facts::KnownFacts;
use crate::report::{Frame, Report};
use kerf_machine::driver::Axes;

/// Millimetres of an inch.
const INCH_MM: f64 = 25.4;

/// The place that a controller told last.
#[derive(Clone, Copy, Debug, Default)]
pub struct Place {
    machine: Option<Axes>,
    /// Zero of the workpiece, machine frame; a place of the workpiece is no place without it.
    offset: Option<Axes>,
}

impl Place {
    /// Learns from a report.
    pub fn hear(&mut self, report: &Report, told: &KnownFacts) {
        let offset = report.offset.map(|offset| millimetres(offset, told));
        self.offset = offset.or(self.offset);
        let Some((frame, place)) = report.place else { return };
        let place = millimetres(place, told);
        self.machine = match frame {
            Frame::Machine => Some(place),
            Frame::Work => self.offset.map(|offset| place.plus(offset)),
        }
        .map(|place| on_steps(place, told))
        .or(self.machine);
    }

    /// Returns the place in the machine frame, mm; nothing until it is known.
    pub const fn machine(&self) -> Option<Axes> {
        self.machine
    }
}

/// A place that the controller told, mm.
pub fn millimetres(place: Axes, told: &KnownFacts) -> Axes {
    if told.in_inches() { Axes(place.0.map(|v| v * INCH_MM)) } else { place }
}

/// Tenths of a thousandth of an inch are coarser than a thousandth of a millimetre: the place is on the nearest step.
pub fn on_steps(place: Axes, told: &KnownFacts) -> Axes {
    if !told.in_inches() {
        return place;
    }
    let mut place = place;
    for (axis, at) in place.0.iter_mut().enumerate() {
        let steps = told.steps(axis);
        if steps > 0.0 {
            *at = (*at * steps).round() / steps;
        }
    }
    place
}
