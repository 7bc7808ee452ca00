//! A server whose disk is full: what is to be saved is refused with the reason, and what lies there stays whole.

#![cfg(target_os = "linux")]

use crate::shop::Shop;
use crate::shop::console::Console;
use std::fs;

/// A server that writes no file longer than so many kilobytes, as on a full disk.
fn full(shop: &Shop, kilobytes: u32) -> Console {
    let line = format!("ulimit -f {kilobytes}; exec \"$0\" \"$@\"");
    Console::begin_with(shop, &[], |command| {
        let mut shell = std::process::Command::new("bash");
        shell.args(["-c", &line]).arg(command.get_program()).args(command.get_args());
        shell.current_dir(shop.path());
        shell.envs(command.get_envs().filter_map(|(name, value)| Some((name, value?))));
        shell
    })
}

/// So many bytes of a part file.
fn long(bytes: usize) -> String {
    "MX,1\n".repeat(bytes / 5)
}

/// So many lines that lie apart, as a DXF.
fn lines(number: usize) -> String {
    let line = |n: usize| format!("0\nLINE\n8\n0\n10\n{n}\n20\n0\n11\n{n}.5\n21\n10.25\n");
    let all: String = (0..number).map(line).collect();
    format!("0\nSECTION\n2\nENTITIES\n{all}0\nENDSEC\n0\nEOF\n")
}

/// A save is refused: the status, words of the answer; the file of before stays and nothing lies beside it.
#[track_caller]
fn check(request: &str, body: &str) {
    let shop = Shop::new(&[("a.sbp", "MX,1\n"), ("door.rsg", ""), ("many.dxf", &lines(15_000))]);
    let console = full(&shop, 900);
    let open = r#"{"op":{"op":"open","name":"many.dxf"}}"#;
    assert_eq!(console.answer("POST /api/do/draw", open).0, 200);
    let files = || (shop.read("a.sbp"), shop.read("door.rsg"), shop.names());
    let before = files();
    let (status, answer) = console.answer(request, body);
    assert_eq!((status, answer["why"].as_str()), (507, Some("full")), "{answer}");
    let text = answer["text"].as_str().unwrap();
    assert!(text.contains("is not written, it is as it was before: the disk is full"), "{text}");
    assert_eq!(files(), before);
    // The server is there, and saves what has room.
    assert_eq!(console.answer("PUT /api/files/small.sbp", "MX,2\n").0, 200);
    assert_eq!(shop.read("small.sbp"), "MX,2\n");
}

#[test]
fn a_file_that_has_no_room_is_refused_and_the_one_there_stays() {
    check("PUT /api/files/a.sbp?replace=1", &long(2_000_000));
    check("PUT /api/files/new.sbp", &long(2_000_000));
}

#[test]
fn a_drawing_that_has_no_room_is_refused_and_the_file_there_stays() {
    check("POST /api/do/draw", r#"{"op":{"op":"save","name":"door.rsg","replaces":"*"}}"#);
}

#[test]
fn a_part_program_that_has_no_room_is_refused_and_the_file_there_stays() {
    check("POST /api/do/draw", r#"{"op":{"op":"program","name":"a.sbp","replaces":"*"}}"#);
}

/// A file is replaced only after its version is kept: without room for that it stays.
#[test]
fn a_file_whose_version_cannot_be_kept_stays() {
    let shop = Shop::new(&[]);
    fs::write(shop.file("a.sbp"), long(5_000_000)).unwrap();
    let console = full(&shop, 4096);
    let (status, answer) = console.answer("PUT /api/files/a.sbp?replace=1", "MX,2\n");
    assert_eq!((status, answer["why"].as_str()), (507, Some("full")), "{answer}");
    assert!(answer["text"].as_str().unwrap().contains("a.sbp stays as it is"), "{answer}");
    assert_eq!(shop.read("a.sbp").len(), 5_000_000);
}
