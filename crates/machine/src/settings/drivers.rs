//! Motor drivers with registers on a board with step queues (TMC2208 and its kin).

use super::motors::MOTORS;

/// Motor drivers with registers, by their motors X, Y, Z, W, Q, R.
#[derive(Clone, Debug, PartialEq)]
pub struct Drivers {
    /// Kind and pins of each: `tmc2209 gpio9 gpio8 2` on a wire, `tmc5160 PC4` with a chip select. Empty for one that is set
    /// by hand.
    pub kinds: [String; MOTORS],
    /// MISO, MOSI, SCK of those with chip selects.
    pub spi: String,
    /// Current of a coil while the motor turns, amperes, root mean square.
    pub current_a: [f64; MOTORS],
    /// Share of it while the motor stands.
    pub hold: f64,
    /// Sense resistors, ohms; 0 for the usual ones of the kind.
    pub ohms: [f64; MOTORS],
    /// Microsteps of a full step.
    pub microsteps: [u32; MOTORS],
    /// They make 256 microsteps of each full step by themselves.
    pub interpolates: bool,
    /// StealthChop in place of SpreadCycle.
    pub quiet: bool,
    /// Thresholds at which they tell a stall; 0 where they tell none.
    pub stall: [i32; MOTORS],
}

impl Default for Drivers {
    fn default() -> Self {
        Self {
            kinds: Default::default(),
            spi: String::new(),
            current_a: [0.0; MOTORS],
            hold: 0.5,
            ohms: [0.0; MOTORS],
            microsteps: [16; MOTORS],
            interpolates: true,
            quiet: false,
            stall: [0; MOTORS],
        }
    }
}
