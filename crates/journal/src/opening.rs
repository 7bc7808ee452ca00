//! Opening of a journal: it is compared with its seal and its copy, and rescued where it is damaged.

use super::copy::{self, BACKUP_FILE};
use super::database::{self, Access};
use super::rows;
use super::seal::{self, Found, Mark, SEAL_FILE, Seal, Verdict};
use super::store::{JOURNAL_FILE, Opened, Store};
use super::{JournalError, rescue, stated};
use rusqlite::Connection;
use std::path::{Path, PathBuf};

/// Opens the journal of a data folder, makes one where there is none, and rescues what can be read where it is
/// damaged. What had to be done is told.
pub(super) fn open(folder: &Path) -> Result<(Store, Vec<String>), JournalError> {
    std::fs::create_dir_all(or_here(folder))
        .map_err(|error| JournalError::of_disk(folder, &error))?;
    let (store, mut told) = match open_sound(folder, Access::Write) {
        Err(JournalError::Damaged { what, .. }) => {
            let told = rescue::rescue(folder, &what)?;
            let rescued = open_sound(folder, Access::Write)?.0;
            copy::back_up(&rescued)?;
            (rescued, told)
        }
        Ok((store, Some(doubt))) => {
            let told = rescue::doubt(&store, &doubt)?;
            (store, told)
        }
        Ok((store, None)) => (store, Vec::new()),
        Err(error) => return Err(error),
    };
    stated::part_facts(&store)?;
    if let Some(wrong) = copy::wrong(&store)? {
        let copy = folder.join(BACKUP_FILE).display().to_string();
        told.push(format!("{copy}, the copy of the journal, {wrong}: a new one was made"));
        copy::back_up(&store)?;
    }
    told.iter().for_each(|line| store.tell(line));
    Ok((store, told))
}

/// Opens the journal of a data folder to look at it; `None` where there is none.
pub(super) fn look(folder: &Path) -> Result<Option<Store>, JournalError> {
    let file = std::fs::metadata(folder.join(JOURNAL_FILE));
    let lost = rescue::lost(folder, &seal_of(folder)?).is_some();
    match file.is_ok_and(|file| file.len() > 0) || lost {
        true => Ok(Some(open_sound(folder, Access::Look)?.0)),
        false => Ok(None),
    }
}

/// Opens it, when nothing of it is lost; with the reason why nobody can tell that for sure.
fn open_sound(folder: &Path, access: Access) -> Result<(Store, Option<String>), JournalError> {
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
    Ok((Store::new(folder, Opened::new(connection, rested, name)), doubt))
}

/// The seal of a data folder.
fn seal_of(folder: &Path) -> Result<Found, JournalError> {
    let there = |error| JournalError::of_disk(&folder.join(SEAL_FILE), &error);
    Found::in_folder(folder).map_err(there)
}

/// The name of a journal. One that begins is sealed before its first change: a kill between the two would leave a journal whose seal is
/// gone.
fn begun(folder: &Path, seal: &Found, begins: bool) -> Result<String, JournalError> {
    if let Some(seal) = seal.seal() {
        return Ok(seal.mark.journal.clone());
    }
    let mark = Mark::new();
    let name = mark.journal.clone();
    if begins && *seal == Found::None {
        let there = |error| JournalError::of_disk(&folder.join(SEAL_FILE), &error);
        Seal { mark, rested: 0, digest: None }.write(folder).map_err(there)?;
    }
    Ok(name)
}

/// Compares a journal that was opened with its seal and its copy.
fn standing(
    connection: &Connection,
    seal: &Found,
    copy: Option<&Mark>,
    alone: Option<&Mark>,
) -> rows::Result<Verdict> {
    // A write-ahead file that is lost may have held the very tables.
    let there = database::has_tables(connection)?;
    let (mark, digest) = if there { Mark::with_digest(connection)? } else { (None, 0) };
    Ok(seal::compare(&seal::Reached { mark: mark.as_ref(), digest, alone, copy }, seal))
}

/// The folder we are in has an empty name in relative paths.
fn or_here(folder: &Path) -> PathBuf {
    if folder.as_os_str().is_empty() { ".".into() } else { folder.to_owned() }
}
