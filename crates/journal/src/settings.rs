//! The settings beside the journal: `machine.toml` leads, sessions follow.
//!
//! ```text
//!   machine.toml ──► session at the start of each run: what somebody changed since
//!        ▲              │
//!        └──────────────┘ at its end: what V commands changed
//! ```

use super::{Journal, JournalError};
use crate::machine_file::{MachineFile, MachineFileError};
use kerf_machine::{Configuration, table};
use kerf_program::Settings;
use std::sync::{Arc, MutexGuard, PoisonError};

/// State of the file when it was looked at last.
#[derive(Debug, Default)]
pub(super) struct Known {
    /// Another file than that of the data folder.
    file: Option<MachineFile>,
    text: Option<String>,
    machine: Arc<Configuration>,
}

impl Journal {
    /// The file of the machine's settings.
    pub fn machine_file(&self) -> MachineFile {
        let other = self.known().file.clone();
        other.unwrap_or_else(|| MachineFile::of_data(&self.folder).known_to(self))
    }

    /// From here on another file leads.
    pub fn use_machine_file(&self, file: MachineFile) {
        *self.known() = Known { file: Some(file), ..Known::default() };
    }

    /// The machine that the file describes now; whether there is a file.
    pub(super) fn machine(&self) -> Result<(Arc<Configuration>, bool), JournalError> {
        let file = self.machine_file();
        let text = file.text().map_err(unusable)?;
        let there = text.is_some();
        let mut known = self.known();
        if text != known.text {
            let machine = file.read(text.as_deref().unwrap_or_default()).map_err(unusable)?;
            (known.text, known.machine) = (text, Arc::new(machine));
        }
        Ok((known.machine.clone(), there))
    }

    /// Brings a configuration up to date with what somebody changed in the file since it was looked at last; nothing
    /// where nobody changed anything.
    ///
    /// # Errors
    /// The mistakes of the file: with those nothing may move.
    pub fn refreshed(
        &self,
        mut mine: Configuration,
    ) -> Result<Option<Configuration>, JournalError> {
        let before = self.known().machine.clone();
        let (now, _) = self.machine()?;
        if Arc::ptr_eq(&before, &now) {
            return Ok(None);
        }
        for setting in table::changed(&before, &now) {
            // What the file has was checked when it was read.
            drop(setting.set(&mut mine, &setting.get(&now)));
        }
        Ok(Some(mine))
    }

    /// Writes back what was changed of the settings that a run began with; without those, of what the
    /// file said last.
    pub(super) fn keep_settings(
        &self,
        began: Option<&Settings>,
        settings: &Settings,
    ) -> Result<(), JournalError> {
        let file = self.machine_file();
        let mut known = self.known();
        let said = file.text().map_err(unusable)?;
        let after = file.keep(began.unwrap_or(&known.machine.program), settings);
        let after = after.map_err(unusable)?;
        // What somebody else changed meanwhile is still news for the session.
        if said == known.text && after != said {
            let machine = file.read(after.as_deref().unwrap_or_default()).map_err(unusable)?;
            (known.text, known.machine) = (after, Arc::new(machine));
        }
        Ok(())
    }

    fn known(&self) -> MutexGuard<'_, Known> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

pub(super) fn unusable(error: MachineFileError) -> JournalError {
    match error {
        MachineFileError::Disk { path, why } => JournalError::of_disk(&path, &why),
        error => JournalError::Settings(error.to_string()),
    }
}
