//! Moves and jogs.

use super::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};
use kerf_program::{Axis, MoveKind};

mod direction;

mod home;

mod independent;

mod speeds;

const AXIS: [ParamSpec; 6] = [
    ParamSpec::keep("X location", Kind::Number(Unit::Axis(Axis::X))),
    ParamSpec::keep("Y location", Kind::Number(Unit::Axis(Axis::Y))),
    ParamSpec::keep("Z location", Kind::Number(Unit::Axis(Axis::Z))),
    ParamSpec::keep("A location", Kind::Number(Unit::Axis(Axis::A))),
    ParamSpec::keep("B location", Kind::Number(Unit::Axis(Axis::B))),
    ParamSpec::keep("C location", Kind::Number(Unit::Axis(Axis::C))),
];

macro_rules! single {
    ($letters:literal, $kind:ident, $axis:ident, $group:ident, $stack:ident) => {
        CommandSpec::new(
            $letters,
            concat!(stringify!($group), " ", stringify!($axis)),
            Group::$group,
            &[ParamSpec::required("Value", Kind::Number(Unit::Axis(Axis::$axis)))
                .about("Where to go, or how far with SR.")],
            Stack::$stack,
            concat!(
                "Moves the ",
                stringify!($axis),
                " axis alone to a location, or by a distance with SR."
            ),
            Act::Move(act::Move::Axes { kind: MoveKind::$kind, first: Axis::$axis.index() }),
        )
    };
}

macro_rules! several {
    ($letters:literal, $kind:ident, $count:literal, $group:ident) => {
        CommandSpec::new(
            $letters,
            concat!(stringify!($group), " ", stringify!($count), " axes"),
            Group::$group,
            AXIS.split_at($count).0,
            Stack::Joins,
            concat!(
                "Moves the first ",
                stringify!($count),
                " axes together in a straight line; a blank axis stays where it is."
            ),
            Act::Move(act::Move::Axes { kind: MoveKind::$kind, first: 0 }),
        )
    };
}

/// The commands with files of their own.
pub(super) static OTHERS: [&CommandSpec; 8] = [
    &home::MH,
    &home::JH,
    &direction::MD,
    &independent::MI,
    &independent::MO,
    &speeds::MS,
    &speeds::JS,
    &speeds::MN,
];

pub(super) static SPECS: [CommandSpec; 22] = [
    single!("MX", Cut, X, Move, Joins),
    single!("MY", Cut, Y, Move, Joins),
    single!("MZ", Cut, Z, Move, Joins),
    single!("MA", Cut, A, Move, Joins),
    single!("MB", Cut, B, Move, Joins),
    single!("MC", Cut, C, Move, Joins),
    several!("M2", Cut, 2, Move),
    several!("M3", Cut, 3, Move),
    several!("M4", Cut, 4, Move),
    several!("M5", Cut, 5, Move),
    several!("M6", Cut, 6, Move),
    single!("JX", Jog, X, Jog, Joins),
    single!("JY", Jog, Y, Jog, Joins),
    single!("JZ", Jog, Z, Jog, Joins),
    single!("JA", Jog, A, Jog, Joins),
    single!("JB", Jog, B, Jog, Joins),
    single!("JC", Jog, C, Jog, Joins),
    several!("J2", Jog, 2, Jog),
    several!("J3", Jog, 3, Jog),
    several!("J4", Jog, 4, Jog),
    several!("J5", Jog, 5, Jog),
    several!("J6", Jog, 6, Jog),
];
