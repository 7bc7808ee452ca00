//! Where the configuration of the machine lies: the file of `--config`, or `machine.toml` in the
//! data folder.

use crate::args::DataArgs;
use crate::exit::Usage;
use crate::setup;
use anyhow::{Context, Result, bail};
use kerf_control::files::{Disk, RealDisk};
use std::path::{Path, PathBuf};

/// Its name in the data folder.
const FILE: &str = "machine.toml";

/// The file.
pub struct MachineFile(PathBuf);

impl MachineFile {
    /// The file that changes go to.
    pub fn of(config: Option<&Path>, data: &DataArgs) -> Result<Self> {
        match config {
            Some(path) if path.is_file() => Ok(Self(path.into())),
            Some(name) => {
                bail!(Usage(format!("{} is no file that could be changed", name.display())))
            }
            None => Self::of_data(data),
        }
    }

    /// The one of the data folder.
    pub fn of_data(data: &DataArgs) -> Result<Self> {
        Ok(Self(setup::data_folder(data)?.join(FILE)))
    }

    /// What it says; nothing when it is not there.
    pub fn text(&self) -> Result<String> {
        if self.0.is_file() { setup::read_text(&self.0) } else { Ok(String::new()) }
    }

    /// Its name, for messages.
    pub fn name(&self) -> String {
        self.0.display().to_string()
    }

    /// Puts a text in its place, whole or not at all.
    pub fn write(&self, text: &str) -> Result<()> {
        let folder = self.0.parent().unwrap_or(Path::new(""));
        let written =
            RealDisk.make_folder(folder).and_then(|()| RealDisk.write(&self.0, text.as_bytes()));
        written.with_context(|| format!("cannot write {}", self.name()))
    }
}
