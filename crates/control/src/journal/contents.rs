//! Files by the hash of their bytes.

use super::rows::{Result, Rows, Table, key_text};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// The name of some bytes: their SHA-256 in hexadecimal digits.
pub(super) fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

impl Rows<'_> {
    /// Keeps bytes and tells their name.
    pub(super) fn keep_content(&self, bytes: &[u8]) -> Result<String> {
        let hash = hash(bytes);
        if !self.has(Table::Content, &hash)? {
            self.put(Table::Content, &hash, bytes)?;
        }
        Ok(hash)
    }

    /// All of them.
    pub(super) fn contents(&self) -> Result<BTreeMap<String, Vec<u8>>> {
        self.each(Table::Content, |(key, bytes)| Ok((key_text(key), bytes)))?.into_iter().collect()
    }
}
