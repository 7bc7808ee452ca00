//! The registry as text files in the data folder, for programs that know nothing else.
//!
//! `registry.txt` is written anew, whole, whenever what it says changes: watch it. Lines of
//! `registry.in` are taken over as if `kerf registry set` had been told them, and the file is taken
//! away: write it under another name and rename it, so that it is never seen half.

use super::live::Live;
use super::{Journal, JournalError};
use crate::stored::check_value;
use kerf_files::replace_whole;
use std::fs;
use std::io;
use std::path::Path;

/// Name of the file that other programs read.
pub const MIRROR_FILE: &str = "registry.txt";

/// Name of the file that other programs write.
pub const INCOMING_FILE: &str = "registry.in";

/// More than this is no list of values, bytes.
const MOST_BYTES: u64 = 1 << 20;

/// Writes what other programs read.
pub(super) fn publish(journal: &Journal, live: &Live) -> Result<(), JournalError> {
    let mut text: String =
        live.values().iter().map(|(key, value)| format!("{key}={value}\n")).collect();
    for (key, value) in journal.values()?.into_iter().filter(|(key, _)| !Live::tells(key)) {
        text += &format!("{key}={}\n", value.replace('\n', "\\n"));
    }
    let there = journal.folder().join(MIRROR_FILE);
    // Who watches it is told of changes only.
    if fs::read_to_string(&there).is_ok_and(|before| before == text) {
        return Ok(());
    }
    replace_whole(&there, text.as_bytes()).map_err(|error| JournalError::of_disk(&there, &error))
}

impl Journal {
    /// Takes over the values that other programs wrote into their file; what is none is left out.
    ///
    /// # Errors
    /// As the journal cannot be written; then the file stays.
    pub fn take_in(&self) -> Result<(), JournalError> {
        let file = self.folder().join(INCOMING_FILE);
        let Some(text) = incoming(&file).map_err(|error| JournalError::of_disk(&file, &error))?
        else {
            return Ok(());
        };
        for (key, value) in text.lines().filter_map(|line| line.split_once('=')) {
            let key = key.rsplit(['/', '\\']).next().unwrap_or(key).trim();
            let value = Some(value.trim()).filter(|value| !value.is_empty());
            if check_value(key, value).is_ok() {
                self.set_value(key, value)?;
            }
        }
        match fs::remove_file(&file) {
            // Another thread, or another Kerf, has taken the same lines.
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
            done => done.map_err(|error| JournalError::of_disk(&file, &error)),
        }
    }
}

fn incoming(file: &Path) -> io::Result<Option<String>> {
    match fs::metadata(file) {
        Ok(about) if about.is_file() && about.len() <= MOST_BYTES => {
            Ok(Some(String::from_utf8_lossy(&fs::read(file)?).into_owned()))
        }
        _ => Ok(None),
    }
}
