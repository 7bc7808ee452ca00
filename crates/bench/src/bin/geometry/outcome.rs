//! Outcome of an offset, to be set beside what others give.

/// Result of an offset: rings, vertices, area.
#[derive(Clone, Copy, Debug, Default)]
pub struct Outcome {
    /// Number of rings.
    pub rings: usize,
    /// Number of vertices.
    pub vertices: usize,
    /// Area, mm².
    pub area: f64,
}

impl Outcome {
    /// Adds a ring.
    pub fn add(&mut self, vertices: usize, area: f64) {
        self.rings += 1;
        self.vertices += vertices;
        self.area += area;
    }
}
