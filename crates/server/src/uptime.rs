//! The server's clock, which pages reckon with.

use std::time::Instant;

/// The time since the server began. It never goes back, and no other clock sets it.
#[derive(Clone, Copy, Debug)]
pub struct Uptime(Instant);

impl Default for Uptime {
    fn default() -> Self {
        Self(Instant::now())
    }
}

impl Uptime {
    /// Milliseconds.
    pub fn ms(&self) -> f64 {
        self.0.elapsed().as_secs_f64() * 1e3
    }
}
