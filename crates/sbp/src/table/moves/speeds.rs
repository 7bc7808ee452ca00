//! MS and JS, and MN.

use crate::table::values::{JOG, MOVE, set_speeds};
use crate::table::{CommandSpec, Group, ParamSpec, Stack};
use kerf_diag::Code;

static MOVE_SPEEDS: [ParamSpec; 4] = MOVE;
static JOG_SPEEDS: [ParamSpec; 4] = JOG;

pub(super) static MS: CommandSpec = CommandSpec::new(
    "MS",
    "Move Speed",
    Group::Move,
    &MOVE_SPEEDS,
    Stack::Ends,
    "Sets move speeds. Motion comes to rest first; VS changes speed without that.",
    |c, a| set_speeds(c, a, &MOVE_SPEEDS),
);

pub(super) static JS: CommandSpec = CommandSpec::new(
    "JS",
    "Jog Speed",
    Group::Jog,
    &JOG_SPEEDS,
    Stack::Ends,
    "Sets jog speeds. Motion comes to rest first; VS changes speed without that.",
    |c, a| set_speeds(c, a, &JOG_SPEEDS),
);

pub(super) static MN: CommandSpec = CommandSpec::new(
    "MN",
    "Move Nudge",
    Group::Move,
    &[],
    Stack::Ends,
    "Opens a panel for small corrections: the tool moves, working locations stay, table base \
     coordinates follow. It needs the console.",
    |c, _| {
        let hint = "stop the file and nudge there, or move and set the location with VA";
        Err(c.fail_at(c.span, Code::NotSupported, "MN needs the console", hint))
    },
);
