//! What of the command line reaches a server: the rest is refused by name, for nobody would heed it there.

use crate::exit::Usage;
use anyhow::{Result, bail};
use clap::ArgMatches;
use clap::parser::ValueSource;

/// Refuses the options of a command that were given and are not among those that reach a server.
pub fn refuse_others(cli: &clap::Command, given: &ArgMatches, reach: &[&str]) -> Result<()> {
    let Some((name, given)) = given.subcommand() else { return Ok(()) };
    let command = cli.find_subcommand(name);
    let known = command.into_iter().flat_map(clap::Command::get_arguments);
    let typed = known.filter(|arg| {
        let id = arg.get_id().as_str();
        let source = given.try_contains_id(id).ok().and_then(|_| given.value_source(id));
        source == Some(ValueSource::CommandLine) && !reach.contains(&id)
    });
    let names: Vec<_> =
        typed.filter_map(|arg| arg.get_long()).map(|it| format!("--{it}")).collect();
    if names.is_empty() {
        return Ok(());
    }
    let (names, are) = (names.join(", "), if names.len() > 1 { "are" } else { "is" });
    bail!(Usage(format!(
        "{names} {are} not heeded by a server, which has its own machine, folders and settings: leave it out, set \
         the machine at the server (kerf machine set, its console), or run it here without --server"
    )))
}
