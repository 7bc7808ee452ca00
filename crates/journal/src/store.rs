//! The open journal: its database, the seal that follows each change, and what was found wrong.

use super::JournalError;
use super::database::{self, Trouble};
use super::rows::{self, Rows};
use super::seal::{Mark, SEAL_FILE, Seal};
use rusqlite::Connection;
use serde::de::DeserializeOwned;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Name of the file in the data folder.
pub const JOURNAL_FILE: &str = "journal.db";

/// A journal that is open.
#[derive(Debug)]
pub(super) struct Store {
    /// Reads while somebody writes; opened when it is needed first. It comes first here so that it is closed first: whoever
    /// writes and closes last takes the files beside the journal away.
    reader: Mutex<Option<Connection>>,
    database: Mutex<Opened>,
    folder: Box<Path>,
    /// Words about all that was found wrong since it was opened.
    told: Mutex<Vec<String>>,
}

/// The file that is open.
#[derive(Debug)]
pub(super) struct Opened {
    pub connection: Connection,
    /// Each commit waits for the disk; then the seal follows at once.
    lasts: bool,
    /// The write-ahead file is empty: everything is in the file itself.
    rests: bool,
    /// The generation that is in the file itself.
    rested: u64,
    /// The name of a journal that was never changed.
    name: String,
}

impl Opened {
    /// A file whose own generation, and whose name where it was never changed, are known.
    pub(super) const fn new(connection: Connection, rested: u64, name: String) -> Self {
        Self { connection, lasts: true, rests: false, rested, name }
    }
}

impl Store {
    /// The journal of a data folder.
    pub(super) fn new(folder: &Path, opened: Opened) -> Self {
        let (reader, told) = (Mutex::default(), Mutex::default());
        Self { reader, database: Mutex::new(opened), folder: folder.into(), told }
    }

    /// The data folder.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Tells all that was found wrong with the files of the data folder since it was opened.
    pub(super) fn mistakes_found(&self) -> Vec<String> {
        self.told.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Keeps a line for whoever asks what was found wrong since it was opened.
    pub(super) fn tell(&self, line: &str) {
        self.told.lock().unwrap_or_else(PoisonError::into_inner).push(line.to_owned());
    }

    /// Sets whether a commit has to survive a power cut at once, or the death of the process only.
    pub(super) fn each_commit_lasts(&self, lasts: bool) -> Result<(), JournalError> {
        let mut opened = self.opened();
        opened.lasts = lasts;
        database::synchronous(&opened.connection, lasts).map_err(|error| self.located(error))
    }

    /// Puts everything into the file itself and seals it. Does nothing where that is so.
    pub(super) fn rest(&self) -> Result<(), JournalError> {
        let mut opened = self.opened();
        if opened.rests {
            return Ok(());
        }
        let at_rest = at_rest(&opened.connection).map_err(|error| self.located(error))?;
        let Some((rested, mark, digest)) = at_rest else { return Ok(()) };
        if let Some(mark) = mark {
            opened.rested = rested;
            self.seal(&Seal { mark, rested, digest: Some(digest) })?;
        }
        opened.rests = true;
        Ok(())
    }

    fn seal(&self, seal: &Seal) -> Result<(), JournalError> {
        let there = |error| JournalError::of_disk(&self.folder.join(SEAL_FILE), &error);
        seal.write(&self.folder).map_err(there)
    }

    /// Looks at the rows as this process has left them.
    pub(super) fn read<T>(
        &self,
        look: impl FnOnce(&Rows<'_>) -> rows::Result<T>,
    ) -> Result<T, JournalError> {
        look(&Rows(&self.opened().connection)).map_err(|error| self.located(error))
    }

    /// Looks at the rows as the file has them while a thread may be writing into it: nobody waits for the disk.
    pub(super) fn read_beside<T>(
        &self,
        look: impl FnOnce(&Rows<'_>) -> rows::Result<T>,
    ) -> Result<T, JournalError> {
        let mut reader = self.reader.lock().unwrap_or_else(PoisonError::into_inner);
        let look_up = |reader: &mut Option<Connection>| {
            let connection = match reader.take() {
                Some(connection) => connection,
                None => database::look(&self.folder.join(JOURNAL_FILE))?,
            };
            look(&Rows(reader.insert(connection)))
        };
        look_up(&mut reader).map_err(|error| self.located(error))
    }

    /// Changes that are made together or not at all. The seal follows.
    pub(super) fn write<T>(
        &self,
        change: impl FnOnce(&Rows<'_>) -> rows::Result<T>,
    ) -> Result<T, JournalError> {
        let mut opened = self.opened();
        opened.rests = false;
        let Opened { connection, name, .. } = &mut *opened;
        let counted = |rows: &Rows<'_>| Ok((change(rows)?, Mark::count(rows, name)?));
        let changed = rows::together(connection, counted);
        let (changed, mark) = changed.map_err(|error| self.located(error))?;
        // Where commits do not wait for the disk, the seal could be there before them.
        if opened.lasts {
            self.seal(&Seal { mark, rested: opened.rested, digest: None })?;
        }
        Ok(changed)
    }

    /// Reads a value back from the text under a name.
    pub(super) fn parsed<T: DeserializeOwned>(
        &self,
        name: &str,
        text: Option<String>,
    ) -> Result<Option<T>, JournalError> {
        let parse = |text: String| serde_json::from_str(&text);
        let damaged = |error| Trouble::Damaged(format!("{name}: {error}"));
        text.map(parse).transpose().map_err(|error| self.located(damaged(error)))
    }

    fn located(&self, error: Trouble) -> JournalError {
        error.at(&self.folder.join(JOURNAL_FILE))
    }

    /// A thread that panicked left no half-made change: the transaction was rolled back.
    pub(super) fn opened(&self) -> MutexGuard<'_, Opened> {
        self.database.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Puts everything into the file itself: the generation that is there, how far the journal has come, the digest of its
/// rows. `None` while somebody reads.
fn at_rest(connection: &Connection) -> rows::Result<Option<(u64, Option<Mark>, u64)>> {
    // Somebody else may change it behind the checkpoint.
    let before = Mark::of(&Rows(connection))?;
    if !database::checkpoint(connection)? {
        return Ok(None);
    }
    let (mark, digest) = Mark::with_digest(connection)?;
    Ok(Some((before.map_or(0, |before| before.generation), mark, digest)))
}
