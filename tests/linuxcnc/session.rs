//! A LinuxCNC without a machine and without a panel, started for tests and benchmarks where it is installed: one at a time
//! on a computer. Nothing of LinuxCNC is in here; its configuration is our own.

use std::fs::{self, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// It is ready, or has ended, within this.
const PATIENCE: Duration = Duration::from_secs(40);

/// The interpreter that knows its module.
pub const PYTHON: &str = "/usr/bin/python3";

const HAL: &str = include_str!("mill.hal");
const INI: &str = include_str!("mill.ini");

/// Its panel shows nothing, and ends with whoever started it.
const PANEL: &str = "#!/bin/sh\nwhile [ -e {folder}/runs ] && kill -0 {pid}; do sleep 0.2; done\n";

/// A running LinuxCNC; it ends when it is dropped.
pub struct Session {
    pub folder: TempDir,
    linuxcnc: Child,
}

/// Starts it; the reason why not where it is not installed, or another one runs.
pub fn begins() -> Result<Session, String> {
    if !answers("import linuxcnc") || quiet("linuxcnc").arg("-h").status().is_err() {
        return Err("LinuxCNC (Debian package linuxcnc-uspace) is not installed".into());
    }
    if is_up() {
        return Err("another LinuxCNC runs here".into());
    }
    let session = started().map_err(|why| why.to_string())?;
    let begin = Instant::now();
    while !is_up() {
        if begin.elapsed() > PATIENCE {
            return Err("LinuxCNC does not start here".into());
        }
        sleep(Duration::from_millis(200));
    }
    Ok(session)
}

fn started() -> std::io::Result<Session> {
    let folder = tempfile::tempdir()?;
    let place = |name: &str| folder.path().join(name);
    let (path, pid) = (folder.path().to_string_lossy(), std::process::id().to_string());
    let files = [
        ("mill.ini", INI),
        ("mill.hal", HAL),
        ("panel.sh", PANEL),
        ("tools.tbl", "T1 P1 Z12.5 D6\n"),
        ("runs", ""),
    ];
    for (name, text) in files {
        fs::write(place(name), text.replace("{folder}", &path).replace("{pid}", &pid))?;
    }
    fs::set_permissions(place("panel.sh"), Permissions::from_mode(0o755))?;
    let mut command = quiet("linuxcnc");
    command.arg("-r").arg(place("mill.ini")).env("RTAPI_FIFO_PATH", place("fifo"));
    if fs::metadata(place("runs"))?.uid() == 0 {
        // It does not run as root alone: its other user is nobody, who has to make its socket.
        command.env("RTAPI_UID", "65534");
        fs::set_permissions(folder.path(), Permissions::from_mode(0o777))?;
    }
    let linuxcnc = command.spawn()?;
    Ok(Session { folder, linuxcnc })
}

fn quiet(program: &str) -> Command {
    let mut command = Command::new(program);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

fn answers(python: &str) -> bool {
    quiet(PYTHON).args(["-c", python]).status().is_ok_and(|status| status.success())
}

/// A LinuxCNC that runs tells its state.
fn is_up() -> bool {
    answers("import linuxcnc; it = linuxcnc.stat(); it.poll(); assert it.task_state and it.joints")
}

impl Drop for Session {
    fn drop(&mut self) {
        let _ = fs::remove_file(self.folder.path().join("runs"));
        let begin = Instant::now();
        while matches!(self.linuxcnc.try_wait(), Ok(None)) && begin.elapsed() < PATIENCE {
            sleep(Duration::from_millis(100));
        }
        let _ = self.linuxcnc.kill();
        let _ = self.linuxcnc.wait();
    }
}
