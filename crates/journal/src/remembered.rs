//! Memory of the machine between commands: where it is, what G-code keeps; and, beside the
//! journal, its settings.

use super::progress::{PROGRESS, Reached};
use super::rows::{Rows, Table};
use super::under_way::keep_reached;
use super::{Journal, JournalError, Placed, json, rows};
use crate::Standing;
use kerf_diag::Diagnostic;
use kerf_machine::Configuration;
use kerf_program::{Axis, AxisSet, Settings};
use std::sync::{Arc, MutexGuard, PoisonError};

/// Key of the settings before they had a file of their own.
const SETTINGS: &str = "settings";
const PLACE: &str = "place";
const GCODE: &str = "gcode";
const HOMED: &str = "homed";
const TRUTH: &str = "truth";

/// The texts of what is on record of where the machine stands: place, G-code, progress, homed axes, truth.
pub(super) type OnRecord = [Option<String>; 5];

/// Function that reads settings from the text that sets them, as journals of before kept it.
pub type ReadSettings = fn(&str) -> Result<Settings, Box<Diagnostic>>;

/// Memory of the machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Remembered {
    /// Settings, frames, position.
    pub memory: kerf_sbp::Session,
    /// Configuration of the machine; the settings of V commands are those of `memory`.
    pub machine: Arc<Configuration>,
    /// Memory of G-code.
    pub gcode: kerf_gcode::State,
    /// Certainty of the place that the memory has.
    pub whereabouts: Whereabouts,
    /// Axes that were homed.
    pub homed: AxisSet,
    /// Distances of the simulated machine from where it is believed to be.
    pub truth: Vec<Vec<f64>>,
}

/// Certainty of the place at which the machine is believed to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whereabouts {
    /// It stood there when it was written, and nothing has moved it since.
    Known,
    /// It was moving when the process ended: it is near there.
    Moving,
}

impl Journal {
    /// Reads what the machine remembers; `None` when it has never run.
    ///
    /// # Errors
    /// As the file cannot be read, or a setting in it is no longer allowed.
    pub fn remembered(
        &self,
        read_settings: ReadSettings,
    ) -> Result<Option<Remembered>, JournalError> {
        let standing = self.standing()?;
        let [place, gcode, reached, homed, truth] = standing.clone();
        *self.seen() = Some(standing);
        let (machine, told) = self.machine()?;
        let old = if told { None } else { self.old_settings(read_settings)? };
        if place.is_none() && old.is_none() && !told {
            return Ok(None);
        }
        let settings = old.unwrap_or_else(|| machine.program.clone());
        let place: Option<Placed> = self.parsed(PLACE, place)?;
        let reached: Option<Reached> = self.parsed(PROGRESS, reached)?;
        let moving = reached.as_ref().is_some_and(|reached| reached.moving);
        let Placed { position, frame } = reached.map(|r| r.place).or(place).unwrap_or_default();
        let memory =
            kerf_sbp::Session { settings, frame, position, ..kerf_sbp::Session::default() };
        let whereabouts = if moving { Whereabouts::Moving } else { Whereabouts::Known };
        let gcode = self.parsed(GCODE, gcode)?.unwrap_or_default();
        let truth = self.parsed(TRUTH, truth)?.unwrap_or_default();
        // Whoever does not know where an axis is does not know its home either.
        let homed = homed.filter(|_| !moving).unwrap_or_default();
        let homed = homed.chars().filter_map(Axis::from_letter);
        let homed = homed.fold(AxisSet::EMPTY, AxisSet::with);
        Ok(Some(Remembered { memory, machine, gcode, whereabouts, homed, truth }))
    }

    /// Reads the record of where the machine stands.
    fn standing(&self) -> Result<OnRecord, JournalError> {
        self.read(|rows| {
            let fact = |key| rows.text(Table::Fact, key);
            Ok([fact(PLACE)?, fact(GCODE)?, fact(PROGRESS)?, fact(HOMED)?, fact(TRUTH)?])
        })
    }

