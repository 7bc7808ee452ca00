//! Which file the configuration of the machine is: that of `--config`, or the one of the data folder.

use crate::args::DataArgs;
use crate::exit::Usage;
use crate::{memory, setup};
use anyhow::{Result, bail};
use kerf_control::journal::JOURNAL_FILE;
use kerf_control::machine_file::MachineFile;
use kerf_machine::profile::{PROFILES, profile};
use std::path::Path;

/// The file that changes go to.
pub fn of(config: Option<&Path>, data: &DataArgs) -> Result<MachineFile> {
    match config {
        Some(path) if path.is_file() => Ok(MachineFile::at(path)),
        Some(name) => {
            let words = name.display().to_string();
            if profile(&words).is_none() {
                bail!(nothing_called(&words));
            }
            bail!(Usage(format!(
                "{words} is a ready-made machine, which stays as it is: kerf machine profiles {words} > mine.toml \
                 makes a file of it"
            )))
        }
        None => of_data(data),
    }
}

/// The one of the data folder.
pub fn of_data(data: &DataArgs) -> Result<MachineFile> {
    Ok(MachineFile::of_data(&setup::data_folder(data)?))
}

/// The same, to be changed: the journal knows what Kerf leaves in it, where there is one.
pub fn of_data_to_change(data: &DataArgs) -> Result<MachineFile> {
    let (file, folder) = (of_data(data)?, setup::data_folder(data)?);
    if !folder.join(JOURNAL_FILE).exists() {
        return Ok(file);
    }
    let journal = memory::journal(&folder, false)?;
    Ok(journal.map_or(file.clone(), |journal| file.known_to(&journal)))
}

/// There is neither a file nor a ready-made machine of a name.
pub fn nothing_called(name: &str) -> Usage {
    Usage(format!(
        "cannot read {name}: there is no such file, and no ready-made machine; {}",
        nearest(name)
    ))
}

/// Tells which ready-made machine a name may have meant, and where they are listed.
pub fn nearest(name: &str) -> String {
    let names = PROFILES.iter().map(|profile| profile.name);
    let meant = kerf_diag::did_you_mean(name, names).map_or_else(String::new, |it| it + " ");
    meant + "`kerf machine profiles` lists them"
}
