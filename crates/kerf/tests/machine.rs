//! `kerf machine` as a user meets it.
#![allow(clippy::unwrap_used)]

use std::path::Path;
use std::process::{Command, Output};

fn kerf(data: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kerf"));
    command.arg("machine").args(arguments).env("KERF_DATA", data).output().unwrap()
}

fn told(data: &Path, arguments: &[&str]) -> String {
    let output = kerf(data, arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn refused(data: &Path, arguments: &[&str], part: &str) {
    let output = kerf(data, arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert!(message.contains(part), "{arguments:?}: {message}");
}

#[test]
fn pro_misc_config_save() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("new");
    told(&data, &["use", "sim"]);
    told(&data, &["set", "zpos.top_mm", "-12"]);
    assert_eq!(told(&data, &["get", "zpos.top_mm"]), "-12\n");
    assert_eq!(told(&data, &["get", "zpos.bottom_mm"]), "-30\n");
    refused(&data, &["set", "zpos.top_mm", "-25"], "zpos.surface_mm (-20) is above zpos.top_mm");
    assert_eq!(told(&data, &["get", "zpos.top_mm"]), "-12\n", "a refused value changes nothing");
}

#[test]
fn pro_axes_axes() {
    let folder = tempfile::tempdir().unwrap();
    let axes = told(folder.path(), &["axes", "--config", "sim"]);
    let names: Vec<&str> = axes.lines().skip(1).filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(names, ["x", "y", "z", "w"]);
}

#[test]
fn pro_motors_fixed() {
    let folder = tempfile::tempdir().unwrap();
    for (axis, motor) in [("motors.x", "\"x\"\n"), ("motors.y", "\"y\"\n"), ("motors.z", "\"z\"\n")]
    {
        assert_eq!(told(folder.path(), &["get", axis]), motor);
    }
    refused(
        folder.path(),
        &["set", "motors.y", "x"],
        "motors.y must be y, which cannot be changed",
    );
}

#[test]
fn pro_motors_assign() {
    let folder = tempfile::tempdir().unwrap();
    told(folder.path(), &["set", "motors.w", "R"]);
    told(folder.path(), &["set", "motors.y2", "W"]);
    let axes = told(folder.path(), &["axes"]);
    assert!(axes.contains("\ny    Y W ") && axes.contains("\nw    R "), "{axes}");
    refused(folder.path(), &["set", "motors.x2", "W"], "motor W drives two axes");
}

#[test]
fn a_mistake_in_a_file_is_told_with_line_and_hint() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("m.toml");
    std::fs::write(&file, "axes = 3\n[delays]\nend = 4\n").unwrap();
    let output = kerf(folder.path(), &["check", file.to_str().unwrap()]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(
        text.contains("m.toml:3:1: there is no setting delays.end [K002] did you mean"),
        "{text}"
    );
}
