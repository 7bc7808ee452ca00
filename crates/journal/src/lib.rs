//! The journal: the state of a machine that has to outlive the process, in one SQLite file.
//!
//! ```text
//!  fact      place, homed axes, what G-code remembers, the run under way and how far it is; what the machine says of
//!            itself, as which axes are not verified: nobody else writes there ([`stated`])
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
//!   the time of the world. Then a thread writes ([`scribe`]): while the machine moves nobody waits for the
//!   disk, and the record may be behind by as long as the disk takes; before the machine sets off it is not.
//! - Every change counts the generation up, and a second file follows it ([`seal`]): a journal that lost its newest changes
//!   is damaged, and so is one that is older than its copy ([`copy`]). At rest everything is in the one file.
//! - One process owns the machine ([`Journal::own`]); others may look, and set values.
//! - Order is the order of writing; no decision depends on a clock.
//! - Settings are none of its business: they are in `machine.toml` beside it ([`settings`]).

mod before;
mod contents;
mod copy;
mod database;
mod error;
pub mod facts;
mod history;
mod kept_work;
mod known_machine;
mod live;
pub mod machine_file;
mod mirror;
mod options;
mod place;
mod press;
mod progress;
mod remembered;
mod rescue;
mod rows;
mod scribe;
mod seal;
mod settings;
mod standing;
mod started;
mod stated;
mod surroundings;
pub mod switches;
mod tape;
mod under_way;
mod value;
mod work;

pub use before::{Before, Door};
pub use error::JournalError;
pub use history::Past;
pub use kept_work::KeptWork;
pub use known_machine::KnownMachine;
pub use live::Live;
pub use mirror::{INCOMING_FILE, MIRROR_FILE};
pub use options::{LimitPolicy, RunOptions};
pub use place::Placed;
pub use press::Press;
pub use remembered::{ReadSettings, Remembered, Whereabouts};
pub use scribe::Hurry;
pub use seal::SEAL_FILE;
pub use standing::Standing;
pub use started::Started;
pub use surroundings::{Shell, Surroundings};
pub use tape::{Kind, Tape, Turn};
pub use under_way::{CutShort, RunUnderWay};
pub use value::check_value;
pub use work::Work;

use database::Access;
use remembered::OnRecord;
use rows::{Rows, Table, json};
use rusqlite::Connection;
use seal::{Mark, Seal, Verdict};
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
    /// Reads while somebody writes; opened when it is needed first. It comes first here so that it is closed first: whoever
    /// writes and closes last takes the files beside the journal away.
    reader: Arc<Mutex<Option<Connection>>>,
    database: Arc<Mutex<Opened>>,
    folder: Arc<Path>,
    /// State of `machine.toml` when it was looked at last.
    known: Arc<Mutex<settings::Known>>,
    /// Record of where the machine stands, as it was read last or left by this process.
    seen: Arc<Mutex<Option<OnRecord>>>,
    /// Words about all that was found wrong since it was opened.
    told: Arc<Mutex<Vec<String>>>,
}

