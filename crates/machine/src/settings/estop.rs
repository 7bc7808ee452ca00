//! The emergency stop input (Profiler reference, "Emergency Stopping").

/// Settings of the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EmergencyStop {
    /// The level that stops: 1 or 0. With 0 a broken wire stops too.
    pub active: bool,
    /// The stop of part files (input 4) cuts the power of the spindles at once, and that of
    /// the motors five seconds later, as on alpha tools; otherwise a run goes on once it is released.
    pub cuts_power: bool,
}

impl Default for EmergencyStop {
    fn default() -> Self {
        Self { active: true, cuts_power: false }
    }
}
