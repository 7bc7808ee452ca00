//! Bytes to text: old program files come in several encodings.

use std::borrow::Cow;

/// The text of a file, without a byte-order mark; line ends stay as they are.
///
/// UTF-8 where the bytes are valid UTF-8, Windows-1252 otherwise: that is what old editors wrote.
///
/// # Errors
/// The line (from 1) of the first NUL byte: such a file is no text.
pub fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, u32> {
    // `contains` looks at many bytes at a time.
    if bytes.contains(&0) {
        let above = bytes.iter().take_while(|b| **b != 0).filter(|b| **b == b'\n').count();
        return Err(above as u32 + 1);
    }
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    Ok(match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(|b| windows_1252(*b)).collect()),
    })
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
        ] {
            assert_eq!(decode(bytes).as_deref(), Ok(text));
        }
        assert_eq!(decode(b"MX,1\n\0"), Err(2));
    }
}
