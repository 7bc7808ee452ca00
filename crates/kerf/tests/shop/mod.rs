//! A folder of part files and the `kerf` command in it.

#![allow(dead_code)]

#[cfg(unix)]
pub mod bounded;
pub mod console;

use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

/// From here on commands hear SIGHUP. Whoever runs the tests may have it ignored (nohup), and so would they; a
/// handler here is none there.
#[cfg(unix)]
pub fn hear_hangups() {
    signal_hook::flag::register(signal_hook::consts::SIGHUP, std::sync::Arc::default()).unwrap();
}

/// A folder of its own for one test, with a data folder beside the part files.
pub struct Shop {
    folder: TempDir,
}

/// Result of a command.
pub struct Did {
    output: Output,
}

impl Shop {
    /// A folder with these files.
    pub fn new(files: &[(&str, &str)]) -> Self {
        let shop = Self { folder: tempfile::tempdir().unwrap() };
        files.iter().for_each(|(name, text)| shop.write(name, text.as_bytes()));
        shop
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    pub fn file(&self, name: &str) -> PathBuf {
        self.path().join(name)
    }

    pub fn write(&self, name: &str, bytes: &[u8]) {
        let path = self.file(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.file(name)).unwrap()
    }

    /// Names of everything in the folder but the data folder and logs.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.path()).unwrap();
        let names = entries.map(|e| e.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> =
            names.filter(|n| n != "data" && !n.ends_with(".log")).collect();
        names.sort();
        names
    }

    pub fn command(&self) -> Command {
        // KERF_BIN is another build of the command, as `make soak` uses it.
        let kerf = std::env::var_os("KERF_BIN");
        let mut command = Command::new(kerf.unwrap_or_else(|| env!("CARGO_BIN_EXE_kerf").into()));
        command.current_dir(self.path()).env("KERF_DATA", self.file("data")).env("NO_COLOR", "1");
        command
    }

    /// Runs `kerf` with arguments separated by blanks.
    pub fn kerf(&self, args: &str) -> Did {
        self.kerf_with(args, b"")
    }

    /// The same with text on standard input.
    pub fn kerf_with(&self, args: &str, input: &[u8]) -> Did {
        let mut child = self
            .command()
            .args(args.split_whitespace())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("kerf starts");
        // A command that does not read its input may be gone already.
        let _ = child.stdin.take().unwrap().write_all(input);
        Did { output: child.wait_with_output().unwrap() }
    }
}

impl Did {
    /// Takes the result of a command that was started otherwise.
    pub fn of(output: Output) -> Self {
        Self { output }
    }

    pub fn out(&self) -> String {
        String::from_utf8(self.output.stdout.clone()).unwrap()
    }

    pub fn err(&self) -> String {
        String::from_utf8(self.output.stderr.clone()).unwrap()
    }

    /// Checks the exit code.
    #[track_caller]
    pub fn exits(&self, code: i32) -> &Self {
        assert_eq!(self.output.status.code(), Some(code), "\n{}\n{}", self.out(), self.err());
        self
    }

    /// Checks that the error stream holds a text, and no panic.
    #[track_caller]
    pub fn complains(&self, part: &str) -> &Self {
        let err = self.err();
        assert!(err.contains(part) && !err.contains("panicked"), "{part:?} not in\n{err}");
        self
    }

    /// Checks that standard output holds a text.
    #[track_caller]
    pub fn says(&self, part: &str) -> &Self {
        assert!(self.out().contains(part), "{part:?} not in\n{}", self.out());
        self
    }

    /// Each line of standard output as JSON.
    pub fn events(&self) -> Vec<Value> {
        self.out().lines().map(|line| serde_json::from_str(line).expect(line)).collect()
    }

    /// The events of a kind.
    pub fn all(&self, kind: &str) -> Vec<Value> {
        self.events().into_iter().filter(|e| e["e"] == kind).collect()
    }

    /// The last event.
    pub fn end(&self) -> Value {
        self.events().pop().expect("an end")
    }

    /// Standard output as one JSON value.
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.out()).expect("JSON")
    }
}

pub fn until(what: &str, mut holds: impl FnMut() -> bool) {
    let begun = std::time::Instant::now();
    while !holds() {
        assert!(begun.elapsed().as_secs() < 20, "{what}");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
}
