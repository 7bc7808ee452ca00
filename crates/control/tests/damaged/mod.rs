//! Bytes as damage to the files of a journal. The test of this crate and the fuzz target share it.

use kerf_journal::{BACKUP_FILE, JOURNAL_FILE, Journal, SEAL_FILE};
use std::fs;
use std::path::Path;
use std::sync::OnceLock;

const FILES: [&str; 4] = [JOURNAL_FILE, "journal.db-wal", SEAL_FILE, BACKUP_FILE];

/// Values that a sound journal holds.
const VALUES: usize = 24;

/// The files of a journal that was killed: half of its values are in the write-ahead file only.
fn template() -> &'static [Vec<u8>; 4] {
    static MADE: OnceLock<[Vec<u8>; 4]> = OnceLock::new();
    MADE.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a folder");
        let (journal, _) = Journal::open(folder.path()).expect("a journal");
        let keep = |n: usize| journal.registry.set_value(&format!("key{n}"), Some("kept"));
        (0..VALUES / 2).try_for_each(keep).expect("values");
        journal.back_up().and_then(|()| journal.rest()).expect("a copy");
        (VALUES / 2..VALUES).try_for_each(keep).expect("values");
        FILES.map(|name| fs::read(folder.path().join(name)).unwrap_or_default())
    })
}

/// Damages files as bytes say, four at a time: which file and how, where (two), with what.
fn damaged(bytes: &[u8]) -> [Option<Vec<u8>>; 4] {
    let mut files = template().clone().map(Some);
    for change in bytes.chunks_exact(4).take(16) {
        let Some(file) = files.get_mut(usize::from(change[0]) % 4) else { continue };
        let Some(text) = file else { continue };
        let at = usize::from(change[1]) << 8 | usize::from(change[2]);
        let at = if text.is_empty() { 0 } else { at * 7 % text.len() };
        match change[0] / 4 % 8 {
            0 => *file = None,
            1 => text.truncate(at),
            2 => text.extend(bytes),
            3 => text.splice(at.., bytes.iter().copied()).for_each(drop),
            4 => text[at..].iter_mut().take(512).for_each(|byte| *byte = change[3]),
            _ => text.iter_mut().skip(at).take(1).for_each(|byte| *byte ^= change[3]),
        }
    }
    files
}

/// Opens the journal after such damage: it never panics, and nothing is lost without a word.
pub fn check(bytes: &[u8]) {
    let folder = tempfile::tempdir().expect("a folder");
    let files = damaged(bytes);
    for (name, file) in FILES.into_iter().zip(&files) {
        if let Some(file) = file {
            fs::write(folder.path().join(name), file).expect("a file");
        }
    }
    if let Err(why) = opens(folder.path()) {
        assert!(why.contains("journal"), "no file is named: {why}");
    } else {
        // Whatever was rescued is whole.
        let again = Journal::open(folder.path()).expect("it opened before");
        assert_eq!(again.1, [""; 0], "told twice");
    }
}

/// Tells whether a file is there with something in it.
fn holds(file: &Path) -> bool {
    fs::metadata(file).is_ok_and(|file| file.len() > 0)
}

fn opens(folder: &Path) -> Result<(), String> {
    drop(
        Journal::look(folder)
            .and_then(|journal| journal.map_or(Ok(()), |it| it.registry.values().map(drop))),
    );
    // A folder in which nothing of a journal is left is that of a new machine.
    let is_new = FILES.iter().all(|name| !holds(&folder.join(name)));
    let (journal, told) = Journal::open(folder).map_err(|error| error.to_string())?;
    let values = journal.registry.values().map_err(|error| error.to_string())?;
    let kept = values.iter().filter(|(_, value)| value == "kept").count();
    assert!(kept == VALUES || !told.is_empty() || is_new, "lost without a word: {kept}");
    journal.memory.read(kerf_control::settings_text::read).map_err(|error| error.to_string())?;
    journal.runs.cut_short().map_err(|error| error.to_string())?;
    journal.runs.history().map_err(|error| error.to_string())?;
    drop(journal.own().map_err(|error| error.to_string())?);
    Ok(())
}
