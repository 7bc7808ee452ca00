#![allow(clippy::unwrap_used)]

mod settings;

use super::rows::{Rows, Table};
use super::{Journal, JournalError};
use tempfile::{TempDir, tempdir};

fn opened(folder: &TempDir) -> (Journal, Vec<String>) {
    Journal::open(folder.path()).unwrap()
}

#[test]
fn a_journal_of_the_first_version_keeps_what_the_machine_said() {
    let folder = tempdir().unwrap();
    let (journal, _) = opened(&folder);
    journal.registry.set_value("uValue", Some("hello")).unwrap();
    let first = |rows: &Rows<'_>| {
        rows.set(Table::Value, "PositionLost", Some("Z"))?;
        Ok(rows.0.execute_batch("PRAGMA user_version = 1")?)
    };
    journal.store.write(first).unwrap();
    journal.rest().unwrap();
    drop(journal);
    let kept = [("PositionLost".to_owned(), "Z".to_owned()), ("uValue".into(), "hello".into())];
    let looked = Journal::look(folder.path()).unwrap().unwrap();
    assert_eq!(looked.registry.values().unwrap(), kept);
    let (journal, told) = opened(&folder);
    assert_eq!((journal.registry.values().unwrap(), told), (kept.to_vec(), Vec::new()));
    journal.registry.set_value("PositionLost", None).unwrap();
    assert_eq!(journal.registry.value("PositionLost").unwrap().as_deref(), Some("Z"));
    drop(journal);
    assert_eq!(opened(&folder).0.registry.values().unwrap(), kept);
}

#[test]
fn a_later_version_is_left_alone() {
    let folder = tempdir().unwrap();
    opened(&folder).0.store.opened().connection.execute_batch("PRAGMA user_version = 99").unwrap();
    assert!(matches!(Journal::open(folder.path()), Err(JournalError::Newer { .. })));
}
