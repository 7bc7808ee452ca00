#![allow(clippy::unwrap_used)]

use super::*;
use crate::files::{Folders, MemoryDisk};
use crate::settings_text;
use crate::stored::Stored;
use crate::text::{TextOptions, run_text};
use crate::{Company, RunOptions, Session, Shelf, Started};
use std::fs;
use tempfile::{TempDir, tempdir};

fn opened(folder: &TempDir) -> (Journal, Vec<String>) {
    Journal::open(folder.path()).unwrap()
}

fn after(program: &str) -> Session {
    run_text(&[("a.sbp", program)], "a.sbp", TextOptions::default()).session
}

/// The machine as its journal remembers it, with a program in its part folder.
fn recalled(folder: &TempDir, program: &str) -> (Session, Shelf) {
    let (journal, _) = opened(folder);
    let disk = MemoryDisk::new([("a.sbp", program.as_bytes())]);
    let folders = Folders::new("".into(), Vec::new(), Vec::new());
    let stored = Stored::of(journal.clone()).unwrap();
    let mut shelf = Shelf::new(Box::new(disk), folders, stored, folder.path().into());
    let (session, _) = Session::recall(&journal, &mut shelf).unwrap();
    (session, shelf)
}

/// Runs a program on record, begun at a moment as a person reads it.
fn run(folder: &TempDir, program: &str, date: &str) -> Session {
    let (mut session, mut shelf) = recalled(folder, program);
    let started = Some(Started { time: "12:00:00".into(), date: date.into() });
    let options = RunOptions { started, ..RunOptions::default() };
    let company = Company { sink: &mut (), operator: &mut (), pace: &mut () };
    let program = kerf_part::read("a.sbp".into(), program.as_bytes());
    session.run_on_record(program, options, None, &mut shelf, company).unwrap();
    session
}

#[test]
fn sbp_val_va_store() {
    let folder = tempdir().unwrap();
    let session = after("M3,4,5,6\nZT\nM3,8,10,12\nVA,1,2,3\nVC,.375\nSR\n");
    let (journal, _) = opened(&folder);
    assert_eq!(journal.remembered().unwrap(), None);
    journal.remember(&session.memory, &session.gcode).unwrap();
    let back = opened(&folder).0.remembered().unwrap().unwrap();
    assert_eq!(back.whereabouts, Whereabouts::Known);
    assert_eq!(
        (back.memory.position, back.memory.frame),
        (session.memory.position, session.memory.frame)
    );
    let [back, left] = [&back.memory, &session.memory].map(|m| settings_text::write(&m.settings));
    assert_eq!(back, left);
    let file = fs::read_to_string(folder.path().join("machine.toml")).unwrap();
    assert_eq!(file, "distance = \"relative\"\n[cutter]\ndiameter_mm = 9.525\n");
}

#[test]
fn what_g_code_remembers_comes_back() {
    let program = "G10 L2 P2 X1.5 Y.1\nG55\n#500=7.25\n#<_depth>=3\nG10 L1 P3 R.125 Z1\nG28.1";
    let session = run_text(&[("a.nc", program)], "a.nc", TextOptions::default()).session;
    let folder = tempdir().unwrap();
    let (journal, _) = opened(&folder);
    journal.remember(&session.memory, &session.gcode).unwrap();
    assert_eq!(journal.remembered().unwrap().unwrap().gcode, session.gcode);
}

#[test]
fn of_a_preview_what_was_before_it_is_kept() {
    let folder = tempdir().unwrap();
    let (journal, _) = opened(&folder);
    let kept = |program: &str| {
        let session = after(program);
        journal.remember(&session.memory, &session.gcode).unwrap();
        journal.remembered().unwrap().unwrap().memory
    };
    assert_eq!(kept("MX,1\nSP\nMX,5\nVC,2"), kept("MX,1"));
}

#[test]
fn a_nudge_is_kept() {
    let folder = tempdir().unwrap();
    run(&folder, "MX,4\nZX\nMX,1\n", "2026-11-20");
    let (mut session, mut shelf) = recalled(&folder, "");
    session.nudge(kerf_program::Axis::X, 2.5).unwrap();
    session.keep_place(&mut shelf).unwrap();
    let (back, _) = recalled(&folder, "");
    assert_eq!(back.memory.position[kerf_program::Axis::X], 5.0 * 25.4 + 2.5);
    assert_eq!(back.memory.frame, session.memory.frame);
}

