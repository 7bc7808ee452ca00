//! The subcommands, one file each.

mod trace;

use crate::exit::Exit;
use anyhow::Result;
use clap::Subcommand;

/// What `kerf` can be told to do.
#[derive(Subcommand)]
pub enum Command {
    Trace(trace::TraceArgs),
}

/// Does it.
pub fn run(command: Command) -> Result<Exit> {
    match command {
        Command::Trace(args) => trace::run(&args),
    }
}
