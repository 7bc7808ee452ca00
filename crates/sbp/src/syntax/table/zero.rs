//! Zero commands: where the display reads 0.

use super::{Act, CommandSpec, Group, Stack, act};
use kerf_program::{Axis, AxisSet};

macro_rules! zero {
    ($letters:literal, $name:literal, $doc:literal, $($axis:ident)+) => {
        CommandSpec::new(
            $letters,
            $name,
            Group::Zero,
            &[],
            Stack::Ends,
            $doc,
            Act::Zero(act::Zero::Working(AxisSet::EMPTY$(.with(Axis::$axis))+)),
        )
    };
}

pub(super) static SPECS: [CommandSpec; 13] = [
    zero!("ZX", "Zero X", "Makes the present X location zero. Table base coordinates stay.", X),
    zero!("ZY", "Zero Y", "Makes the present Y location zero. Table base coordinates stay.", Y),
    zero!("ZZ", "Zero Z", "Makes the present Z location zero. Table base coordinates stay.", Z),
    zero!("ZA", "Zero A", "Makes the present A location zero. Table base coordinates stay.", A),
    zero!("ZB", "Zero B", "Makes the present B location zero. Table base coordinates stay.", B),
    zero!("ZC", "Zero C", "Makes the present C location zero. Table base coordinates stay.", C),
    zero!("Z2", "Zero X and Y", "Makes the present X and Y locations zero.", X Y),
    zero!("Z3", "Zero X, Y, Z", "Makes the present X, Y and Z locations zero.", X Y Z),
    zero!("Z4", "Zero X, Y, Z, A", "Makes the present X, Y, Z and A locations zero.", X Y Z A),
    zero!("Z5", "Zero X to B", "Makes the present X, Y, Z, A and B locations zero.", X Y Z A B),
    zero!("Z6", "Zero X to C", "Makes all six present locations zero.", X Y Z A B C),
    CommandSpec::new(
        "ZT",
        "Zero Table Base",
        Group::Zero,
        &[],
        Stack::Ends,
        "Makes the present place the zero of the table base coordinates. Working locations stay.",
        Act::Zero(act::Zero::TableBase),
    ),
    CommandSpec::new(
        "UZ",
        "Zero everything",
        Group::Utilities,
        &[],
        Stack::Ends,
        "Makes all working locations and all table base coordinates zero.",
        Act::Zero(act::Zero::Everything),
    ),
];
