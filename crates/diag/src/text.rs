//! Bytes and numbers to text: old program files come in several encodings.

use std::borrow::Cow;

/// Byte-order mark that some editors put before UTF-8.
const UTF_8_MARK: &[u8] = b"\xEF\xBB\xBF";

/// The text of a file, without a byte-order mark; line ends stay as they are.
///
/// UTF-16 where its byte-order mark says so, UTF-8 where the bytes are valid UTF-8, Windows-1252
/// otherwise: that is what old editors wrote.
///
/// # Errors
/// The line (from 1) of the first NUL byte: such a file is no text.
pub fn decode(bytes: Cow<'_, [u8]>) -> Result<String, u32> {
    match &*bytes {
        [0xFF, 0xFE, rest @ ..] => return whole(utf_16(rest, u16::from_le_bytes)),
        [0xFE, 0xFF, rest @ ..] => return whole(utf_16(rest, u16::from_be_bytes)),
        _ => {}
    }
    // `contains` looks at many bytes at a time.
    if bytes.contains(&0) {
        let above = bytes.iter().take_while(|b| **b != 0).filter(|b| **b == b'\n').count();
        return Err(above as u32 + 1);
    }
    let mut bytes = bytes.into_owned();
    if bytes.starts_with(UTF_8_MARK) {
        bytes.drain(..UTF_8_MARK.len());
    }
    let old = |bytes: Vec<u8>| bytes.into_iter().map(windows_1252).collect();
    Ok(String::from_utf8(bytes).unwrap_or_else(|error| old(error.into_bytes())))
}

fn utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let units = bytes.chunks(2).map(|pair| unit([pair[0], pair.get(1).copied().unwrap_or(0)]));
    char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}

fn whole(text: String) -> Result<String, u32> {
    match text.find('\0') {
        Some(at) => Err(text[..at].matches('\n').count() as u32 + 1),
        None => Ok(text),
    }
}

/// Windows-1252, 0x80 to 0x9F; the five unused places become the replacement character.
const HIGH: [char; 32] = [
    '€', '\u{FFFD}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{FFFD}', 'Ž',
    '\u{FFFD}', '\u{FFFD}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{FFFD}',
    'ž', 'Ÿ',
];

fn windows_1252(byte: u8) -> char {
    match byte {
        0x80..=0x9F => HIGH[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

/// A whole number with commas between its thousands: `1,204,332`.
pub fn with_commas(number: u64) -> String {
    let digits = number.to_string();
    let groups = digits.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy);
    groups.collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_become_text() {
        for (bytes, text) in [
            (&b"MX,1"[..], "MX,1"),
            (b"\xEF\xBB\xBFMX,1", "MX,1"),
            ("'größe".as_bytes(), "'größe"),
            (b"'gr\xF6\xDFe \x80\x93", "'größe €“"),
            (b"\xFF\xFEM\0X\0", "MX"),
            (b"\xFE\xFF\0M\0X", "MX"),
        ] {
            assert_eq!(decode(bytes.into()).as_deref(), Ok(text));
        }
        assert_eq!(decode(b"MX,1\n\0"[..].into()), Err(2));
        assert_eq!(decode(b"\xFF\xFEM\0\n\0\0\0"[..].into()), Err(2));
    }

    #[test]
    fn thousands_are_parted_by_commas() {
        let written = [7, 1000, 200_000, 1_204_332].map(with_commas);
        assert_eq!(written, ["7", "1,000", "200,000", "1,204,332"]);
    }
}
