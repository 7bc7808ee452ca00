//! Behaviour that needs somebody at a terminal.

#![cfg(unix)]

use crate::shop::Shop;
use std::fs::File;
use std::io::{Read, Write};
use std::os::unix::fs::PermissionsExt;
use std::process::Stdio;
use std::thread::{sleep, spawn};
use std::time::Duration;

/// A terminal: its two ends.
fn terminal() -> (File, File) {
    let pair = nix::pty::openpty(None, None).unwrap();
    (File::from(pair.master), File::from(pair.slave))
}

/// A program of the shell in the shop; its path.
fn program(shop: &Shop, name: &str, text: &str) -> String {
    shop.write(name, text.as_bytes());
    let path = shop.file(name);
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
    path.display().to_string()
}

#[test]
fn sbp_cmd_un__fe_starts_the_program_at_a_terminal() {
    let shop = Shop::new(&[]);
    // An editor: it tells what it was started with, then takes a line from the terminal.
    let text = "#!/bin/sh\nread first < \"$1\"\necho \"$1 $first\" > opened\nread line\necho \"$line\" > typed\n";
    let editor = program(&shop, "editor.sh", text);
    shop.write("notes.txt", b"two doors\n");
    shop.write("a.sbp", b"FE,notes.txt\nMX,1\n");
    shop.kerf(&format!("send UN,{editor}")).exits(0);

    let (mut keys, slave) = terminal();
    let mut kerf = shop.command();
    kerf.args(["run", "a.sbp"]).stdin(slave).stdout(Stdio::piped()).stderr(Stdio::piped());
    let running = kerf.spawn().unwrap();
    drop(kerf);
    while !shop.file("opened").is_file() {
        sleep(Duration::from_millis(20));
    }
    // Ctrl-Z in the editor suspends both, and `fg` has both go on.
    let id = nix::unistd::Pid::from_raw(running.id() as i32);
    for signal in [nix::sys::signal::SIGTSTP, nix::sys::signal::SIGCONT] {
        nix::sys::signal::kill(id, signal).unwrap();
        sleep(Duration::from_millis(200));
    }
    keys.write_all(b"saved\n").unwrap();
    let did = running.wait_with_output().unwrap();
    assert!(did.status.success(), "{}", String::from_utf8_lossy(&did.stderr));
    let opened = shop.read("opened");
    assert!(opened.ends_with("notes.txt two doors\n"), "{opened}");
    assert_eq!(shop.read("typed"), "saved\n", "what is typed meanwhile belongs to the editor");
    assert!(String::from_utf8_lossy(&did.stdout).contains("ran to its end"));

    // Without a terminal, and after a blank UN, nothing is started.
    std::fs::remove_file(shop.file("opened")).unwrap();
    shop.kerf("run a.sbp").exits(0);
    shop.kerf("send UN").exits(0);
    let (mut keys, slave) = terminal();
    keys.write_all(b"OK\n").unwrap();
    let mut kerf = shop.command();
    assert!(kerf.args(["run", "a.sbp"]).stdin(slave).output().unwrap().status.success());
    assert!(!shop.file("opened").is_file());
}

#[test]
fn sbp_io_play__the_bell_of_a_terminal() {
    let shop = Shop::new(&[]);
    shop.write("ding.wav", b"x");
    shop.write("a.sbp", b"PLAY ding.wav\nMX,1\n");
    let (mut screen, slave) = terminal();
    let shown = spawn(move || {
        let mut bytes = Vec::new();
        // The end of a pseudo terminal reads as an error.
        let _ = screen.read_to_end(&mut bytes);
        bytes
    });
    let mut kerf = shop.command();
    let status = kerf.args(["run", "a.sbp"]).stdin(Stdio::null()).stdout(slave).status().unwrap();
    drop(kerf);
    assert!(status.success());
    let shown = shown.join().unwrap();
    assert_eq!(shown.iter().filter(|byte| **byte == 7).count(), 1);
    let file = shop.kerf("run a.sbp");
    assert!(!file.out().contains('\u{7}'), "a file takes no bell");
}

/// A command at a terminal where somebody types an answer; its exit code and what it asked.
fn answered(shop: &Shop, args: &[&str], answer: &[u8]) -> (Option<i32>, String) {
    let (mut terminal, slave) = terminal();
    terminal.write_all(answer).unwrap();
    let mut kerf = shop.command();
    let err = slave.try_clone().unwrap();
    let status = kerf.args(args).stdin(slave).stdout(Stdio::null()).stderr(err).status().unwrap();
    drop(kerf);
    let mut shown = Vec::new();
    // The end of a pseudo terminal reads as an error.
    let _ = terminal.read_to_end(&mut shown);
    (status.code(), String::from_utf8_lossy(&shown).into_owned())
}

#[test]
fn a_file_that_kerf_did_not_make_is_asked_about() {
    let shop = Shop::new(&[("a.sbp", "SA\nMX,1\n"), ("a.svg", "by hand")]);
    let preview = ["preview", "a.sbp", "-o", "a.svg"];
    for (answer, code) in [(b"n\n", 3), (b"\n\n", 3)] {
        let (exit, asked) = answered(&shop, &preview, answer);
        assert!(asked.contains("a.svg is there already, 7 bytes") && asked.contains("Replace it?"));
        assert_eq!((exit, shop.read("a.svg").as_str()), (Some(code), "by hand"));
    }
    assert_eq!(answered(&shop, &preview, b"y\n").0, Some(0));
    assert!(shop.read("a.svg").contains("<svg"));
}
