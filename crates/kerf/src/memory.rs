//! What the machine remembers between commands: the settings file of the data folder.
//!
//! `run` and `send` go on where the last one ended; everything that only looks starts from inches
//! and zeros, so that its answer depends on nothing but the file. `--start` chooses otherwise.

use crate::args::{PlaceArgs, Start};
use anyhow::{Context, Result, anyhow};
use kerf_control::gcode_file::{self, GCODE_FILE};
use kerf_control::settings_file::{self, Restored, SETTINGS_FILE};
use kerf_control::{Session, Shelf};
use kerf_diag::Diagnostic;
use kerf_program::{Axis, Settings};
use kerf_sbp::POSITION_LOST;
use std::sync::Arc;

/// How a command begins, and what it leaves.
pub struct Memory {
    /// It goes on from the settings file.
    kept: bool,
    /// The settings in the file, where options of this command replace them.
    replaced: Option<Settings>,
}

impl Memory {
    /// Puts what is remembered into a session, for a command that usually only `previews`.
    /// Settings that options give hold for this command only; units are such an option too.
    pub fn recall(
        place: &PlaceArgs,
        units_given: bool,
        previews: bool,
        shelf: &mut Shelf,
        session: &mut Session,
    ) -> Result<Self> {
        let usual = if previews { Start::Fresh } else { Start::Kept };
        let kept = place.start.unwrap_or(usual) == Start::Kept;
        let text = if kept { shelf.settings_text().context("settings file")? } else { None };
        if let Some(text) = text {
            let Restored { memory, unverified } =
                settings_file::read(&text).map_err(|error| mend(&error))?;
            if unverified && !previews {
                doubt_position(shelf);
            }
            session.memory = memory;
        }
        let text = if kept { shelf.gcode_text().context("what G-code remembers")? } else { None };
        if let Some(text) = text {
            session.gcode = gcode_file::read(&text).map_err(|error| mend(&error))?;
        }
        let given = place.config.is_some() || units_given;
        let replaced = given.then(|| session.memory.settings.clone());
        Ok(Self { kept, replaced })
    }

    /// Whether a run leaves anything.
    pub const fn keeps(&self) -> bool {
        self.kept
    }

    /// A run begins: should it never end, the next one knows.
    pub fn begin(&self, shelf: &mut Shelf, session: &Session) -> Result<()> {
        self.write(shelf, session, true)
    }

    /// A run is over.
    pub fn end(&self, shelf: &mut Shelf, session: &Session) -> Result<()> {
        shelf.save().context("cannot keep the stored values")?;
        self.write(shelf, session, false)
    }

    fn write(&self, shelf: &mut Shelf, session: &Session, under_way: bool) -> Result<()> {
        if !self.kept {
            return Ok(());
        }
        let mut memory = session.memory.clone();
        if let Some(settings) = &self.replaced {
            memory.settings = settings.clone();
            memory.before_preview.iter_mut().for_each(|b| b.settings = Arc::new(settings.clone()));
        }
        let text = settings_file::write(&memory, under_way);
        shelf.keep_settings(&text).with_context(|| format!("cannot keep {SETTINGS_FILE}"))?;
        match gcode_file::write(&session.gcode) {
            Some(text) => {
                shelf.keep_gcode(&text).with_context(|| format!("cannot keep {GCODE_FILE}"))
            }
            None => Ok(()),
        }
    }
}

/// What to do about a file that cannot be read.
fn mend(error: &Diagnostic) -> anyhow::Error {
    let (place, message) = (&error.place, &error.message);
    anyhow!("{} line {}: {message}; mend it, or remove it", place.file, place.line)
}

/// The machine may stand elsewhere than the file says.
fn doubt_position(shelf: &mut Shelf) {
    let letters: String = Axis::ALL.into_iter().map(Axis::letter).collect();
    shelf.stored.set(POSITION_LOST, Some(&letters));
    eprintln!(
        "kerf: the last run never came to its end; locations are those before it and not verified"
    );
}
