//! Which file the configuration of the machine is: that of `--config`, or the one of the data folder.

use crate::args::DataArgs;
use crate::exit::Usage;
use crate::setup;
use anyhow::{Result, bail};
use kerf_control::machine_file::MachineFile;
use std::path::Path;

/// The file that changes go to.
pub fn of(config: Option<&Path>, data: &DataArgs) -> Result<MachineFile> {
    match config {
        Some(path) if path.is_file() => Ok(MachineFile::at(path)),
        Some(name) => bail!(Usage(format!("{} is no file that could be changed", name.display()))),
        None => of_data(data),
    }
}

/// The one of the data folder.
pub fn of_data(data: &DataArgs) -> Result<MachineFile> {
    Ok(MachineFile::of_data(&setup::data_folder(data)?))
}
