//! The table of functions (Profiler reference, "Hand Console").

use super::spec::Function;
use super::{heights, jobs, moves, settings};

/// Every function, in the order of their numbers.
pub const FUNCTIONS: &[Function] = &[
    settings::CUT_SPEED,
    settings::PLUNGE_SPEED,
    heights::SETTING,
    heights::BOTTOM_ADJUST,
    moves::ORIGIN,
    moves::FINISH,
    moves::BY,
    jobs::SET_ORIGIN,
    jobs::SET_FINISH,
    jobs::SAVE,
    jobs::SAVE_MACHINE,
    settings::SCALE,
    settings::SET_POINTS,
    settings::X_SET_POINT,
    settings::Y_SET_POINT,
    heights::ADJUST,
    heights::ADJUST_X,
    heights::ADJUST_Y,
    moves::HOMES,
    moves::TO,
    settings::Z2_ADJUSTMENT,
    settings::BOTTOM_DELAY,
    settings::BOTTOM_INPUT,
    settings::RAISE,
    settings::ORIGIN_AT_START,
    settings::ARROW_SPEED,
    settings::ARROW_ACCEL,
    settings::CENTRIPETAL,
    moves::FIND_Z,
    moves::FIND_XY,
    jobs::NEAREST,
    jobs::OFFSET,
    settings::REPEATS,
    DIGITIZING,
    settings::Y_FACTOR,
    heights::BOTTOM_JUSTIFY,
];

/// The function behind which there is a mode of its own.
pub(super) const DIGITIZE: &str = "70";

const DIGITIZING: Function = Function {
    number: DIGITIZE,
    name: "Digitize",
    doc: "Shapes are taken from a pattern: digitizing, a mode of its own",
    steps: &[],
    does: |_, _| Ok(Vec::new().into()),
};

/// The function of a number as it is typed: `18.1`, and `018.10` too.
pub fn function(number: &str) -> Option<&'static Function> {
    let typed: f64 = number.parse().ok()?;
    FUNCTIONS.iter().find(|function| function.number.parse() == Ok(typed))
}
