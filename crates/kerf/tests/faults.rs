//! The data folder fails: full, not to be written, damaged. Each time there is a clear message, nothing
//! moves that is not on record, and what was kept is still there.

#![cfg(unix)]

use crate::shop::{Did, Shop};
use kerf_journal::Journal;
use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
use std::os::unix::process::CommandExt;
use std::process::Command;
use std::time::{Duration, SystemTime};

/// A machine that stands at X 5.
fn shop() -> Shop {
    let many = "&n=0\nAGAIN:\n&n=&n+1\nSetUsrVal, &n\nMX,&n\nIF &n<900 THEN GOTO AGAIN\n";
    let line = |d: String| {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900mm\" height=\"20mm\" \
            viewBox=\"0 0 900 20\"><path d=\"M 0 10 {d}\"/></svg>"
        )
    };
    let zigzag: String = (1..900).map(|x| format!("L {x} {} ", x % 19)).collect();
    let shop = Shop::new(&[
        ("a.sbp", "SA\nMX,7\n"),
        ("many.sbp", many),
        ("x.sbp", "PRINT %(1)\n"),
        ("a.svg", &line("L 7 10".into())),
        ("many.svg", &line(zigzag)),
        ("repeated.toml", "[job]\nrepeats = 12\n"),
    ]);
    shop.kerf("send MX,5 --quiet").exits(0);
    shop
}

fn x(shop: &Shop) -> String {
    let mut send = shop.command();
    let did = Did::of(send.args(["send", "&x=%(1)", "PRINT &x", "--quiet"]).output().unwrap());
    did.exits(0).out().trim_end().to_owned()
}

/// Runs `kerf` where no file may be larger than so many kilobytes, as on a full disk; the signal that tells of it
/// ends no run.
fn on_full_disk(shop: &Shop, kilobytes: u32, args: &str) -> Did {
    let mut shell = Command::new("bash");
    let line = format!("ulimit -f {kilobytes}; exec {} {args}", env!("CARGO_BIN_EXE_kerf"));
    shell.args(["-c", &line]).current_dir(shop.path());
    shell.env("KERF_DATA", shop.file("data")).env("NO_COLOR", "1");
    Did::of(shell.output().unwrap())
}

#[test]
fn on_a_full_disk_nothing_starts() {
    let shop = shop();
    for work in ["a.sbp", "a.svg"] {
        let full = on_full_disk(&shop, 1, &format!("run {work} --trace t"));
        full.exits(1).complains("disk of the data folder is full");
        assert!(!full.out().contains("ran to its end"), "{}", full.out());
        assert!(!shop.file("t").exists(), "{work}: nothing begins");
        assert_eq!(x(&shop), "5", "what was kept is still there");
    }
}

#[test]
fn a_disk_that_fills_up_does_not_stop_a_cut() {
    let shop = shop();
    let full = on_full_disk(&shop, 600, "run many.sbp --trace t");
    full.complains("J001").complains("not on record").complains("disk of the data folder is full");
    assert_eq!(full.err().matches("J001").count(), 1, "it is told once\n{}", full.err());
    full.exits(1).says("ran to its end").complains("what the run left is not kept: the disk");
    assert!(shop.read("t").contains("\"to\":{\"x\":900,"), "the cut was made");
    let after = shop.kerf("run x.sbp --quiet");
    after.exits(3).complains("not verified");
    shop.kerf("send UD --quiet").exits(0).says("position not verified");
}

#[test]
fn a_disk_that_fills_up_does_not_stop_a_job() {
    let shop = shop();
    // Whatever the operator wants is on record before it happens.
    let requests: String = (1..90).map(|t| format!(" --override {}@{t}", 50 + t)).collect();
    let full = on_full_disk(&shop, 300, &format!("run many.svg --trace t{requests}"));
    full.complains("J001").complains("not on record").complains("disk of the data folder is full");
    assert_eq!(full.err().matches("J001").count(), 1, "it is told once\n{}", full.err());
    full.exits(1).says("ran to its end").complains("what the run left is not kept: the disk");
    assert!(shop.read("t").contains("\"to\":{\"x\":899,"), "the cut was made");
    let after = shop.kerf("run x.sbp --quiet");
    after.exits(3).complains("not verified").complains("the job many.svg was cut short at shape 1");
}

/// `kerf` as somebody who may not write everywhere.
fn as_nobody(shop: &Shop, args: &str) -> Did {
    let mut command = shop.command();
    if fs::metadata(shop.path()).unwrap().uid() == 0 {
        command.uid(65534);
    }
    Did::of(command.args(args.split_whitespace()).output().unwrap())
}

