//! The limits of the axes, as the search uses them.

use kerf_program::Dynamics;

/// Limits are kept with this much to spare, so that rounding never exceeds them.
pub(crate) const SPARE: f64 = 1.0 - 1e-9;

/// Part of the limit of jerk that is used, so that rounding never exceeds it.
pub(crate) const USED: f64 = 1.0 - 1e-6;

/// Limits of the axes that move.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds<const N: usize> {
    pub speed: [f64; N],
    pub accel: [f64; N],
    /// One over the limits of speed.
    pub per_speed: [f64; N],
    /// One over the limits of acceleration.
    pub per_accel: [f64; N],
}

impl<const N: usize> Bounds<N> {
    /// Those of a machine.
    pub fn of(dynamics: &Dynamics) -> Self {
        Self::new(&dynamics.speed_mm_s.0, &dynamics.accel_mm_s2.0)
    }

    /// Of the first axes; a limit that is not above zero becomes very small instead.
    fn new(speed: &[f64], accel: &[f64]) -> Self {
        let least = |v: f64| v.max(1e-6) * SPARE;
        let speed: [f64; N] = std::array::from_fn(|k| least(speed[k]));
        let accel: [f64; N] = std::array::from_fn(|k| least(accel[k]));
        Self { speed, accel, per_speed: speed.map(f64::recip), per_accel: accel.map(f64::recip) }
    }
}
