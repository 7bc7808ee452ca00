//! Automatic height control (Profiler reference, "Automatic Height Control").

use super::words;

words! {
    /// How the height is sensed.
    HeightMode {
        /// Two inputs, too high and too low.
        Simple = "simple",
        /// Readings 0 … 255 of a potentiometer.
        Proportional = "proportional",
    }
}

/// Settings of height control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightControl {
    /// Used for THRU shapes ("Do Height Control").
    pub on: bool,
    /// How the height is sensed.
    pub mode: HeightMode,
    /// Highest speed of Z under height control, mm/s; at most that of the axis.
    pub speed_mm_s: f64,
    /// Highest acceleration of Z under height control, mm/s²; at most that of the axis.
    pub accel_mm_s2: f64,
    /// Acts above this share of the cutting speed, percent; 0 always.
    pub activation_percent: f64,
    /// Acts between THRU shapes too.
    pub between: bool,
    /// Reading wanted when cutting along X.
    pub x_set_point: u8,
    /// Reading wanted when cutting along Y.
    pub y_set_point: u8,
    /// Steps of the Z motor for one unit of the reading.
    pub k: f64,
    /// Millimetres for one unit of the reading.
    pub scale_mm: f64,
    /// Errors above this are drawn in another colour, mm.
    pub display_accuracy_mm: f64,
    /// A larger reading means a smaller gap.
    pub invert: bool,
    /// Serial port of the readings, 1 … 4.
    pub port: u8,
    /// Its speed, baud.
    pub baud: u32,
}

impl Default for HeightControl {
    fn default() -> Self {
        Self {
            on: false,
            mode: HeightMode::Simple,
            speed_mm_s: 30.0,
            accel_mm_s2: 400.0,
            activation_percent: 0.0,
            between: false,
            x_set_point: 150,
            y_set_point: 150,
            k: 20.0,
            scale_mm: 0.038,
            display_accuracy_mm: 0.1,
            invert: false,
            port: 3,
            baud: 9600,
        }
    }
}
