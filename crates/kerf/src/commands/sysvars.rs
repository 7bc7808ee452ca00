//! `kerf sysvars`: the system variables and what they read on the machine as it was left.

use crate::args::{PlaceArgs, Start};
use crate::exit::Exit;
use crate::{out, parse, setup};
use anyhow::Result;
use clap::Args;
use kerf_program::settings::LinearUnit;
use kerf_sbp::{SystemVariable, Value};
use std::path::Path;

/// Lists the system variables: number, present value, unit and name
///
/// `kerf get` prints one of them. Values are those of the machine as the last run left it; --start fresh shows those of a new one.
#[derive(Args)]
#[command(after_help = "Example: kerf sysvars --units mm")]
pub struct SysvarsArgs {
    /// Units, in or mm
    #[arg(long, value_name = "UNIT", value_parser = parse::units)]
    units: Option<LinearUnit>,
    #[command(flatten)]
    place: PlaceArgs,
}

pub fn run(args: &SysvarsArgs) -> Result<Exit> {
    let place = PlaceArgs { start: args.place.start.or(Some(Start::Kept)), ..args.place.clone() };
    let lines =
        all(&place, args.units)?.into_iter().map(|(variable, value)| line(&variable, &value));
    out::print(&lines.collect::<String>());
    Ok(Exit::Good)
}

/// Every system variable with what it reads.
pub fn all(place: &PlaceArgs, units: Option<LinearUnit>) -> Result<Vec<(SystemVariable, Value)>> {
    let mut workspace = setup::workspace(Path::new(""), place, true)?;
    let (mut session, _) = setup::session(place, true, &mut workspace)?;
    let mut settings = setup::settings(place, session.memory.settings)?;
    if let Some(unit) = units {
        settings.use_linear_unit(unit);
    }
    session.memory.settings = settings;
    Ok(kerf_control::system_variables(&session, &mut workspace))
}

/// A line of the list.
pub fn line(variable: &SystemVariable, value: &Value) -> String {
    let (number, unit, name) = (variable.number, variable.unit, variable.name);
    format!("{number:>3}  {:>12}  {unit:<20}  {name}\n", value.display())
}
