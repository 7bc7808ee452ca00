//! Whatever is given: a clear message, the right exit code, no panic.

use crate::shop::Shop;
use std::io::Write;
use std::process::Stdio;

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
fn an_endless_loop_is_told_or_reaches_the_bound_of_lines() {
    check(b"L:\nGOTO L\n", "--max-lines 10000", 3, "limit", "endless loop");
    let counting = b"&n=0\nL:\n&n=&n+1\nGOTO L\n";
    check(counting, "--max-lines 10000", 3, "limit", "stopped after 10000 lines");
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
    for command in [
        "run",
        "trace",
        "time",
        "preview -o x.svg",
        "plot -o x.svg",
        "timing -o x.svg",
        "heights --sheet=-20",
        "draw -o x.rsg",
        "toolpath -o x.rsm",
        "wavlength",
        "machine check",
        "log verify",
        "serve --listen 127.0.0.1:0",
    ] {
        shop.kerf(&format!("{command} none.sbp")).exits(2).complains("cannot read none.sbp");
        shop.kerf(&format!("{command} folder")).exits(2).complains("is a folder");
    }
    shop.kerf("fmt none.sbp").exits(2).complains("cannot read none.sbp");
    for line in ["convert none.sbp x.nc", "convert none.bmp x.sbp", "send none.sbp com2"] {
        shop.kerf(line).exits(2).complains("cannot read none.");
    }
    shop.kerf("sb3 none.sbp,,4,,2").exits(2).complains("cannot read none.sbp");
    // Messages about a machine that cannot be read name it without a file.
    shop.write("data/machine.toml", b"axes = 9");
    shop.kerf("machine check").exits(1).says("axes must be 3 to 6");
    shop.write("data/machine.toml", b"");
    // The other files are checked all the same.
    let did = shop.kerf("check none.sbp a.nc folder");
    did.exits(2).says("F001").says("cannot read none.sbp").says("is a folder").says("2 errors");
    assert!(did.out().contains("a.nc: "), "{}", did.out());
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
        ("trace a.sbp --machine none.toml", "no machine 'none.toml': no such file"),
        ("trace a.sbp --config bad.toml", "axes must be 3 to 6"),
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

#[test]
fn messages_that_nobody_reads_end_nothing() {
    let bad = "MX,1\nQQ,3\nMX,2\nM23,1\n".repeat(30);
    let shop = Shop::new(&[("bad.sbp", &bad), ("a.sbp", "MX,1\nPRINT \"x\"\nMX,0\n")]);
    for (args, code) in [
        ("run bad.sbp", 1),
        ("run bad.sbp --allow-errors", 1),
        ("run a.sbp --trace -", 0),
        ("run a.sbp", 0),
        ("fmt - ", 0),
        ("registry get nothing", 1),
        ("run none.sbp", 2),
    ] {
        let mut kerf = shop.command();
        kerf.args(args.split_whitespace()).stdin(Stdio::piped());
        let mut running = kerf.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // Both readers are gone before anything is written.
        drop((running.stdout.take(), running.stderr.take()));
        let _ = running.stdin.take().unwrap().write_all(b"mx,1\n");
        assert_eq!(running.wait().unwrap().code(), Some(code), "{args}");
    }
}

#[test]
fn only_part_files_are_formatted() {
    let mine = "[axes]\nend = \"low\"\n";
    let shop = Shop::new(&[("mine.toml", mine), ("notes.txt", "mx,1\n"), ("a.sbp", "mx,1\n")]);
    for name in ["mine.toml", "notes.txt", "plain"] {
        shop.write(name, mine.as_bytes());
        let did = shop.kerf(&format!("fmt a.sbp {name}"));
        did.exits(2)
            .complains(&format!("{name} is no part file by its ending"))
            .complains(".sbp .sbc");
        did.complains(&format!("kerf fmt - < {name}"));
        assert_eq!(shop.read(name), mine);
        assert_eq!(shop.read("a.sbp"), "mx,1\n", "nothing is written where a name is wrong");
    }
    for (name, tidy) in
        [("a.sbc", "MX,1\n"), ("a.sbd", "MX,1\n"), ("a.NC", "G0 X1\n"), ("a.cnc", "G0 X1\n")]
    {
        let text = if tidy.starts_with('M') { "mx,1\n" } else { "g0x1\n" };
        shop.write(name, text.as_bytes());
        shop.kerf(&format!("fmt {name}")).exits(0);
        assert_eq!(shop.read(name), tidy, "{name}");
    }
    // What is no text is told, and the others are formatted.
    let photo = b"\x89PNG\r\n\x1a\n\0\0\0mx,1\n";
    for name in ["photo.sbp", "photo.nc"] {
        shop.write(name, photo);
        let did = shop.kerf(&format!("fmt {name} a.sbp"));
        did.exits(1).complains("not a text file").complains(&format!("{name}:3"));
        assert_eq!(std::fs::read(shop.file(name)).unwrap(), photo);
        assert_eq!(shop.read("a.sbp"), "MX,1\n");
        shop.kerf(&format!("fmt --check {name}")).exits(1).complains("not a text file");
    }
    let did = shop.kerf_with("fmt -", photo);
    did.exits(1).complains("not a text file");
    assert_eq!(did.out(), "");
}

#[test]
fn an_empty_part_file_is_told() {
    for name in ["a.sbp", "a.nc"] {
        let shop = Shop::new(&[(name, ""), ("blank.sbp", "\n \n"), ("note.sbp", "' later\n")]);
        let did = shop.kerf(&format!("check {name}"));
        did.exits(0).says("warning[W022]: the file is empty").says("1 warning");
        shop.kerf("check blank.sbp").exits(0).says("the file is empty");
        shop.kerf("check note.sbp").exits(0).says("nothing wrong");
        for command in ["preview -o a.svg", "run", "time"] {
            shop.kerf(&format!("{command} {name}")).exits(0).complains("the file is empty");
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_that_cannot_be_read_is_told_beside_the_others() {
    let shop = Shop::new(&[("a.sbp", "MX,1\nQQ,3\n")]);
    // It is there, and reading it fails.
    let did = shop.kerf("check a.sbp /proc/self/mem --format json");
    did.exits(2);
    let found = did.json();
    let codes: Vec<_> = found.as_array().unwrap().iter().map(|d| &d["code"]).collect();
    assert_eq!(codes, ["S002", "F001"]);
    assert!(found[1]["message"].as_str().unwrap().starts_with("cannot read /proc/self/mem: "));
}

#[test]
fn what_cannot_be_written_is_told_by_its_own_name() {
    let shop = Shop::new(&[("a.sbp", "JZ,.5\nMX,1\nMZ,-.1\nMX,2\nMY,1\n")]);
    for command in [
        "draw a.sbp -o nodir/z.rsg",
        "convert a.sbp nodir/z.nc",
        "preview a.sbp -o nodir/z.svg",
        "plot a.sbp -o nodir/z.svg",
        "run a.sbp --picture nodir/z.svg",
    ] {
        let did = shop.kerf(command);
        did.exits(1).complains("cannot write nodir/z.").complains("No such file or directory");
        assert!(!did.err().contains("tmp"), "{command}: {}", did.err());
    }
}

#[test]
fn help_says_that_a_wrong_command_line_is_2() {
    for command in ["convert", "fmt", "draw", "toolpath", "machine", "io", "registry", "check"] {
        let did = Shop::new(&[]).kerf(&format!("help {command}"));
        let text = did.exits(0).out().split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains("2 the command line was wrong"), "{command}");
    }
}

#[test]
fn a_drawing_with_the_text_of_something_else_is_not_called_empty() {
    let text = "' a part file\nJZ,.5\nMX,1\nMZ,-.1\nMX,2\nMY,1\n";
    let shop = Shop::new(&[("a.dxf", text), ("a.rsm", text), ("none.dxf", "")]);
    for command in ["draw a.dxf --list", "run a.rsm"] {
        let did = shop.kerf(command);
        did.exits(1).complains("the file is no DXF");
        assert!(!did.err().contains("empty"), "{}", did.err());
    }
    shop.kerf("draw none.dxf --list").exits(1).complains("the file is empty");
}

#[test]
fn a_drawing_of_kerf_with_the_ending_of_gcode_is_told_once() {
    let shop = Shop::new(&[("a.sbp", "JZ,.5\nMX,1\nMZ,-.1\nMX,2\nMY,1\nMX,0\n")]);
    shop.kerf("draw a.sbp -o a.rsg").exits(0);
    shop.kerf("toolpath a.rsg -o a.rsm").exits(0);
    for name in ["a.rsg", "a.rsm"] {
        std::fs::copy(shop.file(name), shop.file("a.nc")).unwrap();
        let did = shop.kerf("check a.nc");
        did.exits(1).says("(RSG, DXF) or a job (RSM), not G-code").says(".rsg, .rsm or .dxf");
        did.says("\n1 error\n");
    }
}
