//! Files by the hash of their bytes.
//!
//! A file is kept in pieces, so that a large one is never in memory twice: keys are the hash and the number
//! of the piece.

use super::rows::{Result, Rows, Table, key_text};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Bytes of a piece.
const PIECE: usize = 1 << 20;

/// The name of some bytes: their SHA-256 in hexadecimal digits.
pub(super) fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The key of a piece; in order of text they are in order of numbers.
fn key(hash: &str, piece: usize) -> String {
    format!("{hash} {piece:06}")
}

impl Rows<'_> {
    /// Keeps bytes under their hash.
    pub(super) fn keep_content(&self, hash: &str, bytes: &[u8]) -> Result<()> {
        if self.has(Table::Content, &key(hash, 0))? {
            return Ok(());
        }
        self.put(Table::Content, key(hash, 0), &bytes[..bytes.len().min(PIECE)])?;
        for (number, piece) in bytes.chunks(PIECE).enumerate().skip(1) {
            self.put(Table::Content, key(hash, number), piece)?;
        }
        Ok(())
    }

    /// All of them.
    pub(super) fn contents(&self) -> Result<BTreeMap<String, Vec<u8>>> {
        let mut contents = BTreeMap::<String, Vec<u8>>::new();
        for row in self.each(Table::Content, |(key, bytes)| Ok((key_text(key), bytes)))? {
            let (key, piece) = row?;
            let hash = key.split_once(' ').map_or(key.as_str(), |(hash, _)| hash);
            contents.entry(hash.into()).or_default().extend(piece);
        }
        Ok(contents)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::{PIECE, hash};
    use crate::opening;

    /// Bytes that repeat in no piece.
    fn bytes(count: usize) -> Vec<u8> {
        (0..count).map(|k| (k * k / 251) as u8).collect()
    }

    #[test]
    fn files_of_any_length_come_back() {
        let folder = tempfile::tempdir().unwrap();
        let (store, _) = opening::open(folder.path()).unwrap();
        let files = [0, 1, PIECE - 1, PIECE, PIECE + 1, 12 * PIECE + 7].map(bytes);
        for file in &files {
            store.write(|rows| rows.keep_content(&hash(file), file)).unwrap();
            store.write(|rows| rows.keep_content(&hash(file), file)).unwrap();
        }
        let back = store.read(|rows| rows.contents()).unwrap();
        assert_eq!(back.len(), files.len());
        assert!(files.iter().all(|file| back.get(&hash(file)) == Some(file)));
    }
}
