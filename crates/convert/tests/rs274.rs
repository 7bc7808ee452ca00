//! Programs written for LinuxCNC are accepted by LinuxCNC's own interpreter, `rs274` of the Debian package
//! `linuxcnc-uspace`. Where it is not installed the test says so and passes.

use crate::support::{LINUXCNC, SBP, converted, plain};
use kerf_convert::Conversion;
use kerf_program::settings::LinearUnit;
use std::path::Path;
use std::process::{Command, Stdio};

/// Runs a program; what `rs274` complains of.
fn complaint(text: &str) -> Option<String> {
    let folder = std::env::temp_dir().join(format!("kerf-rs274-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("part.ngc");
    std::fs::write(&file, text).unwrap();
    let tools = folder.join("tools.tbl");
    std::fs::write(&tools, "T3 P3 D0.25 Z0\nT5 P5 D0.25 Z0\n").unwrap();
    let output = Command::new("rs274")
        .args(["-g", "-t"])
        .arg(&tools)
        .arg(&file)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    let said = String::from_utf8_lossy(&output.stderr).replace("executing", "");
    (!output.status.success()).then(|| said.trim().to_string())
}

#[test]
fn linuxcnc_accepts_what_is_written_for_it() {
    if Command::new("rs274").arg("-h").stdin(Stdio::null()).output().is_err() {
        eprintln!("rs274 is not installed: not looked at");
        return;
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "sbp") {
            continue;
        }
        for keep_variables in [false, true] {
            let how = Conversion { keep_variables, ..plain(SBP, LINUXCNC, LinearUnit::Inch) };
            let bytes = std::fs::read(&path).unwrap();
            let made = converted("part.sbp", &bytes, &how, folder.clone());
            let complaint = complaint(&made.text.unwrap());
            assert_eq!(complaint, None, "{} {keep_variables}", path.display());
        }
    }
}
