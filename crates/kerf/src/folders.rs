//! Folders that options name have to be there: a misspelt one would be an empty one.

use crate::exit::Usage;
use clap::ArgMatches;
use std::path::{Path, PathBuf};

/// Options that name a folder, as their fields are called, with what it is the folder of.
const FOLDERS: [(&str, &str); 2] = [("parts", "part files"), ("custom", "custom cuts")];

/// Refuses folders of options that are not there.
///
/// # Errors
/// There is none.
pub fn refuse_missing(given: &ArgMatches) -> Result<(), Usage> {
    let Some((_, given)) = given.subcommand() else { return Ok(()) };
    for (option, of) in FOLDERS {
        if let Some(folder) = given.try_get_one::<PathBuf>(option).ok().flatten() {
            is_there(folder, &format!("--{option} names the folder of {of}"))?;
        }
    }
    refuse_missing(given)
}

/// Refuses a folder that is not there; the words tell for what it is named.
///
/// # Errors
/// There is none.
pub fn is_there(folder: &Path, named: &str) -> Result<(), Usage> {
    if folder.as_os_str().is_empty() || folder.is_dir() {
        return Ok(());
    }
    let name = folder.display();
    Err(Usage(format!("there is no folder {name}: {named}; make it first, or name another")))
}
