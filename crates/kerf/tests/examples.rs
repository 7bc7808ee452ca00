//! Runs every numbered example as a person would and compares what it did with its `expected.txt`.
//!
//! The expectation is short and made to be read: how the run ended, what was cut, what was
//! switched, shown and asked. Times are left out; the planner's own tests hold them.

use kerf_ledger::traces::{self, Traces};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

#[test]
fn examples_do_what_they_say() {
    let folders = example_folders();
    assert!(folders.len() >= 7, "{folders:?}");
    let differing: Vec<String> = folders.iter().filter_map(|folder| difference(folder)).collect();
    assert!(differing.is_empty(), "\n{}", differing.join("\n"));
}

#[test]
fn examples_are_free_of_warnings() {
    for folder in example_folders() {
        let told: Vec<Value> = trace(&folder).into_iter().filter(|e| e["e"] == "diag").collect();
        assert!(told.is_empty(), "{}: {told:?}", folder.display());
    }
}

/// Formatting changes none of them, of either language.
#[test]
fn examples_are_formatted() {
    let kerf = || Command::new(env!("CARGO_BIN_EXE_kerf"));
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let told = kerf().args(["fmt", "--check"]).arg(&examples).output().unwrap();
    assert!(told.status.success(), "run kerf fmt: {}", String::from_utf8_lossy(&told.stdout));
    let scratch = tempfile::tempdir().unwrap();
    std::fs::create_dir(scratch.path().join("inside")).unwrap();
    std::fs::write(scratch.path().join("inside/part.sbp"), "m2,1 , 2\n").unwrap();
    std::fs::write(scratch.path().join("notes.txt"), "m2,1 , 2\n").unwrap();
    let told = kerf().args(["fmt", "--check"]).arg(scratch.path()).output().unwrap();
    let told = (told.status.code(), String::from_utf8_lossy(&told.stdout).into_owned());
    assert!(
        told.0 == Some(1) && told.1.contains("part.sbp") && !told.1.contains("notes"),
        "{told:?}"
    );
}

/// With KERF_TRACES: the trace of each example is the recorded one.
#[test]
fn traces_are_the_recorded_ones() {
    if traces::folder().is_none() {
        return;
    }
    let mut traces = Traces::default();
    for folder in example_folders() {
        let lines: Vec<String> = trace(&folder).iter().map(Value::to_string).collect();
        traces.add(&folder.file_name().unwrap().to_string_lossy(), lines);
    }
    traces.hold("examples.txt");
}

/// Folder of the example and name of the picture.
const FIGURES: &[(&str, &str)] = &[("03-coaster", "coaster")];

/// The pictures that README and book show are those that `make figures` draws.
#[test]
fn figures_are_fresh() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let scratch = tempfile::tempdir().unwrap();
    for (folder, name) in FIGURES {
        let drawn = scratch.path().join("drawn.svg");
        let part = format!("examples/{folder}/{name}.sbp");
        let mut command = Command::new(env!("CARGO_BIN_EXE_kerf"));
        command.current_dir(&root).env("KERF_DATA", scratch.path()).args(["preview", &part, "-o"]);
        assert!(command.arg(&drawn).status().unwrap().success(), "{part}");
        let figure = root.join(format!("docs/figures/{name}.svg"));
        let same = std::fs::read(&drawn).unwrap() == std::fs::read(&figure).unwrap_or_default();
        assert!(same, "docs/figures/{name}.svg is stale: run make figures");
    }
}

fn example_folders() -> Vec<PathBuf> {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let entries = std::fs::read_dir(examples).expect("the folder of examples");
    let mut folders: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    folders.retain(|path| path.is_dir());
    folders.sort();
    folders
}

/// Output of an example that differs from the expected one.
fn difference(folder: &Path) -> Option<String> {
    let expected = std::fs::read_to_string(folder.join("expected.txt")).unwrap_or_default();
    let did = summary(&trace(folder));
    let name = folder.display();
    (did != expected).then(|| format!("{name}: expected\n{expected}--- did\n{did}"))
}

/// The trace of an example: the part file or drawing named after the folder, with the options of
/// `options.txt` if there are any.
fn trace(folder: &Path) -> Vec<Value> {
    let name = folder.file_name().unwrap().to_string_lossy();
    let (_, name) = name.split_once('-').expect("NN-name");
    let part = ["sbp", "nc", "rsg"].map(|ending| format!("{name}.{ending}"));
    let part = part.into_iter().find(|part| folder.join(part).is_file()).expect("a part file");
    let options = std::fs::read_to_string(folder.join("options.txt")).unwrap_or_default();
    let data = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_kerf"))
        .current_dir(folder)
        .env("KERF_DATA", data.path())
        .arg("trace")
        .arg(part)
        .args(options.split_whitespace())
        .output()
        .expect("kerf runs");
    let text = String::from_utf8(output.stdout).expect("text");
    text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

fn summary(events: &[Value]) -> String {
    let end = events.last().expect("an end");
    let mut text = format!("ended {}\n", end["status"].as_str().unwrap());
    let _ = writeln!(text, "cut {}, arcs {}", number(&end["cut"]), end["arcs"]);
    let range = |axis: &str| {
        let corner = |which: &str| number(&end["bounds"][which][axis]);
        format!("{} {} to {}", axis.to_uppercase(), corner("min"), corner("max"))
    };
    let _ = writeln!(text, "{}, {}, {}", range("x"), range("y"), range("z"));
    for line in events.iter().filter_map(told) {
        let _ = writeln!(text, "{line}");
    }
    text
}

/// Part of an event that a person at the machine would notice.
fn told(event: &Value) -> Option<String> {
    let text = event["text"].as_str().unwrap_or_default();
    match event["e"].as_str()? {
        "print" => Some(format!("print {text}")),
        "ask" => Some(format!("ask {text} -> {}", event["answer"].as_str()?)),
        "output" if event["why"] == "program" => {
            let state = if event["on"] == true { "on" } else { "off" };
            // Jobs switch lines that have names.
            let name =
                event["name"].as_str().map_or(format!("output {}", event["n"]), str::to_owned);
            Some(format!("{name} {state}"))
        }
        "stop" => Some(format!("stopped by {} {}", event["by"].as_str()?, event["n"])),
        _ => None,
    }
}

/// To a thousandth, without trailing zeros.
fn number(value: &Value) -> String {
    let rounded = (value.as_f64().unwrap_or(f64::NAN) * 1e3).round() / 1e3;
    (rounded + 0.0).to_string()
}
