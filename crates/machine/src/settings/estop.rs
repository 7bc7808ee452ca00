//! The emergency stop input (Profiler reference, "Emergency Stopping").

/// Settings of the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EmergencyStop {
    /// The level that stops: 1 or 0. With 0 a broken wire stops too.
    pub active: bool,
}

impl Default for EmergencyStop {
    fn default() -> Self {
        Self { active: true }
    }
}
