//! Whole numbers of 32 bits in one to five bytes, seven bits each, the highest first.
//!
//! Bit 7 says that more bytes follow. A first byte whose bits 5 and 6 are both set is negative. So n bytes carry
//! −2^(7n−2) … 3·2^(7n−2) − 1, and small numbers of either sign are short.

/// Most bytes of a number.
const LONGEST: usize = 5;

/// Appends a number; one that is signed is given as its 32 bits.
pub fn put(value: u32, out: &mut Vec<u8>) {
    let signed = i64::from(value as i32);
    for group in (1..LONGEST).rev() {
        let unit = 1_i64 << (7 * group - 2);
        if signed < -unit || signed >= 3 * unit {
            out.push(0x80 | (signed >> (7 * group)) as u8 & 0x7f);
        }
    }
    out.push(signed as u8 & 0x7f);
}

/// Takes a number from the front of bytes, and moves them on; nothing where they end within it, or it has too many.
pub fn take(bytes: &mut &[u8]) -> Option<u32> {
    let (first, _) = bytes.split_first()?;
    let mut value = if first & 0x60 == 0x60 { u32::MAX } else { 0 };
    for n in 0..LONGEST.min(bytes.len()) {
        value = value << 7 | u32::from(bytes[n] & 0x7f);
        if bytes[n] & 0x80 == 0 {
            *bytes = &bytes[n + 1..];
            return Some(value);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(value: i64, bytes: &[u8]) {
        let mut out = Vec::new();
        put(value as u32, &mut out);
        assert_eq!(out, bytes, "{value}");
        let mut rest = bytes;
        assert_eq!((take(&mut rest), rest), (Some(value as u32), &[][..]), "{value}");
    }

    #[test]
    fn numbers_have_the_bytes_that_boards_give_them() {
        check(0, &[0x00]);
        check(95, &[0x5f]);
        check(96, &[0x80, 0x60]);
        check(-1, &[0x7f]);
        check(-32, &[0x60]);
        check(-33, &[0xff, 0x5f]);
        check(127, &[0x80, 0x7f]);
        check(128, &[0x81, 0x00]);
        check(1000, &[0x87, 0x68]);
        check(12287, &[0xdf, 0x7f]);
        check(12288, &[0x80, 0xe0, 0x00]);
        check(-4096, &[0xe0, 0x00]);
        check(-4097, &[0xff, 0xdf, 0x7f]);
        check(-32768, &[0xfe, 0x80, 0x00]);
        check(32767, &[0x81, 0xff, 0x7f]);
        check(100_000, &[0x86, 0x8d, 0x20]);
        check(16_000_000, &[0x87, 0xd0, 0xc8, 0x00]);
        check(-2000, &[0xf0, 0x30]);
        check(201_326_592, &[0x80, 0xe0, 0x80, 0x80, 0x00]);
        check(2_147_483_647, &[0x87, 0xff, 0xff, 0xff, 0x7f]);
        check(0xffff_fff0, &[0x70]);
    }

    #[test]
    fn the_top_of_a_large_number_may_come_without_its_sign() {
        for bytes in [[0x89, 0x90, 0xa3, 0x98, 0x3a], [0xf9, 0x90, 0xa3, 0x98, 0x3a]] {
            assert_eq!(take(&mut &bytes[..]), Some(2_450_050_106));
        }
    }

    #[test]
    fn bytes_that_end_within_a_number_give_none() {
        for bytes in [&[][..], &[0x80], &[0x80; 5], &[0xff; 9]] {
            assert_eq!(take(&mut { bytes }), None);
        }
    }
}
