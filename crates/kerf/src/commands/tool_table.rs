//! `kerf machine tools`: the tools of G-code by their numbers.

use super::by_hand::{Shop, not_beside_a_server};
use super::which::Which;
use crate::exit::{Exit, Usage};
use crate::{out, parse};
use anyhow::{Result, bail};
use clap::Subcommand;
use kerf_gcode::Tool;
use kerf_program::{Axis, decimal};

/// Changes of a tool.
#[derive(Clone, Copy, Debug, Subcommand)]
pub enum ToolsAction {
    /// Sets diameter and length of one; what is not given stays
    Set {
        /// Its number
        #[arg(value_parser = clap::value_parser!(u32).range(1..))]
        number: u32,
        /// Diameter of its cutter, millimetres
        #[arg(long, value_name = "MM", value_parser = parse::not_negative)]
        diameter: Option<f64>,
        /// Its length as G43 takes it, millimetres
        #[arg(long, value_name = "MM", allow_hyphen_values = true, value_parser = parse::number)]
        length: Option<f64>,
    },
    /// Forgets one
    Clear {
        /// Its number
        number: u32,
    },
}

/// Lists them, or changes one.
pub fn run(which: &Which, action: Option<ToolsAction>) -> Result<Exit> {
    not_beside_a_server(which, "set its tools (G10 L1)")?;
    let mut shop = Shop::open(which, false)?;
    let tools = &mut shop.session.gcode.tools;
    match action {
        None => {
            let lines: String = tools.iter().map(|(number, tool)| line(*number, tool)).collect();
            let none = "no tool is known: kerf machine tools set NUMBER --length MM\n";
            out::print(if lines.is_empty() { none } else { &lines });
            return Ok(Exit::Good);
        }
        Some(ToolsAction::Set { number, diameter, length }) => {
            if diameter.or(length).is_none() {
                bail!(Usage("give --diameter, --length or both".into()));
            }
            let tool = tools.entry(number).or_default();
            tool.diameter_mm = diameter.unwrap_or(tool.diameter_mm);
            tool.offset[Axis::Z] = length.unwrap_or(tool.offset[Axis::Z]);
        }
        Some(ToolsAction::Clear { number }) => {
            if tools.remove(&number).is_none() {
                bail!(Usage(format!("tool {number} is not known")));
            }
        }
    }
    shop.session.keep_place(&mut shop.workspace)?;
    Ok(Exit::Good)
}

/// A tool with its diameter and its length.
fn line(number: u32, tool: &Tool) -> String {
    let [diameter, length] = [tool.diameter_mm, tool.offset[Axis::Z]].map(|mm| decimal(mm, 3));
    format!("T{number:<5} diameter {diameter:>8} mm  length {length:>9} mm\n")
}
