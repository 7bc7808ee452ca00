//! Groups of commands, as `kerf --help` lists them.

use clap::Command;
use std::fmt::Write;

/// Heading of each group, with its commands in the order in which they are listed.
const GROUPS: [(&str, &[&str]); 6] = [
    (
        "Part files, without moving anything",
        &["check", "preview", "plot", "time", "timing", "heights", "trace", "fmt", "convert"],
    ),
    ("Drawings", &["draw", "toolpath"]),
    ("Runs", &["run", "send", "receive", "serve", "sb3"]),
    ("The machine", &["get", "set", "machine", "settings", "map", "io", "log"]),
    ("Older ways to get and set values, for scripts", &["registry", "sysvars"]),
    ("Files and help", &["parts", "samples", "wavlength", "explain", "help"]),
];

/// The command line with its commands listed in groups.
pub fn grouped(cli: Command) -> Command {
    let mut list = String::new();
    for (heading, names) in GROUPS {
        // Writing to a string does not fail.
        let _ = writeln!(list, "{heading}:");
        for command in names.iter().filter_map(|name| cli.find_subcommand(name)) {
            let about = command.get_about().map(ToString::to_string).unwrap_or_default();
            let aliases: String =
                command.get_visible_aliases().map(|alias| format!(" [alias: {alias}]")).collect();
            let _ = writeln!(list, "  {:<11}{about}{aliases}", command.get_name());
        }
        list.push('\n');
    }
    let template = format!(
        "{{about-section}}\n{{usage-heading}} {{usage}}\n\n{list}Options:\n{{options}}{{after-help}}"
    );
    cli.help_template(template)
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn each_command_is_in_one_group() {
        let cli = crate::Cli::command();
        let mut listed: Vec<&str> = GROUPS.iter().flat_map(|(_, names)| *names).copied().collect();
        let mut commands: Vec<&str> = cli.get_subcommands().map(Command::get_name).collect();
        listed.sort_unstable();
        commands.sort_unstable();
        assert_eq!(listed, commands);
    }
}
