//! The `kerf` command with its memory bounded.

use super::Shop;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// No command takes longer, even unoptimised on a busy machine.
const MOST_TIME: Duration = Duration::from_secs(240);

/// The end of a bounded command.
pub struct Ended {
    pub code: Option<i32>,
    /// The signal that ended it.
    pub signal: Option<i32>,
    pub out: String,
    pub err: String,
}

/// Runs `kerf` in a folder with so much memory to address, KiB; panics when it takes too long.
pub fn bounded(shop: &Shop, most_kib: u64, args: &str) -> Ended {
    let (out, err) = (shop.file("data/out"), shop.file("data/err"));
    fs::create_dir_all(shop.file("data")).unwrap();
    let line = format!("ulimit -v {most_kib}; exec '{}' {args}", env!("CARGO_BIN_EXE_kerf"));
    let mut child = Command::new("sh")
        .args(["-c", &line])
        .current_dir(shop.path())
        .env("KERF_DATA", shop.file("data"))
        .stdin(Stdio::null())
        .stdout(fs::File::create(&out).unwrap())
        .stderr(fs::File::create(&err).unwrap())
        .spawn()
        .unwrap();
    let begin = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if begin.elapsed() > MOST_TIME {
            child.kill().unwrap();
            child.wait().unwrap();
            panic!("kerf {args} does not end");
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let [out, err] =
        [out, err].map(|file| String::from_utf8_lossy(&fs::read(file).unwrap()).into_owned());
    assert!(!err.contains("panicked") && !err.contains("memory"), "{args}: {err}");
    Ended { code: status.code(), signal: status.signal(), out, err }
}
