//! Help: pages that the console shows. In a part file help does nothing, with a warning.

use super::{Act, CommandSpec, Group, Stack};

macro_rules! help {
    ($letters:literal, $name:literal, $doc:literal) => {
        CommandSpec::new($letters, $name, Group::Help, &[], Stack::Joins, $doc, Act::Help)
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
