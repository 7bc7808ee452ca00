//! Lines with their check number: `TEXT*CRC`, the CRC-32 of the text in eight hexadecimal digits.

/// The polynomial of CRC-32 (ISO 3309), its bits reversed.
const POLYNOMIAL: u32 = 0xEDB8_8320;

fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            if crc & 1 == 1 { crc >> 1 ^ POLYNOMIAL } else { crc >> 1 }
        })
    })
}

/// Returns a text as a line.
pub fn line(text: &str) -> String {
    format!("{text}*{:08x}\n", crc(text.as_bytes()))
}

/// Returns the text of a line; nothing where its check number is another.
pub fn text(line: &[u8]) -> Option<&str> {
    let (text, check) = str::from_utf8(line).ok()?.trim_end().rsplit_once('*')?;
    (u32::from_str_radix(check, 16).ok()? == crc(text.as_bytes())).then_some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_read_as_it_was_written_and_not_with_a_bit_turned() {
        assert_eq!(crc(b"123456789"), 0xCBF4_3926, "the check value that is published with it");
        let said = line("3 g 7 G53 G1 X1");
        assert_eq!(text(said.trim_end().as_bytes()), Some("3 g 7 G53 G1 X1"));
        for bit in 0..8 * (said.len() - 1) {
            let mut bytes = said.trim_end().as_bytes().to_vec();
            bytes[bit / 8] ^= 1 << (bit % 8);
            let read = text(&bytes);
            assert!(read.is_none() || read == Some("3 g 7 G53 G1 X1"), "bit {bit}: {read:?}");
        }
    }
}
