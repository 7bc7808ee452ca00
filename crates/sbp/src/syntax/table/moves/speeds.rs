//! MS and JS, and MN.

use crate::syntax::table::values::{JOG, MOVE};
use crate::syntax::table::{Act, CommandSpec, Group, ParamSpec, Stack, act};

static MOVE_SPEEDS: [ParamSpec; 4] = MOVE;
static JOG_SPEEDS: [ParamSpec; 4] = JOG;

pub(super) static MS: CommandSpec = CommandSpec::new(
    "MS",
    "Move Speed",
    Group::Move,
    &MOVE_SPEEDS,
    Stack::Ends,
    "Sets move speeds. Motion comes to rest first; VS changes speed without that.",
    Act::Move(act::Move::Speeds),
);

pub(super) static JS: CommandSpec = CommandSpec::new(
    "JS",
    "Jog Speed",
    Group::Jog,
    &JOG_SPEEDS,
    Stack::Ends,
    "Sets jog speeds. Motion comes to rest first; VS changes speed without that.",
    Act::Move(act::Move::Speeds),
);

pub(super) static MN: CommandSpec = CommandSpec::new(
    "MN",
    "Move Nudge",
    Group::Move,
    &[],
    Stack::Ends,
    "Opens a panel for small corrections: the tool moves, working locations stay, table base \
     coordinates follow. It needs the console.",
    Act::Move(act::Move::Nudge),
);
