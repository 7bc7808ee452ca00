//! Programs made to hang, to fill the memory or to reach what is not theirs: each ends soon, in
//! bounded memory, with an error that has a place, and never in a panic.

#![cfg(unix)]

use crate::shop;
use crate::shop::Shop;
use serde_json::Value;
use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Memory a command may address, KiB.
const MOST_KIB: u64 = 2 << 20;

/// The end of a bounded command.
struct Ended {
    code: Option<i32>,
    events: Vec<Value>,
    err: String,
}

/// Runs `kerf` with its memory bounded, and takes what it prints for events.
fn bounded(shop: &Shop, args: &str) -> Ended {
    let did = shop::bounded::bounded(shop, MOST_KIB, args);
    let events = did.out.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    Ended { code: did.code, events, err: did.err }
}

/// The program ends with this error, which points to a line of it, or without one where the
/// message is empty.
#[track_caller]
fn check(program: &[u8], code: i32, message: &str) {
    check_files(&[("a.sbp", program)], code, message);
}

#[track_caller]
fn check_files(files: &[(&str, &[u8])], code: i32, message: &str) {
    let shop = Shop::new(&[]);
    files.iter().for_each(|(name, bytes)| shop.write(name, bytes));
    let did = bounded(&shop, "trace a.sbp --max-lines 20000");
    assert_eq!(did.code, Some(code), "{:?} {}", did.events.last(), did.err);
    assert_eq!(did.events.last().unwrap()["e"], "end");
    let errors: Vec<&Value> = did.events.iter().filter(|e| e["severity"] == "error").collect();
    if message.is_empty() {
        assert!(errors.is_empty(), "{errors:?}");
        return;
    }
    let named = |e: &&&Value| e["message"].as_str().unwrap().contains(message);
    let error = errors.iter().find(named).unwrap_or_else(|| panic!("{message:?}: {errors:?}"));
    assert!(error["line"].as_u64().unwrap() >= 1, "{error}");
}

/// `head`, then a piece many times, then `tail`.
fn long(head: &str, piece: &str, count: usize, tail: &str) -> Vec<u8> {
    format!("{head}{}{tail}", piece.repeat(count)).into_bytes()
}

#[test]
fn lines_of_a_hundred_megabytes() {
    check(&long("MX,", "1", 100_000_000, ""), 1, "line");
    check(&long("M3,1,2,", "3,", 50_000_000, ""), 1, "line");
    check(&long("", "\0", 100_000_000, ""), 1, "not a text file");
}

#[test]
fn a_million_labels() {
    let labels: String = (0..1_000_000).map(|n| format!("L{n}:\n")).collect();
    check(format!("GOTO L999999\nMX,1\n{labels}").as_bytes(), 0, "");
    check(&long("", "L:\n", 200_000, "MX,1/0\n"), 3, "stopped after 20000 lines");
    check(&long("", "GOTO Nowhere\n", 200_000, ""), 1, "NOWHERE");
}

#[test]
fn expressions_without_a_bottom() {
    let deep = |open: &str, close: &str| {
        long(&format!("MX,{}1", open.repeat(200_000)), close, 200_000, "\n")
    };
    check(&deep("(", ")"), 1, "nested too deep");
    check(&long("MX,", "SQR(", 200_000, "1\n"), 1, "nested too deep");
}

#[test]
fn files_and_subroutines_that_call_each_other() {
    let files: [(&str, &[u8]); 3] =
        [("a.sbp", b"FP,b.sbp\n"), ("b.sbp", b"C#,66\n"), ("custom/custom66.sbc", b"FP,a.sbp\n")];
    check_files(&files, 1, "nested deeper than 8 files");
    check(b"A:\nGOSUB A\n", 1, "GOSUB nested deeper");
    check(b"GOSUB A\nEND\nA:\nGOSUB B\nRETURN\nB:\nGOSUB A\nRETURN\n", 1, "GOSUB nested deeper");
}

#[test]
fn repetitions_within_repetitions() {
    let call = |n: usize| format!("FP,f{n}.sbp,,,,1000000000\n").into_bytes();
    let calls: Vec<(String, Vec<u8>)> = (1..7)
        .map(|n| (format!("f{n}.sbp"), call(n + 1)))
        .chain([("a.sbp".into(), call(1)), ("f7.sbp".into(), b"&a=1\n".to_vec())])
        .collect();
    let files: Vec<_> = calls.iter().map(|(n, b)| (n.as_str(), b.as_slice())).collect();
    check_files(&files, 3, "stopped after 20000 lines");
    let empty: [(&str, &[u8]); 2] = [("a.sbp", b"FP,b.sbp,,,,1000000000\n"), ("b.sbp", b"")];
    check_files(&empty, 3, "stopped after 20000 lines");
}

