//! VV: a user variable from the keyboard.

use crate::table::{CommandSpec, Group, Kind, ParamSpec, Stack};
use kerf_diag::Code;

pub(super) static VV: CommandSpec = CommandSpec::new(
    "VV",
    "Values: variable",
    Group::Values,
    &[ParamSpec::required("Assignment", Kind::Text).about("`&name = value`.")],
    Stack::Joins,
    "Gives a user variable a value, as the assignment alone does. UL lists the variables, SL deletes \
     them.",
    // The reader makes an assignment of it; what arrives here is none.
    |c, a| {
        let hint = "write VV,&name = value";
        Err(c.fail_at(a.span(0), Code::Syntax, "an assignment is expected", hint))
    },
);
