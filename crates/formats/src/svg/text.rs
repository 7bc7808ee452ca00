//! From the bytes of a file to its letters.

use std::borrow::Cow;

/// First bytes of packed files (RFC 1952).
const GZIP: [u8; 2] = [0x1f, 0x8b];

/// The text of a file in UTF-8, or in UTF-16 where it begins with the mark of that.
///
/// # Errors
/// It is packed.
pub fn text_of(bytes: &[u8]) -> Result<Cow<'_, str>, &'static str> {
    if bytes.starts_with(&GZIP) {
        return Err("the file is compressed (.svgz): unpack it, or save it as plain SVG");
    }
    let read: fn([u8; 2]) -> u16 = match bytes {
        [0xff, 0xfe, ..] => u16::from_le_bytes,
        [0xfe, 0xff, ..] => u16::from_be_bytes,
        _ => return Ok(String::from_utf8_lossy(bytes)),
    };
    let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|two| read([two[0], two[1]])).collect();
    Ok(Cow::Owned(String::from_utf16_lossy(&units)))
}
