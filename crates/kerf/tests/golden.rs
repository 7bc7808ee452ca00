//! Whole traces, kept as files that a person can read.
//!
//! Each `golden/*.sbp` has its trace beside it. A first line `'options: …` gives options. When a trace
//! changes for a reason, `KERF_BLESS=1 cargo test -p kerf --test all golden::` writes the new one; read the
//! difference before keeping it.

use kerf_control::{TextOptions, run_text};
use kerf_trace::json;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

fn programs() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let entries = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    let mut programs: Vec<PathBuf> =
        entries.filter(|p| p.extension().is_some_and(|e| e == "sbp")).collect();
    programs.sort();
    programs
}

fn options(program: &Path) -> Vec<String> {
    let text = fs::read_to_string(program).unwrap();
    let line = text.lines().next().unwrap_or_default().strip_prefix("'options: ");
    line.unwrap_or_default().split_whitespace().map(str::to_owned).collect()
}

/// Output of `kerf trace`, the program named from its own folder's parent.
fn trace(program: &Path) -> String {
    let data = tempfile::tempdir().unwrap();
    let name = Path::new("golden").join(program.file_name().unwrap());
    let output = Command::new(env!("CARGO_BIN_EXE_kerf"))
        .current_dir(program.parent().unwrap().parent().unwrap())
        .env("KERF_DATA", data.path())
        .arg("trace")
        .arg(name)
        .args(options(program))
        .output()
        .unwrap();
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn traces_are_as_they_were() {
    let programs = programs();
    assert!(programs.len() >= 4);
    for program in programs {
        let golden = program.with_extension("jsonl");
        let trace = trace(&program);
        if env::var_os("KERF_BLESS").is_some() {
            fs::write(&golden, &trace).unwrap();
        }
        let expected = fs::read_to_string(&golden).unwrap_or_default();
        for (number, (got, want)) in trace.lines().zip(expected.lines()).enumerate() {
            assert_eq!(got, want, "{} line {}", golden.display(), number + 1);
        }
        assert_eq!(trace.lines().count(), expected.lines().count(), "{}", golden.display());
    }
}

#[test]
fn the_same_run_gives_the_same_bytes() {
    for program in programs() {
        assert_eq!(trace(&program), trace(&program), "{}", program.display());
    }
}

#[test]
fn how_many_lines_are_read_at_once_changes_nothing() {
    for program in programs() {
        let text = fs::read_to_string(&program).unwrap();
        let run = |lines: u64| {
            let mut options = TextOptions::default()
                .answers("-.25\nYes")
                .input(3, 1.0, true)
                .input(5, 9.0, true)
                .preview();
            options.run.lines_at_once = lines;
            let outcome = run_text(&[("a.sbp", &text)], "a.sbp", options);
            outcome.events.iter().map(json::to_string).collect::<Vec<_>>().join("\n")
        };
        let whole = run(0);
        for lines in [1, 2, 3, 7, 50] {
            assert_eq!(run(lines), whole, "{} by {lines}", program.display());
        }
    }
}
