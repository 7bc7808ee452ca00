//! Automatic height control: Z follows the sheet while a cut moves (Profiler reference, "Automatic
//! Height Control").

use crate::job::Heights;
use serde::{Deserialize, Serialize};

/// A tool this near to the floor stands on it, mm: far below a step.
const AT_FLOOR_MM: f64 = 1e-6;

/// The largest reading.
const MOST: f64 = 255.0;

/// The input of a torch: Z goes down while it is on, up while it is off (command reference, VH).
pub const TORCH_INPUT: u8 = 1;

/// Sensing of the height.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Gauge {
    /// Two inputs, by their numbers: too high moves Z down, too low moves it up.
    Simple {
        /// The head is too high.
        high: u8,
        /// The head is too low.
        low: u8,
    },
    /// Readings 0 … 255; a larger one means a larger gap, or a smaller one where the gain is negative.
    Proportional {
        /// Readings wanted along X and along Y.
        set_points: [f64; 2],
        /// Millimetres that Z moves down for one unit of error; negative where a larger reading means a
        /// smaller gap.
        gain_mm: f64,
        /// Millimetres of gap for one unit.
        scale_mm: f64,
        /// Seconds from one reading to the next.
        interval_s: f64,
    },
}

/// Law by which Z follows the height.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HeightLaw {
    /// The gauge of the height.
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
    /// Z follows while the tool travels, raised by so much above the height of the cut, and the sensor
    /// stays down; without it Z follows while a cut moves.
    #[serde(default)]
    pub raised_mm: Option<f64>,
}

impl HeightLaw {
    /// The reading wanted in a direction of travel: that of X, of Y, and evenly between them.
    pub fn set_point(&self, dx: f64, dy: f64) -> f64 {
        let Gauge::Proportional { set_points: [x, y], .. } = self.gauge else { return 0.0 };
        x + (y - x) * dy.abs().atan2(dx.abs()) / std::f64::consts::FRAC_PI_2
    }

    /// Returns the reading of the sensor for a gap, mm, before it is rounded and held within 0 … 255.
    pub fn reading(&self, gap_mm: f64) -> f64 {
        let Gauge::Proportional { gain_mm, scale_mm, .. } = self.gauge else { return 0.0 };
        let units = gap_mm / scale_mm;
        if gain_mm < 0.0 { MOST - units } else { units }
    }

    /// The gap at which the sensor says so, mm.
    pub fn gap_mm(&self, reading: f64) -> f64 {
        let Gauge::Proportional { gain_mm, scale_mm, .. } = self.gauge else { return 0.0 };
        scale_mm * if gain_mm < 0.0 { MOST - reading } else { reading }
    }

    /// Heights in force once Z has been carried to a height, mm, machine frame: ZSurface is where the tool cuts,
    /// or would cut below a way between paths, and ZTop keeps its distance to it. A tool that can go no lower is
    /// not at its height over the sheet: it carries nothing.
    pub fn carried(&self, heights: Heights, z_mm: f64) -> Heights {
        if z_mm <= self.floor_mm + AT_FLOOR_MM {
            return heights;
        }
        let surface_mm = z_mm - self.raised_mm.unwrap_or_default();
        let top_mm = surface_mm + heights.top_mm - heights.surface_mm;
        Heights { top_mm, surface_mm, ..heights }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pro_height_prop_angle() {
        let gauge = Gauge::Proportional {
            set_points: [150.0, 170.0],
            gain_mm: 0.04,
            scale_mm: 0.038,
            interval_s: 0.001,
        };
        let law = HeightLaw {
            gauge,
            speed_mm_s: 30.0,
            accel_mm_s2: 400.0,
            activation: 0.0,
            ceiling_mm: 0.0,
            floor_mm: -30.0,
            raised_mm: None,
        };
        let cases = [(0.0, 150.0), (30.0, 156.67), (45.0, 160.0), (60.0, 163.33), (90.0, 170.0)];
        for (angle_deg, expected) in cases.into_iter().chain([(135.0, 160.0), (-45.0, 160.0)]) {
            let (dy, dx) = f64::to_radians(angle_deg).sin_cos();
            let wanted = law.set_point(dx, dy);
            assert!((wanted - expected).abs() < 0.005, "{wanted} at {angle_deg} degrees");
        }
    }
}
