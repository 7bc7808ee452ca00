//! Datagrams of motor drivers on a single wire (TMC2208, TMC2209 and their kin).
//!
//! A datagram is `0x05, address, register, check number` to read, and `0x05, address, register | 0x80, four bytes,
//! check number` to write; the check number is CRC-8 with the polynomial x⁸ + x² + x + 1, bits lowest first (data
//! sheet of the TMC2209, "UART datagrams"). The board sends bits, not bytes: each byte goes between a start bit 0 and
//! a stop bit 1.

use super::TmcError;

/// Bits a second on the wire.
pub const BAUD: f64 = 40_000.0;
/// First byte of each datagram.
const SYNC: u8 = 0x05;
/// Address of a driver in its answers: the host.
const HOST: u8 = 0xff;
/// Marks a register that is written.
const WRITE: u8 = 0x80;
/// Bytes of an answer.
const ANSWER: usize = 8;
/// Bytes of an answer with its start and stop bits.
pub const ANSWER_BITS: u32 = 10;

/// Returns the bits that read a register.
pub fn read(address: u8, register: u8) -> Vec<u8> {
    framed(&checked(&[SYNC, address, register & !WRITE]))
}

/// Returns the bits that write a register.
pub fn write(address: u8, register: u8, value: u32) -> Vec<u8> {
    let [a, b, c, d] = value.to_be_bytes();
    framed(&checked(&[SYNC, address, register | WRITE, a, b, c, d]))
}

/// Returns the value in the bits of an answer.
///
/// # Errors
///
/// Nothing came, or it is no answer about that register.
pub fn answer(register: u8, bits: &[u8]) -> Result<u32, TmcError> {
    if bits.is_empty() {
        return Err(TmcError::Silent);
    }
    let bytes = unframed(bits).filter(|bytes| bytes.len() == ANSWER).ok_or(TmcError::Garbled)?;
    let sound = checked(&bytes[..ANSWER - 1]) == bytes;
    match bytes[..] {
        [SYNC, HOST, of, a, b, c, d, _] if sound && of == register => {
            Ok(u32::from_be_bytes([a, b, c, d]))
        }
        _ => Err(TmcError::Garbled),
    }
}

/// Appends the check number.
fn checked(bytes: &[u8]) -> Vec<u8> {
    let bits = bytes.iter().flat_map(|byte| (0..8).map(move |bit| byte >> bit & 1));
    let crc = bits.fold(0_u8, |crc, bit| if crc >> 7 != bit { crc << 1 ^ 0x07 } else { crc << 1 });
    [bytes, &[crc]].concat()
}

/// Puts start and stop bits around each byte, lowest bit first.
fn framed(bytes: &[u8]) -> Vec<u8> {
    let mut bits = vec![0; (bytes.len() * 10).div_ceil(8)];
    let one = |byte: u8| 1_u16 << 9 | u16::from(byte) << 1;
    let line = bytes.iter().flat_map(|byte| (0..10).map(move |bit| one(*byte) >> bit & 1 == 1));
    for (at, bit) in line.enumerate() {
        bits[at / 8] |= u8::from(bit) << (at % 8);
    }
    bits
}

/// Takes start and stop bits away; nothing where one is wrong.
fn unframed(bits: &[u8]) -> Option<Vec<u8>> {
    let bit = |at: usize| u16::from(bits[at / 8] >> (at % 8) & 1);
    let word = |n: usize| (0..10).fold(0, |word, k| word | bit(n * 10 + k) << k);
    let byte =
        |n: usize| Some(word(n)).filter(|w| w & 1 == 0 && w >> 9 == 1).map(|w| (w >> 1) as u8);
    (0..bits.len() * 8 / 10).map(byte).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn registers_are_asked_for_with_the_bits_that_a_driver_answered() {
        assert_eq!(read(0, 6), [0x0a, 0x02, 0xc8, 0xa0, 0xb7]);
        assert_eq!(write(0, 0, 1).len(), 10);
    }

    #[test]
    fn answers_are_read_and_garbled_ones_are_told() {
        let bits = [0x0a, 0xfa, 0xcf, 0xa0, 0x90, 0x00, 0x02, 0x08, 0xa8, 0xa7];
        assert_eq!(answer(6, &bits), Ok(0x2100_0040));
        assert_eq!(answer(7, &bits), Err(TmcError::Garbled));
        assert_eq!(answer(6, &[]), Err(TmcError::Silent));
        for bit in 0..80 {
            let mut bad = bits;
            bad[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(answer(6, &bad), Err(TmcError::Garbled), "bit {bit}");
        }
    }
}
