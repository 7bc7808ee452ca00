//! Which file the configuration of the machine is: the one that `--machine` names, or that of the data folder.

use crate::data_args::{DataArgs, data_folder};
use crate::exit::Usage;
use crate::machine_choice::MachineChoice;
use crate::machine_name::MachineName;
use crate::memory;
use crate::named_machine::{Named, named, saved};
use anyhow::{Result, bail};
use clap::ArgMatches;
use kerf_journal::{JOURNAL_FILE, machine_file::MachineFile};
use kerf_machine::profile::profile;
use std::path::Path;

/// The file under which a machine is saved.
///
/// # Errors
/// The name means another machine, or is none.
pub fn to_save(name: &str, data: &DataArgs) -> Result<MachineFile> {
    let path = Path::new(name);
    match (MachineName::read(name), saved(path, data)?) {
        (Ok(MachineName::Configured(_)), Some(file)) if profile(name).is_none() => {
            Ok(MachineFile::at(file))
        }
        _ => bail!(Usage(format!(
            "'{name}' cannot be the name of a saved machine: give a word that names no other machine, as shop"
        ))),
    }
}

/// The file that changes go to.
pub fn of(choice: &MachineChoice, data: &DataArgs) -> Result<MachineFile> {
    let Some(name) = choice.configuration() else { return of_data(data) };
    match named(name, data)? {
        Named::File(path) => Ok(MachineFile::at(&path)),
        Named::Ready(ready) => bail!(Usage(format!(
            "{0} is a ready-made machine, which stays as it is: kerf machine profiles {0} > mine.toml makes a file \
             of it",
            ready.name
        ))),
    }
}

/// The one of the data folder.
pub fn of_data(data: &DataArgs) -> Result<MachineFile> {
    Ok(MachineFile::of_data(&data_folder(data)?))
}

/// The same, to be changed: the journal knows what Kerf leaves in it, where there is one.
pub fn of_data_to_change(data: &DataArgs) -> Result<MachineFile> {
    let (file, folder) = (of_data(data)?, data_folder(data)?);
    if !folder.join(JOURNAL_FILE).exists() {
        return Ok(file);
    }
    let journal = memory::journal(&folder, false)?;
    Ok(journal.map_or(file.clone(), |journal| journal.settings.knows(file)))
}

/// Refuses configurations of options that are not there, also where a command does not look at them.
///
/// # Errors
/// No file and no machine is called so.
pub fn refuse_missing(given: &ArgMatches) -> Result<()> {
    let Some((_, given)) = given.subcommand() else { return Ok(()) };
    let data = DataArgs::given(given);
    for name in MachineChoice::configured(given) {
        named(name, &data)?;
    }
    refuse_missing(given)
}
