//! The data folder, as the command line names it.

use anyhow::{Context, Result};
use clap::{ArgMatches, Args};
use std::env;
use std::path::PathBuf;

/// Options that name the folder of values that survive.
#[derive(Args, Clone, Debug)]
pub struct DataArgs {
    /// The folder of values that survive [default: KERF_DATA, or the system's place for data]
    #[arg(long = "data", value_name = "DIR", global = true)]
    pub folder: Option<PathBuf>,
}

/// The option that names the data folder, as its field is called.
const DATA: &str = "folder";

impl DataArgs {
    /// Reads them off the options of a command, also of one that does not have them.
    pub fn given(given: &ArgMatches) -> Self {
        Self { folder: given.try_get_one(DATA).ok().flatten().cloned() }
    }
}

/// Returns the folder of values that survive.
pub fn data_folder(args: &DataArgs) -> Result<PathBuf> {
    if let Some(folder) = &args.folder {
        return Ok(folder.clone());
    }
    let variable = |name| env::var_os(name).filter(|v| !v.is_empty()).map(PathBuf::from);
    let home = || variable("HOME").or_else(|| variable("USERPROFILE"));
    variable("KERF_DATA")
        .or_else(|| Some(variable("XDG_DATA_HOME")?.join("kerf")))
        .or_else(|| Some(variable("LOCALAPPDATA")?.join("kerf")))
        .or_else(|| Some(home()?.join(".local/share/kerf")))
        .context("no folder for data: give --data or set KERF_DATA")
}
