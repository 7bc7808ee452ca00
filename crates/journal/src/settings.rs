//! The settings beside the journal: `machine.toml` leads, sessions follow.
//!
//! ```text
//!   machine.toml ──► session at the start of each run: what somebody changed since
//!        ▲              │
//!        └──────────────┘ at its end: what V commands changed
//! ```

use super::JournalError;
use super::known_machine::KnownMachine;
use super::store::Store;
use crate::machine_file::{MachineFile, MachineFileError};
use kerf_machine::{Configuration, table};
use kerf_program::Settings;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The most changed settings that a message names.
const NAMED: usize = 4;

/// The machine's settings, beside the journal that knows them. Clones are the same settings.
#[derive(Clone, Debug)]
pub struct MachineSettings {
    store: Arc<Store>,
    /// State of `machine.toml` when it was looked at last.
    known: Arc<Mutex<Known>>,
}

/// State of the file when it was looked at last.
#[derive(Debug, Default)]
struct Known {
    /// Another file than that of the data folder.
    file: Option<MachineFile>,
    text: Option<String>,
    machine: Arc<Configuration>,
}

impl MachineSettings {
    pub(super) fn new(store: Arc<Store>) -> Self {
        Self { store, known: Arc::default() }
    }

    /// The file of the machine's settings.
    pub fn file(&self) -> MachineFile {
        let other = self.known().file.clone();
        other.unwrap_or_else(|| self.knows(MachineFile::of_data(self.store.folder())))
    }

    /// A file of which the journal knows what Kerf leaves in it, and tells when somebody else leaves another machine there.
    #[must_use]
    pub fn knows(&self, file: MachineFile) -> MachineFile {
        file.known_to(KnownMachine(self.store.clone()))
    }

    /// Makes another file the one that decides.
    pub fn use_file(&self, file: MachineFile) {
        *self.known() = Known { file: Some(file), ..Known::default() };
    }

    /// The machine that the file describes now; whether there is a file.
    pub(super) fn machine(&self) -> Result<(Arc<Configuration>, bool), JournalError> {
        let file = self.file();
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
    pub(super) fn keep(
        &self,
        began: Option<&Settings>,
        settings: &Settings,
    ) -> Result<(), JournalError> {
        let file = self.file();
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

    /// Looks at the file. Where it describes another machine than Kerf left, that is told, once.
    ///
    /// # Errors
    /// If the journal or the file cannot be read or written.
    pub fn meet(&self) -> Result<Option<String>, JournalError> {
        let file = self.file();
        // Another file is its owner's: Kerf is told of it at every start.
        if !file.is_of(self.store.folder()) {
            return Ok(None);
        }
        let machine = KnownMachine(self.store.clone());
        let (text, known) = (file.text().map_err(unusable)?, machine.texts()?);
        match known.last() {
            Some(last) if !known.contains(&text) => {
                meet_another(&machine, &file, text, last.as_deref())
            }
            Some(_) if known.len() == 1 => Ok(None),
            _ => machine.is(text.as_deref()).map(|()| None),
        }
    }

    fn known(&self) -> MutexGuard<'_, Known> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Tells that the file describes another machine than Kerf left.
fn meet_another(
    machine: &KnownMachine,
    file: &MachineFile,
    text: Option<String>,
    known: Option<&str>,
) -> Result<Option<String>, JournalError> {
    // Its mistakes are told by whoever needs it, and nothing moves with them.
    let Ok(now) = file.read(text.as_deref().unwrap_or_default()) else { return Ok(None) };
    let before = file.read(known.unwrap_or_default()).unwrap_or_default();
    let others = others(&before, &now);
    if others.is_empty() {
        return machine.is(text.as_deref()).map(|()| None);
    }
    let kept = known.map(|known| file.keep_beside(known)).transpose().map_err(unusable)?;
    let mend = kept.map_or_else(String::new, |kept| {
        format!(
            "; as Kerf left it, it is kept as {}: put that in its place to have it back",
            kept.display()
        )
    });
    machine.is(text.as_deref())?;
    let how = match text.as_deref().map(str::trim) {
        None => "is gone",
        Some("") => "is empty",
        Some(_) => "is not as Kerf left it",
    };
    Ok(Some(format!(
        "{} {how}: {others}{mend}. Locations are not verified: home the machine, zero its axes anew, or confirm them",
        file.name()
    )))
}

/// The settings that are others, in words. Nobody reads the hash of a password.
fn others(before: &Configuration, now: &Configuration) -> String {
    let changed: Vec<_> = table::changed(before, now).collect();
    let one = |setting: &&table::Setting| match setting.key {
        "options.password" => "options.password is another".to_owned(),
        key => format!("{key} was {} and is {}", setting.get(before), setting.get(now)),
    };
    let mut told = changed.iter().take(NAMED).map(one).collect::<Vec<_>>().join(", ");
    if changed.len() > NAMED {
        told += &format!(", and {} more", changed.len() - NAMED);
    }
    told
}

fn unusable(error: MachineFileError) -> JournalError {
    match error {
        MachineFileError::Disk { path, why } => JournalError::of_disk(&path, &why),
        error => JournalError::Settings(error.to_string()),
    }
}
