//! Commands whose work is done outside the language: virtual tools, help.
//!
//! The reader and every list need their letters and values. In a part file help does nothing, with
//! a warning; what cannot be done without the console is refused and says so.

use super::{CommandSpec, Group, Kind, ParamSpec, Stack};
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

macro_rules! refused {
    ($letters:literal, $name:literal, $group:ident, $params:expr, $needs:literal, $doc:literal) => {
        CommandSpec::new($letters, $name, Group::$group, $params, Stack::Ends, $doc, |c, _| {
            Err(c.fail(Code::NotSupported, concat!($letters, " needs ", $needs)))
        })
    };
}

/// What a virtual tool is started with.
const TOOL: &[ParamSpec] = &[
    ParamSpec::keep("Value 1", Kind::Text).about("Handed to the tool as it is."),
    ParamSpec::keep("Value 2", Kind::Text),
    ParamSpec::keep("Value 3", Kind::Text),
    ParamSpec::keep("Value 4", Kind::Text),
    ParamSpec::keep("Value 5", Kind::Text),
    ParamSpec::keep("Value 6", Kind::Text),
    ParamSpec::keep("Value 7", Kind::Text),
    ParamSpec::keep("Value 8", Kind::Text),
];

const SETTINGS_FILE: &[ParamSpec] = &[ParamSpec::keep("Name", Kind::File)];

pub(super) static SPECS: [CommandSpec; 22] = [
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
    refused!(
        "TC",
        "Copy machine",
        Tools,
        TOOL,
        "the virtual tools",
        "Makes a file by probing an object."
    ),
    refused!(
        "TD",
        "Drill press",
        Tools,
        TOOL,
        "the virtual tools",
        "Makes a file that drills holes."
    ),
    refused!("TF", "Fluter", Tools, TOOL, "the virtual tools", "Makes a file that cuts flutes."),
    refused!(
        "TH",
        "Header writer",
        Tools,
        TOOL,
        "the virtual tools",
        "Writes a head into a part file."
    ),
    refused!("TI", "Indexer", Tools, TOOL, "the virtual tools", "Sets an indexer going."),
    refused!(
        "TS",
        "Setup",
        Tools,
        TOOL,
        "the virtual tools",
        "Records how the machine is equipped."
    ),
    refused!(
        "TT",
        "Typesetter",
        Tools,
        TOOL,
        "the virtual tools",
        "Makes a file that carves text."
    ),
    refused!(
        "TU",
        "Surfacer",
        Tools,
        TOOL,
        "the virtual tools",
        "Makes a file that planes the table."
    ),
    refused!(
        "UI",
        "Install firmware",
        Utilities,
        &[],
        "a controller with firmware of its own",
        "Loads the controller's firmware."
    ),
    refused!(
        "UN",
        "Name the editor",
        Utilities,
        &[ParamSpec::keep("Program", Kind::File).about("Blank is the built-in editor.")],
        "the console",
        "Names the program that edits files."
    ),
    refused!(
        "UR",
        "Load settings",
        Utilities,
        SETTINGS_FILE,
        "the console",
        "Loads a settings file."
    ),
    refused!(
        "US",
        "Save settings",
        Utilities,
        SETTINGS_FILE,
        "the console",
        "Saves the settings into a file."
    ),
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
    use crate::testing::{FakeHost, check, rows, run_as};
    use kerf_program::Command;

    rows! {
        tools_are_named: "TC, 1500, small, 2" => "error TC needs the virtual tools";
        settings_files_are_named: "US,mine" => "error US needs the console", "UR" => "error needs the console", "UI" => "error firmware";
        the_nudge_panel_is_named: "MN" => "error MN needs the console";
    }

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
