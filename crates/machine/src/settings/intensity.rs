//! The intensity output (Profiler reference, "Intensity Output").

/// Entries of the intensity table.
pub const LEVELS: usize = 128;

/// Output of intensity, and its dependence on speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Intensity {
    /// Intensity is sent to the port ("Output the Intensity").
    pub output: bool,
    /// Intensity 0 … 127 of each discretized speed 0 … 127.
    pub table: [u8; LEVELS],
    /// Scale of the output, percent.
    pub scale_percent: f64,
    /// The lower clip is rounded up, so that no pulse is shorter than the shortest.
    pub strict_clip: bool,
    /// The lowest bit of the port byte is set during the bottom delay ("burn bit").
    pub low_bit_at_bottom: bool,
    /// Parallel port of the intensity byte, 1 or 2.
    pub port: u8,
}

impl Default for Intensity {
    fn default() -> Self {
        Self {
            output: false,
            table: std::array::from_fn(|i| i as u8),
            scale_percent: 100.0,
            strict_clip: false,
            low_bit_at_bottom: false,
            port: 1,
        }
    }
}
