//! The limits of a machine's axes, for planners that use them to the full.

use crate::settings::Speeds;
use crate::{AXES, Axes, Axis};
use serde::{Deserialize, Deserializer, Serialize};

/// Limits of every axis and the tolerance of the path: what the `profiler` and `optimal` models of
/// motion plan with. A machine whose configuration gives them is planned by `optimal` unless it
/// names another; one without (`None` in [`Settings`](crate::Settings)) ramps as VR says.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dynamics {
    /// Highest speed of each axis, mm/s or degrees/s.
    pub speed_mm_s: Axes,
    /// Highest acceleration of each axis, mm/s² or degrees/s².
    pub accel_mm_s2: Axes,
    /// Highest jerk of each axis, mm/s³ or degrees/s³; `None` leaves it free.
    #[serde(default, deserialize_with = "free_where_null")]
    pub jerk_mm_s3: Option<Axes>,
    /// Largest distance of the path from the programmed one, mm (rotary axes count a degree as a
    /// millimetre).
    pub tolerance_mm: f64,
}

/// An axis without a bound is infinite, which JSON writes as null.
fn free_where_null<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Axes>, D::Error> {
    let read: Option<[Option<f64>; AXES]> = Option::deserialize(from)?;
    Ok(read.map(|axes| Axes(axes.map(|jerk| jerk.unwrap_or(f64::INFINITY)))))
}

impl Dynamics {
    /// Returns the limits of a mid-size router's axes, where nothing else is known: jog speeds, a modest
    /// acceleration, a hundredth of a millimetre at corners. The last two are guesses.
    pub fn usual(speeds: &Speeds) -> Self {
        Self {
            speed_mm_s: Axes(Axis::ALL.map(|axis| speeds.jog.of(axis))),
            accel_mm_s2: Axes::splat(500.0),
            jerk_mm_s3: None,
            tolerance_mm: 0.01,
        }
    }
}
