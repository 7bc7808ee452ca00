//! Configurations by name: files, saved machines, ready-made ones.

use crate::data_args::{DataArgs, data_folder};
use crate::exit::Usage;
use crate::given;
use crate::machine_name::{DriverName, MachineName};
use anyhow::{Context, Result, bail};
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

/// Returns the controller that a configuration tells of. A configuration that cannot be read tells of none: whoever opens
/// it says why.
///
/// # Errors
/// It names something that is no controller.
pub fn controller(name: &Path, data: &DataArgs) -> Result<Option<DriverName>, Usage> {
    let Ok(Some(told)) = text(name, data).map(|text| controller_in(&text)) else { return Ok(None) };
    let name = match named(name, data) {
        Ok(Named::File(path)) => path.display().to_string(),
        _ => name.display().to_string(),
    };
    match MachineName::read(&told) {
        Ok(MachineName::Controller(named)) => Ok(Some(named)),
        Ok(MachineName::Sim) => Ok(None),
        Ok(MachineName::Configured(_)) => Err(Usage(format!(
            "{name}: options.controller is '{told}', which is no controller: grbl:/dev/ttyUSB0"
        ))),
        Err(why) => Err(Usage(format!("{name}: options.controller is '{told}': {why}"))),
    }
}

fn controller_in(text: &str) -> Option<String> {
    let machine = kerf_machine::file::read(&"".into(), text).ok()?;
    Some(machine.options.controller).filter(|told| !told.is_empty())
}

/// The file of a saved machine; a path names none.
pub fn saved(name: &Path, data: &DataArgs) -> Result<Option<PathBuf>> {
    let alone = name.file_name().filter(|file| *file == name.as_os_str());
    let word = alone.and_then(|word| word.to_str()).filter(|word| !word.ends_with(".toml"));
    let Some(word) = word else { return Ok(None) };
    Ok(Some(data_folder(data)?.join(SAVED).join(format!("{word}.toml"))))
}

/// The saved machines of a data folder by name, with their files.
pub fn all_saved(data: &DataArgs) -> Result<Vec<(String, PathBuf)>> {
    let folder = data_folder(data)?.join(SAVED);
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
