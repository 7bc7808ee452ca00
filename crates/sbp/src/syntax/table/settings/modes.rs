//! Modes, and what becomes of locations, variables and values.

use crate::syntax::table::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, act};
use kerf_program::settings::Distance;

/// A command of this menu without values.
const fn plain(
    letters: &'static str,
    name: &'static str,
    doc: &'static str,
    act: act::Mode,
) -> CommandSpec {
    CommandSpec::new(letters, name, Group::Settings, &[], Stack::Ends, doc, Act::Mode(act))
}

pub(super) static SA: CommandSpec = plain(
    "SA",
    "Set absolute",
    "From here on values of moves are locations, counted from 0.",
    act::Mode::Distance(Distance::Absolute),
);

pub(super) static SR: CommandSpec = plain(
    "SR",
    "Set relative",
    "From here on values of moves are distances from where the tool is.",
    act::Mode::Distance(Distance::Relative),
);

pub(super) static SM: CommandSpec = plain(
    "SM",
    "Set move/cut mode",
    "Commands drive the tool. After a preview everything is as it was before it. Without a controller \
     nothing moves: preview is offered.",
    act::Mode::MoveCut,
);

pub(super) static SP: CommandSpec = plain(
    "SP",
    "Set preview mode",
    "Commands are drawn and change nothing: SM returns to where the tool really is. Given again in \
     preview it clears the picture.",
    act::Mode::Preview,
);

pub(super) static ST: CommandSpec = CommandSpec::new(
    "ST",
    "Set to table base",
    Group::Settings,
    &[],
    Stack::Ends,
    "Makes the working locations equal to the table base coordinates. Nothing moves.",
    Act::Zero(act::Zero::ToTableBase),
);

pub(super) static SL: CommandSpec =
    plain("SL", "Clear variables", "Deletes all user variables.", act::Mode::ClearVariables);

pub(super) static SV: CommandSpec = plain(
    "SV",
    "Set values permanent",
    "The values that would go back at the end of the part file stay as they are now: speeds, VI, VU \
     and limits.",
    act::Mode::KeepValues,
);

pub(super) static SC: CommandSpec = CommandSpec::new(
    "SC",
    "End the stack",
    Group::Settings,
    &[ParamSpec::keep("Value", Kind::Whole).demanded().about("2, the only one there is.")],
    Stack::Ends,
    "SC,2 brings motion to rest and begins a new stack of moves (handbooks, Movement Blocks).",
    Act::Mode(act::Mode::EndStack),
);
