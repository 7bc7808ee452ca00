//! VS, and the speeds that MS and JS set too.

use crate::interp::{Arguments, Context, Stop};
use crate::table::setting::{changed, real};
use crate::table::{Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit};
use kerf_diag::Code;
use kerf_program::Axis;
use kerf_program::settings::{MM_PER_INCH, to_user};

macro_rules! speed {
    ($name:literal, $unit:expr, $($place:tt)+) => {
        ParamSpec::of($name, Kind::Number($unit), real!(speeds.$($place)+)).within(Bound::Positive)
    };
}

const A: Unit = Unit::AxisSpeed(Axis::A);
const B: Unit = Unit::AxisSpeed(Axis::B);

/// The move speeds, as MS lists them.
pub(in crate::table) const MOVE: [ParamSpec; 4] = [
    speed!("XY move speed", Unit::Speed, cut.xy).about("Of the tool's tip along its path."),
    speed!("Z move speed", Unit::Speed, cut.z),
    speed!("A move speed", A, cut.a),
    speed!("B move speed", B, cut.b),
];

/// The jog speeds, as JS lists them.
pub(in crate::table) const JOG: [ParamSpec; 4] = [
    speed!("XY jog speed", Unit::Speed, jog.xy).about("Of the tool's tip along its path."),
    speed!("Z jog speed", Unit::Speed, jog.z),
    speed!("A jog speed", A, jog.a),
    speed!("B jog speed", B, jog.b),
];

static PARAMS: [ParamSpec; 8] =
    [MOVE[0], MOVE[1], MOVE[2], MOVE[3], JOG[0], JOG[1], JOG[2], JOG[3]];

pub(super) static VS: CommandSpec = CommandSpec::new(
    "VS",
    "Values: speeds",
    Group::Values,
    &PARAMS,
    Stack::Joins,
    "Move and jog speeds of all axes. Unlike MS and JS it does not interrupt motion. In a part file \
     the values go back at its end, unless SV keeps them.",
    |c, a| {
        warn_old_order(c, a);
        set_speeds(c, a, &PARAMS)
    },
);

/// The slowest speed of a linear axis, inches a second (command reference, VU).
const SLOWEST_IN_S: f64 = 0.05;

/// Sets speeds; all are checked before any is changed.
pub(in crate::table) fn set_speeds(
    c: &mut Context<'_>,
    a: &Arguments,
    params: &[ParamSpec],
) -> Result<(), Stop> {
    for (index, param) in params.iter().enumerate() {
        let linear = param.kind.unit().scale(c.settings()) != 1.0
            || matches!(param.kind.unit(), Unit::Speed);
        let slow = a.number(index).is_some_and(|v| v / MM_PER_INCH < SLOWEST_IN_S - 1e-9);
        if linear && slow {
            let slowest = to_user(SLOWEST_IN_S * MM_PER_INCH, c.settings().linear_unit.mm());
            let name = param.name.to_lowercase();
            let message = format!("{name} must be at least {slowest}");
            let hint = "the step interval divider of VU (15th value) makes motion slower than that";
            return Err(c.fail_at(a.span(index), Code::OutOfRange, message, hint));
        }
    }
    let settings = changed(c, a, params);
    c.change_settings(|s| *s = settings);
    super::units::warn_capped_jogs(c);
    Ok(())
}

/// Files for older versions list XY, Z, A moves and XY, Z jogs; the handbooks' sample does.
fn warn_old_order(c: &mut Context<'_>, a: &Arguments) {
    let given = |i: usize| a.given(i);
    if given(0) && given(1) && !given(2) && given(3) && given(4) && !(5..8).any(given) {
        let hint = "write four move speeds, then four jog speeds: XY, Z, A, B each";
        c.warn(Code::OldOrder, "this looks like the older order of speeds", hint);
    }
}
