//! Which file the configuration of the machine is: the one that `--machine` names, or that of the data folder.

use crate::args::DataArgs;
use crate::exit::Usage;
use crate::machine_name::{MachineChoice, MachineName};
use crate::{given, memory, setup};
use anyhow::{Context, Result, bail};
use clap::ArgMatches;
use kerf_journal::{JOURNAL_FILE, machine_file::MachineFile};
use kerf_machine::profile::{PROFILES, Profile, profile};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Folder of saved machines in the data folder.
const SAVED: &str = "machines";

/// Configuration that a name stands for.
pub enum Named {
    /// A file: named itself, or saved in the data folder.
    File(PathBuf),
    /// A ready-made machine.
    Ready(&'static Profile),
}

/// Finds the configuration of a name: a file, a saved machine or a ready-made one, in this order.
///
/// # Errors
/// Nothing is called so.
pub fn named(name: &Path, data: &DataArgs) -> Result<Named> {
    if name.is_file() {
        return Ok(Named::File(name.into()));
    }
    if let Some(saved) = saved(name, data)?.filter(|path| path.is_file()) {
        return Ok(Named::File(saved));
    }
    match name.to_str().and_then(profile) {
        Some(ready) => Ok(Named::Ready(ready)),
        None if name.exists() => Ok(Named::File(name.into())),
        None => bail!(nothing_called(&name.to_string_lossy())),
    }
}

/// The text of the configuration of a name.
///
/// # Errors
/// Nothing is called so, or it cannot be read.
pub fn text(name: &Path, data: &DataArgs) -> Result<String> {
    match named(name, data)? {
        Named::Ready(ready) => Ok(ready.text.to_owned()),
        Named::File(path) => given::text(&path),
    }
}

/// The file of a saved machine; a path names none.
fn saved(name: &Path, data: &DataArgs) -> Result<Option<PathBuf>> {
    let alone = name.file_name().filter(|file| *file == name.as_os_str());
    let word = alone.and_then(|word| word.to_str()).filter(|word| !word.ends_with(".toml"));
    let Some(word) = word else { return Ok(None) };
    Ok(Some(setup::data_folder(data)?.join(SAVED).join(format!("{word}.toml"))))
}

/// The saved machines of a data folder by name, with their files.
pub fn all_saved(data: &DataArgs) -> Result<Vec<(String, PathBuf)>> {
    let folder = setup::data_folder(data)?.join(SAVED);
    let entries = match fs::read_dir(&folder) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.with_context(|| folder.display().to_string())?,
    };
    let paths: Result<Vec<PathBuf>, _> = entries.map(|entry| Ok(entry?.path())).collect();
    let paths = paths
        .map_err(|error: std::io::Error| error)
        .with_context(|| folder.display().to_string())?;
    let named = |path: PathBuf| {
        let name = path.file_name()?.to_str()?.strip_suffix(".toml")?.to_owned();
        Some((name, path))
    };
    let mut all: Vec<_> = paths.into_iter().filter_map(named).collect();
    all.sort();
    Ok(all)
}

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
    Ok(MachineFile::of_data(&setup::data_folder(data)?))
}

/// The same, to be changed: the journal knows what Kerf leaves in it, where there is one.
pub fn of_data_to_change(data: &DataArgs) -> Result<MachineFile> {
    let (file, folder) = (of_data(data)?, setup::data_folder(data)?);
    if !folder.join(JOURNAL_FILE).exists() {
        return Ok(file);
    }
    let journal = memory::journal(&folder, false)?;
    Ok(journal.map_or(file.clone(), |journal| journal.settings.knows(file)))
}

/// The option that names the data folder, as its field is called.
const DATA: &str = "folder";

/// Refuses configurations of options that are not there, also where a command does not look at them.
///
/// # Errors
/// No file and no machine is called so.
pub fn refuse_missing(given: &ArgMatches) -> Result<()> {
    let Some((_, given)) = given.subcommand() else { return Ok(()) };
    let data = DataArgs { folder: given.try_get_one(DATA).ok().flatten().cloned() };
    for name in MachineChoice::configured(given) {
        named(name, &data)?;
    }
    refuse_missing(given)
}

/// There is neither a file nor a machine of a name.
fn nothing_called(name: &str) -> Usage {
    Usage(format!(
        "there is no machine '{name}': no such file, no saved machine and no ready-made one; {}",
        nearest(name)
    ))
}

/// Tells which ready-made machine a name may have meant, and where they are listed.
pub fn nearest(name: &str) -> String {
    let names = PROFILES.iter().map(|profile| profile.name);
    let meant = kerf_diag::did_you_mean(name, names).map_or_else(String::new, |it| it + " ");
    meant + "`kerf machine profiles` lists them"
}