#[test]
fn loops_in_which_nothing_changes() {
    for (text, line) in
        [("a:\nGOTO a\n", 2), ("MX,1\na:\nGOTO a\n", 3), ("a:\n&x = 5\nIF &x > 3 THEN GOTO a\n", 3)]
    {
        let shop = Shop::new(&[("a.sbp", text)]);
        for command in ["check a.sbp", "preview a.sbp -o a.svg", "run a.sbp --quiet"] {
            let did = shop.kerf(command);
            let told = did.out() + &did.err();
            assert!(told.contains("endless loop"), "{command}: {told}");
            assert!(told.contains(&format!("a.sbp:{line}")), "{command}: {told}");
        }
    }
}

#[test]
fn loops_that_grow() {
    check(b"&a=\"x\"\nL:\n&a=&a & &a\nGOTO L\n", 1, "longer than a million bytes");
    check(b"&a=\"x\"\nL:\n&a=&a & &a\nPRINT &a;\nGOTO L\n", 1, "longer than a million bytes");
    let text = "x".repeat(100_000);
    let print = format!("L:\nPRINT \"{text}\";\nGOTO L\n");
    let shop = Shop::new(&[("a.sbp", &print)]);
    let did = bounded(&shop, "trace a.sbp --max-lines 400");
    let parts = did.events.iter().filter(|e| e["e"] == "print").count();
    assert!(did.code == Some(3) && parts > 10, "{parts} parts");
    let write = format!("OPEN \"o\" FOR OUTPUT AS #1\nL:\nWRITE #1; \"{text}\"\nGOTO L\n");
    check(write.as_bytes(), 1, "too much written to file #1");
    check(b"ON INPUT(1,1) &a=1\nL:\nMX,1\nMX,0\nGOTO L\n", 3, "stopped after 20000 lines");
    check(b"L:\nSK\nGOTO L\n", 3, "stopped after 20000 lines");
}

#[test]
fn numbers_that_mean_no_machine() {
    for (program, code, message) in [
        ("PAUSE 1e300", 1, "a pause lasts"),
        ("&a=1e308*10", 1, "no finite result"),
        ("&a=LOG(0)\nMX,&a-&a", 1, "no finite result"),
        ("&a=%(1e300)", 1, "no system variable"),
        ("CC,1e300,T,1", 1, ""),
        ("CC,1,T,1,0,360,-.001,1000000000", 1, ""),
        ("CR,1,1,T,1,0,-.001,1000000000", 1, ""),
        ("VS,1e-300\nMX,1", 1, ""),
        ("MX,1\nFP,a.sbp,1e300,0,1e-300", 1, ""),
    ] {
        let shop = Shop::new(&[("a.sbp", program)]);
        let did = bounded(&shop, "trace a.sbp");
        assert_eq!(did.code, Some(code), "{program}: {:?}", did.events.last());
        let errors = did.events.iter().filter(|e| e["severity"] == "error");
        let told: Vec<&str> = errors.map(|e| e["message"].as_str().unwrap()).collect();
        assert!(told.iter().any(|m| m.contains(message)), "{program}: {told:?}");
        assert!(did.events.iter().all(|e| !e.to_string().contains("null,\"t")), "{program}");
    }
}

