//! VV: a user variable from the keyboard.

use crate::syntax::table::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, act};

pub(super) static VV: CommandSpec = CommandSpec::new(
    "VV",
    "Values: variable",
    Group::Values,
    &[ParamSpec::required("Assignment", Kind::Text).about("`&name = value`.")],
    Stack::Joins,
    "Gives a user variable a value, as the assignment alone does. UL lists the variables, SL deletes \
     them.",
    // The reader makes an assignment of it; what arrives here is none.
    Act::Value(act::Value::Assignment),
);
