//! The plasma start sequence (Profiler reference, "Plasma Startup Sequence").

/// Settings of the sequence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plasma {
    /// Used instead of the ordinary start.
    pub use_sequence: bool,
    /// Height above the place where Too-Close came, mm.
    pub initial_height_mm: f64,
    /// Wait after the arc came during which its input is ignored, seconds.
    pub initial_wait_s: f64,
    /// From the start of cutting the arc input is ignored for so long, seconds.
    pub debounce_s: f64,
    /// Longest wait for the arc, seconds.
    pub arc_timeout_s: f64,
}

impl Default for Plasma {
    fn default() -> Self {
        Self {
            use_sequence: false,
            initial_height_mm: 4.0,
            initial_wait_s: 0.5,
            debounce_s: 0.3,
            arc_timeout_s: 10.0,
        }
    }
}
