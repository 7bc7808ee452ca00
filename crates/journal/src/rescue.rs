//! Rescue of a journal that is damaged: everything that can still be read is saved, row by
//! row, what is newer comes from the copy made when the last run was over. The damaged file stays, under
//! another name.

use super::copy::BACKUP_FILE;
use super::database::{self, Access};
use super::rows::{self, Row, Rows, Table, key_text};
use super::seal::{self, Found as SealFound, Mark, Reached, SEAL_FILE, Seal, Verdict};
use super::store::{JOURNAL_FILE, Store};
use super::{JournalError, stated};
use crate::facts::Fact;
use kerf_program::Axis;
use rusqlite::{Connection, OpenFlags};
use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Rows by the text of their key, each with the kind of file that it is from.
type Found = BTreeMap<String, (Origin, Row)>;

/// A journal whose bytes are gone, although there was one: it has a copy, a seal, or a write-ahead file with changes.
pub(super) fn lost(folder: &Path, seal: &SealFound) -> Option<JournalError> {
    let path = folder.join(JOURNAL_FILE);
    let what = match fs::metadata(&path) {
        Ok(file) if file.len() == 0 => "it is empty",
        Err(error) if error.kind() == ErrorKind::NotFound => "it is gone",
        _ => return None,
    };
    let log = fs::metadata(beside(&path, LOG)).is_ok_and(|log| log.len() > 0);
    let was_there = log || folder.join(BACKUP_FILE).is_file() || seal.seal().is_some();
    was_there.then(|| JournalError::Damaged { path, what: what.into() })
}

/// Puts a sound file in the place of a damaged one and tells what was done.
pub(super) fn rescue(folder: &Path, what: &str) -> Result<Vec<String>, JournalError> {
    let file = folder.join(JOURNAL_FILE);
    let aside = unused(folder);
    let moved = |error: std::io::Error| JournalError::of_disk(&file, &error);
    let seal = SealFound::in_folder(folder).map_err(moved)?.seal().cloned();
    let (there, log) = (file.exists(), beside(&file, LOG).exists());
    move_with_log(&file, &aside).map_err(moved)?;
    let sources = sources(&aside, &folder.join(BACKUP_FILE), seal.as_ref());
    let mut fresh = database::open(&file, Access::Write).map_err(|error| error.at(&file))?;
    let kept = match (there, log) {
        (true, _) => format!("; it is kept as {}", aside.display()),
        (false, true) => {
            format!("; its write-ahead file is kept as {}", beside(&aside, LOG).display())
        }
        (false, false) => String::new(),
    };
    let mut told = vec![format!("the journal was damaged ({}: {what}){kept}", file.display())];
    let saved = rows::together(&mut fresh, |rows| {
        for table in Table::ALL {
            let mut found = Found::new();
            for source in &sources {
                found.extend(source.rows(table));
            }
            told.extend(summed_up(table, &found));
            for (_, (key, bytes)) in found.into_values() {
                rows.put(table, key, &bytes)?;
            }
        }
        stated::part(rows)?;
        next(&sources, seal.as_ref()).put(rows)?;
        not_verified(rows)
    });
    saved.map_err(|error| error.at(&file))?;
    told.push(NOT_VERIFIED.into());
    Ok(told)
}

/// The mend, for a person.
const NOT_VERIFIED: &str =
    "locations are not verified: home the machine, zero its axes anew, or confirm them";

/// A journal of which nobody can tell that it is the newest: its seal is gone, or damaged.
pub(super) fn doubt(store: &Store, why: &str) -> Result<Vec<String>, JournalError> {
    store.write(not_verified)?;
    let (seal, file) = (store.folder().join(SEAL_FILE), store.folder().join(JOURNAL_FILE));
    let (seal, file) = (seal.display(), file.display());
    Ok(vec![
        format!("{seal} {why}: whether {file} is the newest cannot be told; it was sealed anew"),
        NOT_VERIFIED.into(),
    ])
}

/// Every axis has to be confirmed.
fn not_verified(rows: &Rows<'_>) -> rows::Result<()> {
    let axes: String = Axis::ALL.into_iter().map(Axis::letter).collect();
    let doubted = [Fact::ConfirmLocation, Fact::PositionLost];
    doubted.into_iter().try_for_each(|fact| rows.set(Table::Fact, fact.key(), Some(&axes)))
}

/// The kind of file that rows are from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Origin {
    Damaged,
    Copy,
}

/// A file that can be read in part.
struct Source {
    origin: Origin,
    connection: Connection,
    mark: Option<Mark>,
    /// A source that is trusted more comes later: the journal that the seal is of and all of its changes; then by generations.
    trusted: (bool, u64),
}

