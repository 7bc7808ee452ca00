//! Datagrams of motor drivers with a chip select (TMC2130, TMC5160): a byte of address, four of data, highest first.
//!
//! An answer is the state of the driver and the data of the datagram before: the register that was read, or the value that
//! was written. So each datagram goes out twice, and the second answer is looked at.

use super::TmcError;

/// Marks a register that is written.
const WRITE: u8 = 0x80;
/// Mode of the bus: the clock is high at rest, data are taken at its rising edge.
pub const MODE: u32 = 3;
/// Length of a bit, seconds.
pub const BIT_S: f64 = 1e-6;

/// Returns the datagram that reads a register.
pub fn read(register: u8) -> Vec<u8> {
    vec![register & !WRITE, 0, 0, 0, 0]
}

/// Returns the datagram that writes a register.
pub fn write(register: u8, value: u32) -> Vec<u8> {
    [&[register | WRITE][..], &value.to_be_bytes()].concat()
}

/// Returns the data of an answer.
///
/// # Errors
///
/// Nobody drives the line, or bytes are missing.
pub fn answer(bytes: &[u8]) -> Result<u32, TmcError> {
    match *bytes {
        [0xff, 0xff, 0xff, 0xff, 0xff] | [0, 0, 0, 0, 0] => Err(TmcError::Silent),
        [_, a, b, c, d] => Ok(u32::from_be_bytes([a, b, c, d])),
        _ => Err(TmcError::Garbled),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_are_the_last_four_bytes_and_an_idle_line_is_told() {
        assert_eq!(write(0x10, 0x0006_1f0a), [0x90, 0x00, 0x06, 0x1f, 0x0a]);
        assert_eq!(read(0x6f), [0x6f, 0, 0, 0, 0]);
        assert_eq!(answer(&[0x01, 0x30, 0, 0, 0x40]), Ok(0x3000_0040));
        assert_eq!(answer(&[0xff; 5]), Err(TmcError::Silent));
        assert_eq!(answer(&[0; 5]), Err(TmcError::Silent));
        assert_eq!(answer(&[1, 2]), Err(TmcError::Garbled));
    }
}
