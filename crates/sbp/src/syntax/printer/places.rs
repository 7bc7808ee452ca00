//! The place of the machine, and which values of it were written.

use super::printing::Printing;
use kerf_program::settings::AxisUnit;
use kerf_program::{AXES, Axes, Axis, Command, Frame, Settings, decimal, length_places};
use std::fmt::Write as _;
use std::sync::Arc;

/// Decimals of an angle.
const DEGREE_PLACES: usize = 7;

/// The place as a reader of the file knows it.
#[derive(Debug)]
pub(super) struct Places {
    settings: Arc<Settings>,
    unit_mm: f64,
    places: usize,
    pub(super) frame: Frame,
    pub(super) position: Axes,
    /// The values as they were last written, so that none is repeated.
    written: [Option<String>; AXES],
    /// The change of tools may have left the tool higher than the program knows.
    pub(super) raised: bool,
}

impl Places {
    pub(super) fn new(printing: &Printing) -> Self {
        Self {
            settings: printing.settings.clone(),
            unit_mm: printing.unit.mm(),
            places: length_places(printing.unit),
            frame: printing.frame,
            position: printing.position,
            written: Default::default(),
            raised: false,
        }
    }

    /// A length in the unit of the file.
    pub(super) fn length(&self, mm: f64) -> String {
        decimal(mm / self.unit_mm, self.places)
    }

    /// A value of an axis in its unit.
    pub(super) fn value(&self, axis: Axis, internal: f64) -> String {
        if axis.index() < 3 {
            return self.length(internal);
        }
        let places = match self.settings.axis_unit(axis) {
            AxisUnit::Linear(unit) => length_places(unit),
            AxisUnit::Degrees => DEGREE_PLACES,
        };
        decimal(internal / self.settings.axis_scale(axis), places)
    }

    /// A place as working values.
    pub(super) fn values(&self, place: Axes) -> [String; AXES] {
        let working = self.frame.working(place);
        Axis::ALL.map(|axis| self.value(axis, working[axis]))
    }

    /// The values of the axes that a move to a place has to name.
    pub(super) fn changes(&mut self, to: Axes) -> [Option<String>; AXES] {
        let (there, here) = (self.values(to), self.values(self.position));
        let mut named: [Option<String>; AXES] = Default::default();
        for (i, value) in there.into_iter().enumerate() {
            let known = self.written[i].as_ref() == Some(&value);
            let still = self.written[i].is_none() && value == here[i] && !(self.raised && i == 2);
            if !known && !still {
                self.written[i] = Some(value.clone());
                named[i] = Some(value);
            }
        }
        named
    }

    /// Counts values as written.
    pub(super) fn wrote(&mut self, axis: Axis, value: String) {
        self.written[axis.index()] = Some(value);
    }

    /// Moves the zero of an axis, and tells how far table base is ahead of it, with its sign.
    pub(super) fn zero_at(&mut self, axis: Axis, frame: &Frame) -> String {
        self.frame.working_zero[axis] = frame.working_zero[axis];
        self.written[axis.index()] = None;
        let ahead = self.value(axis, self.frame.base_zero[axis] - frame.working_zero[axis]);
        if ahead.starts_with('-') { ahead } else { format!("+{ahead}") }
    }

    /// The owner's file ran: the tool may be at its safe height.
    pub(super) fn changed_tool(&mut self) {
        self.raised = true;
        self.written[Axis::Z.index()] = None;
    }

    /// Follows a command that is not written.
    pub(super) fn follow(&mut self, command: &Command) {
        match command {
            Command::Line(line) => self.position = line.to,
            Command::Arc(arc) => self.position = arc.to,
            Command::Location { frame, .. } => self.frame = *frame,
            _ => {}
        }
    }
}

/// A command and its values, empty ones at the end left out.
pub(super) fn fields(command: &str, values: &[Option<String>]) -> String {
    let count = values.iter().rposition(Option::is_some).map_or(0, |last| last + 1);
    let mut text = String::from(command);
    for value in &values[..count] {
        let _ = write!(text, ",{}", value.as_deref().unwrap_or_default());
    }
    text
}
