//! The check number of a frame: CRC-16/MCRF4XX.
//!
//! Polynomial 0x1021 reflected, start 0xFFFF, input and output reflected, nothing added at the end.

/// The polynomial x¹⁶ + x¹² + x⁵ + 1, lowest bit first.
const POLYNOMIAL: u16 = 0x8408;

/// Check numbers of single bytes.
const TABLE: [u16; 256] = table();

const fn table() -> [u16; 256] {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut rest = byte as u16;
        let mut bit = 0;
        while bit < 8 {
            rest = if rest & 1 == 1 { rest >> 1 ^ POLYNOMIAL } else { rest >> 1 };
            bit += 1;
        }
        table[byte] = rest;
        byte += 1;
    }
    table
}

/// Returns the check number of bytes.
///
/// ```
/// assert_eq!(kerf_driver_klipper::wire::crc::crc16(b"123456789"), 0x6f91);
/// ```
pub fn crc16(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0xffff, |crc, byte| crc >> 8 ^ TABLE[usize::from(crc as u8 ^ byte)])
}
