//! The `kerf` command: the whole of Kerf from a terminal.
//!
//! Each subcommand is a file of [`commands`]; what they share is in [`args`] (options) and [`setup`]
//! (from options to a machine, its folders and its memory). Exit codes are in [`exit`].

/// As in the standard library, but a terminal that has gone is no panic: what runs has to be stopped.
macro_rules! eprint {
    ($($arg:tt)*) => {{
        use std::io::Write as _;
        let _ = write!(std::io::stderr(), $($arg)*);
    }};
}

/// As [`eprint`], with the end of the line.
macro_rules! eprintln {
    ($($arg:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($arg)*);
    }};
}

mod accepted_options;
mod args;
mod checked;
mod clock;
mod coloured;
mod commands;
mod controller;
mod curves;
mod data_args;
mod date;
mod drawings;
mod exit;
mod folders;
mod given;
mod groups;
mod job_options;
mod machine_choice;
mod machine_file;
mod machine_name;
mod memory;
#[cfg(test)]
mod messages;
mod named_machine;
mod operator;
mod out;
mod outputs;
mod parse;
mod picture;
mod picture_format;
mod preview_mode;
mod progress;
mod remote;
mod report;
mod script;
mod sending;
mod served;
mod setup;
mod sources;
mod start_up;
mod stop;
mod streamed;
mod summary;
mod transfer;
mod unused;
mod visit;
mod waveforms;

use clap::{Arg, ArgAction, CommandFactory, FromArgMatches, Parser};
use std::process::ExitCode;

/// Runs part files, makes tool paths from drawings, drives the machine
///
/// Part files are OpenSBP or G-code and run on a machine: the simulated one unless told otherwise.
/// `kerf check`, `preview`, `plot`, `time`, `timing` and `trace` move and change nothing.
#[derive(Parser)]
#[command(name = "kerf", version, max_term_width = 100, after_help = START_HERE)]
#[command(disable_help_subcommand = true)]
struct Cli {
    #[command(subcommand)]
    command: commands::Command,
    /// The version for editing alone: nothing that moves or switches a machine
    #[arg(long)]
    edit_only: bool,
}

/// Text below the list of commands.
const START_HERE: &str = "Start here:
  kerf check box.sbp                  is anything wrong with it?
  kerf preview box.sbp -o box.html    what will it cut?
  kerf time box.sbp                   how long does it take?
  kerf plot box.sbp -o speed.svg      how fast is it where?
  kerf run box.sbp                    run it, on the simulated machine

`kerf help COMMAND` lists the options of a command with examples, `kerf explain CODE` explains a message,
`kerf help term WORD` a word of the field.

Exit codes: 0 all went well, 1 the program failed or errors were found, 2 the command line was wrong,
3 stopped by the operator or a limit";

/// The option that is also taken behind the command, where no help lists it.
const EDIT_ONLY: &str = "edit_only";

/// The command line: its commands with all options.
fn command_line() -> clap::Command {
    let behind = Arg::new(EDIT_ONLY).long("edit-only").hide(true).action(ArgAction::SetTrue);
    let cli = Cli::command().mut_subcommands(|it| it.arg(behind.clone().global(true)));
    parse::with_negative_numbers(groups::grouped(unused::hidden(cli)))
}

fn main() -> ExitCode {
    let cli = command_line();
    let given = cli.clone().get_matches();
    let Cli { command, edit_only } = Cli::from_arg_matches(&given).unwrap_or_else(|e| e.exit());
    let behind = given.subcommand().is_some_and(|(_, given)| given.get_flag(EDIT_ONLY));
    let fits = command.restricted(edit_only || behind).and_then(|it| it.heeding(&cli, &given));
    match stop::outlive_full_files().and_then(|()| commands::run(fits)) {
        Ok(exit) => exit.into(),
        Err(error) => {
            eprintln!("kerf: {error:#}");
            exit::of_error(&error).into()
        }
    }
}
