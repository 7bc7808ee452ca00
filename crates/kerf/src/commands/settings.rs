//! `kerf settings`: what the V commands are set to, and files of it.

use super::send;
use crate::args::{PlaceArgs, RunArgs, Start};
use crate::exit::{Exit, Usage};
use crate::{out, setup};
use anyhow::{Result, bail};
use clap::{Args, Subcommand};
use kerf_program::{FileRequest, Folder, HostError};
use std::path::Path;

/// Shows, saves and loads the settings of the V commands, as UV, US and UR do
///
/// Settings files (.sbd) lie in the folder `settings` of the data folder; some come with Kerf. They are
/// part files that set a machine.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf settings show\n  kerf settings save mine\n  \
    kerf settings load simulated-96x48")]
pub struct SettingsArgs {
    #[command(subcommand)]
    action: Action,
}

#[derive(Subcommand)]
enum Action {
    /// Prints the lines that set what is set now, and the part folder
    Show(Lined),
    /// Lists the settings files
    List(Lined),
    /// Saves the settings into a file
    Save(Named),
    /// Runs a settings file
    Load {
        #[command(flatten)]
        named: Named,
        /// Begins the system log anew
        #[arg(long)]
        delete_log: bool,
    },
}

#[derive(Args)]
struct Lined {
    #[command(flatten)]
    place: PlaceArgs,
}

#[derive(Args)]
struct Named {
    /// Its name
    name: String,
    #[command(flatten)]
    machine: super::run::MachineArgs,
    #[command(flatten)]
    run: RunArgs,
}

pub fn run(args: SettingsArgs) -> Result<Exit> {
    match args.action {
        Action::Show(Lined { place }) => show(&place),
        Action::List(Lined { place }) => {
            let workspace = setup::workspace(Path::new(""), &place, true)?;
            out::print(&(workspace.settings_files().join("\n") + "\n"));
            Ok(Exit::Good)
        }
        Action::Save(named) => typed(|name| format!("US,{name}"), named),
        Action::Load { named, delete_log } => {
            is_there(&named)?;
            typed(|name| format!("UR,{name},{}", u8::from(delete_log)), named)
        }
    }
}

/// Refuses a settings file that is not there.
fn is_there(Named { name, run, .. }: &Named) -> Result<()> {
    let mut workspace = setup::workspace(Path::new(""), &run.place, true)?;
    let request = FileRequest { folder: Folder::Settings, name: name.clone() };
    match workspace.source(&request) {
        Err(HostError::NotFound(why)) => bail!(Usage(why)),
        _ => Ok(()),
    }
}

/// Prints the lines of UV.
fn show(place: &PlaceArgs) -> Result<Exit> {
    let start = place.start.or(Some(Start::Kept));
    let lines = lines(&PlaceArgs { start, ..place.clone() })?;
    out::print(&(lines.join("\n") + "\n"));
    Ok(Exit::Good)
}

/// The lines of UV: what sets what is set now, and the part folder.
pub fn lines(place: &PlaceArgs) -> Result<Vec<String>> {
    let mut workspace = setup::workspace(Path::new(""), place, true)?;
    let (session, _) = setup::session(place, true, &mut workspace)?;
    let settings = setup::settings(place, session.memory.settings)?;
    let mut lines = kerf_sbp::table::settings_lines(&settings);
    lines.push(format!("FS,{},{}", workspace.user_path(), workspace.mask()));
    Ok(lines)
}

fn typed(line: impl FnOnce(&str) -> String, named: Named) -> Result<Exit> {
    let Named { name, machine, run } = named;
    send::carry_out(&(line(&name) + "\n"), machine, run)
}
