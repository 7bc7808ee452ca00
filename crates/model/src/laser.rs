//! The PWM of a laser: LOW at rest, rising with speed to HIGH (command reference, VH).

use kerf_motion::Span;
use kerf_program::MoveKind;
use kerf_program::settings::{IoModes, TorchHeight};

/// VN field 3: laser control.
const LASER: u8 = 2;

/// The channel a laser is connected to.
pub(crate) const CHANNEL: u8 = 1;

/// Tells whether the laser is controlled now.
pub(crate) const fn active(height: &TorchHeight, modes: &IoModes) -> bool {
    height.on && modes.analog == LASER
}

/// Duty at a speed, percent; `full_mm_s` is the speed asked for.
fn percent(height: &TorchHeight, mm_s: f64, full_mm_s: f64) -> f64 {
    height.low_percent + (height.high_percent - height.low_percent) * (mm_s / full_mm_s).min(1.0)
}

/// The corners of the duty over one move: when, seconds of the plan, and percent. Between two
/// corners it changes evenly. Jogs do not burn.
pub(crate) fn corners(span: &Span<'_>, height: &TorchHeight) -> [(f64, f64); 4] {
    let made = span.made;
    let duty = |mm_s: f64| match made.kind {
        MoveKind::Cut => percent(height, mm_s, made.speed_mm_s),
        MoveKind::Jog => height.low_percent,
    };
    // A plan that does not follow the ramps of VR may be faster: the corners stay inside the move.
    let half_s = 0.5 * (span.t1_s - span.t0_s);
    let ramp_s = |v: f64| ((span.v_peak - v) / made.accel_mm_s2).clamp(0.0, half_s);
    [
        (span.t0_s, duty(span.v_entry)),
        (span.t0_s + ramp_s(span.v_entry), duty(span.v_peak)),
        (span.t1_s - ramp_s(span.v_exit), duty(span.v_peak)),
        (span.t1_s, duty(span.v_exit)),
    ]
}
