//! Help: pages that the console shows. In a part file help does nothing, with a warning.

use super::{CommandSpec, Group, Stack};
use crate::interp::{Context, Stop};
use kerf_diag::Code;
use kerf_program::Command;

macro_rules! help {
    ($letters:literal, $name:literal, $doc:literal) => {
        CommandSpec::new($letters, $name, Group::Help, &[], Stack::Joins, $doc, |c, _| {
            help(c, concat!($letters, ": ", $name))
        })
    };
}

pub(super) static SPECS: [CommandSpec; 10] = [
    help!("HA", "About", "Shows version, licence and driver."),
    help!("HB", "Bulletins", "Opens the page of news."),
    help!("HC", "Command reference", "Opens the reference of all commands."),
    help!(
        "HE",
        "Quick reference for editing",
        "Opens the commands with their values in file order."
    ),
    help!("HN", "Ask for help", "Makes a request for help with the problem log."),
    help!("HQ", "Quick start", "Opens the page for the first run."),
    help!("HR", "Quick reference", "Opens the commands on one page to print."),
    help!("HT", "Troubleshooting", "Opens troubleshooting and maintenance."),
    help!("HU", "User guide", "Opens the user guide."),
    help!("HW", "Web site", "Shows the address of the project."),
];

/// Typed, it names the page for the console; a part file goes on without.
fn help(c: &mut Context<'_>, page: &str) -> Result<(), Stop> {
    if c.core.options.typed {
        c.emit(Command::Message { text: page.into() });
    } else {
        let hint = "help opens when it is typed";
        c.warn(Code::IgnoredInFile, "help is not shown from a part file", hint);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::Options;
    use crate::testing::{FakeHost, check, run_as};
    use kerf_program::Command;

    #[test]
    fn help_in_a_part_file_is_passed_over() {
        for letter in "ABCENQRTUW".chars() {
            check(&format!("H{letter}⏎MX,1"), "at 1,0,0; warning help is not shown");
        }
    }

    #[test]
    fn typed_help_names_its_page() {
        let typed = Options { typed: true, ..Options::default() };
        let ran = run_as("HC", FakeHost::default(), Default::default(), typed);
        let page = Command::Message { text: "HC: Command reference".into() };
        assert!(ran.commands.iter().any(|c| c.command == page), "{:?}", ran.commands);
    }
}
