//! `kerf log`: the system log.

use crate::data_args::{DataArgs, data_folder};
use crate::exit::Exit;
use crate::{given, out};
use anyhow::Result;
use clap::{Args, Subcommand};
use kerf_workspace::{system_log::SYSTEM_LOG, system_log::changed_lines};
use std::path::PathBuf;

/// Shows the system log, or looks whether a line of it was changed
#[derive(Args)]
#[command(
    after_help = "Examples:\n  kerf log show\n  kerf log verify\n  kerf log verify copy-of-SbSys.log"
)]
pub struct LogArgs {
    #[command(subcommand)]
    action: Action,
    #[command(flatten)]
    data: DataArgs,
}

#[derive(Subcommand)]
enum Action {
    /// Prints it
    Show,
    /// Prints the lines whose check numbers are wrong
    Verify {
        /// Another file than that of the data folder
        file: Option<PathBuf>,
    },
}

pub fn run(args: &LogArgs) -> Result<Exit> {
    let own = data_folder(&args.data)?.join(SYSTEM_LOG);
    match &args.action {
        Action::Show => {
            out::print(&given::text(&own)?);
            Ok(Exit::Good)
        }
        Action::Verify { file } => {
            let file = file.as_ref().unwrap_or(&own);
            let changed = changed_lines(&given::text(file)?);
            let line = |n: &usize| format!("{}:{n}: was changed\n", file.display());
            out::print(&changed.iter().map(line).collect::<String>());
            Ok(if changed.is_empty() { Exit::Good } else { Exit::Failed })
        }
    }
}
