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

/// Values of the intensity output below the highest.
const FULL: f64 = 127.0;

impl Laser {
    /// Returns the length of each pulse of a pulsed laser at an intensity 0 … 127, microseconds ("Intensity Output
    /// Example").
    pub fn pulse_us(hz: f64, value: u8) -> f64 {
        1e6 / hz * f64::from(value) / FULL
    }

    /// Returns the power that a laser's board makes of its port and its cut outputs, percent of full power: an old one
    /// turns full on with the burn bit and cut 1, and off with the burn bit and cut 2.
    pub fn power_percent(&self, value: u8, burn: bool, [cut1, cut2]: [bool; 2]) -> f64 {
        if !self.use_laser {
            return 0.0;
        }
        match (self.legacy_board && burn, cut1, cut2) {
            (true, true, _) => 100.0,
            (true, _, true) => 0.0,
            _ => 100.0 * f64::from(value) / FULL,
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pro_intensity_pulse() {
        // 100 kHz: a period of 10 µs.
        assert!((Laser::pulse_us(100_000.0, 38) - 2.992).abs() < 5e-4);
    }

    #[test]
    fn pro_laser_legacy() {
        let laser = |legacy_board| Laser { use_laser: true, legacy_board, ..Laser::default() };
        let (old, new) = (laser(true), laser(false));
        let (cut1, cut2, none) = ([true, false], [false, true], [false, false]);
        assert_eq!([cut1, cut2].map(|cuts| old.power_percent(0, true, cuts)), [100.0, 0.0]);
        assert_eq!(old.power_percent(127, true, cut2), 0.0);
        assert_eq!(old.power_percent(127, true, none), 100.0);
        assert!((old.power_percent(38, false, cut1) - 29.921).abs() < 1e-3);
        assert!((new.power_percent(38, true, cut2) - 29.921).abs() < 1e-3, "others ignore the bit");
        assert_eq!(Laser::default().power_percent(127, false, cut1), 0.0);
    }
}