/// The file that is open.
#[derive(Debug)]
struct Opened {
    connection: Connection,
    /// Each commit waits for the disk; then the seal follows at once.
    lasts: bool,
    /// Nothing was changed since everything was put into the file itself.
    rests: bool,
    /// The generation that is in the file itself.
    rested: u64,
    /// The name of a journal that was never changed.
    name: String,
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
        // What cannot be put into the file itself now is in the one beside it.
        drop(self.journal.rest());
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
        let (journal, mut told) = match Self::open_sound(folder, Access::Write) {
            Err(JournalError::Damaged { what, .. }) => {
                let told = rescue::rescue(folder, &what)?;
                let rescued = Self::open_sound(folder, Access::Write)?.0;
                rescued.back_up()?;
                (rescued, told)
            }
            Ok((journal, Some(doubt))) => {
                let told = rescue::doubt(&journal, &doubt)?;
                (journal, told)
            }
            Ok((journal, None)) => (journal, Vec::new()),
            Err(error) => return Err(error),
        };
        journal.part_facts()?;
        if let Some(wrong) = journal.wrong_copy()? {
            let copy = journal.folder.join(BACKUP_FILE).display().to_string();
            told.push(format!("{copy}, the copy of the journal, {wrong}: a new one was made"));
            journal.back_up()?;
        }
        told.iter().for_each(|line| journal.tell(line));
        Ok((journal, told))
    }

    /// Opens the journal of a data folder to look at it; `None` where there is none.
    ///
    /// # Errors
    /// Whatever keeps it from being read.
    pub fn look(folder: &Path) -> Result<Option<Self>, JournalError> {
        let file = std::fs::metadata(folder.join(JOURNAL_FILE));
        let lost = rescue::lost(folder, &seal_of(folder)?).is_some();
        match file.is_ok_and(|file| file.len() > 0) || lost {
            true => Ok(Some(Self::open_sound(folder, Access::Look)?.0)),
            false => Ok(None),
        }
    }

    /// Opens it, when nothing of it is lost; with the reason why nobody can tell that for sure.
    fn open_sound(folder: &Path, access: Access) -> Result<(Self, Option<String>), JournalError> {
        // The seal and the copy first: they never are ahead of the journal.
        let seal = seal_of(folder)?;
        if let Some(lost) = rescue::lost(folder, &seal) {
            return Err(lost);
        }
        let file = folder.join(JOURNAL_FILE);
        let (copy, alone) = (copy::mark(&folder.join(BACKUP_FILE)), copy::mark(&file));
        let opened = database::open(&file, access).and_then(|connection| {
            let verdict = standing(&connection, &seal, copy.as_ref(), alone.as_ref())?;
            Ok((connection, verdict))
        });
        let (connection, verdict) = opened.map_err(|error| error.at(&file))?;
        let doubt = match verdict {
            Verdict::Whole => None,
            Verdict::Doubtful(why) => Some(why),
            Verdict::Damaged(what) => return Err(JournalError::Damaged { path: file, what }),
        };
        let rested = seal.seal().map_or(0, |seal| seal.rested);
        // One of which nobody can tell is sealed with the doubt.
        let begins = access == Access::Write && doubt.is_none();
        let name = begun(folder, &seal, begins)?;
        let opened = Opened { connection, lasts: true, rests: false, rested, name };
        let (database, known) = (Arc::new(Mutex::new(opened)), Arc::default());
        let (seen, told) = (Arc::default(), Arc::default());
        let reader = Arc::default();
        Ok((Self { database, reader, folder: folder.into(), known, seen, told }, doubt))
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

    /// Tells all that was found wrong with the files of the data folder since it was opened.
    pub fn told(&self) -> Vec<String> {
        self.told.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Keeps a line for whoever asks what was found wrong since it was opened.
    pub fn tell(&self, line: &str) {
        self.told.lock().unwrap_or_else(PoisonError::into_inner).push(line.to_owned());
    }

    /// The value of a key.
    ///
    /// # Errors
    /// As the file cannot be read.
    pub fn value(&self, key: &str) -> Result<Option<String>, JournalError> {
        self.read(|rows| stated::value(rows, key))
    }

    /// The value of a key, as the file has it while a thread may be writing into it: nobody waits for the disk.
    pub fn look_up(&self, key: &str) -> Result<Option<String>, JournalError> {
        let mut reader = self.reader.lock().unwrap_or_else(PoisonError::into_inner);
        let look_up = |reader: &mut Option<Connection>| {
            let connection = match reader.take() {
                Some(connection) => connection,
                None => database::look(&self.folder.join(JOURNAL_FILE))?,
            };
            stated::value(&Rows(reader.insert(connection)), key)
        };
        look_up(&mut reader).map_err(|error| self.located(error))
    }

    /// Gives a key a value; `None` removes it. What the machine says of itself is no value: see [`Journal::state`].
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
        self.read(stated::values)
    }

    /// Sets whether a commit has to survive a power cut at once, or the death of the process only.
    pub fn each_commit_lasts(&self, lasts: bool) -> Result<(), JournalError> {
        let mut opened = self.opened();
        opened.lasts = lasts;
        database::synchronous(&opened.connection, lasts).map_err(|error| self.located(error))
    }

    /// Nothing changes for a while: everything is put into the file itself, and sealed. Does nothing where that is so.
    ///
    /// # Errors
    /// As the files cannot be written; then what was changed is in the write-ahead file still.
    pub fn rest(&self) -> Result<(), JournalError> {
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

    fn read<T>(&self, look: impl FnOnce(&Rows<'_>) -> rows::Result<T>) -> Result<T, JournalError> {
        look(&Rows(&self.opened().connection)).map_err(|error| self.located(error))
    }

    /// Changes that are made together or not at all. The seal follows.
    fn write<T>(
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

    fn located(&self, error: database::Trouble) -> JournalError {
        error.at(&self.folder.join(JOURNAL_FILE))
    }

    /// A thread that panicked left no half-made change: the transaction was rolled back.
    fn opened(&self) -> MutexGuard<'_, Opened> {
        self.database.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The seal of a data folder.
fn seal_of(folder: &Path) -> Result<seal::Found, JournalError> {
    let there = |error| JournalError::of_disk(&folder.join(SEAL_FILE), &error);
    seal::Found::in_folder(folder).map_err(there)
}

/// The name of a journal. One that begins is sealed before its first change: a kill between the two would leave a journal whose seal is
/// gone.
fn begun(folder: &Path, seal: &seal::Found, begins: bool) -> Result<String, JournalError> {
    if let Some(seal) = seal.seal() {
        return Ok(seal.mark.journal.clone());
    }
    let mark = Mark::new();
    let name = mark.journal.clone();
    if begins && *seal == seal::Found::None {
        let there = |error| JournalError::of_disk(&folder.join(SEAL_FILE), &error);
        Seal { mark, rested: 0, digest: None }.write(folder).map_err(there)?;
    }
    Ok(name)
}

/// Puts everything into the file itself: the generation that is there, how far the journal has come, the digest of its
/// rows. `None` while somebody reads.
fn at_rest(connection: &Connection) -> rows::Result<Option<(u64, Option<Mark>, u64)>> {
    // Somebody else may change it behind the checkpoint.
    let before = Mark::of(&Rows(connection))?;
    if !database::checkpoint(connection)? {
        return Ok(None);
    }
    let (mark, digest) = reached(connection)?;
    Ok(Some((before.map_or(0, |before| before.generation), mark, digest)))
}

fn reached(connection: &Connection) -> rows::Result<(Option<Mark>, u64)> {
    rows::at_once(connection, |rows| Ok((Mark::of(rows)?, rows::digest(rows.0)?)))
}

/// Compares a journal that was opened with its seal and its copy.
fn standing(
    connection: &Connection,
    seal: &seal::Found,
    copy: Option<&Mark>,
    alone: Option<&Mark>,
) -> rows::Result<Verdict> {
    // A write-ahead file that is lost may have held the very tables.
    let there = database::has_tables(connection)?;
    let (mark, digest) = if there { reached(connection)? } else { (None, 0) };
    Ok(seal::compare(&seal::Reached { mark: mark.as_ref(), digest, alone, copy }, seal))
}

/// The folder we are in has an empty name in relative paths.
fn or_here(folder: &Path) -> PathBuf {
    if folder.as_os_str().is_empty() { ".".into() } else { folder.to_owned() }
}

#[cfg(test)]
mod tests;
