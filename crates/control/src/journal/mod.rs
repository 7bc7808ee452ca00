//! The journal: the state of a machine that has to outlive the process, in one SQLite file.
//!
//! ```text
//!  fact      place, homed axes, what G-code remembers, the run under way and how far it is
//!  value     what programs and other software keep under a key
//!  step      what the world told the run under way, in order
//!  content   program files of that run, by the hash of their bytes
//!  history   runs that are over, oldest first
//! ```
//!
//! - Every table has the same shape: key, text, and a check number of both ([`rows`]), so that a bit
//!   that changed on the disk is noticed, and a damaged file is saved row by row ([`rescue`]).
//! - A change is in the file before what follows from it happens (write-ahead). Between two moves
//!   of a run that are closer than [`progress::EVERY`] nothing is written, unless machine time is
//!   the time of the world.
//! - One process owns the machine ([`Journal::own`]); others may look, and set values.
//! - Order is the order of writing; no decision depends on a clock.
//! - Settings are none of its business: they are in `machine.toml` beside it ([`settings`]).

mod contents;
mod database;
mod error;
mod history;
mod kept_work;
mod live;
mod mirror;
mod place;
mod progress;
mod remembered;
mod rescue;
mod rows;
mod settings;
mod tape;
mod under_way;

pub use error::JournalError;
pub use history::Past;
pub(crate) use kept_work::KeptWork;
pub use live::Live;
pub use mirror::{INCOMING_FILE, MIRROR_FILE};
pub use place::Placed;
use remembered::Standing;
pub use remembered::{Remembered, Whereabouts};
pub(crate) use tape::{Kind, Tape, Turn};
pub use under_way::{CutShort, RunUnderWay};

use database::Access;
use rows::{Rows, Table, json};
use rusqlite::Connection;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Name of the file in the data folder.
pub const JOURNAL_FILE: &str = "journal.db";

/// Name of the copy made whenever a run is over.
pub const BACKUP_FILE: &str = "journal.backup.db";

/// Name of the file that is locked by the process that owns the machine.
const OWNER_FILE: &str = "owner.lock";

/// A journal that is open. Clones are the same journal.
#[derive(Clone, Debug)]
pub struct Journal {
    database: Arc<Mutex<Connection>>,
    folder: Arc<Path>,
    /// What `machine.toml` said when it was looked at last.
    known: Arc<Mutex<settings::Known>>,
    /// What it said of the machine when that was read last, or left by this process.
    seen: Arc<Mutex<Option<Standing>>>,
}

/// The right to move the machine; ends with the value, or with the process.
#[derive(Debug)]
pub struct Owner {
    journal: Journal,
    _lock: File,
}

impl Drop for Owner {
    fn drop(&mut self) {
        self.journal.has_seen();
    }
}

impl Journal {
    /// Opens the journal of a data folder, makes one where there is none, and rescues what can be
    /// read where it is damaged. What had to be done is told.
    ///
    /// # Errors
    /// Whatever keeps it from being read and written.
    pub fn open(folder: &Path) -> Result<(Self, Vec<String>), JournalError> {
        std::fs::create_dir_all(or_here(folder))
            .map_err(|error| JournalError::of_disk(folder, &error))?;
        match Self::open_sound(folder, Access::Write) {
            Err(JournalError::Damaged { what, .. }) => {
                let told = rescue::rescue(folder, &what)?;
                Ok((Self::open_sound(folder, Access::Write)?, told))
            }
            opened => Ok((opened?, Vec::new())),
        }
    }

    /// Opens the journal of a data folder to look at it; `None` where there is none.
    ///
    /// # Errors
    /// Whatever keeps it from being read.
    pub fn look(folder: &Path) -> Result<Option<Self>, JournalError> {
        let file = std::fs::metadata(folder.join(JOURNAL_FILE));
        match file.is_ok_and(|file| file.len() > 0) || rescue::lost(folder).is_some() {
            true => Self::open_sound(folder, Access::Look).map(Some),
            false => Ok(None),
        }
    }

