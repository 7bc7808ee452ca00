//! `kerf registry`: the values that programs and other software keep.

use super::kept_values::KeptValues;
use crate::exit::Exit;
use crate::out;
use anyhow::Result;
use clap::{Args, Subcommand};

/// Shows and sets the values that survive runs: uValue, $variables, what other software leaves
///
/// Keys are those of the external-control registry; a path before the last / is left out, so that
/// ShopBot/UserData/uValue is uValue. `kerf get` and `kerf set` know these values too.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf registry get\n  kerf registry get uValue\n  \
    kerf registry set uValue hello\n  kerf registry set uValue\n\nExit codes: 0 done, 1 the key has no value, 2 the command line was wrong")]
pub struct RegistryArgs {
    #[command(subcommand)]
    action: Action,
    #[command(flatten)]
    values: KeptValues,
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

pub fn run(args: &RegistryArgs) -> Result<Exit> {
    match &args.action {
        Action::Get { key: None } => {
            let lines =
                args.values.all()?.into_iter().map(|(key, value)| format!("{key}={value}\n"));
            out::print(&lines.collect::<String>());
        }
        Action::Get { key: Some(key) } => match args.values.get(key)? {
            Some(value) => out::print(&(value + "\n")),
            None => {
                eprintln!("kerf: {key} has no value");
                return Ok(Exit::Failed);
            }
        },
        Action::Set { key, value } => args.values.set(key, value.as_deref())?,
    }
    Ok(Exit::Good)
}
