//! Part files of the project's own, and real ones where they are at hand: whatever they do, their runs end in order, and saving
//! and restoring in the middle changes nothing.

use super::rig::Rig;
use crate::corpus::find;
use crate::testing::FakeHost;
use crate::{Interpreter, Options, Session, Status, read};
use std::path::Path;

/// Name, origin and text of every file; a file is called `origin__name.sbp`.
fn files(folder: &Path) -> Vec<(String, String, String)> {
    let mut files: Vec<_> = find::files(folder)
        .iter()
        .map(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let (origin, name) = name.split_once("__").unwrap_or(("", &name));
            let bytes = std::fs::read(path).unwrap();
            (name.into(), origin.into(), String::from_utf8_lossy(&bytes).into_owned())
        })
        .collect();
    files.sort();
    files
}

/// A run that may call the other files of its origin; saved and restored now and then when asked.
fn run(file: &(String, String, String), all: &[(String, String, String)], saving: bool) -> Rig {
    let siblings = all.iter().filter(|other| other.1 == file.1);
    let files = siblings.map(|(name, _, text)| (name.to_lowercase(), text.clone())).collect();
    let options = Options { max_lines: 3_000, allow_errors: true, ..Options::default() };
    let program = read(file.0.as_str().into(), file.2.as_bytes());
    let interpreter = Interpreter::new(program, Session::default(), options);
    let mut rig = Rig::of(interpreter, FakeHost { files, ..FakeHost::default() });
    for step in 1.. {
        rig.step();
        rig.come_to_rest();
        if rig.done.is_some() {
            break;
        }
        if saving && step % 701 == 0 {
            let saved = serde_json::to_string(&rig.interpreter).unwrap();
            rig.interpreter = serde_json::from_str(&saved).unwrap();
        }
    }
    rig
}

#[test]
fn own_files_run_to_their_end() {
    let (complete, all) = complete(&find::own("sbp"));
    assert_eq!(complete, all);
}

#[test]
fn real_files_run_to_an_end_that_is_told() {
    let Some(folder) = find::real("sbp") else { return };
    let (complete, all) = complete(&folder);
    // The others want files, answers or machines that are not here, or another dialect.
    assert!(complete * 3 > all, "{complete} of {all} run to their end");
}

/// Runs the files of a folder, plainly and saved and restored on the way; how many did not fail, and of how many.
fn complete(folder: &Path) -> (usize, usize) {
    let all = files(folder);
    let mut complete = 0;
    for file in &all {
        let plain = run(file, &all, false);
        let failed = plain.done == Some(Status::Failed);
        assert_eq!(
            failed,
            !plain.error.is_empty() && plain.done != Some(Status::Limit),
            "{}",
            file.0
        );
        complete += usize::from(!failed);
        let restored = run(file, &all, true);
        assert_eq!((restored.out, restored.done), (plain.out, plain.done), "{}", file.0);
    }
    (complete, all.len())
}
