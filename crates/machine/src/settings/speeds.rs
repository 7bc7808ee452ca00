//! Speeds of plunging and of moving by hand (Profiler reference, "Maximum Machine Cutting Speeds",
//! "Moving the Tool").
//!
//! The machine's highest cutting speed, the factor along Y and the centripetal share are those of
//! [`kerf_program::Smoothing`].

/// Speeds of jobs and of the arrow keys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MachineSpeeds {
    /// From Z top down to the cutting height, mm/s; at most the highest speed of Z.
    pub plunge_mm_s: f64,
    /// Speed of the arrow keys, percent of the axis' highest.
    pub arrow_speed_percent: f64,
    /// Acceleration of the arrow keys, percent of the axis' highest.
    pub arrow_accel_percent: f64,
}

impl Default for MachineSpeeds {
    fn default() -> Self {
        Self { plunge_mm_s: 20.0, arrow_speed_percent: 25.0, arrow_accel_percent: 100.0 }
    }
}
