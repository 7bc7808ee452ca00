//! U commands that show something of the running session.

use super::setting::plain;
use super::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, act};
use kerf_program::Settings;
use kerf_program::settings::Distance;

pub(super) static SPECS: [CommandSpec; 4] = [
    shows(
        "UL",
        "List variables",
        "Shows all user variables and their values.",
        act::Utility::Variables,
    ),
    shows(
        "UV",
        "Show values",
        "Shows the values of all V commands, and the part folder.",
        act::Utility::Values,
    ),
    shows(
        "UD",
        "Diagnostics",
        "Shows what helps to find a fault: versions, places, inputs, outputs, the last error; and adds it with \
         the values of UV to problem.log.",
        act::Utility::Diagnostics,
    ),
    CommandSpec::new(
        "UU",
        "Calculator",
        Group::Utilities,
        &[ParamSpec::keep("Expression", Kind::Text)],
        Stack::Joins,
        "Shows what an expression comes to; alone it opens the calculator of the console.",
        Act::Utility(act::Utility::Calculator),
    ),
];

const fn shows(
    letters: &'static str,
    name: &'static str,
    doc: &'static str,
    act: act::Utility,
) -> CommandSpec {
    CommandSpec::new(letters, name, Group::Utilities, &[], Stack::Ends, doc, Act::Utility(act))
}

/// The settings as the lines of a part file that sets them, units first.
///
/// Locations are not among them (VA), nor what ends with a file (VO).
pub fn settings_lines(settings: &Settings) -> Vec<String> {
    let mut lines: Vec<String> = ["VD", "VB", "VC", "VI", "VL", "VN", "VH", "VP", "VR", "VS", "VU"]
        .into_iter()
        .filter_map(|letters| super::find(letters)?.present(settings))
        .collect();
    let relative = settings.distance == Distance::Relative;
    lines.push(if relative { "SR" } else { "SA" }.into());
    lines.push(format!("SW,{}", plain(settings.warning_s)));
    lines.push(format!("SO,4,{}", settings.io.output4));
    lines
}
