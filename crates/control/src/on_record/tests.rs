#![allow(clippy::unwrap_used)]

use super::*;
use kerf_files::{Folders, MemoryDisk};
use kerf_journal::JOURNAL_FILE;
use kerf_workspace::stored::Stored;
use std::sync::mpsc::channel;
use std::time::Duration;
use tempfile::{TempDir, tempdir};

/// A workspace whose run is on record and is written down by a thread.
fn writing_behind(folder: &TempDir) -> (Journal, Workspace) {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let folders = Folders::new("".into(), Vec::new(), Vec::new());
    let stored = Stored::of(journal.clone()).unwrap();
    let disk = Box::new(MemoryDisk::default());
    let mut workspace = Workspace::new(disk, folders, stored, folder.path().into());
    let (session, work, options) = (Session::default(), Work::default(), RunOptions::default());
    let kept = KeptWork::of(&work).unwrap();
    let (standing, around) = (session.resting(), workspace.surroundings());
    let run = RunUnderWay::new(&standing, &kept, &options, None, around);
    workspace.tape = journal.runs.begin(&run, &standing, &kept.bytes).unwrap();
    workspace.tape.writes_behind(None);
    (journal, workspace)
}

/// While somebody has the file and does not let go of it, a program gives a value and reads it, and another that
/// somebody else gave.
#[test]
fn a_value_of_a_program_does_not_wait_for_the_disk() {
    let folder = tempdir().unwrap();
    let (journal, mut workspace) = writing_behind(&folder);
    journal.registry.set_value("theirs", Some("1")).unwrap();
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
            workspace.set_value("ours", Some(number));
            assert_eq!(workspace.value("ours").as_deref(), Some(number));
        }
        assert_eq!(workspace.value("theirs").as_deref(), Some("1"));
        done.send(()).unwrap();
        assert_eq!(holder.join().unwrap(), Ok(()), "it waited for the disk");
    });
    workspace.tape.ends();
    let (again, _) = Journal::open(folder.path()).unwrap();
    assert_eq!(again.registry.value("ours").unwrap().as_deref(), Some("3"));
    journal.registry.set_value("ours", Some("4")).unwrap();
    assert_eq!(workspace.value("ours").as_deref(), Some("4"));
}