    fn open_sound(folder: &Path, access: Access) -> Result<Self, JournalError> {
        if let Some(lost) = rescue::lost(folder) {
            return Err(lost);
        }
        let file = folder.join(JOURNAL_FILE);
        let connection = database::open(&file, access)
            .and_then(|connection| rows::check(&connection).map(|()| connection))
            .map_err(|error| error.at(&file))?;
        let (database, known) = (Arc::new(Mutex::new(connection)), Arc::default());
        Ok(Self { database, folder: folder.into(), known, seen: Arc::default() })
    }

    /// Takes the machine; nobody else may move it meanwhile.
    ///
    /// # Errors
    /// [`JournalError::Owned`] while another process has it.
    pub fn own(&self) -> Result<Owner, JournalError> {
        let path = self.folder.join(OWNER_FILE);
        let file = File::options().create(true).append(true).open(&path);
        let file = file.map_err(|error| JournalError::of_disk(&path, &error))?;
        match file.try_lock() {
            Ok(()) => Ok(Owner { journal: self.clone(), _lock: file }),
            Err(std::fs::TryLockError::WouldBlock) => {
                Err(JournalError::Owned { folder: self.folder.to_path_buf() })
            }
            Err(std::fs::TryLockError::Error(error)) => Err(JournalError::of_disk(&path, &error)),
        }
    }

    /// The data folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The value of a key.
    ///
    /// # Errors
    /// As the file cannot be read.
    pub fn value(&self, key: &str) -> Result<Option<String>, JournalError> {
        self.read(|rows| rows.text(Table::Value, key))
    }

    /// Gives a key a value; `None` removes it.
    ///
    /// # Errors
    /// As the file cannot be written.
    pub fn set_value(&self, key: &str, value: Option<&str>) -> Result<(), JournalError> {
        self.write(|rows| rows.set(Table::Value, key, value))
    }

    /// Keys and values in order.
    ///
    /// # Errors
    /// As the file cannot be read.
    pub fn values(&self) -> Result<Vec<(String, String)>, JournalError> {
        self.read(|rows| rows.all(Table::Value))
    }

    /// A copy of the journal for the day on which it is damaged.
    ///
    /// # Errors
    /// As the copy cannot be written.
    pub fn back_up(&self) -> Result<(), JournalError> {
        let (new, kept) = (self.folder.join("journal.backup.new"), self.folder.join(BACKUP_FILE));
        let there = |error: std::io::Error| JournalError::of_disk(&kept, &error);
        // What a process left that was killed here.
        if new.exists() {
            std::fs::remove_file(&new).map_err(there)?;
        }
        let copied = database::copy(&self.connection(), &new).map_err(|error| error.at(&kept));
        copied.and_then(|()| std::fs::rename(&new, &kept).map_err(there))
    }

    /// Whether a commit has to survive a power cut at once, or the death of the process only.
    pub(crate) fn each_commit_lasts(&self, lasts: bool) -> Result<(), JournalError> {
        database::synchronous(&self.connection(), lasts).map_err(|error| self.located(error))
    }

    fn read<T>(&self, look: impl FnOnce(&Rows<'_>) -> rows::Result<T>) -> Result<T, JournalError> {
        look(&Rows(&self.connection())).map_err(|error| self.located(error))
    }

    /// Changes that are made together or not at all.
    fn write<T>(
        &self,
        change: impl FnOnce(&Rows<'_>) -> rows::Result<T>,
    ) -> Result<T, JournalError> {
        let mut connection = self.connection();
        rows::together(&mut connection, change).map_err(|error| self.located(error))
    }

    fn located(&self, error: database::Trouble) -> JournalError {
        error.at(&self.folder.join(JOURNAL_FILE))
    }

    /// A thread that panicked left no half-made change: the transaction was rolled back.
    fn connection(&self) -> MutexGuard<'_, Connection> {
        self.database.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The folder we are in has an empty name in relative paths.
fn or_here(folder: &Path) -> PathBuf {
    if folder.as_os_str().is_empty() { ".".into() } else { folder.to_owned() }
}

#[cfg(test)]
mod tests;
