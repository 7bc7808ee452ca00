//! The journal of a machine, beside runs that are kept in it.

use kerf_control::{RunContext, Session, TextOptions, run_text, settings_text};
use kerf_files::{Folders, MemoryDisk};
use kerf_journal::{facts::Fact, *};
use kerf_workspace::{Workspace, stored::Stored};
use std::fs;
use tempfile::{TempDir, tempdir};

fn opened(folder: &TempDir) -> (Journal, Vec<String>) {
    Journal::open(folder.path()).unwrap()
}

fn after(program: &str) -> Session {
    run_text(&[("a.sbp", program)], "a.sbp", TextOptions::default()).session
}

/// The machine as its journal remembers it, with a program in its part folder.
fn recalled(folder: &TempDir, program: &str) -> (Session, Workspace) {
    let (journal, _) = opened(folder);
    let disk = MemoryDisk::new([("a.sbp", program.as_bytes())]);
    let folders = Folders::new("".into(), Vec::new(), Vec::new());
    let stored = Stored::of(journal.clone()).unwrap();
    let mut workspace = Workspace::new(Box::new(disk), folders, stored, folder.path().into());
    let (session, _) = Session::recall(&journal, &mut workspace).unwrap();
    (session, workspace)
}

/// Runs a program on record, begun at a moment as a person reads it.
fn run(folder: &TempDir, program: &str, date: &str) -> Session {
    let (mut session, mut workspace) = recalled(folder, program);
    let started = Some(Started { time: "12:00:00".into(), date: date.into() });
    let options = RunOptions { started, ..RunOptions::default() };
    let context = RunContext {
        sink: &mut (),
        operator: &mut (),
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    let program = kerf_part::read("a.sbp".into(), program.as_bytes());
    session.run_on_record(program, options, None, &mut workspace, context).unwrap();
    session
}

#[test]
fn sbp_val_va_store() {
    let folder = tempdir().unwrap();
    let session = after("M3,4,5,6\nZT\nM3,8,10,12\nVA,1,2,3\nVC,.375\nSR\n");
    let (journal, _) = opened(&folder);
    assert_eq!(journal.memory.read(settings_text::read).unwrap(), None);
    journal.memory.keep(&session.memory, &session.gcode).unwrap();
    let back = opened(&folder).0.memory.read(settings_text::read).unwrap().unwrap();
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
    journal.memory.keep(&session.memory, &session.gcode).unwrap();
    assert_eq!(journal.memory.read(settings_text::read).unwrap().unwrap().gcode, session.gcode);
}

#[test]
fn of_a_preview_the_place_before_it_is_kept_and_what_was_set() {
    let folder = tempdir().unwrap();
    let (journal, _) = opened(&folder);
    let kept = |program: &str| {
        let session = after(program);
        journal.memory.keep(&session.memory, &session.gcode).unwrap();
        journal.memory.read(settings_text::read).unwrap().unwrap().memory
    };
    assert_eq!(kept("MX,1\nSP\nMX,5\nZX\nVC,2"), kept("MX,1\nVC,2"));
}

#[test]
fn a_nudge_is_kept() {
    let folder = tempdir().unwrap();
    run(&folder, "MX,4\nZX\nMX,1\n", "2026-11-20");
    let (mut session, mut workspace) = recalled(&folder, "");
    crate::place_and_nudge::nudge(&mut session, kerf_program::Axis::X, 2.5);
    session.keep_place(&mut workspace).unwrap();
    let (back, _) = recalled(&folder, "");
    assert_eq!(back.memory.position[kerf_program::Axis::X], 5.0 * 25.4 + 2.5);
    assert_eq!(back.memory.frame, session.memory.frame);
}

#[test]
fn values_are_seen_by_everybody_at_once() {
    let folder = tempdir().unwrap();
    let (mine, theirs) = (opened(&folder).0, opened(&folder).0);
    mine.registry.set_value("uValue", Some("hello")).unwrap();
    assert_eq!(theirs.registry.value("uValue").unwrap().as_deref(), Some("hello"));
    theirs.registry.set_value("uValue", None).unwrap();
    assert_eq!(mine.registry.values().unwrap(), []);
}

#[test]
fn what_the_machine_says_of_itself_is_no_value_that_others_write() {
    let folder = tempdir().unwrap();
    let (journal, _) = opened(&folder);
    journal.registry.state(Fact::PositionLost, Some("XY")).unwrap();
    for fact in Fact::ALL {
        journal.registry.set_value(fact.key(), Some("1")).unwrap();
        let told = (fact == Fact::PositionLost).then_some("XY");
        assert_eq!(journal.registry.value(fact.key()).unwrap().as_deref(), told, "{fact:?}");
    }
    assert_eq!(journal.registry.values().unwrap(), [("PositionLost".into(), "XY".into())]);
    journal.registry.set_value("PositionLost", None).unwrap();
    assert_eq!(journal.registry.value("PositionLost").unwrap().as_deref(), Some("XY"));
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
    opened(&folder).0.registry.set_value("a", Some("1")).unwrap();
    let looked = Journal::look(folder.path()).unwrap().unwrap();
    assert_eq!(looked.registry.value("a").unwrap().as_deref(), Some("1"));
    assert!(looked.registry.set_value("a", Some("2")).is_err());
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
        journal.runs.history().unwrap().into_iter().map(|p| p.started.unwrap().date).collect();
    assert_eq!(dates, ["2026-11-21", "1970-01-01", "2038-01-19"], "in the order of the runs");
    assert_eq!(
        journal.memory.read(settings_text::read).unwrap().unwrap().memory.position.0[0],
        3.0 * 25.4
    );
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

/// Change to the bytes of a file.
type Damage = Box<dyn Fn(&mut Vec<u8>)>;

/// Finds the place of some bytes.
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
        let memory = journal.memory.read(settings_text::read).unwrap().unwrap().memory;
        assert_eq!(memory.position.0[0], 50.8, "{what}");
        assert!((memory.settings.cutter.diameter_mm - 9.525).abs() < 1e-9, "{what}");
        assert_eq!(journal.registry.value("uValue").unwrap().as_deref(), Some("hello"), "{what}");
        assert_eq!(
            journal.registry.value("PositionLost").unwrap().as_deref(),
            Some("XYZABC"),
            "{what}"
        );
        assert!(folder.path().join("journal.damaged-1.db").is_file(), "{what}");
        assert_eq!(opened(&folder).1, [""; 0], "{what}: sound again");
    }
}

