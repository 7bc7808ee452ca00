//! Rows of the journal: key, text, check number. All tables have this shape.

pub(super) use super::database::Trouble;
use rusqlite::types::{Value, ValueRef};
use rusqlite::{Connection, OptionalExtension, ToSql, TransactionBehavior};
use sha2::{Digest, Sha256};

pub(super) type Result<T> = std::result::Result<T, Trouble>;

/// The tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Table {
    /// Facts that are known of the machine, by name.
    Fact,
    /// Values that programs keep.
    Value,
    /// Steps that the world told the run under way, by number.
    Step,
    /// Files by the hash of their bytes.
    Content,
    /// Runs that are over, by number.
    History,
}

impl Table {
    pub(super) const ALL: [Self; 5] =
        [Self::Fact, Self::Value, Self::Step, Self::Content, Self::History];

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Fact => "fact",
            Self::Value => "value",
            Self::Step => "step",
            Self::Content => "content",
            Self::History => "history",
        }
    }
}

/// The rows of a database.
pub(super) struct Rows<'a>(pub &'a Connection);

/// A row as it is in the file.
pub(super) type Row = (Value, Vec<u8>);

impl Rows<'_> {
    /// The bytes under a key.
    pub(super) fn bytes(&self, table: Table, key: impl ToSql) -> Result<Option<Vec<u8>>> {
        let sql = format!("SELECT key, text, sum FROM {} WHERE key = ?1", table.name());
        let mut statement = self.0.prepare_cached(&sql)?;
        let row = statement.query_row([key], |row| Ok(checked(table, row))).optional()?;
        Ok(row.transpose()?.map(|(_, bytes)| bytes))
    }

    /// The text under a key.
    pub(super) fn text(&self, table: Table, key: impl ToSql) -> Result<Option<String>> {
        self.bytes(table, key)?.map(|bytes| text(table, bytes)).transpose()
    }

    /// Puts bytes under a key; text stays readable to whoever opens the file.
    pub(super) fn put(&self, table: Table, key: impl ToSql, bytes: &[u8]) -> Result<()> {
        let key = owned(&key)?;
        let sql = format!("INSERT OR REPLACE INTO {} VALUES (?1, ?2, ?3)", table.name());
        let sum = check_number(&key, bytes);
        let mut statement = self.0.prepare_cached(&sql)?;
        match std::str::from_utf8(bytes) {
            Ok(text) => statement.execute((key, text, sum))?,
            Err(_) => statement.execute((key, bytes, sum))?,
        };
        Ok(())
    }

    /// Puts a text under a key, or removes the key.
    pub(super) fn set(&self, table: Table, key: &str, text: Option<&str>) -> Result<()> {
        match text {
            Some(text) => self.put(table, key, text.as_bytes()),
            None => {
                let sql = format!("DELETE FROM {} WHERE key = ?1", table.name());
                self.0.prepare_cached(&sql)?.execute([key])?;
                Ok(())
            }
        }
    }

    /// Tells whether there is such a key.
    pub(super) fn has(&self, table: Table, key: &str) -> Result<bool> {
        let sql = format!("SELECT 1 FROM {} WHERE key = ?1", table.name());
        Ok(self.0.prepare_cached(&sql)?.exists([key])?)
    }

    /// Removes the rows of a table whose keys are numbers up to one.
    pub(super) fn remove_up_to(&self, table: Table, last: i64) -> Result<()> {
        self.0.execute(&format!("DELETE FROM {} WHERE key <= ?1", table.name()), [last])?;
        Ok(())
    }

    /// Removes the rows of a table whose keys are numbers from one on.
    pub(super) fn remove_from(&self, table: Table, first: i64) -> Result<()> {
        self.0.execute(&format!("DELETE FROM {} WHERE key >= ?1", table.name()), [first])?;
        Ok(())
    }

    /// Empties a table.
    pub(super) fn clear(&self, table: Table) -> Result<()> {
        self.0.execute(&format!("DELETE FROM {}", table.name()), [])?;
        Ok(())
    }

    /// Keys and texts in order of keys.
    pub(super) fn all(&self, table: Table) -> Result<Vec<(String, String)>> {
        let named = |(key, bytes)| Ok((key_text(key), text(table, bytes)?));
        self.each(table, Ok)?.into_iter().map(|row| row.and_then(named)).collect()
    }

    /// Every row that can be read, in order of keys, each with what is wrong with it.
    pub(super) fn each<T>(
        &self,
        table: Table,
        make: impl Fn(Row) -> Result<T>,
    ) -> Result<Vec<Result<T>>> {
        let sql = format!("SELECT key, text, sum FROM {} ORDER BY key", table.name());
        let mut statement = self.0.prepare(&sql)?;
        let mut rows = statement.query([])?;
        let mut found = Vec::new();
        while let Some(row) = rows.next()? {
            found.push(checked(table, row).and_then(&make));
        }
        Ok(found)
    }

    /// Rows that can be read and are sound, up to where the file cannot be read any more.
    pub(super) fn each_while_readable(&self, table: Table) -> Vec<Row> {
        let sql = format!("SELECT key, text, sum FROM {}", table.name());
        let Ok(mut statement) = self.0.prepare(&sql) else { return Vec::new() };
        let Ok(mut rows) = statement.query([]) else { return Vec::new() };
        let mut found = Vec::new();
        while let Ok(Some(row)) = rows.next() {
            found.extend(checked(table, row));
        }
        found
    }

    /// The greatest key of a table whose keys are numbers; 0 when it is empty.
    pub(super) fn last(&self, table: Table) -> Result<i64> {
        let sql = format!("SELECT coalesce(max(key), 0) FROM {}", table.name());
        Ok(self.0.query_row(&sql, [], |row| row.get(0))?)
    }
}