#[test]
fn in_a_folder_that_cannot_be_written_nothing_starts() {
    let shop = shop();
    fs::set_permissions(shop.path(), fs::Permissions::from_mode(0o755)).unwrap();
    // They are nobody's but their owner's.
    for entry in fs::read_dir(shop.file("data")).unwrap().map(Result::unwrap) {
        if fs::metadata(shop.path()).unwrap().uid() == 0 {
            chown(entry.path(), Some(65534), None).unwrap();
        }
    }
    fs::set_permissions(shop.file("data"), fs::Permissions::from_mode(0o555)).unwrap();
    if fs::metadata(env!("CARGO_BIN_EXE_kerf")).unwrap().mode() & 0o001 == 0 {
        return;
    }
    for work in ["a.sbp", "a.svg"] {
        let run = as_nobody(&shop, &format!("run {work}"));
        run.exits(1).complains("data folder cannot be written").complains("--data");
        assert!(!run.out().contains("ran to its end"), "{}", run.out());
    }
    as_nobody(&shop, "sysvars").exits(0).says("  1             5  ");
    as_nobody(&shop, "run a.sbp --start fresh").exits(0).complains("values are not kept");
    fs::set_permissions(shop.file("data"), fs::Permissions::from_mode(0o755)).unwrap();
    assert_eq!(x(&shop), "5");
}

#[test]
fn a_folder_that_cannot_be_made_is_told() {
    let shop = shop();
    shop.kerf("run a.sbp --data a.sbp/data").exits(1).complains("data folder cannot be written");
}

/// A journal that lost its bytes, or is gone, with its copy beside it: nothing of it is lost in silence.
#[test]
fn an_empty_journal_is_told_and_rescued() {
    for (gone, what) in [(false, "it is empty"), (true, "it is gone")] {
        let shop = shop();
        shop.kerf("run a.sbp --quiet").exits(0);
        for ending in ["", "-wal", "-shm"] {
            let _ = fs::remove_file(shop.file(&format!("data/journal.db{ending}")));
        }
        if !gone {
            shop.write("data/journal.db", b"");
        }
        shop.kerf("registry get Status").exits(1).complains("damaged").complains(what);
        let first = shop.kerf("run x.sbp --quiet");
        first
            .exits(3)
            .complains("the journal was damaged")
            .complains(what)
            .complains("not verified");
        assert_eq!(shop.file("data/journal.damaged-1.db").exists(), !gone);
        assert_eq!(x(&shop), "7", "{what}");
    }
}

/// The server, the pages and `kerf` write `machine.toml`; whatever else lies there is told, and locations are confirmed once.
#[test]
fn another_machine_file_is_told_and_confirmed_once() {
    let shop = shop();
    shop.kerf("machine set speeds.cut.xy 101.6").exits(0);
    let known = shop.read("data/machine.toml");
    let unmoved = |did: &Did| assert!(!did.err().contains("not verified"), "{}", did.err());
    let file = shop.file("data/machine.toml");
    let check = |text: Option<&str>, how: &str| {
        match text {
            Some(text) => fs::write(&file, text).unwrap(),
            None => fs::remove_file(&file).unwrap(),
        }
        let first = shop.kerf("run x.sbp --quiet");
        first.exits(3).complains("machine.toml").complains(how).complains("not verified");
        first.complains("speeds.cut.xy was 101.6").complains("as Kerf left it, it is kept as");
        shop.write("yes", b"location=Continue\n");
        shop.kerf("run x.sbp --quiet --answers yes").exits(0);
        unmoved(&shop.kerf("run x.sbp --quiet"));
        assert_eq!(x(&shop), "5", "{how}");
        fs::write(&file, &known).unwrap();
        shop.kerf("run x.sbp --quiet").exits(3).complains("not as Kerf left it");
        shop.kerf("run x.sbp --quiet --answers yes").exits(0);
    };
    unmoved(&shop.kerf("run x.sbp --quiet"));
    check(None, "is gone");
    check(Some(""), "is empty");
    check(Some("[speeds.cut]\nxy = 25\n"), "is not as Kerf left it");
    // Who only writes a comment changes no machine.
    fs::write(&file, format!("# mine\n{known}")).unwrap();
    unmoved(&shop.kerf("run x.sbp --quiet"));
}

