//! Whatever is given: a clear message, the right exit code, no panic.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod shop;

use shop::Shop;

#[track_caller]
fn check(program: &[u8], options: &str, code: i32, status: &str, message: &str) {
    let shop = Shop::new(&[]);
    shop.write("a.sbp", program);
    let did = shop.kerf(&format!("trace a.sbp {options}"));
    did.exits(code).complains("");
    assert_eq!(did.end()["status"], status, "{}", did.out());
    let told = did.all("diag").iter().any(|d| d["message"].as_str().unwrap().contains(message));
    assert!(message.is_empty() || told, "{message:?} not in\n{}", did.out());
    // A run and a check say the same.
    let run = shop.kerf(&format!("run a.sbp {options}"));
    run.exits(code).complains(message);
    let check = shop.kerf(&format!("check a.sbp {options}"));
    check.complains("").exits(i32::from(code == 1 || status == "limit")).says(message);
}

#[test]
fn files_that_are_no_part_files() {
    check(b"MX,1\0\0\0", "", 1, "failed", "not a text file");
    check(b"", "", 0, "ok", "");
    check(b"\n\n\r\n", "", 0, "ok", "");
    check(b"\xff\xfe\xe9 MX", "", 1, "failed", "");
}

#[test]
fn a_file_that_calls_itself_ends_in_the_depth_error() {
    check(b"FP,a.sbp\n", "", 1, "failed", "nested deeper than 8 files");
}

#[test]
fn an_endless_loop_reaches_the_bound_of_lines() {
    check(b"L:\nGOTO L\n", "--max-lines 10000", 3, "limit", "stopped after 10000 lines");
    let moving = b"L:\nMX,1\nMX,0\nGOTO L\n";
    check(moving, "--max-lines 10000", 3, "limit", "stopped after 10000 lines");
}

#[test]
fn arithmetic_without_a_result() {
    check(b"MX,1/0\n", "", 1, "failed", "division by zero");
    check(b"MX,SQR(0-1)\n", "", 1, "failed", "");
    check(b"&a=0-1\nMX,LOG(&a)\n", "", 1, "failed", "");
}

#[test]
fn numbers_beyond_any_machine() {
    let shop = Shop::new(&[
        ("a.sbp", "MX,1e300\n"),
        ("b.sbp", "MX,99999999999999999999999\nMY,1\nCC,1\n"),
        ("c.sbp", "MX,9e18\nMX,0\nJZ,9e18\nVS,999999\nMX,1\n"),
        ("d.sbp", "&a=10^300\nMX,&a*&a\n"),
    ]);
    for (file, code) in [("a.sbp", None), ("b.sbp", None), ("c.sbp", None), ("d.sbp", Some(1))] {
        let did = shop.kerf(&format!("trace {file}"));
        did.complains("");
        if let Some(code) = code {
            did.exits(code);
        }
        assert!(did.end()["e"] == "end", "{file}: {}", did.out());
        assert!(!did.out().contains("e+") && !did.out().contains("inf"), "{file}: {}", did.out());
    }
}

#[test]
fn places_that_are_no_files() {
    let shop = Shop::new(&[("folder/a.sbp", "MX,1"), ("a.nc", "G0 X1")]);
    for command in ["run", "trace", "time", "preview -o x.svg"] {
        shop.kerf(&format!("{command} none.sbp")).exits(2).complains("cannot read none.sbp");
        shop.kerf(&format!("{command} folder")).exits(2).complains("is a folder");
    }
    shop.kerf("check none.sbp").exits(1).says("cannot read none.sbp");
    shop.kerf("fmt none.sbp").exits(2).complains("cannot read none.sbp");
}

#[test]
fn options_that_are_wrong() {
    let shop = Shop::new(&[("a.sbp", "MX,1"), ("bad.toml", "axes = 9")]);
    for (args, message) in [
        ("", "Usage"),
        ("trace", "required"),
        ("frob a.sbp", "unrecognized subcommand"),
        ("trace a.sbp --units cm", "give in or mm"),
        ("trace a.sbp --input 13@1=1", "1 to 12"),
        ("trace a.sbp --input 3", "NUMBER@SECONDS=STATE"),
        ("trace a.sbp --set 3", "NAME=VALUE"),
        ("trace a.sbp --repeat 0", "--repeat"),
        ("trace a.sbp --offset 4d", "give 3d or 2d"),
        ("trace a.sbp --answers none.txt", "cannot read none.txt"),
        ("trace a.sbp --config none.toml", "cannot read none.toml"),
        ("trace a.sbp --config bad.toml", "axes must be 1 to 6"),
        ("run a.sbp --machine router", "no machine 'router'"),
        ("preview a.sbp -o a.gif", ".svg, .png or .html"),
        ("preview a.sbp", "--output"),
    ] {
        shop.kerf(args).exits(2).complains(message);
    }
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let shop = Shop::new(&[]);
    shop.write("a.sbp", "MX,1\nMX,0\n".repeat(20_000).as_bytes());
    let line = format!("'{}' trace a.sbp | head -1", env!("CARGO_BIN_EXE_kerf"));
    if cfg!(unix) {
        let output =
            std::process::Command::new("sh").arg("-c").arg(line).current_dir(shop.path()).output();
        let err = String::from_utf8(output.unwrap().stderr).unwrap();
        assert_eq!(err, "");
    }
}
