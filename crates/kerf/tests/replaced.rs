//! Files that a command writes and that are there already.

use crate::shop;
use crate::shop::Shop;
use kerf_files::versions::Versions;

const PART: &str = "SA\nMX,1\nMY,2\n";

/// A command that writes a file is refused where another lies, unless it is told to.
fn check(args: &str, output: &str) {
    let shop = Shop::new(&[("a.sbp", PART), (output, "by hand")]);
    let refused = shop.kerf(args);
    refused.exits(2).complains(&format!("{output} is there already, 7 bytes, changed 20"));
    refused.complains("nothing was written; --force replaces it");
    assert_eq!(shop.read(output), "by hand", "{args}");
    shop.kerf(&format!("{args} --force")).exits(0);
    assert_ne!(std::fs::read(shop.file(output)).unwrap(), b"by hand", "{args}");
    // It is Kerf's own now, and made anew as often as is liked.
    shop.kerf(args).exits(0);
    // Whoever changes it makes it his own.
    shop.write(output, b"changed by hand");
    shop.kerf(args).exits(2);
    assert_eq!(shop.read(output), "changed by hand", "{args}");
}

#[test]
fn a_file_that_kerf_did_not_make_is_not_replaced_in_a_script() {
    check("preview a.sbp -o a.svg", "a.svg");
    check("plot a.sbp -o speed.svg", "speed.svg");
    check("timing a.sbp -o times.json", "times.json");
    check("convert a.sbp a.nc", "a.nc");
    check("draw a.sbp -o a.rsg", "a.rsg");
    check("draw a.sbp -o a.dxf", "a.dxf");
    check("toolpath a.sbp -o a.rsm", "a.rsm");
    check("run a.sbp --quiet --trace a.jsonl", "a.jsonl");
    check("run a.sbp --quiet --picture run.svg", "run.svg");
    check("run a.sbp --quiet --vcd a.vcd", "a.vcd");
}

#[test]
fn a_command_that_fails_makes_no_file_its_own() {
    let shop = Shop::new(&[("a.svg", "by hand"), ("a.sbp", PART)]);
    shop.kerf("preview missing.sbp -o a.svg --force").exits(2);
    assert_eq!(shop.read("a.svg"), "by hand");
    shop.kerf("preview a.sbp -o a.svg").exits(2);
}

#[cfg(unix)]
#[test]
fn the_trace_of_a_killed_run_is_kerfs_own() {
    let long = "&n=0\nL:\nMX,1\nMX,0\n&n=&n+1\nIF &n<10000000 THEN GOTO L\n";
    let shop = Shop::new(&[("a.sbp", PART), ("long.sbp", long)]);
    let args = ["run", "long.sbp", "--quiet", "--trace", "t.jsonl"];
    let mut run = shop.command().args(args).spawn().unwrap();
    let written = || std::fs::metadata(shop.file("t.jsonl")).is_ok_and(|file| file.len() > 0);
    shop::until("the trace", written);
    run.kill().unwrap();
    run.wait().unwrap();
    let left = std::fs::read(shop.file("t.jsonl")).unwrap();
    // Who edits it makes it his own, and whoever undoes that gives it back.
    shop.write("t.jsonl", &[&left, &b"by hand"[..]].concat());
    shop.kerf("run a.sbp --quiet --trace t.jsonl").exits(2).complains("is there already");
    shop.write("t.jsonl", &left);
    let next = shop.kerf("run a.sbp --quiet --trace t.jsonl");
    assert!(!next.err().contains("is there already"), "{}", next.err());
    // What somebody else puts there afterwards is his own.
    shop.kerf("preview a.sbp -o t.jsonl --force");
    shop.write("t.jsonl", b"by hand");
    shop.kerf("run a.sbp --quiet --trace t.jsonl").exits(2).complains("is there already");
}

#[test]
fn what_is_no_file_is_written_to_as_ever() {
    let shop = Shop::new(&[("a.sbp", PART)]);
    for _ in 0..2 {
        shop.kerf("run a.sbp --trace -").exits(0);
        #[cfg(unix)]
        shop.kerf("run a.sbp --quiet --trace /dev/null").exits(0);
    }
}

#[test]
fn versions_are_listed_and_brought_back() {
    let shop = Shop::new(&[("door.sbp", "MX,1\n")]);
    shop.kerf("parts --versions door.sbp").exits(0).says("no version of door.sbp is kept");
    let versions = Versions::in_data(&shop.file("data"));
    for text in ["MX,2\n", "MX,30\n"] {
        versions.keep("door.sbp", &shop.file("door.sbp")).unwrap();
        shop.write("door.sbp", text.as_bytes());
    }
    let listed = shop.kerf("parts --versions door.sbp");
    let lines: Vec<_> = listed.exits(0).out().lines().map(str::to_owned).collect();
    assert!(lines[0].starts_with("   2  20") && lines[0].ends_with("  5 bytes"), "{lines:?}");
    shop.kerf("parts --versions door.sbp --restore 1").exits(0).says("version 1 again");
    assert_eq!(shop.read("door.sbp"), "MX,1\n");
    shop.kerf("parts --versions door.sbp").exits(0).says("   3  20");
    shop.kerf("parts --versions door.sbp --restore 9")
        .exits(1)
        .complains("no version has this number");
    shop.kerf("parts --versions ../x --restore 1").exits(1);
}
