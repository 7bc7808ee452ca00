#![allow(clippy::unwrap_used)]

use super::*;
use crate::stored::Stored;
use kerf_files::{Folders, MemoryDisk};
use kerf_journal::JOURNAL_FILE;
use std::sync::mpsc::channel;
use std::time::Duration;
use tempfile::{TempDir, tempdir};

/// A shelf whose run is on record and is written down by a thread.
fn writing_behind(folder: &TempDir) -> (Journal, Shelf) {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let folders = Folders::new("".into(), Vec::new(), Vec::new());
    let stored = Stored::of(journal.clone()).unwrap();
    let disk = Box::new(MemoryDisk::default());
    let mut shelf = Shelf::new(disk, folders, stored, folder.path().into());
    let (session, work, options) = (Session::default(), Work::default(), RunOptions::default());
    let kept = KeptWork::of(&work).unwrap();
    let (standing, around) = (session.standing(), shelf.surroundings());
    let run = RunUnderWay::new(&standing, &kept, &options, None, around);
    shelf.tape = journal.begin(&run, &standing, &kept.bytes).unwrap();
    shelf.tape.writes_behind(None);
    (journal, shelf)
}

/// While somebody has the file and does not let go of it, a program gives a value and reads it, and another that
/// somebody else gave.
#[test]
fn a_value_of_a_program_does_not_wait_for_the_disk() {
    let folder = tempdir().unwrap();
    let (journal, mut shelf) = writing_behind(&folder);
    journal.set_value("theirs", Some("1")).unwrap();
    let ((holds, held), (done, is_done)) = (channel(), channel());
    std::thread::scope(|scope| {
        let file = folder.path().join(JOURNAL_FILE);
        let holder = scope.spawn(move || {
            let other = rusqlite::Connection::open(file).unwrap();
            other.execute_batch("BEGIN IMMEDIATE").unwrap();
            holds.send(()).unwrap();
            is_done.recv_timeout(Duration::from_secs(2))
        });
        held.recv().unwrap();
        for number in ["2", "3"] {
            shelf.set_value("ours", Some(number));
            assert_eq!(shelf.value("ours").as_deref(), Some(number));
        }
        assert_eq!(shelf.value("theirs").as_deref(), Some("1"));
        done.send(()).unwrap();
        assert_eq!(holder.join().unwrap(), Ok(()), "it waited for the disk");
    });
    shelf.tape.ends();
    let (again, _) = Journal::open(folder.path()).unwrap();
    assert_eq!(again.value("ours").unwrap().as_deref(), Some("3"));
    journal.set_value("ours", Some("4")).unwrap();
    assert_eq!(shelf.value("ours").as_deref(), Some("4"));
}
