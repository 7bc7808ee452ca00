//! Ctrl-C while a long file is read and planned: what runs stops, and the process ends.

#![cfg(unix)]

use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::fmt::Write;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Reading, planning and running so many moves takes longer by far than a test is awake.
const MOVES: usize = 600_000;

/// The process ends within a second; a computer that builds other programs meanwhile gives it less than that.
const BOUND: Duration = Duration::from_secs(3);

/// A file whose plan never comes to rest.
fn long_file(folder: &Path) {
    let mut text = "G21 G90\nF3000\n".to_owned();
    for n in 0..MOVES {
        let (sin, cos) = (n as f64 / 50.0).sin_cos();
        writeln!(text, "G1 X{:.3} Y{:.3}", 90.0 * cos + 100.0, 90.0 * sin + 100.0).unwrap();
    }
    std::fs::write(folder.join("long.nc"), text).unwrap();
}

fn begun(folder: &Path, args: &str) -> Child {
    let mut kerf = Command::new(env!("CARGO_BIN_EXE_kerf"));
    kerf.args(args.split(' ')).current_dir(folder).stdin(Stdio::null());
    kerf.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Presses Ctrl-C, and gives the exit code.
#[track_caller]
fn ended(child: &mut Child) -> i32 {
    kill(Pid::from_raw(child.id() as i32), Signal::SIGINT).unwrap();
    let pressed = Instant::now();
    while pressed.elapsed() < BOUND {
        if let Some(status) = child.try_wait().unwrap() {
            return status.code().unwrap();
        }
        sleep(Duration::from_millis(5));
    }
    child.kill().unwrap();
    panic!("it runs on");
}

#[test]
fn a_run_that_is_planned_ends_at_ctrl_c() {
    let folder = tempfile::tempdir().unwrap();
    long_file(folder.path());
    let mut child = begun(folder.path(), "run long.nc --data data --start kept");
    // The journal begins with the run; before that nothing listens, and nothing moves.
    let journal = folder.path().join("data/journal.db");
    let begun = Instant::now();
    while !journal.exists() && begun.elapsed() < Duration::from_secs(30) {
        sleep(Duration::from_millis(5));
    }
    sleep(Duration::from_millis(1500));
    assert_eq!(ended(&mut child), 3, "stopped in the middle");
}

#[test]
fn a_console_that_draws_a_long_file_ends_at_ctrl_c() {
    let folder = tempfile::tempdir().unwrap();
    long_file(folder.path());
    let mut child =
        begun(folder.path(), "serve long.nc --parts . --data data --listen 127.0.0.1:0");
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
    assert!(line.starts_with("Kerf's console"), "{line}");
    assert_eq!(ended(&mut child), 0);
}
