//! The corners of the `profiler` model of motion (Profiler reference, "Tool Path Smoothing", "Maximum
//! Machine Cutting Speeds"; function 40).

use serde::{Deserialize, Serialize};

/// The models of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RampModel {
    /// The ramps of VR.
    Shopbot,
    /// Smoothed sections, and a stop at every other corner.
    Profiler,
    /// As fast as the limits of the axes allow.
    Optimal,
}

impl RampModel {
    /// Its word in configurations and options.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Shopbot => "shopbot",
            Self::Profiler => "profiler",
            Self::Optimal => "optimal",
        }
    }
}

/// Parameters of corners and curves in the `profiler` model.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Smoothing {
    /// Largest distance of the smooth curve from the segments, in [`FACTOR_MM`]; 0 smooths nothing.
    pub factor: f64,
    /// Corners outside smoothed sections that turn by less are passed without slowing, degrees.
    pub stop_angle_deg: f64,
    /// Acceleration towards the centre of a curve, percent of the lesser of X's and Y's.
    pub centripetal_percent: f64,
    /// The machine's highest cutting speed along X, mm/s; that of the X axis when not given.
    pub cut_speed_mm_s: Option<f64>,
    /// The highest cutting speed along Y is so many times that along X; between them it changes
    /// evenly with the angle.
    pub y_factor: f64,
}

/// The distance that a smoothing factor of 1 allows, mm. The reference gives none.
pub const FACTOR_MM: f64 = 0.1;

impl Default for Smoothing {
    fn default() -> Self {
        Self {
            factor: 0.6,
            stop_angle_deg: 1.0,
            centripetal_percent: 100.0,
            cut_speed_mm_s: None,
            y_factor: 1.0,
        }
    }
}

impl Smoothing {
    /// Returns the largest distance of the smooth curve from the segments, mm.
    pub const fn limit_mm(&self) -> f64 {
        FACTOR_MM * self.factor
    }

    /// The share of the cutting speed along X that holds in a direction, radians from X or −X: 1
    /// along X, the factor along Y.
    pub fn speed_share(&self, angle_rad: f64) -> f64 {
        1.0 + (self.y_factor - 1.0) * angle_rad / std::f64::consts::FRAC_PI_2
    }
}
