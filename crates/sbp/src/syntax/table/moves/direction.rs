//! MD: so far in a direction.

use crate::syntax::table::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};

pub(super) static MD: CommandSpec = CommandSpec::new(
    "MD",
    "Move Distance",
    Group::Move,
    &[
        ParamSpec::required("Length", Kind::Number(Unit::Length))
            .about("How far, in absolute mode too; negative goes backwards."),
        ParamSpec::required("Angle", Kind::Text).about(
            "Degrees clockwise from +Y; with R or L right or left of the last move; a time of day \
             (1:30); or points of the compass (SSW).",
        ),
        ParamSpec::keep("Z change", Kind::Text)
            .about("A Z location, in relative mode too; with U or D up or down by so much."),
    ],
    Stack::Joins,
    "Moves by a length and a direction, and Z along with it.",
    Act::Move(act::Move::Direction),
);
