//! The journal of a data folder, and its parts.

use super::store::Store;
use super::{JournalError, MachineSettings, Memory, Owner, Registry, Runs, copy, opening};
use std::path::Path;
use std::sync::Arc;

/// A journal that is open. Clones are the same journal.
#[derive(Clone, Debug)]
pub struct Journal {
    pub(super) store: Arc<Store>,
    /// Values by key.
    pub registry: Registry,
    /// The machine's settings, which `machine.toml` leads.
    pub settings: MachineSettings,
    /// Memory of the machine between commands.
    pub memory: Memory,
    /// The run under way, and those that are over.
    pub runs: Runs,
}

impl Journal {
    /// Opens the journal of a data folder, makes one where there is none, and rescues what can be
    /// read where it is damaged. What had to be done is told.
    ///
    /// # Errors
    /// Whatever keeps it from being read and written.
    pub fn open(folder: &Path) -> Result<(Self, Vec<String>), JournalError> {
        opening::open(folder).map(|(store, told)| (Self::of(store), told))
    }

    /// Opens the journal of a data folder to look at it; `None` where there is none.
    ///
    /// # Errors
    /// Whatever keeps it from being read.
    pub fn look(folder: &Path) -> Result<Option<Self>, JournalError> {
        Ok(opening::look(folder)?.map(Self::of))
    }

    fn of(store: Store) -> Self {
        let store = Arc::new(store);
        let registry = Registry::new(store.clone());
        let settings = MachineSettings::new(store.clone());
        let memory = Memory::new(store.clone(), settings.clone());
        let runs = Runs::new(registry.clone(), settings.clone());
        Self { store, registry, settings, memory, runs }
    }

    /// Takes the machine; nobody else may move it meanwhile.
    ///
    /// # Errors
    /// [`JournalError::Owned`] while another process has it.
    pub fn own(&self) -> Result<Owner, JournalError> {
        Owner::new(self.store.clone(), self.memory.clone())
    }

    /// The data folder.
    pub fn folder(&self) -> &Path {
        self.store.folder()
    }

    /// Tells all that was found wrong with the files of the data folder since it was opened.
    pub fn mistakes_found(&self) -> Vec<String> {
        self.store.mistakes_found()
    }

    /// Keeps a line for whoever asks what was found wrong since it was opened.
    pub fn tell(&self, line: &str) {
        self.store.tell(line);
    }

    /// Sets whether a commit has to survive a power cut at once, or the death of the process only.
    pub fn each_commit_lasts(&self, lasts: bool) -> Result<(), JournalError> {
        self.store.each_commit_lasts(lasts)
    }

    /// Puts everything into the file itself and seals it, before a quiet time. Does nothing where that is done.
    ///
    /// # Errors
    /// If the files cannot be written; then what was changed is in the write-ahead file still.
    pub fn rest(&self) -> Result<(), JournalError> {
        self.store.rest()
    }

    /// A copy of the journal for the day on which it is damaged.
    ///
    /// # Errors
    /// If the copy cannot be written.
    pub fn back_up(&self) -> Result<(), JournalError> {
        copy::back_up(&self.store)
    }
}
