//! `kerf machine zeros`: the zero points that a controller keeps.

use super::axis_words::numbers;
use super::machine::controller as named_controller;
use super::shop::{Shop, not_beside_a_server};
use super::which::Which;
use crate::controller::First;
use crate::exit::{Exit, Usage};
use crate::out;
use anyhow::{Result, anyhow, bail};
use clap::Subcommand;
use kerf_control::controller::{Controller, working_reads};
use kerf_machine::driver::{Zero, ZeroChange};
use kerf_program::{decimal, rounded};

/// Changes of a zero point.
#[derive(Clone, Debug, Subcommand)]
pub enum ZerosAction {
    /// Sets one so that the axes read these numbers where the tool is, millimetres
    Set {
        /// Its name, as G54
        name: String,
        /// X,Y,Z; an axis without a number stays: 0,0,
        #[arg(allow_hyphen_values = true)]
        place: String,
        /// The numbers are its place, from home
        #[arg(long)]
        from_home: bool,
    },
    /// Has another one hold
    Use {
        /// Its name, as G55
        name: String,
    },
    /// Takes the shift of G92 away
    Clear,
}

impl ZerosAction {
    /// The zero point and its change.
    fn change(&self) -> Result<(String, ZeroChange)> {
        Ok(match self {
            Self::Set { name, place, from_home } => {
                let at = numbers(place)?;
                if at.iter().all(Option::is_none) {
                    bail!(Usage("give a number for one axis at least".into()));
                }
                let change = if *from_home { ZeroChange::Lies(at) } else { ZeroChange::Reads(at) };
                (name.to_uppercase(), change)
            }
            Self::Use { name } => (name.to_uppercase(), ZeroChange::Holds),
            Self::Clear => (Zero::SHIFT.into(), ZeroChange::Gone),
        })
    }
}

/// Lists them, or changes one; Kerf's own zero follows the one that holds.
pub fn run(which: &Which, action: Option<&ZerosAction>) -> Result<Exit> {
    named_controller(which)?;
    let change = action.map(ZerosAction::change).transpose()?;
    not_beside_a_server(which, "see and set its zero points")?;
    let mut shop = Shop::open_after(which, First::LOOK, false)?;
    let Some((name, change)) = change else {
        let told = shop.controller.as_ref().map(listed);
        shop.leave();
        out::print(&told.unwrap_or_default());
        return Ok(Exit::Good);
    };
    let missing = || anyhow!("there is no controller that keeps zero points");
    let controller = shop.controller.clone().ok_or_else(missing)?;
    let changed = controller.keeps_zero(&name, change, || false);
    let told = controller.zeros();
    let holds = told.iter().any(|zero| zero.name == name && zero.holds);
    let memory = &shop.session.memory;
    let reads = working_reads(memory.position, &told, change).filter(|_| changed.is_ok() && holds);
    let Some(reads) = reads else {
        shop.leave();
        changed.map_err(|why| anyhow!(why))?;
        return Ok(Exit::Good);
    };
    let unit_mm = memory.settings.linear_unit.mm();
    let word = |reads: &Option<f64>| {
        reads.map_or(String::new(), |mm| rounded(mm / unit_mm, 9).to_string())
    };
    let words: Vec<String> = reads[..3].iter().map(word).collect();
    shop.types(&format!("VA,{}", words.join(",")))
}

/// A line for each, with its place in millimetres; the one that holds is marked.
fn listed(controller: &Controller) -> String {
    let line = |zero: Zero| {
        let at: String =
            zero.at.0[..3].iter().map(|mm| format!("{:>12}", decimal(*mm, 3))).collect();
        let holds = if zero.holds && !zero.is_shift() { "  holds" } else { "" };
        format!("{:<6}{at}{holds}\n", zero.name)
    };
    controller.zeros().into_iter().map(line).collect()
}
