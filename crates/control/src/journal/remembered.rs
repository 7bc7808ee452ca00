//! What the machine remembers between commands: settings, where it is, what G-code keeps.

use super::progress::{PROGRESS, Reached};
use super::rows::{Rows, Table};
use super::{Journal, JournalError, Placed, json, rows};
use crate::settings_text;
use kerf_program::Settings;

const SETTINGS: &str = "settings";
const PLACE: &str = "place";
const GCODE: &str = "gcode";

/// What the machine remembers.
#[derive(Clone, Debug, PartialEq)]
pub struct Remembered {
    /// Settings, frames, position.
    pub memory: kerf_sbp::Session,
    /// What G-code remembers.
    pub gcode: kerf_gcode::State,
    /// Whether the machine is where the memory says.
    pub whereabouts: Whereabouts,
}

/// Whether the machine is where it is believed to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whereabouts {
    /// It stood there when it was written, and nothing has moved it since.
    Known,
    /// It was moving when the process ended: it is near there.
    Moving,
}

impl Journal {
    /// What the machine remembers; `None` when it has never run.
    ///
    /// # Errors
    /// As the file cannot be read, or a setting in it is no longer allowed.
    pub fn remembered(&self) -> Result<Option<Remembered>, JournalError> {
        let [settings, place, gcode, reached] = self.read(|rows| {
            let fact = |key| rows.text(Table::Fact, key);
            Ok([fact(SETTINGS)?, fact(PLACE)?, fact(GCODE)?, fact(PROGRESS)?])
        })?;
        let Some(settings) = settings else { return Ok(None) };
        let settings = settings_text::read(&settings)
            .map_err(|error| JournalError::Settings(error.message.clone()))?;
        let place: Option<Placed> = self.parsed(PLACE, place)?;
        let reached: Option<Reached> = self.parsed(PROGRESS, reached)?;
        let moving = reached.as_ref().is_some_and(|reached| reached.moving);
        let Placed { position, frame } = reached.map(|r| r.place).or(place).unwrap_or_default();
        let memory =
            kerf_sbp::Session { settings, frame, position, ..kerf_sbp::Session::default() };
        let whereabouts = if moving { Whereabouts::Moving } else { Whereabouts::Known };
        let gcode = self.parsed(GCODE, gcode)?.unwrap_or_default();
        Ok(Some(Remembered { memory, gcode, whereabouts }))
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
        self.write(|rows| remember(rows, memory, gcode))
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

/// Of a preview that was not left, what was before it is kept.
pub(super) fn remember(
    rows: &Rows<'_>,
    memory: &kerf_sbp::Session,
    gcode: &kerf_gcode::State,
) -> rows::Result<()> {
    let (settings, frame, position): (&Settings, _, _) = match &memory.before_preview {
        Some(before) => (&before.settings, before.frame, before.position),
        None => (&memory.settings, memory.frame, memory.position),
    };
    rows.put(Table::Fact, SETTINGS, settings_text::write(settings).as_bytes())?;
    rows.put(Table::Fact, PLACE, &json(&Placed { position, frame })?)?;
    rows.put(Table::Fact, GCODE, &json(gcode)?)
}
