//! `kerf registry`: the values that programs and other software keep.

use crate::args::DataArgs;
use crate::exit::{Exit, Usage};
use crate::remote::Remote;
use crate::{memory, out, setup};
use anyhow::Result;
use clap::{Args, Subcommand};
use kerf_control::files::{Disk, RealDisk};
use kerf_control::journal::Journal;
use kerf_control::stored::check_value;
use std::path::Path;

/// Shows and sets the values that survive runs: uValue, $variables, what other software leaves
///
/// Keys are those of the external-control registry; a path before the last / is left out, so that
/// ShopBot/UserData/uValue is uValue.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf registry get\n  kerf registry get uValue\n  \
    kerf registry set uValue hello\n  kerf registry set uValue\n\nExit codes: 0 done, 1 the key has no value, 2 the command line was wrong")]
pub struct RegistryArgs {
    #[command(subcommand)]
    action: Action,
    /// Those of a running `kerf serve` at this address
    #[arg(long, value_name = "URL", global = true)]
    server: Option<String>,
    #[command(flatten)]
    data: DataArgs,
}

#[derive(Subcommand)]
enum Action {
    /// Prints a value, or all of them
    Get {
        /// Its key
        key: Option<String>,
    },
    /// Sets a value; without one the key is removed
    Set {
        /// Its key
        key: String,
        /// The value
        value: Option<String>,
    },
}

/// Asks a server, or tells it.
fn remotely(server: &Remote, action: &Action) -> Result<Exit> {
    match action {
        Action::Get { key: None } => {
            let lines = server.values()?.into_iter().map(|(key, value)| format!("{key}={value}\n"));
            out::print(&lines.collect::<String>());
        }
        Action::Get { key: Some(key) } => {
            let key = last_part(key);
            match server.values()?.into_iter().find(|(name, _)| name == key) {
                Some((_, value)) => out::print(&(value + "\n")),
                None => return Ok(no_value(key)),
            }
        }
        Action::Set { key, value } => server.set_value(last_part(key), value.as_deref())?,
    }
    Ok(Exit::Good)
}

fn no_value(key: &str) -> Exit {
    eprintln!("kerf: {key} has no value");
    Exit::Failed
}

pub fn run(args: &RegistryArgs) -> Result<Exit> {
    if let Action::Set { key, value } = &args.action {
        check_value(last_part(key), value.as_deref()).map_err(Usage)?;
    }
    if let Some(url) = &args.server {
        return remotely(&Remote::new(url, &args.data)?, &args.action);
    }
    let data = setup::data_folder(&args.data)?;
    match &args.action {
        Action::Get { key: None } => {
            let values = journal(&data)?.map(|j| j.values()).transpose()?.unwrap_or_default();
            let lines = values.iter().map(|(key, value)| format!("{key}={value}\n"));
            out::print(&lines.collect::<String>());
        }
        Action::Get { key: Some(key) } => {
            let key = last_part(key);
            let folder = || RealDisk.real_path(&data).display().to_string();
            let kept = journal(&data)?.map(|j| j.value(key)).transpose()?.flatten();
            let value = match live(&data, key)?.or(kept) {
                Some(value) => value,
                None if key == "SpindleStatus" => "0".into(),
                None if key == "uAppPath" => folder(),
                None if key == "uUsrPath" => {
                    RealDisk.real_path(Path::new("")).display().to_string()
                }
                None => return Ok(no_value(key)),
            };
            out::print(&(value + "\n"));
        }
        Action::Set { key, value } => {
            if let Some(journal) = memory::journal(&data, false)? {
                journal.set_value(last_part(key), value.as_deref())?;
            }
        }
    }
    Ok(Exit::Good)
}

/// Returns a value that the machine keeps itself: its status and its switches.
fn live(data: &Path, key: &str) -> Result<Option<String>> {
    let live = journal(data)?.map(|j| j.live()).transpose()?.unwrap_or_default();
    let found = live.values().into_iter().find(|(name, _)| *name == key);
    Ok(found.map(|(_, value)| value.to_string()))
}

fn journal(data: &Path) -> Result<Option<Journal>> {
    memory::journal(data, true)
}

fn last_part(key: &str) -> &str {
    key.rsplit(['/', '\\']).next().unwrap_or(key)
}
