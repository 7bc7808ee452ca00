//! Speeds and ramps (VS, MS, JS, VR).

use super::unit::{MM_PER_INCH, inch};
use crate::Axis;
use serde::{Deserialize, Serialize};

/// One value for XY together and one for each other axis, as VS and VR list them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs)]
pub struct PerGroup {
    pub xy: f64,
    pub z: f64,
    pub a: f64,
    pub b: f64,
    pub c: f64,
}

impl PerGroup {
    /// The same value everywhere.
    pub const fn splat(v: f64) -> Self {
        Self { xy: v, z: v, a: v, b: v, c: v }
    }

    /// The value that holds for an axis.
    pub const fn of(&self, axis: Axis) -> f64 {
        match axis {
            Axis::X | Axis::Y => self.xy,
            Axis::Z => self.z,
            Axis::A => self.a,
            Axis::B => self.b,
            Axis::C => self.c,
        }
    }

    /// The place of the value that holds for an axis.
    pub const fn of_mut(&mut self, axis: Axis) -> &mut f64 {
        match axis {
            Axis::X | Axis::Y => &mut self.xy,
            Axis::Z => &mut self.z,
            Axis::A => &mut self.a,
            Axis::B => &mut self.b,
            Axis::C => &mut self.c,
        }
    }
}

/// Speeds (VS, MS, JS): XY is the vector speed of the tool tip, mm/s; rotary axes degrees/s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Speeds {
    /// Move speeds.
    pub cut: PerGroup,
    /// Jog speeds.
    pub jog: PerGroup,
}

/// The manual leaves speeds to the tool; these are Kerf's own for a mid-size router.
impl Default for Speeds {
    fn default() -> Self {
        Self {
            cut: PerGroup { xy: inch(2.0), z: inch(1.0), a: inch(1.0), b: 30.0, c: 30.0 },
            jog: PerGroup { xy: inch(6.0), z: inch(3.0), a: inch(3.0), b: 60.0, c: 60.0 },
        }
    }
}

/// Ramps (VR).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ramps {
    /// Speed at which moves start and end, mm/s.
    pub cut: PerGroup,
    /// Speed at which jogs start and end, mm/s.
    pub jog: PerGroup,
    /// Distance of a move for a gain of [`RAMP_SPEED_STEP_MM_S`] from ramp speed, mm.
    pub cut_rate_mm: f64,
    /// The same for jogs.
    pub jog_rate_mm: f64,
    /// Sensitivity of 3D ramping, percent.
    pub threshold_3d_percent: f64,
    /// Path length over which changes of direction are summed, mm.
    pub min_distance_mm: f64,
    /// Speed at a corner just at the criterion, percent of the speed.
    pub slow_corner_percent: f64,
    /// Ramp rate in keypad mode, mm.
    pub keypad_rate_mm: f64,
    /// Circles of a smaller diameter run at ramp speed, mm.
    pub small_circle_mm: f64,
}

impl Default for Ramps {
    fn default() -> Self {
        Self {
            cut: PerGroup { b: 0.4, c: 0.4, ..PerGroup::splat(inch(0.4)) },
            jog: PerGroup { b: 0.4, c: 0.4, ..PerGroup::splat(inch(0.4)) },
            cut_rate_mm: inch(0.2),
            jog_rate_mm: inch(0.2),
            threshold_3d_percent: 100.0,
            min_distance_mm: inch(0.15),
            slow_corner_percent: 65.0,
            keypad_rate_mm: inch(0.2),
            small_circle_mm: inch(0.25),
        }
    }
}

/// The gain of speed that the ramp rate speaks of: 2 in/s (command reference, VR).
pub const RAMP_SPEED_STEP_MM_S: f64 = 2.0 * MM_PER_INCH;

impl Ramps {
    /// Acceleration of a ramp that starts at `ramp_mm_s` with this rate, mm/s².
    ///
    /// From the ramp speed v0 to v0+2 in the distance of the rate: a = ((v0+2)² − v0²)/(2·rate).
    pub fn acceleration_mm_s2(ramp_mm_s: f64, rate_mm: f64) -> f64 {
        let top = ramp_mm_s + RAMP_SPEED_STEP_MM_S;
        (top * top - ramp_mm_s * ramp_mm_s) / (2.0 * rate_mm)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ramp_of_the_manual_is_14_inches_per_second_squared() {
        let a = Ramps::acceleration_mm_s2(inch(0.4), inch(0.2));
        assert!((a / MM_PER_INCH - 14.0).abs() < 1e-9);
    }
}