/// The files of a data folder that hold the journal.
const FILES: [&str; 4] = [JOURNAL_FILE, "journal.db-wal", SEAL_FILE, BACKUP_FILE];

/// Reads the files of a journal, in the middle of whatever somebody does with it.
fn files_of(folder: &TempDir) -> Vec<(&'static str, Option<Vec<u8>>)> {
    FILES.map(|name| (name, fs::read(folder.path().join(name)).ok())).into()
}

/// A folder that holds these files, as after a kill or a restored copy.
fn folder_of(files: &[(&'static str, Option<Vec<u8>>)]) -> TempDir {
    let folder = tempdir().unwrap();
    for (name, bytes) in files {
        if let Some(bytes) = bytes {
            fs::write(folder.path().join(name), bytes).unwrap();
        }
    }
    folder
}

/// A machine that was killed with its newest changes in the write-ahead file: at X 50.8, with sixty values; the copy and the
/// file itself know X 25.4 and thirty of them.
fn killed() -> Vec<(&'static str, Option<Vec<u8>>)> {
    let folder = tempdir().unwrap();
    let values = |numbers: std::ops::Range<u32>| {
        let (journal, _) = opened(&folder);
        numbers.for_each(|n| journal.registry.set_value(&format!("key{n}"), Some("kept")).unwrap());
        journal
    };
    values(0..30);
    run(&folder, "MX,1\n", "2026-11-21");
    let journal = values(30..60);
    let session = after("MX,2\n");
    journal.memory.keep(&session.memory, &session.gcode).unwrap();
    // The files are read while the journal is open: as a kill leaves them.
    files_of(&folder)
}

/// Does something to one file of a journal that was killed, opens it, and gives what is told, X, the values that are
/// left, and whether locations are verified.
fn opened_after(
    files: &[(&'static str, Option<Vec<u8>>)],
    name: &str,
    damage: impl FnOnce(&mut Option<Vec<u8>>),
) -> (Vec<String>, f64, usize, bool) {
    let mut files = files.to_vec();
    damage(&mut files.iter_mut().find(|(it, _)| *it == name).unwrap().1);
    let folder = folder_of(&files);
    let (journal, told) = opened(&folder);
    let values =
        journal.registry.values().unwrap().into_iter().filter(|(_, value)| value == "kept").count();
    let position =
        journal.memory.read(settings_text::read).unwrap().map(|it| it.memory.position.0[0]);
    let verified = journal.registry.value(kerf_sbp::POSITION_LOST).unwrap().is_none();
    drop(journal);
    assert_eq!(opened(&folder).1, [""; 0], "{name}: whole again");
    (told, position.unwrap_or_default(), values, verified)
}

/// Change to the bytes of a file, or to a file that is not there.
type Loss = Box<dyn Fn(&mut Option<Vec<u8>>)>;

#[test]
fn a_write_ahead_file_that_is_lost_is_told() {
    let files = killed();
    let wal = "journal.db-wal";
    assert_eq!(opened_after(&files, wal, |_| ()), (Vec::new(), 50.8, 60, true));
    let length = files[1].1.as_ref().unwrap().len();
    let flipped = |at: usize| move |it: &mut Option<Vec<u8>>| it.as_mut().unwrap()[at] ^= 4;
    let cut = |to: usize| move |it: &mut Option<Vec<u8>>| it.as_mut().unwrap().truncate(to);
    let cases: [(&str, Loss); 7] = [
        ("gone", Box::new(|it| *it = None)),
        ("emptied", Box::new(cut(0))),
        ("halved", Box::new(cut(length / 2))),
        ("its last bytes", Box::new(cut(length - 100))),
        ("a bit of its head", Box::new(flipped(20))),
        ("a bit in the middle", Box::new(flipped(length / 2))),
        ("a bit at the end", Box::new(flipped(length - 400))),
    ];
    for (what, damage) in cases {
        let (told, x, values, verified) = opened_after(&files, wal, damage);
        assert!(told[0].contains("journal.db: it lacks its last"), "{what}: {told:?}");
        assert!(told.last().unwrap().starts_with("locations are not verified"), "{what}: {told:?}");
        assert!(x >= 25.4 && values >= 30 && !verified, "{what}: X {x}, {values} values");
    }
}

#[test]
fn a_write_ahead_file_that_is_left_alone_is_told_and_kept() {
    let mut files = killed();
    files.iter_mut().filter(|(name, _)| *name != "journal.db-wal").for_each(|it| it.1 = None);
    let folder = folder_of(&files);
    let (_journal, told) = opened(&folder);
    assert!(told[0].contains("journal.db: it is gone"), "{told:?}");
    assert!(told[0].contains("journal.damaged-1.db-wal"), "{told:?}");
    let kept = fs::read(folder.path().join("journal.damaged-1.db-wal")).unwrap();
    assert_eq!(Some(kept), files[1].1);
}

#[test]
fn an_older_journal_in_the_place_of_a_newer_one_is_told() {
    let folder = tempdir().unwrap();
    run(&folder, "MX,1\n", "2026-11-21");
    let older = files_of(&folder);
    run(&folder, "MX,2\nSetUsrVal, hello\n", "2026-11-22");
    let newer = files_of(&folder);
    let put = |name: &str| {
        let old = older.iter().find(|(it, _)| *it == name).unwrap().1.clone();
        opened_after(&newer, name, |it| *it = old)
    };
    let (told, x, _, verified) = put(JOURNAL_FILE);
    assert!(told[0].contains("an older journal was put in its place"), "{told:?}");
    assert!(!verified && x == 50.8, "from the copy: {x}, {told:?}");
    // Seals and copies that are older promise less; the journal itself is the newest.
    assert_eq!(put(SEAL_FILE), (Vec::new(), 50.8, 0, true));
    let (told, x, _, verified) = put(BACKUP_FILE);
    assert!(told[0].contains("is not as Kerf left it: a new one was made"), "{told:?}");
    assert!(verified && x == 50.8 && told.len() == 1, "{told:?}");
    let (told, x, _, verified) = opened_after(&newer, SEAL_FILE, |it| *it = None);
    assert!(told[0].contains("journal.seal is gone"), "{told:?}");
    assert!(!verified && x == 50.8, "{told:?}");
}

#[test]
fn at_rest_everything_is_in_the_file_itself() {
    let folder = tempdir().unwrap();
    let (journal, _) = opened(&folder);
    run(&folder, "MX,1\nSetUsrVal, hello\n", "2026-11-21");
    let wal = folder.path().join("journal.db-wal");
    assert_eq!(fs::metadata(&wal).map_or(0, |it| it.len()), 0, "a run is over");
    journal.registry.set_value("uValue", Some("hi")).unwrap();
    assert!(fs::metadata(&wal).unwrap().len() > 0);
    journal.rest().unwrap();
    assert_eq!(fs::metadata(&wal).map_or(0, |it| it.len()), 0);
}

#[cfg(unix)]
#[test]
fn nobody_else_reads_the_journal() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempdir().unwrap();
    let (journal, _) = opened(&folder);
    let all = |mode: u32| {
        for entry in fs::read_dir(folder.path()).unwrap().map(std::result::Result::unwrap) {
            fs::set_permissions(entry.path(), fs::Permissions::from_mode(mode)).unwrap();
        }
    };
    all(0o644);
    drop(journal);
    run(&folder, "MX,1\nVC,.375\n", "2026-11-21");
    for name in [JOURNAL_FILE, BACKUP_FILE, SEAL_FILE, "machine.toml"] {
        let mode = fs::metadata(folder.path().join(name)).unwrap().permissions().mode();
        assert_eq!(mode & 0o077, 0, "{name}: {mode:o}");
    }
}
