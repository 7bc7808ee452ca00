//! `kerf machine tools`: the tools by their numbers.

use super::shop::{Shop, not_beside_a_server};
use super::which::Which;
use crate::exit::{Exit, Usage};
use crate::{out, parse};
use anyhow::{Result, bail};
use clap::Subcommand;
use kerf_program::{Axis, Tool, decimal};

/// Changes of a tool.
#[derive(Clone, Debug, Subcommand)]
pub enum ToolsAction {
    /// Sets name, diameter and length of one; what is not given stays
    Set {
        /// Its number
        #[arg(value_parser = clap::value_parser!(u32).range(1..))]
        number: u32,
        /// Its name, as "end mill": the operator is asked for it by this; an empty one for none
        #[arg(long)]
        name: Option<String>,
        /// Diameter of its cutter, millimetres
        #[arg(long, value_name = "MM", value_parser = parse::not_negative)]
        diameter: Option<f64>,
        /// Its length, millimetres: as G43 takes it, or as the sensor for tools has measured it
        #[arg(long, value_name = "MM", allow_hyphen_values = true, value_parser = parse::number)]
        length: Option<f64>,
    },
    /// Tells which one is in the spindle; 0 for none
    In {
        /// Its number
        number: u32,
    },
    /// Forgets one
    Clear {
        /// Its number
        number: u32,
    },
}

/// Lists them, or changes one.
pub fn run(which: &Which, action: Option<&ToolsAction>) -> Result<Exit> {
    not_beside_a_server(which, "set its tools (G10 L1)")?;
    let mut shop = Shop::open(which, false)?;
    let in_spindle = shop.session.gcode.tool;
    let tools = &mut shop.session.gcode.tools;
    match action {
        None => {
            let lines: String =
                tools.iter().map(|(number, tool)| line(*number, tool, in_spindle)).collect();
            let none = "no tool is known: kerf machine tools set NUMBER --length MM\n";
            out::print(if lines.is_empty() { none } else { &lines });
            return Ok(Exit::Good);
        }
        Some(ToolsAction::Set { number, name, diameter, length }) => {
            if name.is_none() && diameter.or(*length).is_none() {
                bail!(Usage("give --name, --diameter, --length or several of them".into()));
            }
            let tool = tools.entry(*number).or_default();
            if let Some(name) = name {
                tool.name = (!name.is_empty()).then(|| name.as_str().into());
            }
            tool.diameter_mm = diameter.unwrap_or(tool.diameter_mm);
            tool.offset[Axis::Z] = length.unwrap_or(tool.offset[Axis::Z]);
        }
        Some(ToolsAction::In { number }) => shop.session.gcode.tool = *number,
        Some(ToolsAction::Clear { number }) => {
            if tools.remove(number).is_none() {
                bail!(Usage(format!("tool {number} is not known")));
            }
        }
    }
    shop.session.keep_place(&mut shop.workspace)?;
    Ok(Exit::Good)
}

/// A tool with its diameter, its length and its name.
fn line(number: u32, tool: &Tool, in_spindle: u32) -> String {
    let [diameter, length] = [tool.diameter_mm, tool.offset[Axis::Z]].map(|mm| decimal(mm, 3));
    let measured = if tool.measured { "  measured" } else { "" };
    let is_in = if number == in_spindle { "  in the spindle" } else { "" };
    let name = tool.name.as_ref().map(|name| format!("  {name}")).unwrap_or_default();
    format!(
        "T{number:<5} diameter {diameter:>8} mm  length {length:>9} mm{measured}{is_in}{name}\n"
    )
}