/// Makes changes together or not at all.
pub(super) fn together<T>(
    connection: &mut Connection,
    change: impl FnOnce(&Rows<'_>) -> Result<T>,
) -> Result<T> {
    let transaction = connection.transaction_with_behavior(TransactionBehavior::Immediate)?;
    let made = change(&Rows(&transaction))?;
    transaction.commit()?;
    Ok(made)
}

/// Looks at rows as they are at one moment, whoever changes them meanwhile.
pub(super) fn at_once<T>(
    connection: &Connection,
    look: impl FnOnce(&Rows<'_>) -> Result<T>,
) -> Result<T> {
    let transaction = connection.unchecked_transaction()?;
    look(&Rows(&transaction))
}

/// The digest of every row that the machine depends on; each has to fit its check number.
pub(super) fn digest(connection: &Connection) -> Result<u64> {
    let mut digest = Sha256::new();
    for table in [Table::Fact, Table::Value, Table::History] {
        for row in Rows(connection).each(table, Ok)? {
            let (key, bytes) = row?;
            let sum = check_number(&key, &bytes);
            digest.update(format!("{} {} {sum}\n", table.name(), key_text(key)));
        }
    }
    Ok(digest.finalize().iter().take(8).fold(0, |sum, byte| sum << 8 | u64::from(*byte)))
}

fn checked(table: Table, row: &rusqlite::Row<'_>) -> Result<Row> {
    let key: Value = row.get(0)?;
    let bytes = match row.get_ref(1)? {
        ValueRef::Text(bytes) | ValueRef::Blob(bytes) => bytes.to_vec(),
        _ => Vec::new(),
    };
    let sum: i64 = row.get(2)?;
    if sum == check_number(&key, &bytes) {
        return Ok((key, bytes));
    }
    let what = format!("{} {} does not fit its check number", table.name(), key_text(key));
    Err(Trouble::Damaged(what))
}

fn check_number(key: &Value, bytes: &[u8]) -> i64 {
    let mut sum = crc32fast::Hasher::new();
    sum.update(key_text(key.clone()).as_bytes());
    sum.update(&[0]);
    sum.update(bytes);
    i64::from(sum.finalize())
}

fn owned(key: &impl ToSql) -> Result<Value> {
    match key.to_sql()? {
        rusqlite::types::ToSqlOutput::Borrowed(key) => {
            Value::try_from(key).map_err(|e| Trouble::Damaged(e.to_string()))
        }
        rusqlite::types::ToSqlOutput::Owned(key) => Ok(key),
        _ => Err(Trouble::Damaged("a key of no kind".into())),
    }
}

pub(super) fn key_text(key: Value) -> String {
    match key {
        Value::Integer(number) => number.to_string(),
        Value::Text(text) => text,
        _ => String::new(),
    }
}

fn text(table: Table, bytes: Vec<u8>) -> Result<String> {
    let wrong = |_| Trouble::Damaged(format!("{} holds what is no text", table.name()));
    String::from_utf8(bytes).map_err(wrong)
}

/// A value as it is kept.
pub(super) fn json(value: &impl serde::Serialize) -> Result<Vec<u8>> {
    serde_json::to_vec(value).map_err(|error| Trouble::Damaged(error.to_string()))
}
