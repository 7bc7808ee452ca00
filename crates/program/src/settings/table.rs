//! Limits, resolution and drivers of the table (VL, VU, VI).

use super::unit::{MM_PER_INCH, inch};
use crate::{AXES, Axes, Axis};
use serde::{Deserialize, Serialize};

/// Table limits in table base coordinates (VL, SF).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Lowest values.
    pub low: Axes,
    /// Highest values.
    pub high: Axes,
    /// The limits are checked.
    pub check: bool,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            low: Axes([0.0, 0.0, inch(-6.0), inch(-6.0), -360.0, -360.0]),
            high: Axes([inch(96.0), inch(48.0), inch(6.0), inch(6.0), 360.0, 360.0]),
            check: false,
        }
    }
}

/// Unit values and resolution (VU).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Resolution {
    /// Steps per mm or per degree.
    pub steps_per_unit: Axes,
    /// Circle segment length, mm.
    pub circle_mm: f64,
    /// Resolution multipliers during jogs.
    pub multipliers: [u8; AXES],
    /// Step interval divider 1 … 100.
    pub divider: u8,
    /// Resolution shifting disabled: jogs reach [`NO_SHIFT_JOG_MM_S`] at most.
    pub no_shift: bool,
}

impl Default for Resolution {
    fn default() -> Self {
        Self {
            steps_per_unit: Axes([
                400.0 / MM_PER_INCH,
                400.0 / MM_PER_INCH,
                400.0 / MM_PER_INCH,
                400.0 / MM_PER_INCH,
                5000.0 / 360.0,
                5000.0 / 360.0,
            ]),
            circle_mm: inch(0.05),
            multipliers: [1; AXES],
            divider: 1,
            no_shift: false,
        }
    }
}

/// Top jog speed with resolution shifting disabled: 16 in/s (command reference, VU).
pub const NO_SHIFT_JOG_MM_S: f64 = 16.0 * MM_PER_INCH;

/// Driver (VI).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Driver {
    /// Port slot 1 … 16.
    pub port: u8,
    /// Axis of each driver channel.
    pub channels: [Axis; AXES],
    /// Speed code: 2 115.2, 3 230.4, 4 460.8, 5 921.6 kbaud.
    pub speed_code: u8,
    /// Steps and outputs are given.
    pub enabled: bool,
}

impl Default for Driver {
    fn default() -> Self {
        Self { port: 1, channels: Axis::ALL, speed_code: 5, enabled: true }
    }
}
