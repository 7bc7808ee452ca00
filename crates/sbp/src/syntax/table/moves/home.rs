//! MH and JH: to X 0, Y 0, above the work.

use crate::syntax::table::{Act, CommandSpec, Group, Stack, act};
use kerf_program::MoveKind;

pub(super) static MH: CommandSpec = CommandSpec::new(
    "MH",
    "Move Home",
    Group::Move,
    &[],
    Stack::Joins,
    "Lifts Z to Safe-Z when it is lower, then moves to X 0, Y 0, also in relative mode. In a file \
     with an offset that is the file's own zero.",
    Act::Move(act::Move::Home(MoveKind::Cut)),
);

pub(super) static JH: CommandSpec = CommandSpec::new(
    "JH",
    "Jog Home",
    Group::Jog,
    &[],
    Stack::Joins,
    "Lifts Z to Safe-Z when it is lower, then jogs to X 0, Y 0, also in relative mode. In a file \
     with an offset that is the file's own zero.",
    Act::Move(act::Move::Home(MoveKind::Jog)),
);
