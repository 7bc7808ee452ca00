//! Motor drivers with registers: the way to them, what is written into them, what they tell of themselves.
//!
//! Facts are those of the data sheets of the makers: TMC2208, TMC2209 (chapters "UART", "Register map"), TMC2130 and
//! TMC5160 ("SPI interface", "Register mapping").

mod chip;
pub mod spi;
mod status;
mod tuning;
pub mod uart;

pub use chip::Chip;
pub use status::{Condition, Trouble};
pub use tuning::{Tuning, TuningError, Write};

/// The reason for which a driver's answer is not taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TmcError {
    /// Nothing came.
    #[error(
        "the motor driver does not answer: is its supply on, is its wire on this pin, is its address right?"
    )]
    Silent,
    /// Start or stop bits, address, register or check number are wrong.
    #[error(
        "the motor driver's answer is garbled: look at the wire, and at the resistor of 1 kΩ in it"
    )]
    Garbled,
}

/// State of the whole chip: bit 0 is set since it was reset.
pub const GSTAT: u8 = 0x01;
/// Number of the datagrams that wrote a register, modulo 256, on the wire.
pub const IFCNT: u8 = 0x02;
/// Choices for the whole chip.
pub const GCONF: u8 = 0x00;
/// Chopper, sense voltage and microsteps.
pub const CHOPCONF: u8 = 0x6c;
/// State of the power stage.
pub const DRV_STATUS: u8 = 0x6f;