/// Waits until a process has said what it does when it is interrupted; on a busy computer that takes its time.
fn until_it_takes_interrupts(id: &str) {
    let status = format!("/proc/{id}/status");
    let takes = || {
        let Ok(status) = fs::read_to_string(&status) else { return true };
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap();
        let interrupt = 1 << (2 - 1);
        u64::from_str_radix(caught.trim(), 16).unwrap() & interrupt != 0
    };
    let begin = Instant::now();
    while !takes() && begin.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn an_endless_run_can_be_interrupted() {
    for program in ["L:\nGOTO L\n", "L:\nMX,1\nMX,0\nGOTO L\n", "FP,b.sbp,,,,1000000000\n"] {
        let shop = Shop::new(&[("a.sbp", program), ("b.sbp", "")]);
        let mut child = shop
            .command()
            .args(["run", "a.sbp", "--max-lines", "0", "-q"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let id = child.id().to_string();
        until_it_takes_interrupts(&id);
        std::thread::sleep(Duration::from_millis(100));
        assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
        let begin = Instant::now();
        let code = loop {
            if let Some(status) = child.try_wait().unwrap() {
                break status.code();
            }
            if begin.elapsed() > Duration::from_secs(20) {
                child.kill().unwrap();
                panic!("{program:?} cannot be interrupted");
            }
            std::thread::sleep(Duration::from_millis(5));
        };
        assert_eq!(code, Some(3), "{program}");
    }
}

#[test]
fn files_that_are_not_theirs() {
    let shop = Shop::new(&[("secret.txt", "secret\n"), ("secret.sbp", "MX,7\n")]);
    fs::create_dir_all(shop.file("parts")).unwrap();
    let link = |to: &str, name: &str| {
        std::os::unix::fs::symlink(shop.file(to), shop.file("parts").join(name)).unwrap();
    };
    link("secret.txt", "link.txt");
    link("secret.sbp", "link.sbp");
    link("new.txt", "dangling.txt");
    let outside = "outside the folders that may be used";
    for line in [
        "FP,..\\..\\etc\\passwd",
        "FP,..\\secret.sbp",
        "FP,link.sbp",
        "FP,/etc/passwd",
        "FP,C:\\..\\secret.sbp",
        "FS,..",
        "OPEN \"..\\secret.txt\" FOR INPUT AS #1",
        "OPEN \"..\\secret.txt\" FOR OUTPUT AS #1",
        "OPEN \"link.txt\" FOR OUTPUT AS #1\nWRITE #1;\"x\"",
        "OPEN \"link.txt\" FOR INPUT AS #1",
        "OPEN \"link.txt\" FOR APPEND AS #1",
        "OPEN \"/tmp/kerf-hostile.txt\" FOR OUTPUT AS #1",
        "OPEN \"C:\\..\\..\\new.txt\" FOR OUTPUT AS #1",
    ] {
        shop.write("parts/a.sbp", line.as_bytes());
        for command in ["run", "trace"] {
            let did = shop.kerf(&format!("{command} parts/a.sbp"));
            did.exits(1).complains("");
            let told = did.out() + &did.err();
            assert!(told.contains(outside) || told.contains("not found"), "{line}: {told}");
        }
    }
    assert_eq!(shop.read("secret.txt"), "secret\n");
    // A link that leads nowhere is replaced by the file; nothing appears where it led.
    shop.write("parts/a.sbp", b"OPEN \"dangling.txt\" FOR OUTPUT AS #1\nWRITE #1;\"x\"\n");
    shop.kerf("run parts/a.sbp").exits(0);
    assert!(!shop.file("new.txt").exists());
}

#[test]
fn what_cannot_be_read_or_written() {
    let shop = Shop::new(&[("a.sbp", "OPEN \"o.txt\" FOR OUTPUT AS #1\nWRITE #1;\"x\"\n")]);
    fs::create_dir_all(shop.file("folder.sbp")).unwrap();
    shop.write("b.sbp", b"FP,folder.sbp\n");
    shop.kerf("run b.sbp").exits(1).complains("not found");
    shop.kerf("run folder.sbp").exits(2).complains("is a folder");
    shop.write("c.sbp", b"OPEN \"folder.sbp\" FOR OUTPUT AS #1\n");
    shop.kerf("run c.sbp").exits(1).complains("cannot write folder.sbp");
    if cfg!(target_os = "linux") {
        shop.kerf("run /proc/self/mem").exits(2).complains("cannot read /proc/self/mem");
        shop.kerf("run a.sbp --parts /proc").exits(1).complains("cannot write");
    }
}

#[test]
fn a_file_that_never_ends() {
    let shop = Shop::new(&[]);
    let did = bounded(&shop, "run /dev/zero");
    assert_eq!(did.code, Some(2), "{}", did.err);
    assert!(did.err.contains("/dev/zero is too large"), "{}", did.err);
}

#[test]
fn what_was_written_before_an_error_stays_whole() {
    let program = "OPEN \"o.txt\" FOR OUTPUT AS #1\nWRITE #1;\"one\"\nWRITE #1;\"two\"\nMX,1/0\n\
        WRITE #1;\"three\"\n";
    let shop = Shop::new(&[("a.sbp", program), ("o.txt", "old\n")]);
    shop.kerf("run a.sbp").exits(1);
    assert_eq!(shop.read("o.txt"), "one\ntwo\n");
    // Nothing that was in the making is left.
    assert_eq!(shop.names(), ["a.sbp", "o.txt"]);
    shop.kerf("trace a.sbp").exits(1);
    assert_eq!(shop.names(), ["a.sbp", "o.txt"]);
}

#[test]
fn answers_that_are_none() {
    let program = "INPUT \"How deep?\" &d\nMSGBOX(Go?,YesNo,Go)\nPAUSE\nMZ,&d\n";
    let shop = Shop::new(&[("a.sbp", program)]);
    for garbage in
        [b"\xff\xfe\0\x01\x02".to_vec(), b"=:=:\n9999999999999:x\n".to_vec(), vec![b'9'; 1 << 20]]
    {
        shop.write("answers.txt", &garbage);
        let did = shop.kerf("trace a.sbp --answers answers.txt");
        did.exits(1).complains("");
        assert_eq!(did.end()["status"], "failed");
        assert!(did.all("diag").iter().any(|d| d["line"].as_u64().unwrap() >= 2), "{}", did.out());
    }
}
