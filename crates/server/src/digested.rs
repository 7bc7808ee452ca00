//! Files of the data folder that hold text of a person, or the paired devices: they carry a digest, so that one that is torn,
//! or of which a bit became another, is seen.
//!
//! ```text
//!  digest 9f86d081…          the digest of what follows
//!  {"name":"door.rsg", …
//! ```

use sha2::{Digest, Sha256};
use std::io;

/// The first line begins with this word.
const MARK: &str = "digest ";

/// SHA-256 in hexadecimal digits.
pub fn hash(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))
}

/// Hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes
        .iter()
        .flat_map(|byte| [byte >> 4, byte & 15])
        .filter_map(|n| char::from_digit(n.into(), 16))
        .collect()
}

/// Bytes with their digest before them.
pub fn with_digest(bytes: &[u8]) -> Vec<u8> {
    [format!("{MARK}{}\n", hash(bytes)).as_bytes(), bytes].concat()
}

/// The bytes behind a digest. A file of an earlier version has none, and begins as JSON does.
///
/// # Errors
/// The bytes differ from those that were written, or the digest is cut short.
pub fn checked(file: &[u8]) -> io::Result<&[u8]> {
    if file.starts_with(b"{") || file.starts_with(b"[") {
        return Ok(file);
    }
    let damaged = |why: &str| io::Error::new(io::ErrorKind::InvalidData, why);
    let body = file.strip_prefix(MARK.as_bytes());
    let end = body.and_then(|body| body.iter().position(|byte| *byte == b'\n'));
    let (Some(body), Some(end)) = (body, end) else {
        return Err(damaged(if file.is_empty() {
            "it is empty"
        } else {
            "its first line is damaged"
        }));
    };
    let (digest, bytes) = (&body[..end], &body[end + 1..]);
    if digest == hash(bytes).as_bytes() {
        Ok(bytes)
    } else {
        Err(damaged("it is not as Kerf wrote it"))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn every_bit_counts() {
        let bytes = br#"{"name":"a.rsg","drawing":"0 1 2"}"#;
        let file = with_digest(bytes);
        assert_eq!(checked(&file).unwrap(), bytes);
        for (at, bit) in (0..file.len()).flat_map(|at| (0..8).map(move |bit| (at, bit))) {
            let mut hurt = file.clone();
            hurt[at] ^= 1 << bit;
            assert!(checked(&hurt).is_err(), "byte {at}, bit {bit}");
        }
        assert!((0..file.len()).all(|length| checked(&file[..length]).is_err()));
    }

    #[test]
    fn files_of_before_have_none() {
        assert_eq!(checked(b"{}").unwrap(), b"{}");
        assert_eq!(checked(b"[]").unwrap(), b"[]");
    }
}
