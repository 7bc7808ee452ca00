//! The values that programs and other software keep: of a server, or of the data folder.

use crate::data_args::{DataArgs, data_folder};
use crate::exit::Usage;
use crate::memory;
use crate::remote::Remote;
use anyhow::Result;
use clap::Args;
use kerf_files::{Disk, RealDisk};
use kerf_journal::{Journal, check_value};
use std::path::{Path, PathBuf};

/// Folder or server whose values are meant.
#[derive(Args, Clone, Debug)]
pub struct KeptValues {
    /// The values of a running `kerf serve` at this address
    #[arg(long, value_name = "URL", global = true)]
    pub server: Option<String>,
    #[command(flatten)]
    pub data: DataArgs,
}

impl KeptValues {
    /// Every value with its key.
    pub fn all(&self) -> Result<Vec<(String, String)>> {
        match self.remote()? {
            Some(server) => server.values(),
            None => {
                let values =
                    self.looks()?.map(|it| it.registry.values()).transpose()?.unwrap_or_default();
                Ok(values.into_iter().collect())
            }
        }
    }

    /// The value of a key, where it has one. The machine itself tells its status, its switches and its folders.
    pub fn get(&self, key: &str) -> Result<Option<String>> {
        let key = last_part(key);
        if let Some(server) = self.remote()? {
            return Ok(server.values()?.into_iter().find(|(name, _)| name == key).map(|it| it.1));
        }
        let journal = self.looks()?;
        let live = journal.as_ref().map(|it| it.registry.live()).transpose()?.unwrap_or_default();
        let live = live.values().into_iter().find(|(name, _)| *name == key);
        let kept = journal.map(|it| it.registry.value(key)).transpose()?.flatten();
        match live.map(|(_, value)| value.to_string()).or(kept) {
            None => self.usual(key),
            value => Ok(value),
        }
    }

    /// Sets a value; without one the key is removed.
    pub fn set(&self, key: &str, value: Option<&str>) -> Result<()> {
        let key = last_part(key);
        check_value(key, value).map_err(Usage)?;
        if let Some(server) = self.remote()? {
            return server.set_value(key, value);
        }
        if let Some(journal) = memory::journal(&self.folder()?, false)? {
            journal.registry.set_value(key, value)?;
        }
        Ok(())
    }

    /// The value of a key that nobody has set.
    fn usual(&self, key: &str) -> Result<Option<String>> {
        let shown = |path: &Path| Some(RealDisk.real_path(path).display().to_string());
        Ok(match key {
            "SpindleStatus" => Some("0".into()),
            "uAppPath" => shown(&self.folder()?),
            "uUsrPath" => shown(Path::new("")),
            _ => None,
        })
    }

    fn remote(&self) -> Result<Option<Remote>> {
        self.server.as_ref().map(|url| Remote::new(url, &self.data)).transpose()
    }

    fn folder(&self) -> Result<PathBuf> {
        data_folder(&self.data)
    }

    fn looks(&self) -> Result<Option<Journal>> {
        memory::journal(&self.folder()?, true)
    }
}

/// The key at the end of a path in the registry.
fn last_part(key: &str) -> &str {
    key.rsplit(['/', '\\']).next().unwrap_or(key)
}
