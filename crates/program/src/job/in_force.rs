//! The values of a job that a pause can change beside its heights.

use serde::{Deserialize, Serialize};

/// Speeds and manners that hold for the rest of a job.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct InForce {
    /// Highest cutting speed, mm/s.
    pub cut_mm_s: f64,
    /// Plunging speed, mm/s.
    pub plunge_mm_s: f64,
    /// The tool rises in pauses.
    pub raise: bool,
}
