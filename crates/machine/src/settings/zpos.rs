//! Special positions of Z, counted from Z home at the top (Profiler reference, "Special Z Axis
//! Positions").

/// Heights in machine coordinates: 0 at home, negative below. Top ≥ surface ≥ bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZPositions {
    /// Height when not machining and between shapes, mm.
    pub top_mm: f64,
    /// Zero of cutting heights: the surface of the material, mm.
    pub surface_mm: f64,
    /// Height of THRU cuts, and the lowest the tool may go, mm.
    pub bottom_mm: f64,
}

impl Default for ZPositions {
    fn default() -> Self {
        Self { top_mm: -10.0, surface_mm: -20.0, bottom_mm: -30.0 }
    }
}
