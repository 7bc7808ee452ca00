//! U commands that show something of the running session.

use super::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, act};

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
