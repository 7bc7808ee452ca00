//! The `kerf` command: the whole of Kerf from a terminal.
//!
//! Each subcommand is a file of [`commands`]; what they share is in [`args`] (options) and [`setup`]
//! (from options to a machine, its folders and its memory). Exit codes are in [`exit`].

mod args;
mod commands;
mod exit;
mod memory;
mod operator;
mod out;
mod parse;
mod picture;
mod progress;
mod report;
mod setup;
mod sources;

use clap::Parser;
use std::process::ExitCode;

/// Runs part files and pictures, times and checks them.
#[derive(Parser)]
#[command(name = "kerf", version, about, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: commands::Command,
}

fn main() -> ExitCode {
    match commands::run(Cli::parse().command) {
        Ok(exit) => exit.into(),
        Err(error) => {
            eprintln!("kerf: {error:#}");
            exit::of_error(&error).into()
        }
    }
}
