//! The speed at which a change of direction may be passed (command reference, Ramping; readings, Ramps,
//! A-106, A-109).
//!
//! ```text
//!  speed ▲ v ───────┐ criterion(v)
//!        │          │
//!        │   v·slow ╲
//!        │             ╲
//!   ramp │               ╲__________
//!        └──────────┴─────┴─────────► angle
//!                        43°
//! ```

use kerf_program::settings::MM_PER_INCH;

/// A sharper change of direction needs a full ramp at any speed.
pub(crate) const FULL_CORNER_RAD: f64 = 0.75;

/// Angles this close to a limit have reached it: coordinates carry a few decimals only, and a corner
/// drawn at just the criterion must not depend on the last of them. Guess; 0.006°.
const ANGLE_TOLERANCE_RAD: f64 = 1e-4;

/// The full corner in the manual's degrees, for the graded part of the rule.
const FULL_DEGREES: f64 = 43.0;

/// The angle at which slowing begins, radians: 43° up to 1 in/s, falling to 5° at 10 in/s.
pub(crate) fn criterion_rad(v_mm_s: f64) -> f64 {
    let inches = (v_mm_s / MM_PER_INCH).clamp(1.0, 10.0);
    (FULL_DEGREES - (inches - 1.0) * 38.0 / 9.0).to_radians()
}

/// Returns `true` if a change of direction is a full corner.
pub(crate) fn is_full(turn_rad: f64) -> bool {
    turn_rad + ANGLE_TOLERANCE_RAD >= FULL_CORNER_RAD
}

/// The speed at which a change of direction is passed by a tool that would run at `v`; never below
/// `ramp`, but for a `v` that is.
pub(crate) fn corner_speed(v: f64, turn_rad: f64, ramp: f64, slow_percent: f64) -> f64 {
    if v <= ramp || turn_rad < SLIGHTEST_RAD {
        return v;
    }
    if is_full(turn_rad) {
        return ramp;
    }
    let criterion = criterion_rad(v);
    if turn_rad + ANGLE_TOLERANCE_RAD < criterion {
        return v;
    }
    let slow = v * slow_percent / 100.0;
    let share = ((turn_rad - criterion) / (FULL_DEGREES.to_radians() - criterion)).clamp(0.0, 1.0);
    (slow + (ramp - slow) * share).clamp(ramp, v)
}

/// No speed is so high that a slighter change of direction matters: below the criterion's end.
pub(crate) const SLIGHTEST_RAD: f64 = 0.08;

#[cfg(test)]
mod tests {
    use super::*;

    /// Inches a second and degrees to inches a second, with the ramp speed and percentage of VR.
    fn check(v: f64, degrees: f64, expected: f64) {
        let mm = MM_PER_INCH;
        let got = corner_speed(v * mm, degrees.to_radians(), 0.4 * mm, 65.0) / mm;
        assert!((got - expected).abs() < 1e-9, "{degrees}° at {v}: {got}, not {expected}");
    }

    #[test]
    fn sbp_motion_corner_threshold() {
        for (v, degrees) in [(0.5, 43.0), (1.0, 43.0), (5.5, 24.0), (10.0, 5.0), (20.0, 5.0)] {
            assert!((criterion_rad(v * MM_PER_INCH).to_degrees() - degrees).abs() < 1e-9, "{v}");
        }
        check(5.5, 10.0, 5.5);
        check(10.0, 10.0, 6.5 - 6.1 * 5.0 / 38.0);
    }

    #[test]
    fn sbp_motion_slowcorner() {
        check(5.5, 24.0, 3.575);
        check(5.5, 33.5, 1.9875);
        check(5.5, 43.0, 0.4);
        let mm = MM_PER_INCH;
        let at_90 = corner_speed(5.5 * mm, 24f64.to_radians(), 0.4 * mm, 90.0) / mm;
        assert!((at_90 - 4.95).abs() < 1e-9);
    }

    #[test]
    fn a_corner_never_speeds_up_and_never_goes_below_ramp_speed() {
        check(0.3, 90.0, 0.3);
        check(1.0, 42.9, 1.0);
        check(1.0, 42.98, 0.4);
        let mm = MM_PER_INCH;
        assert_eq!(corner_speed(2.0 * mm, 0.68, 0.4 * mm, 200.0), 2.0 * mm);
        assert_eq!(corner_speed(2.0 * mm, 0.72, 0.4 * mm, 0.0), 0.4 * mm);
    }
}
