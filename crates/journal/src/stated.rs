//! Words of the machine about itself, in the journal: they are among the facts, where nothing gets that programs and
//! other software write. Journals of the first version have them among the values.

use super::JournalError;
use super::database;
use super::rows::{Result, Rows, Table};
use super::store::Store;
use crate::facts::Fact;

/// Takes what the machine says of itself out of the values, where a journal of the first version has it.
pub(super) fn part_facts(store: &Store) -> std::result::Result<(), JournalError> {
    let first = |rows: &Rows<'_>| Ok(table(rows)? == Table::Value);
    if store.read(first)? { store.write(part) } else { Ok(()) }
}

/// The table in which a journal has what the machine says of itself.
fn table(rows: &Rows<'_>) -> Result<Table> {
    Ok(if database::has_facts_apart(rows.0)? { Table::Fact } else { Table::Value })
}

/// The value of a key, whoever keeps it.
pub(super) fn value(rows: &Rows<'_>, key: &str) -> Result<Option<String>> {
    let table = if Fact::of(key).is_some() { table(rows)? } else { Table::Value };
    rows.text(table, key)
}

/// Keys and values in order, what the machine says of itself among them.
pub(super) fn values(rows: &Rows<'_>) -> Result<Vec<(String, String)>> {
    let mut all = rows.all(Table::Value)?;
    all.retain(|(key, _)| Fact::of(key).is_none());
    for key in Fact::ALL.map(Fact::key) {
        all.extend(value(rows, key)?.map(|text| (key.to_owned(), text)));
    }
    all.sort();
    Ok(all)
}

/// Takes what the machine says of itself out of the values.
pub(super) fn part(rows: &Rows<'_>) -> Result<()> {
    for key in Fact::ALL.map(Fact::key) {
        // What was saved of two journals may have both.
        let first = rows.text(Table::Value, key)?;
        if first.is_some() && !rows.has(Table::Fact, key)? {
            rows.set(Table::Fact, key, first.as_deref())?;
        }
        rows.set(Table::Value, key, None)?;
    }
    database::facts_are_apart(rows.0)
}
