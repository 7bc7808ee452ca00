//! The sheet on the table: how high its surface lies, and what the sensors of the head tell of it.

use serde::{Deserialize, Serialize};

/// A sheet, flat or warped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Sheet {
    /// Height of its surface at machine home, mm, machine frame.
    pub at_mm: f64,
    /// Slope along X, mm a mm.
    pub slope_x: f64,
    /// Slope along Y, mm a mm.
    pub slope_y: f64,
    /// A wave along X: how high, mm.
    pub wave_mm: f64,
    /// Length of the wave, mm; 0 is none.
    pub wave_length_mm: f64,
    /// A step: from this X on it lies higher by so much, mm.
    pub step: Option<[f64; 2]>,
}

impl Sheet {
    /// A flat sheet.
    pub fn flat(at_mm: f64) -> Self {
        Self { at_mm, ..Self::default() }
    }

    /// Height of its surface at a place, mm, machine frame.
    pub fn height_mm(&self, x: f64, y: f64) -> f64 {
        let phase = if self.wave_length_mm > 0.0 { x / self.wave_length_mm } else { 0.0 };
        let wave = self.wave_mm * (phase * std::f64::consts::TAU).sin();
        let step = self.step.map_or(0.0, |[from, up]| if x >= from { up } else { 0.0 });
        self.at_mm + self.slope_x * x + self.slope_y * y + wave + step
    }
}
