//! The registry as text files in the data folder, for programs that know nothing else.
//!
//! `registry.txt` is written anew, whole, whenever what it says changes: watch it. Lines of
//! `registry.in` are taken over as if `kerf registry set` had been told them, and the file is taken
//! away: write it under another name and rename it, so that it is never seen half.

use super::JournalError;
use super::live::Live;
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

/// Writes what other programs read: keys and values.
pub(super) fn publish(
    folder: &Path,
    live: &Live,
    values: &[(String, String)],
) -> Result<(), JournalError> {
    let mut text: String =
        live.values().iter().map(|(key, value)| format!("{key}={value}\n")).collect();
    for (key, value) in values.iter().filter(|(key, _)| !Live::tells(key)) {
        text += &format!("{key}={}\n", value.replace('\n', "\\n"));
    }
    let there = folder.join(MIRROR_FILE);
    // Who watches it is told of changes only.
    if fs::read_to_string(&there).is_ok_and(|before| before == text) {
        return Ok(());
    }
    replace_whole(&there, text.as_bytes()).map_err(|error| JournalError::of_disk(&there, &error))
}

/// Reads what other programs wrote; `None` where they wrote nothing.
pub(super) fn incoming(folder: &Path) -> Result<Option<String>, JournalError> {
    let file = folder.join(INCOMING_FILE);
    match fs::metadata(&file) {
        Ok(about) if about.is_file() && about.len() <= MOST_BYTES => {
            let bytes = fs::read(&file).map_err(|error| JournalError::of_disk(&file, &error))?;
            Ok(Some(String::from_utf8_lossy(&bytes).into_owned()))
        }
        _ => Ok(None),
    }
}

/// Takes away what other programs wrote: it was taken over.
pub(super) fn is_taken(folder: &Path) -> Result<(), JournalError> {
    let file = folder.join(INCOMING_FILE);
    match fs::remove_file(&file) {
        // Another thread, or another Kerf, has taken the same lines.
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        done => done.map_err(|error| JournalError::of_disk(&file, &error)),
    }
}
