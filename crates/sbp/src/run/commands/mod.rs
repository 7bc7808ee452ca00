//! Commands carried out: a file for each family of effects.
//!
//! The table of commands names the effect of each as data ([`Act`]); the compiler asks for a function here when there
//! is a new one.

mod conversion;
mod cuts;
mod direction;
mod display;
mod files;
mod help;
mod independent;
mod modes;
mod moves;
mod outputs;
mod recorder;
mod setting;
mod settings_files;
mod speeds;
#[cfg(test)]
mod tests;
mod tools;
mod utilities;
mod values;
mod zero;

use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::{Act, CommandSpec};

/// Carries a command out. Its arguments are checked: count, kind, bounds, required ones given.
pub(super) fn carry_out(
    c: &mut Context<'_>,
    spec: &CommandSpec,
    a: &Arguments,
) -> Result<(), Stop> {
    match spec.act {
        Act::Move(act) => moves::run(c, act, a),
        Act::Zero(act) => zero::run(c, act),
        Act::Cut(act) => cuts::run(c, act, a),
        Act::File(act) => files::run(c, act, a),
        Act::Mode(act) => modes::run(c, act, a),
        Act::Value(act) => values::run(c, act, a),
        Act::Record(act) => recorder::run(c, act, a),
        Act::Utility(act) => utilities::run(c, act, a),
        Act::Tool(letter) => tools::start(c, letter, a),
        Act::Help => {
            help::show(c, spec);
            Ok(())
        }
    }
}
