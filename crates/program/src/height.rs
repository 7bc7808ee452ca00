//! Automatic height control: Z follows the sheet while a cut moves (Profiler reference, "Automatic
//! Height Control").

use serde::{Deserialize, Serialize};

/// How the height is sensed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Gauge {
    /// Two inputs, by their numbers: too high moves Z down, too low moves it up.
    Simple {
        /// The head is too high.
        high: u8,
        /// The head is too low.
        low: u8,
    },
    /// Readings 0 … 255; a larger one means a larger gap.
    Proportional {
        /// Readings wanted along X and along Y.
        set_points: [f64; 2],
        /// Millimetres that Z moves for one unit of error.
        gain_mm: f64,
        /// Millimetres of gap for one unit.
        scale_mm: f64,
        /// Seconds from one reading to the next.
        interval_s: f64,
    },
}

/// How Z follows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HeightLaw {
    /// What tells the height.
    pub gauge: Gauge,
    /// Highest speed of Z, mm/s.
    pub speed_mm_s: f64,
    /// Highest acceleration of Z, mm/s².
    pub accel_mm_s2: f64,
    /// Acts above this share of the speed asked for; 0 acts always.
    pub activation: f64,
    /// Z stays at or below this, mm, machine frame.
    pub ceiling_mm: f64,
    /// Z stays at or above this, mm, machine frame.
    pub floor_mm: f64,
}

impl HeightLaw {
    /// The reading wanted in a direction of travel: that of X, of Y, and evenly between them.
    pub fn set_point(&self, dx: f64, dy: f64) -> f64 {
        let Gauge::Proportional { set_points: [x, y], .. } = self.gauge else { return 0.0 };
        x + (y - x) * dy.abs().atan2(dx.abs()) / std::f64::consts::FRAC_PI_2
    }
}
