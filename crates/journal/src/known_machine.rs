//! The machine that the journal knows: `machine.toml` as Kerf left it last.
//!
//! Whoever writes the file through Kerf leaves its text here, before it is in its place and after. A text that is not
//! known is somebody's edit, an older file that came back, or a file that lost its bytes: it holds, and it is told;
//! locations are confirmed once, since lengths, units and motors may be others.

use super::JournalError;
use super::rows::{Table, json};
use super::store::Store;
use std::sync::Arc;

/// Name of the fact: texts that may lie there, the newest last. There are two while one takes the place of the other.
const KNOWN: &str = "machine";

/// The machine that a journal knows.
#[derive(Clone, Debug)]
pub(super) struct KnownMachine(pub Arc<Store>);

impl KnownMachine {
    /// The file is about to be written. Gives whether it is known as it is; else the next look at it tells.
    pub(super) fn expects(&self, before: Option<&str>, text: &str) -> Result<bool, JournalError> {
        let known = self.texts()?;
        let before = before.map(str::to_owned);
        if !known.is_empty() && !known.contains(&before) {
            return Ok(false);
        }
        self.keep(&[before, Some(text.to_owned())])?;
        Ok(true)
    }

    /// The file says this from now on.
    pub(super) fn is(&self, text: Option<&str>) -> Result<(), JournalError> {
        self.keep(&[text.map(str::to_owned)])
    }

    /// The texts that may lie there, the newest last.
    pub(super) fn texts(&self) -> Result<Vec<Option<String>>, JournalError> {
        let text = self.0.read(|rows| rows.text(Table::Fact, KNOWN))?;
        Ok(self.0.parsed(KNOWN, text)?.unwrap_or_default())
    }

    fn keep(&self, texts: &[Option<String>]) -> Result<(), JournalError> {
        self.0.write(|rows| rows.put(Table::Fact, KNOWN, &json(&texts)?))
    }
}
