//! Options that a command accepts in a certain case: the others are refused by name.

use crate::exit::Usage;
use anyhow::{Result, bail};
use clap::ArgMatches;
use clap::parser::ValueSource;

/// Options that a command accepts, and the reason for refusing the others.
pub struct AcceptedOptions {
    /// Names of the options, as their fields are called.
    pub options: &'static [&'static str],
    /// Words behind `--input is not heeded `: the case in which it does nothing, and what to do instead.
    pub instead: &'static str,
}

impl AcceptedOptions {
    /// Refuses the options of a command that were given and are not among these.
    pub fn refuse_others(&self, cli: &clap::Command, given: &ArgMatches) -> Result<()> {
        let Some((name, given)) = given.subcommand() else { return Ok(()) };
        let command = cli.find_subcommand(name);
        let known = command.into_iter().flat_map(clap::Command::get_arguments);
        let typed = known.filter(|arg| {
            let id = arg.get_id().as_str();
            let source = given.try_contains_id(id).ok().and_then(|_| given.value_source(id));
            source == Some(ValueSource::CommandLine) && !self.options.contains(&id)
        });
        let names: Vec<_> =
            typed.filter_map(|arg| arg.get_long()).map(|it| format!("--{it}")).collect();
        if names.is_empty() {
            return Ok(());
        }
        let (names, are) = (names.join(", "), if names.len() > 1 { "are" } else { "is" });
        bail!(Usage(format!("{names} {are} not heeded {}", self.instead)))
    }
}
