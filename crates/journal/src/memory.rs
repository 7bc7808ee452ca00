//! Memory of the machine between commands: where it is, what G-code keeps; and, beside the
//! journal, its settings.

use super::reached::{PROGRESS, Reached};
use super::rows::{self, Rows, Table, json};
use super::store::Store;
use super::{JournalError, MachineSettings, Placed, RestingMachine};
use kerf_diag::Diagnostic;
use kerf_machine::Configuration;
use kerf_program::{Axis, AxisSet, Settings};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Key of the settings before they had a file of their own.
const SETTINGS: &str = "settings";
const PLACE: &str = "place";
const GCODE: &str = "gcode";
const HOMED: &str = "homed";
const TRUTH: &str = "truth";

/// The texts of what is on record of where the machine stands: place, G-code, progress, homed axes, truth.
type OnRecord = [Option<String>; 5];

/// Function that reads settings from the text that sets them, as journals of before kept it.
pub type ReadSettings = fn(&str) -> Result<Settings, Box<Diagnostic>>;

/// Memory of the machine as it is on record.
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

/// Memory of the machine between commands. Clones are the same memory.
#[derive(Clone, Debug)]
pub struct Memory {
    store: Arc<Store>,
    settings: MachineSettings,
    /// Record of where the machine stands, as it was read last or left by this process.
    seen: Arc<Mutex<Option<OnRecord>>>,
}

impl Memory {
    pub(super) fn new(store: Arc<Store>, settings: MachineSettings) -> Self {
        Self { store, settings, seen: Arc::default() }
    }

    /// Reads what the machine remembers; `None` when it has never run.
    ///
    /// # Errors
    /// If the file cannot be read, or a setting in it is no longer allowed.
    pub fn read(&self, read_settings: ReadSettings) -> Result<Option<Remembered>, JournalError> {
        let standing = self.standing()?;
        let [place, gcode, reached, homed, truth] = standing.clone();
        *self.seen() = Some(standing);
        let (machine, told) = self.settings.machine()?;
        let old = if told { None } else { self.old_settings(read_settings)? };
        if place.is_none() && old.is_none() && !told {
            return Ok(None);
        }
        let settings = old.unwrap_or_else(|| machine.program.clone());
        let place: Option<Placed> = self.store.parsed(PLACE, place)?;
        let reached: Option<Reached> = self.store.parsed(PROGRESS, reached)?;
        let moving = reached.as_ref().is_some_and(|reached| reached.moving);
        let Placed { position, frame } = reached.map(|r| r.place).or(place).unwrap_or_default();
        let memory =
            kerf_sbp::Session { settings, frame, position, ..kerf_sbp::Session::default() };
        let whereabouts = if moving { Whereabouts::Moving } else { Whereabouts::Known };
        let gcode = self.store.parsed(GCODE, gcode)?.unwrap_or_default();
        let truth = self.store.parsed(TRUTH, truth)?.unwrap_or_default();
        // Whoever does not know where an axis is does not know its home either.
        let homed = homed.filter(|_| !moving).unwrap_or_default();
        let homed = homed.chars().filter_map(Axis::from_letter);
        let homed = homed.fold(AxisSet::EMPTY, AxisSet::with);
        Ok(Some(Remembered { memory, machine, gcode, whereabouts, homed, truth }))
    }

    /// Reads the record of where the machine stands.
    fn standing(&self) -> Result<OnRecord, JournalError> {
        self.store.read(|rows| {
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
    /// If the file cannot be written.
    pub fn keep(
        &self,
        memory: &kerf_sbp::Session,
        gcode: &kerf_gcode::State,
    ) -> Result<(), JournalError> {
        self.settings.keep(None, &memory.settings)?;
        self.store.write(|rows| remember(rows, memory, gcode))
    }

    /// A journal of before has settings in it: they move into their own file.
    pub fn move_settings(&self, read_settings: ReadSettings) -> Result<(), JournalError> {
        let Some(old) = self.old_settings(read_settings)? else { return Ok(()) };
        if !self.settings.machine()?.1 {
            self.settings.keep(None, &old)?;
        }
        self.store.write(|rows| rows.set(Table::Fact, SETTINGS, None))
    }

    fn old_settings(&self, read_settings: ReadSettings) -> Result<Option<Settings>, JournalError> {
        let text = self.store.read(|rows| rows.text(Table::Fact, SETTINGS))?;
        let read = text.map(|text| read_settings(&text)).transpose();
        read.map_err(|error| JournalError::Settings(error.message.clone()))
    }
}

/// Writes the axes that are homed, and what only the simulated machine knows.
pub(super) fn remember_homed(rows: &Rows<'_>, standing: &RestingMachine<'_>) -> rows::Result<()> {
    let homed: String = standing.homed.iter().map(Axis::letter).collect();
    rows.put(Table::Fact, HOMED, homed.as_bytes())?;
    match &standing.truth {
        Some(truth) => rows.put(Table::Fact, TRUTH, &json(truth)?),
        None => Ok(()),
    }
}

/// Writes place and state of G-code. Where Preview (SP) was not left, the place before it is written.
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
