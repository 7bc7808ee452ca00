//! The commands that hand over to the operator.

use crate::syntax::table::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, act};

pub(super) static SI: CommandSpec = CommandSpec::new(
    "SI",
    "Send lines",
    Group::Settings,
    &[],
    Stack::Ends,
    "Opens a box for a few lines that are run at once. In a part file, write the lines themselves.",
    Act::Mode(act::Mode::SendLines),
);

pub(super) static SK: CommandSpec = CommandSpec::new(
    "SK",
    "Keypad",
    Group::Settings,
    &[ParamSpec::keep("Message", Kind::Text).about("What the operator is asked to do.")],
    Stack::Ends,
    "Lets the operator move the tool by hand controls; the file goes on when the keypad is closed. \
     In preview it does not open.",
    Act::Mode(act::Mode::Keypad),
);
