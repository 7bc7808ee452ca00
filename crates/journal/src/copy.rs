//! The copy of the journal for the day on which that is damaged.

use super::contents::hash;
use super::rows::{Rows, Table, json};
use super::seal::Mark;
use super::store::Store;
use super::{JournalError, database};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// Name of the copy made whenever a run is over.
pub const BACKUP_FILE: &str = "journal.backup.db";

/// Name of the fact: hashes of the copies that may lie beside the journal. There are two while one takes the place
/// of the other.
const COPIED: &str = "copied";

/// Makes a copy of the journal for the day on which it is damaged.
pub(super) fn back_up(store: &Store) -> Result<(), JournalError> {
    let (new, kept) = (store.folder().join("journal.backup.new"), store.folder().join(BACKUP_FILE));
    let there = |error: std::io::Error| JournalError::of_disk(&kept, &error);
    // What a process left that was killed here.
    if new.exists() {
        fs::remove_file(&new).map_err(there)?;
    }
    let copied = database::copy(&store.opened().connection, &new).map_err(|error| error.at(&kept));
    copied?;
    let made = hash(&fs::read(&new).map_err(there)?);
    let mut either = copies(store)?;
    either.push(made.clone());
    store.write(|rows| rows.put(Table::Fact, COPIED, &json(&either)?))?;
    fs::rename(&new, &kept).map_err(there)?;
    store.write(|rows| rows.put(Table::Fact, COPIED, &json(&[made])?))
}

/// Tells of a copy that is wrong, although the journal knows that there is one.
pub(super) fn wrong(store: &Store) -> Result<Option<&'static str>, JournalError> {
    let mut wrong = None;
    // Another process may be putting a new one there at this moment.
    for _ in 0..2 {
        let there = fs::read(store.folder().join(BACKUP_FILE));
        let known = copies(store)?;
        wrong = match there {
            _ if known.is_empty() => None,
            Ok(bytes) if known.contains(&hash(&bytes)) => None,
            Ok(bytes) if bytes.is_empty() => Some("is empty"),
            Ok(_) => Some("is not as Kerf left it"),
            Err(error) if error.kind() == ErrorKind::NotFound => Some("is gone"),
            Err(_) => Some("cannot be read"),
        };
        if wrong.is_none() {
            break;
        }
    }
    Ok(wrong)
}

fn copies(store: &Store) -> Result<Vec<String>, JournalError> {
    let text = store.read(|rows| rows.text(Table::Fact, COPIED))?;
    Ok(store.parsed(COPIED, text)?.unwrap_or_default())
}

/// The changes that are in a file by itself; `None` where there is none that can be read.
pub(super) fn mark(file: &Path) -> Option<Mark> {
    let connection = file.is_file().then(|| database::as_it_is(file).ok()).flatten()?;
    Mark::of(&Rows(&connection)).ok().flatten()
}