    /// Tells whether another process has had the machine since this one knew where it stands.
    pub fn another_had_it(&self) -> Result<bool, JournalError> {
        let standing = self.standing()?;
        Ok(self.seen().as_ref().is_some_and(|seen| *seen != standing))
    }

    /// This process leaves the machine as it is on record now. Where that cannot be read, nobody else has changed it.
    pub(super) fn has_seen(&self) {
        if let Ok(standing) = self.standing() {
            *self.seen() = Some(standing);
        }
    }

    fn seen(&self) -> MutexGuard<'_, Option<OnRecord>> {
        self.seen.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Keeps what the machine remembers.
    ///
    /// # Errors
    /// As the file cannot be written.
    pub fn remember(
        &self,
        memory: &kerf_sbp::Session,
        gcode: &kerf_gcode::State,
    ) -> Result<(), JournalError> {
        self.keep_settings(None, &memory.settings)?;
        self.write(|rows| remember(rows, memory, gcode))
    }

    /// The machine is about to be moved by hand. Until that is over it is near where it stands now; a run
    /// that was cut short can still be taken up afterwards.
    pub fn begin_by_hand(&self, standing: &Standing<'_>) -> Result<(), JournalError> {
        let earlier = self.cut_short()?;
        let place = standing.place();
        let reached = Reached { moving: true, place, ..Reached::default() };
        self.write(|rows| {
            keep_reached(rows, earlier.as_ref())?;
            rows.put(Table::Fact, PROGRESS, &json(&reached)?)
        })
    }

    /// It was moved by hand: where it is, and all that belongs to it. What a run that was cut short knew
    /// of that holds no longer.
    pub fn end_by_hand(&self, standing: &Standing<'_>) -> Result<(), JournalError> {
        let earlier = self.cut_short()?;
        self.write(|rows| {
            keep_reached(rows, earlier.as_ref())?;
            remember(rows, standing.memory, standing.gcode)?;
            remember_homed(rows, standing)?;
            rows.set(Table::Fact, PROGRESS, None)
        })
    }

    /// A journal of before has settings in it: they move into their own file.
    pub fn move_settings(&self, read_settings: ReadSettings) -> Result<(), JournalError> {
        let Some(old) = self.old_settings(read_settings)? else { return Ok(()) };
        if !self.machine()?.1 {
            self.keep_settings(None, &old)?;
        }
        self.write(|rows| rows.set(Table::Fact, SETTINGS, None))
    }

    fn old_settings(&self, read_settings: ReadSettings) -> Result<Option<Settings>, JournalError> {
        let text = self.read(|rows| rows.text(Table::Fact, SETTINGS))?;
        let read = text.map(|text| read_settings(&text)).transpose();
        read.map_err(|error| JournalError::Settings(error.message.clone()))
    }

    pub(super) fn parsed<T: serde::de::DeserializeOwned>(
        &self,
        name: &str,
        text: Option<String>,
    ) -> Result<Option<T>, JournalError> {
        let parse = |text: String| serde_json::from_str(&text);
        let damaged = |error| rows::Trouble::Damaged(format!("{name}: {error}"));
        text.map(parse).transpose().map_err(|error| self.located(damaged(error)))
    }
}

/// Which axes are homed, and what only the simulated machine knows.
pub(super) fn remember_homed(rows: &Rows<'_>, standing: &Standing<'_>) -> rows::Result<()> {
    let homed: String = standing.homed.iter().map(Axis::letter).collect();
    rows.put(Table::Fact, HOMED, homed.as_bytes())?;
    match &standing.truth {
        Some(truth) => rows.put(Table::Fact, TRUTH, &json(truth)?),
        None => Ok(()),
    }
}

/// Of a preview that was not left, what was before it is kept.
pub(super) fn remember(
    rows: &Rows<'_>,
    memory: &kerf_sbp::Session,
    gcode: &kerf_gcode::State,
) -> rows::Result<()> {
    let (frame, position) = match &memory.before_preview {
        Some(before) => (before.frame, before.position),
        None => (memory.frame, memory.position),
    };
    rows.put(Table::Fact, PLACE, &json(&Placed { position, frame })?)?;
    rows.put(Table::Fact, GCODE, &json(gcode)?)
}