#[test]
fn values_are_seen_by_everybody_at_once() {
    let folder = tempdir().unwrap();
    let (mine, theirs) = (opened(&folder).0, opened(&folder).0);
    mine.set_value("uValue", Some("hello")).unwrap();
    assert_eq!(theirs.value("uValue").unwrap().as_deref(), Some("hello"));
    theirs.set_value("uValue", None).unwrap();
    assert_eq!(mine.values().unwrap(), []);
}

#[test]
fn one_process_owns_the_machine() {
    let folder = tempdir().unwrap();
    let (mine, theirs) = (opened(&folder).0, opened(&folder).0);
    let owner = mine.own().unwrap();
    assert!(matches!(theirs.own(), Err(JournalError::Owned { .. })));
    drop(owner);
    assert!(theirs.own().is_ok());
}

#[test]
fn who_only_looks_leaves_nothing() {
    let folder = tempdir().unwrap();
    assert!(Journal::look(folder.path()).unwrap().is_none());
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    opened(&folder).0.set_value("a", Some("1")).unwrap();
    let looked = Journal::look(folder.path()).unwrap().unwrap();
    assert_eq!(looked.value("a").unwrap().as_deref(), Some("1"));
    assert!(looked.set_value("a", Some("2")).is_err());
}

#[test]
fn a_clock_that_jumps_changes_nothing() {
    let folder = tempdir().unwrap();
    for date in ["2026-11-21", "1970-01-01", "2038-01-19"] {
        run(&folder, "SR\nMX,1\n", date);
    }
    let (journal, told) = opened(&folder);
    assert_eq!(told, [""; 0]);
    let dates: Vec<_> =
        journal.history().unwrap().into_iter().map(|p| p.started.unwrap().date).collect();
    assert_eq!(dates, ["2026-11-21", "1970-01-01", "2038-01-19"], "in the order of the runs");
    assert_eq!(journal.remembered().unwrap().unwrap().memory.position.0[0], 3.0 * 25.4);
}

#[test]
fn a_later_version_is_left_alone() {
    let folder = tempdir().unwrap();
    opened(&folder).0.connection().execute_batch("PRAGMA user_version = 99").unwrap();
    assert!(matches!(Journal::open(folder.path()), Err(JournalError::Newer { .. })));
}

/// Runs that leave a location, a value and a copy; then something happens to the file.
fn damaged(damage: impl Fn(&mut Vec<u8>)) -> (TempDir, Journal, Vec<String>) {
    let folder = tempdir().unwrap();
    run(&folder, "MX,2\nVC,.375\nSetUsrVal, hello\n", "2026-11-21");
    let file = folder.path().join(JOURNAL_FILE);
    let mut bytes = fs::read(&file).unwrap();
    damage(&mut bytes);
    fs::write(&file, bytes).unwrap();
    let (journal, told) = opened(&folder);
    (folder, journal, told)
}

/// What happens to the bytes of a file.
type Damage = Box<dyn Fn(&mut Vec<u8>)>;

/// Where some bytes are.
fn find(bytes: &[u8], part: &[u8]) -> usize {
    bytes.windows(part.len()).position(|w| w == part).unwrap()
}

#[test]
fn a_damaged_journal_is_rescued() {
    let page = |n: usize| move |bytes: &mut Vec<u8>| bytes[n * 4096..][..4096].fill(0x5a);
    let digit = |bytes: &mut Vec<u8>| {
        let at = find(bytes, b"hello");
        bytes[at] = b'j';
    };
    let cases: [(&str, Damage); 6] = [
        ("the head of the file", Box::new(page(0))),
        ("a page", Box::new(page(1))),
        ("another page", Box::new(page(2))),
        ("one digit", Box::new(digit)),
        ("no database at all", Box::new(|bytes| *bytes = b"hello".to_vec())),
        ("half of it", Box::new(|bytes| bytes.truncate(bytes.len() / 2))),
    ];
    for (what, damage) in cases {
        let (folder, journal, told) = damaged(damage);
        assert!(
            told[0].starts_with("the journal was damaged") && told.len() > 2,
            "{what}: {told:?}"
        );
        let memory = journal.remembered().unwrap().unwrap().memory;
        assert_eq!(memory.position.0[0], 50.8, "{what}");
        assert!((memory.settings.cutter.diameter_mm - 9.525).abs() < 1e-9, "{what}");
        assert_eq!(journal.value("uValue").unwrap().as_deref(), Some("hello"), "{what}");
        assert_eq!(journal.value("PositionLost").unwrap().as_deref(), Some("XYZABC"), "{what}");
        assert!(folder.path().join("journal.damaged-1.db").is_file(), "{what}");
        assert_eq!(opened(&folder).1, [""; 0], "{what}: sound again");
    }
}
