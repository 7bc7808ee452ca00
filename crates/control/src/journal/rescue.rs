//! What to do with a journal that is damaged: everything that can still be read is saved, row by
//! row, the rest comes from the copy made when the last run was over. The damaged file stays, under
//! another name.

use super::database::{self, Access};
use super::rows::{self, Row, Rows, Table, key_text};
use super::{BACKUP_FILE, JOURNAL_FILE, JournalError};
use crate::stopping::CONFIRM;
use kerf_program::Axis;
use kerf_sbp::POSITION_LOST;
use rusqlite::{Connection, OpenFlags};
use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Rows by the text of their key.
type Found = BTreeMap<String, Row>;

/// A journal whose bytes are gone, although there was one: it has a copy.
pub(super) fn lost(folder: &Path) -> Option<JournalError> {
    let path = folder.join(JOURNAL_FILE);
    let what = match fs::metadata(&path) {
        Ok(file) if file.len() == 0 => "it is empty",
        Err(error) if error.kind() == ErrorKind::NotFound => "it is gone",
        _ => return None,
    };
    let copied = folder.join(BACKUP_FILE).is_file();
    copied.then(|| JournalError::Damaged { path, what: what.into() })
}

/// Puts a sound file in the place of a damaged one and tells what was done.
pub(super) fn rescue(folder: &Path, what: &str) -> Result<Vec<String>, JournalError> {
    let file = folder.join(JOURNAL_FILE);
    let aside = unused(folder);
    let moved = |error: std::io::Error| JournalError::of_disk(&file, &error);
    let there = file.exists();
    if there {
        move_with_log(&file, &aside).map_err(moved)?;
    }
    let (damaged, backup) = (reader(&aside), reader(&folder.join(BACKUP_FILE)));
    let mut fresh = database::open(&file, Access::Write).map_err(|error| error.at(&file))?;
    let kept = if there { format!("; it is kept as {}", aside.display()) } else { String::new() };
    let mut told = vec![format!("the journal was damaged ({what}){kept}")];
    let saved = rows::together(&mut fresh, |rows| {
        for table in Table::ALL {
            let (here, copied) =
                (sound_rows(damaged.as_ref(), table), sound_rows(backup.as_ref(), table));
            told.extend(summed_up(table, &here, &copied));
            for (key, bytes) in copied.into_iter().chain(here).collect::<Found>().into_values() {
                rows.put(table, key, &bytes)?;
            }
        }
        let axes: String = Axis::ALL.into_iter().map(Axis::letter).collect();
        rows.set(Table::Value, CONFIRM, Some(&axes))?;
        rows.set(Table::Value, POSITION_LOST, Some(&axes))
    });
    saved.map_err(|error| error.at(&file))?;
    told.push("locations are not verified".into());
    Ok(told)
}

/// What was saved of a table, unless all was empty.
fn summed_up(table: Table, here: &Found, copied: &Found) -> Option<String> {
    let from_copy = copied.keys().filter(|key| !here.contains_key(*key)).count();
    let of = |n: usize| if n == 1 { "1 row".into() } else { format!("{n} rows") };
    match (here.len(), from_copy) {
        (0, 0) => None,
        (n, 0) => Some(format!("{}: {} saved", table.name(), of(n))),
        (0, n) => Some(format!("{}: {} from the copy", table.name(), of(n))),
        (n, m) => Some(format!("{}: {} saved, {} from the copy", table.name(), of(n), of(m))),
    }
}

/// Rows that can be read and fit their check numbers.
fn sound_rows(connection: Option<&Connection>, table: Table) -> Found {
    let Some(connection) = connection else { return Found::new() };
    let found = Rows(connection).each_while_readable(table);
    found.into_iter().map(|(key, bytes)| (key_text(key.clone()), (key, bytes))).collect()
}

fn reader(file: &Path) -> Option<Connection> {
    let there = file.is_file();
    there
        .then(|| Connection::open_with_flags(file, OpenFlags::SQLITE_OPEN_READ_WRITE).ok())
        .flatten()
}

/// Moves the file with what belongs to it: changes that are not in it yet.
fn move_with_log(file: &Path, to: &Path) -> std::io::Result<()> {
    fs::rename(file, to)?;
    for ending in ["-wal", "-shm"] {
        let beside = |path: &Path| PathBuf::from(format!("{}{ending}", path.display()));
        if beside(file).exists() {
            fs::rename(beside(file), beside(to))?;
        }
    }
    Ok(())
}

/// A name that no file has.
fn unused(folder: &Path) -> PathBuf {
    let name = |n: u32| folder.join(format!("journal.damaged-{n}.db"));
    (1..u32::MAX).map(name).find(|path| !path.exists()).unwrap_or_else(|| name(0))
}
