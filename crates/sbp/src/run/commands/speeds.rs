//! Move and jog speeds.

use super::setting::changed;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::Unit;
use kerf_diag::Code;
use kerf_program::settings::{MM_PER_INCH, NO_SHIFT_JOG_MM_S, to_user};

/// The slowest speed of a linear axis, inches a second (command reference, VU).
const SLOWEST_IN_S: f64 = 0.05;

/// Sets speeds; all are checked before any is changed.
pub(super) fn set(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    for (index, param) in a.params().iter().enumerate() {
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
    let settings = changed(c, a);
    c.change_settings(|s| *s = settings);
    warn_capped_jogs(c);
    Ok(())
}

/// Files for older versions list XY, Z, A moves and XY, Z jogs; the handbooks' sample does.
pub(super) fn warn_old_order(c: &mut Context<'_>, a: &Arguments) {
    let given = |i: usize| a.given(i);
    if given(0) && given(1) && !given(2) && given(3) && given(4) && !(5..8).any(given) {
        let hint = "write four move speeds, then four jog speeds: XY, Z, A, B each";
        c.warn(Code::OldOrder, "this looks like the older order of speeds", hint);
    }
}

/// Without resolution shifting fast jogs are slowed down.
pub(super) fn warn_capped_jogs(c: &mut Context<'_>) {
    let (jog, no_shift) = (c.settings().speeds.jog, c.settings().resolution.no_shift);
    if no_shift && jog.xy.max(jog.z) > NO_SHIFT_JOG_MM_S + 1e-9 {
        let hint = "VU's last value 0 allows faster jogs";
        let message = "jogs are limited to 16 in/s (406.4 mm/s): resolution shifting is disabled";
        c.warn(Code::Unusual, message, hint);
    }
}
