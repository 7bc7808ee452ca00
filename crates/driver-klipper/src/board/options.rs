//! Choices for a session.

/// Choices for a session.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Time without word from the host after which the board stops all motors by itself, seconds.
    pub deadline_s: f64,
    /// Farthest that a step is from its planned moment, seconds.
    pub error_s: f64,
    /// Time behind the last step for which latches stay armed, seconds: motion that follows by then begins without arming
    /// them anew.
    pub linger_s: f64,
    /// A shutdown from before the session is cleared: somebody has looked why.
    pub clears: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { deadline_s: 0.1, error_s: 5e-6, linger_s: 0.0, clears: false }
    }
}
