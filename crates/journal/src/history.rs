//! Runs that are over.

use super::rows::{self, Rows, Table, json};
use super::store::Store;
use super::{JournalError, Started};
use serde::{Deserialize, Serialize};

/// So many runs are remembered.
const MOST: i64 = 1000;

/// A run that is over.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Past {
    /// The part file.
    pub file: String,
    /// Hash of its bytes, in hexadecimal digits.
    pub hash: String,
    /// Time and date of its start, as a person reads them; nobody computes with them.
    pub started: Option<Started>,
    /// Machine time it took, seconds.
    pub seconds: f64,
    /// Outcome: `ok`, `ended`, `failed`, `stopped`, `limit`; `cut short` when the process died.
    pub status: String,
}

/// The runs that are over, oldest first.
pub(super) fn all(store: &Store) -> Result<Vec<Past>, JournalError> {
    let rows = store.read(|rows| rows.all(Table::History))?;
    let past = |(_, text): (String, String)| serde_json::from_str(&text).ok();
    Ok(rows.into_iter().filter_map(past).collect())
}

/// Adds a run to the history, which forgets the oldest.
pub(super) fn add(rows: &Rows<'_>, past: &Past) -> rows::Result<()> {
    let number = rows.last(Table::History)? + 1;
    rows.put(Table::History, number, &json(past)?)?;
    rows.remove_up_to(Table::History, number - MOST)
}
