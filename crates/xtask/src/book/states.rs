//! The page of the machine's states, made from the table that runs it.

use crate::Tree;
use anyhow::Result;
use kerf_machine::state::{diagram, rows};
use std::fmt::Write as _;

const STATES: &str = "\
<!-- Written by `make book` from crates/machine/src/state.rs. Do not edit. -->

# What a machine does when it is stopped

One table holds for jobs and part files: OpenSBP's stop and Profiler's pause are the same states with
other settings. What is not in the table may not happen. *Slow down* keeps every step; *come back* is the
whole way back to the place that was kept: travel, router, tool, plunge, cut, each with its delay. Raising,
and switching the router and the tool off, depend on the settings: `pause.raise` for jobs; part files always
rise, and leave outputs to their modes.
";

/// The page.
///
/// # Errors
/// Never; pages share one form.
pub fn states(_: &Tree) -> Result<String> {
    let mut page = STATES.to_owned();
    let _ = write!(page, "\n```mermaid\n{}```\n\n", diagram());
    page += "| in this state | on this event | the machine is then | and does, in order |\n|---|---|---|---|\n";
    for (from, event, to, effects) in rows() {
        let effects: Vec<_> = effects.iter().map(|effect| effect.name()).collect();
        let effects = if effects.is_empty() { "nothing".into() } else { effects.join(", ") };
        let _ = writeln!(page, "| {} | {event:?} | {} | {effects} |", from.name(), to.name());
    }
    Ok(page)
}
