//! `kerf sysvars`: the system variables and what they read on the machine as configured.

use crate::exit::{Exit, Usage};
use crate::{out, parse, setup};
use anyhow::{Result, bail};
use clap::Args;
use kerf_control::{Event, TextOptions, run_text};
use kerf_program::settings::LinearUnit;
use std::path::PathBuf;

/// Lists the system variables: number, value, unit and name
#[derive(Args)]
#[command(after_help = "Example: kerf sysvars --units mm")]
pub struct SysvarsArgs {
    /// Units, in or mm [default: in]
    #[arg(long, value_name = "UNIT", value_parser = parse::units)]
    units: Option<LinearUnit>,
    /// Configuration of the machine
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
}

pub fn run(args: &SysvarsArgs) -> Result<Exit> {
    let settings = setup::configured(args.config.as_deref(), args.units)?;
    let variables: Vec<_> = kerf_sbp::system_variables().collect();
    let values = values(&variables, TextOptions { settings, ..TextOptions::default() });
    if values.len() != variables.len() {
        bail!(Usage("the machine's configuration leaves variables without a value".into()));
    }
    let rows = variables.iter().zip(values);
    let lines = rows.map(|(variable, value)| {
        let (number, unit, name) = (variable.number, variable.unit, variable.name);
        format!("{number:>3}  {value:>12}  {unit:<20}  {name}\n")
    });
    out::print(&lines.collect::<String>());
    Ok(Exit::Good)
}

/// What a program that prints them all would print.
fn values(variables: &[kerf_sbp::SystemVariable], options: TextOptions) -> Vec<String> {
    let lines = variables.iter().map(|v| format!("PRINT %({})\n", v.number));
    let program = lines.collect::<String>();
    let outcome = run_text(&[("sysvars.sbp", &program)], "sysvars.sbp", options);
    let printed = outcome.events.into_iter().filter_map(|event| match event {
        Event::Print { text, .. } => Some(text.to_string()),
        _ => None,
    });
    printed.collect()
}