/// All that can be read, in the order in which one replaces the rows of another.
fn sources(damaged: &Path, copy: &Path, seal: Option<&Seal>) -> Vec<Source> {
    let read = |origin, connection: Option<Connection>| {
        connection.map(|connection| Source::new(origin, connection, seal))
    };
    let mut sources: Vec<Source> = [
        read(Origin::Copy, copy.is_file().then(|| database::as_it_is(copy).ok()).flatten()),
        // A write-ahead file that belongs to another time makes nonsense of the file.
        read(
            Origin::Damaged,
            damaged.is_file().then(|| database::as_it_is(damaged).ok()).flatten(),
        ),
        read(Origin::Damaged, reader(damaged)),
    ]
    .into_iter()
    .flatten()
    .collect();
    sources.sort_by_key(|source| source.trusted);
    match sources.pop_if(|last| last.trusted.0) {
        Some(whole) => vec![whole],
        None => sources,
    }
}

impl Source {
    fn new(origin: Origin, connection: Connection, seal: Option<&Seal>) -> Self {
        let mark = Mark::of(&Rows(&connection)).ok().flatten();
        let fits = database::sound(&connection).and_then(|()| rows::digest(&connection)).ok();
        let (sound, sealed) = (fits.is_some(), seal.cloned().map(SealFound::Sound));
        let is_whole = fits.zip(sealed).is_some_and(|(digest, sealed)| {
            let mark = mark.as_ref();
            seal::compare(&Reached { mark, digest, alone: None, copy: None }, &sealed)
                == Verdict::Whole
        });
        // Of a damaged file the generation may be what cannot be read.
        let unknown = if sound { 0 } else { u64::MAX };
        let foreign = mark.as_ref().zip(seal).is_some_and(|(m, s)| m.journal != s.mark.journal);
        let generation = mark.as_ref().map_or(unknown, |mark| mark.generation);
        let trusted = (is_whole, if foreign { 0 } else { generation });
        Self { origin, connection, mark, trusted }
    }

    /// Rows that can be read and fit their check numbers.
    fn rows(&self, table: Table) -> Found {
        let found = Rows(&self.connection).each_while_readable(table);
        let named = |(key, bytes)| (key_text(Clone::clone(&key)), (self.origin, (key, bytes)));
        found.into_iter().map(named).collect()
    }
}

/// The mark of the rescued journal: further than everything that was there.
fn next(sources: &[Source], seal: Option<&Seal>) -> Mark {
    let marks = sources.iter().filter_map(|source| source.mark.as_ref());
    let last = seal.map(|seal| &seal.mark).into_iter().chain(marks);
    let generation = last.clone().map(|mark| mark.generation).max().unwrap_or_default();
    let journal = last.map(|mark| mark.journal.clone()).next();
    let journal = journal.unwrap_or_else(|| Mark::new().journal);
    Mark { journal, generation: generation.saturating_add(1) }
}

/// Sums up what was saved of a table, unless all was empty.
fn summed_up(table: Table, found: &Found) -> Option<String> {
    let from_copy = found.values().filter(|(origin, _)| *origin == Origin::Copy).count();
    let of = |n: usize| if n == 1 { "1 row".into() } else { format!("{n} rows") };
    match (found.len() - from_copy, from_copy) {
        (0, 0) => None,
        (n, 0) => Some(format!("{}: {} saved", table.name(), of(n))),
        (0, n) => Some(format!("{}: {} from the copy", table.name(), of(n))),
        (n, m) => Some(format!("{}: {} saved, {} from the copy", table.name(), of(n), of(m))),
    }
}

/// The damaged file with its write-ahead file; both stay as they are.
fn reader(file: &Path) -> Option<Connection> {
    let flags = OpenFlags::SQLITE_OPEN_READ_ONLY;
    file.is_file().then(|| Connection::open_with_flags(file, flags).ok()).flatten()
}

/// The ending of the write-ahead file: changes that are not in the file itself yet.
const LOG: &str = "-wal";

/// The file of a database that has this ending.
fn beside(file: &Path, ending: &str) -> PathBuf {
    PathBuf::from(format!("{}{ending}", file.display()))
}

/// Moves as much as there is of a file and of what belongs to it.
fn move_with_log(file: &Path, to: &Path) -> std::io::Result<()> {
    for ending in ["", LOG, "-shm"] {
        let from = beside(file, ending);
        if from.exists() {
            fs::rename(from, beside(to, ending))?;
        }
    }
    Ok(())
}

/// A name that no file has.
fn unused(folder: &Path) -> PathBuf {
    let name = |n: u32| folder.join(format!("journal.damaged-{n}.db"));
    let free = |path: &PathBuf| !path.exists() && !beside(path, LOG).exists();
    (1..u32::MAX).map(name).find(free).unwrap_or_else(|| name(0))
}
