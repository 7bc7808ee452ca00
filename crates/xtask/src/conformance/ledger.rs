//! The ledgers, where they lie beside the checkout.

#[path = "../../../../tests/corpus/shared.rs"]
mod shared;

use anyhow::{Context, Result};

/// The suites of rows, in the order of the score, with how many rows each has.
pub const SUITES: &[(&str, usize)] = &[("opensbp", 776), ("profiler", 770)];

/// A row of a ledger.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Suite it belongs to.
    pub suite: String,
    /// Area within the suite.
    pub area: String,
    /// Its id.
    pub id: String,
    /// The words that say when it is done.
    pub acceptance: String,
}

/// All rows of the ledgers, in order, or nothing when there are none beside the checkout.
///
/// # Errors
/// When a ledger is there but cannot be read.
pub fn beside() -> Result<Option<Vec<Row>>> {
    let Some(folder) = shared::shared("ledger") else { return Ok(None) };
    let mut rows = Vec::new();
    for (suite, _) in SUITES {
        let path = folder.join(format!("{suite}.tsv"));
        let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
        rows.extend(read(suite, &text));
    }
    Ok(Some(rows))
}

fn read(suite: &str, text: &str) -> Vec<Row> {
    let rows = text.lines().skip(1).filter_map(|line| {
        let mut cells = line.split('\t');
        let (id, area) = (cells.next()?, cells.next()?);
        let acceptance = cells.nth(1).unwrap_or_default().to_owned();
        Some(Row { suite: suite.to_owned(), area: area.to_owned(), id: id.to_owned(), acceptance })
    });
    rows.collect()
}