#[test]
fn a_damaged_page_is_told_and_rescued() {
    let shop = shop();
    let file = shop.file("data/journal.db");
    let mut bytes = fs::read(&file).unwrap();
    bytes[4096..8192].fill(0x77);
    fs::write(&file, bytes).unwrap();
    let run = shop.kerf("run x.sbp --quiet");
    run.exits(3)
        .complains("the journal was damaged")
        .complains("kept as")
        .complains("not verified");
    assert_eq!(x(&shop), "5");
    assert!(shop.file("data/journal.damaged-1.db").is_file());
    shop.kerf("send UD --quiet").exits(0).says("position not verified: X Y Z");
    let again = shop.kerf("run x.sbp --quiet");
    assert!(!again.err().contains("damaged"), "{}", again.err());
}

/// Kills a job in the middle of its cut; it runs in real time, by the clock of a zone.
fn killed_job(shop: &Shop, zone: &str) {
    let mut command = shop.command();
    let args = "run many.svg --config repeated.toml --pace real --quiet";
    let mut job = command.args(args.split_whitespace()).env("TZ", zone).spawn().unwrap();
    let cut = || Journal::look(&shop.file("data")).ok()??.runs.cut_short().ok()?;
    let moves = || cut().is_some_and(|cut| cut.moved());
    while !moves() {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    job.kill().unwrap();
    job.wait().unwrap();
}

/// Number of times that a trace cuts to the end of the job; 0 where nothing was traced.
fn passes(shop: &Shop) -> usize {
    let trace = fs::read_to_string(shop.file("t")).unwrap_or_default();
    let ends =
        |line: &&str| line.contains("\"kind\":\"cut\"") && line.contains("\"to\":{\"x\":899,");
    trace.lines().filter(ends).count()
}

#[test]
fn a_job_is_taken_up_from_a_damaged_journal_or_says_why_not() {
    for page in 1..9 {
        let shop = shop();
        killed_job(&shop, "UTC0");
        shop.kerf("send UD --quiet").exits(0);
        let file = shop.file("data/journal.db");
        let mut bytes = fs::read(&file).unwrap();
        let Some(part) = bytes.get_mut(page * 4096..(page + 1) * 4096) else { break };
        part.fill(0x77);
        fs::write(&file, bytes).unwrap();
        let run = shop.kerf("run --resume --trace t");
        assert!(!run.err().contains("panicked"), "page {page}: {}", run.err());
        // These words are in "was cut short", too: then there is no trace.
        let nothing = run.err().contains("no run was cut short");
        let taken_up = !nothing && run.err().contains("was cut short") && passes(&shop) == 12;
        let told = run.err().contains("was damaged") && run.err().contains("not verified");
        assert!(taken_up || told || nothing, "page {page}: {}\n{}", run.out(), run.err());
        x(&shop);
    }
}

/// Whatever was kept was written so many seconds after 1970, as the files say: the clock was put since.
fn kept_at(shop: &Shop, seconds: u64) {
    let time = SystemTime::UNIX_EPOCH + Duration::from_secs(seconds);
    for entry in fs::read_dir(shop.file("data")).unwrap().map(Result::unwrap) {
        if entry.file_type().unwrap().is_file() {
            fs::File::options().write(true).open(entry.path()).unwrap().set_modified(time).unwrap();
        }
    }
}

/// A century ahead, the beginning of time, and a day there and back by the clock on the wall.
#[test]
fn a_clock_that_jumps_loses_nothing() {
    for (seconds, before, after) in [(4_100_000_000, "A-14", "B12"), (0, "A12", "B-14")] {
        let shop = shop();
        killed_job(&shop, before);
        kept_at(&shop, seconds);
        let mut command = shop.command();
        let args = "run --resume --trace t";
        let run = Did::of(command.args(args.split_whitespace()).env("TZ", after).output().unwrap());
        run.exits(0).complains("was cut short");
        assert_eq!(passes(&shop), 12, "{}", run.out());
        kept_at(&shop, seconds);
        let mut command = shop.command();
        let next = Did::of(command.args(["run", "a.sbp"]).env("TZ", before).output().unwrap());
        next.exits(0).says("ran to its end");
        assert_eq!(x(&shop), "7");
        shop.kerf("run --resume").exits(1).complains("no run was cut short");
    }
}

#[test]
fn one_kerf_at_a_time_runs_a_machine() {
    let shop = shop();
    let mut command = shop.command();
    let mut first =
        command.args(["send", "--pace", "real", "--quiet", "PAUSE 20", "MX,9"]).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(500));
    let refused = shop.kerf("run a.sbp");
    shop.kerf("registry set uValue hello").exits(0);
    shop.kerf("registry get uValue").says("hello");
    first.kill().unwrap();
    first.wait().unwrap();
    refused.exits(1).complains("another Kerf runs the machine");
    assert_eq!(x(&shop), "5", "the lock died with it");
}
