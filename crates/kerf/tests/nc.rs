//! Programs opened as drawings.

#![allow(clippy::unwrap_used, missing_docs)]

use serde_json::Value;
use std::process::Command;

fn kerf(program: &str, extension: &str) -> (Option<i32>, Vec<Value>, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = format!("a.{extension}");
    std::fs::write(folder.path().join(&file), program).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_kerf"))
        .current_dir(folder.path())
        .args(["draw", &file, "--list"])
        .output()
        .unwrap();
    let lines = String::from_utf8(output.stdout).unwrap();
    let shapes = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    (output.status.code(), shapes, String::from_utf8_lossy(&output.stderr).into_owned())
}

/// The shapes as `x,y` or `x,y,bulge`, rounded.
fn shapes(program: &str) -> Vec<String> {
    let (code, shapes, told) = kerf(program, "nc");
    assert_eq!(code, Some(0), "{told}");
    let round = |v: &Value| (v.as_f64().unwrap() * 1e4).round() / 1e4 + 0.0;
    let point = |p: &Value| {
        let at = format!("{},{}", round(&p[0]), round(&p[1]));
        if round(&p[2]) == 0.0 { at } else { format!("{at},{}", round(&p[2])) }
    };
    let words =
        |s: &Value| s["points"].as_array().unwrap().iter().map(point).collect::<Vec<_>>().join(" ");
    shapes.iter().map(words).collect()
}

fn check(program: &str, expected: &[&str]) {
    assert_eq!(shapes(program), expected, "{program}");
}

#[test]
fn pro_import_nc_open() {
    check("G71\nG0 X0 Y0\nG1 X10 F500\nG1 Y10\n", &["0,0 10,0 10,10"]);
    check("N10 G71 S1000\nN20 G0 X0 Y0 M3\nN30 G1 X10 F50\nN40 G1 Y10\n", &["0,0 10,0 10,10"]);
}

#[test]
fn pro_import_nc_g0() {
    check("G0 X0 Y0\nG1 X10 F500\nG0 X50 Y50\nG1 X60\n", &["0,0 10,0", "50,50 60,50"]);
}

#[test]
fn pro_import_nc_g1() {
    check("F500\nG1 X10\nY5\n", &["0,0 10,0 10,5"]);
}

#[test]
fn pro_import_nc_g2() {
    check("G0 X20 Y0\nG2 X10 Y-10 I-10 J0 F500\n", &["20,0,-0.4142 10,-10"]);
}

#[test]
fn pro_import_nc_g3() {
    check("G0 X20 Y0\nG3 X10 Y10 I-10 J0 F500\n", &["20,0,0.4142 10,10"]);
    check("G0 X20 Y0\nG3 X20 Y0 I-10 J0 F500\n", &["20,0,1 0,0,1"]);
}

#[test]
fn pro_import_nc_g17() {
    let arc = "G0 X20 Y0\nG3 X10 Y10 I-10 J0 F500\n";
    assert_eq!(shapes(arc), shapes(&format!("G18\nG17\n{arc}")));
}

#[test]
fn pro_import_nc_g70() {
    check("G70\nG0 X0 Y0\nG1 X1 Y0.5 F20\n", &["0,0 25.4,12.7"]);
    check("G20\nG0 X1 Y0\nG3 X0 Y1 I-1 J0 F20\n", &["25.4,0,0.4142 0,25.4"]);
}

#[test]
fn pro_import_nc_g71() {
    check("G71\nG1 X1 F20\n", &["0,0 1,0"]);
    check("G1 X1 F20\n", &["0,0 1,0"]);
    check("G70\nG1 X1 F20\nG71\nX30\n", &["0,0 25.4,0 30,0"]);
}

#[test]
fn pro_import_nc_path2d3d() {
    let (_, shapes, told) = kerf("F500\nG1 X0 Y0 Z-2\nX10 Z-4\n", "nc");
    assert_eq!(shapes[0]["z"], serde_json::json!([-2.0, -4.0]), "{told}");
    let (_, shapes, told) = kerf("F500\nG0 Z5\nG1 Z-2\nX10\nY10\nG0 Z5\n", "nc");
    assert_eq!(shapes[0]["z"], Value::Null);
    assert!(told.contains("cut at Z -2 mm"), "{told}");
}

#[test]
fn part_files_are_drawn_as_they_cut() {
    let (code, shapes, told) = kerf("MZ,-3\nMX,10\nCC,20,T,1\nJZ,5\n", "sbp");
    assert_eq!(code, Some(0), "{told}");
    assert_eq!(shapes.len(), 1);
}

#[test]
fn a_program_with_errors_is_not_drawn() {
    let (code, _, told) = kerf("G1 X[1+ F5\n", "nc");
    assert_eq!(code, Some(1));
    assert!(told.contains("a program with errors is not drawn"), "{told}");
}

#[test]
fn a_drawing_is_converted_to_a_program() {
    let folder = tempfile::tempdir().unwrap();
    let run = |args: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_kerf"))
            .current_dir(folder.path())
            .args(args)
            .output()
            .unwrap()
    };
    run(&["draw", "--do", "circle 50,50 25", "-o", "hole.dxf"]);
    for (target, word) in [("hole.sbp", "CG"), ("hole.nc", "G3")] {
        let output = run(&["convert", "hole.dxf", target]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        assert!(std::fs::read_to_string(folder.path().join(target)).unwrap().contains(word));
        assert_eq!(
            run(&["convert", "hole.dxf", target]).status.code(),
            Some(2),
            "never over a file"
        );
    }
}
