//! Effects of pausing (Profiler reference, "Pausing the Machine").

/// Settings of a pause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pause {
    /// The tool rises to Z top once the machine stands ("Raise On Pause?").
    pub raise: bool,
}

impl Default for Pause {
    fn default() -> Self {
        Self { raise: true }
    }
}
