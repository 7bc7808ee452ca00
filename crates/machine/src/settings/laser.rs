//! Lasers and how they pierce (Profiler reference, "Laser Operation").

use super::words;

words! {
    /// The kind of laser.
    LaserType {
        /// The beam is continuous.
        Continuous = "cw",
        /// The beam is pulsed: the width of its pulses is the intensity.
        Pulsed = "pwm",
    }
}

/// Settings of a laser.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laser {
    /// A laser is the tool.
    pub use_laser: bool,
    /// Which kind; has to be chosen before a job starts.
    pub kind: Option<LaserType>,
    /// Pulse frequency while cutting, Hz.
    pub cut_hz: f64,
    /// Shortest pulse, microseconds.
    pub min_pulse_us: f64,
    /// Longest pulse, microseconds.
    pub max_pulse_us: f64,
    /// An old board, where the lowest bit with cut 1 gives full intensity and with cut 2 none.
    pub legacy_board: bool,
    /// Cut output that marks engraving groups, which are not pierced.
    pub engrave_cut: Option<u8>,
    /// Piercing.
    pub pierce: Pierce,
    /// The gas while cutting.
    pub gas: CutGas,
}

/// The pierce sequence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pierce {
    /// Used in place of the bottom delay.
    pub use_sequence: bool,
    /// Pulse frequency while piercing, Hz.
    pub hz: f64,
    /// Height above the surface, mm.
    pub height_mm: f64,
    /// Tool output of the pierce gas.
    pub gas_tool: Option<u8>,
    /// Wait for the pierce gas, milliseconds.
    pub gas_wait_ms: f64,
    /// Intensity 0 … 127, mapped through the table.
    pub intensity: u8,
    /// Time the laser is on, milliseconds.
    pub time_ms: f64,
    /// Wait while cut gas displaces the pierce gas, milliseconds.
    pub purge_ms: f64,
}

/// The gas while cutting.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CutGas {
    /// Its tool output.
    pub tool: Option<u8>,
    /// Wait for it, milliseconds.
    pub wait_ms: f64,
    /// It is used instead of the group's tool output.
    pub overrides: bool,
}

impl Default for Laser {
    fn default() -> Self {
        Self {
            use_laser: false,
            kind: None,
            cut_hz: 5000.0,
            min_pulse_us: 0.0,
            max_pulse_us: 1e6,
            legacy_board: false,
            engrave_cut: None,
            pierce: Pierce {
                use_sequence: false,
                hz: 500.0,
                height_mm: 5.0,
                gas_tool: None,
                gas_wait_ms: 0.0,
                intensity: 0,
                time_ms: 0.0,
                purge_ms: 0.0,
            },
            gas: CutGas::default(),
        }
    }
}
