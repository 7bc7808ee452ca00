//! Lines with their check number: `TEXT*CRC`, the CRC-32 of the text in eight hexadecimal digits.

/// Returns a text as a line.
pub fn line(text: &str) -> String {
    format!("{text}*{:08x}\n", crc32fast::hash(text.as_bytes()))
}

/// Returns the text of a line; nothing where its check number is another.
pub fn text(line: &[u8]) -> Option<&str> {
    let (text, check) = str::from_utf8(line).ok()?.trim_end().rsplit_once('*')?;
    (u32::from_str_radix(check, 16).ok()? == crc32fast::hash(text.as_bytes())).then_some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_read_as_it_was_written_and_not_with_a_bit_turned() {
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
