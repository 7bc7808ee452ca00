//! Motor drivers with registers, and the ways to them.

use super::Pin;
use crate::tmc::Tuning;

/// A wire to motor drivers.
#[derive(Clone, Debug, PartialEq)]
pub struct DriverWire {
    /// Pin that hears.
    pub rx: Pin,
    /// Pin that speaks; the same one where there is one wire.
    pub tx: Pin,
}

/// A chip select of a motor driver, with the bus on which it is.
#[derive(Clone, Debug, PartialEq)]
pub struct DriverSelect {
    /// Pin of the select, low while the chip is spoken to.
    pub cs: Pin,
    /// MISO, MOSI, SCK.
    pub bus: [Pin; 3],
}

/// The way to the registers of a motor driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RegisterLink {
    /// An address on a wire.
    Wire {
        /// Place of the wire among the wires.
        wire: usize,
        /// The address.
        address: u8,
    },
    /// Place of its chip select among the selects.
    Select(usize),
}

/// A motor driver whose registers are set.
#[derive(Clone, Debug, PartialEq)]
pub struct Driver {
    /// The name of its motor, as people know it.
    pub name: String,
    /// The way to its registers.
    pub way: RegisterLink,
    /// The values in them.
    pub tuning: Tuning,
}
