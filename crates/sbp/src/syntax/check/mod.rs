//! Finds what is doubtful in a part file, without running it.
//!
//! Reading tells what cannot be read; running tells what happens on the way that is taken. These
//! rules look at the whole file, branches that no run takes included, for what experience says goes
//! wrong: a missing label, the wrong unit, a jog through the material, a loop without an end. Each
//! rule stays silent when it cannot know: a false alarm costs more than a missed one.

mod cutting;
mod facts;
mod inputs;
mod jumps;
#[cfg(test)]
mod tests;
mod units;
mod variables;

pub use inputs::stops_on_keys;

use crate::syntax::Program;
use facts::Facts;
use kerf_diag::Diagnostic;
use kerf_program::settings::LinearUnit;

/// A rule: facts about a file to findings, in any order.
type Rule = fn(&Facts<'_>) -> Vec<Diagnostic>;

/// Rules for every file.
const RULES: &[Rule] = &[
    jumps::unknown_labels,
    jumps::unreachable_lines,
    jumps::endless_loops,
    variables::fractional_counters,
    cutting::jogs_below_surface,
    cutting::old_order_of_speeds,
    cutting::plunges_that_lift,
];

/// Rules about what a file should have seen to before it moves, where no other file has done so.
const RULES_ALONE: &[Rule] =
    &[variables::never_assigned, units::missing_guard, units::mismatch, cutting::spindle_off];

/// Looks through a part file that was read.
///
/// A file that is started by itself gives the unit that the machine is set to. `None` is for a file
/// that another one calls: units, variables and the spindle are the caller's business then.
///
/// Gives warnings and notes in order of lines; what reading found is not repeated.
pub fn check(program: &Program, alone: Option<LinearUnit>) -> Vec<Diagnostic> {
    check_until(program, alone, &|| false)
}

/// The same, until it is given up: that is asked before each rule, and those that are left find nothing.
pub fn check_until(
    program: &Program,
    alone: Option<LinearUnit>,
    given_up: &dyn Fn() -> bool,
) -> Vec<Diagnostic> {
    let facts = Facts::new(program, alone.unwrap_or_default());
    let more = if alone.is_some() { RULES_ALONE } else { &[] };
    let rules = RULES.iter().chain(more).take_while(|_| !given_up());
    let mut found: Vec<Diagnostic> = rules.flat_map(|rule| rule(&facts)).collect();
    found.sort_by_key(|d| (d.place.line, d.place.column));
    found
}
