//! Programs opened as drawings.

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
        assert_eq!(run(&["convert", "hole.dxf", target]).status.code(), Some(0), "its own file");
        std::fs::write(folder.path().join(target), "'my own\n").unwrap();
        let refused = run(&["convert", "hole.dxf", target]);
        assert_eq!(refused.status.code(), Some(2), "never over a file of somebody else");
        assert_eq!(std::fs::read_to_string(folder.path().join(target)).unwrap(), "'my own\n");
    }
}

/// The places of the only shape in space.
fn places(program: &str) -> Vec<[f64; 3]> {
    let (code, shapes, told) = kerf(program, "nc");
    assert_eq!((code, shapes.len()), (Some(0), 1), "{told}");
    let (points, z) = (shapes[0]["points"].as_array().unwrap(), &shapes[0]["z"]);
    let place = |(n, p): (usize, &Value)| [&p[0], &p[1], &z[n]].map(|v| v.as_f64().unwrap());
    points.iter().enumerate().map(place).collect()
}

/// All places and all middles between neighbours lie on a circle about the origin of radius 10, and one
/// of them is this.
fn round_and_through(places: &[[f64; 3]], through: [f64; 3]) {
    let far = |p: [f64; 3]| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    let middles =
        places.windows(2).map(|pair| std::array::from_fn(|i| 0.5 * (pair[0][i] + pair[1][i])));
    for place in places.iter().copied().chain(middles) {
        assert!((far(place) - 10.0).abs() < 0.01, "{place:?}");
    }
    let near = |p: &[f64; 3]| far(std::array::from_fn(|i| p[i] - through[i]));
    let nearest = places.iter().map(near).fold(f64::INFINITY, f64::min);
    assert!(nearest < 0.2, "{nearest}");
}

#[test]
fn pro_import_nc_g18() {
    let quarter = places("G0 X0 Y0 Z10\nG18 G3 X10 Z0 I0 K-10 F500\n");
    round_and_through(&quarter, [7.0711, 0.0, 7.0711]);
    assert_eq!((quarter[0], quarter.last()), ([0.0, 0.0, 10.0], Some(&[10.0, 0.0, 0.0])));
    assert!(quarter.iter().all(|place| place[1] == 0.0));
    // An arc that stands upright in the middle is one shape: no chord of it is a plunge.
    for share in 1..40 {
        let (sin, cos) = (f64::from(share) * 1.5_f64).to_radians().sin_cos();
        let (x, z) = (10.0 * cos, 10.0 * sin);
        let text = format!("G0 X{x} Y0 Z{}\nG18 G2 X{x} Z{z} I{} K{z} F500\n", -z, -x);
        // Seen along Y, from below the axis up to above it: clockwise is counter-clockwise there.
        let text = text.replace("G2", "G3");
        let (_, shapes, told) = kerf(&text, "nc");
        assert_eq!(shapes.len(), 1, "{told}");
    }
}

#[test]
fn pro_import_nc_g19() {
    let quarter = places("G0 X0 Y10 Z0\nG19 G3 Y0 Z10 J-10 K0 F500\n");
    round_and_through(&quarter, [0.0, 7.0711, 7.0711]);
    assert!(quarter.iter().all(|place| place[0] == 0.0));
}

#[test]
fn pro_import_nc_arc3d() {
    let slanted = |code: &str| places(&format!("G0 X10 Y0 Z0\n{code} X0 Y8 Z6 I-10 J0 K0 F500\n"));
    let (short, long) = (slanted("G3"), slanted("G2"));
    round_and_through(&short, [7.0711, 5.6569, 4.2426]);
    let middle = short[short.len() / 2];
    for (found, expected) in middle.iter().zip([7.0711, 5.6569, 4.2426]) {
        assert!((found - expected).abs() < 1e-3, "{middle:?}");
    }
    // The rest of the circle: by way of the opposite of that middle.
    round_and_through(&long, [-7.0711, -5.6569, -4.2426]);
    let length = |places: &[[f64; 3]]| -> f64 {
        let step = |p: &[[f64; 3]]| {
            let d: [f64; 3] = std::array::from_fn(|i| p[1][i] - p[0][i]);
            (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt()
        };
        places.windows(2).map(step).sum()
    };
    assert!((length(&long) / length(&short) - 3.0).abs() < 1e-3);
    let (code, _, told) = kerf("G0 X6 Y0 Z8\nG3 X-6 Z-8 I-6 J0 K-8 F500\n", "nc");
    assert_eq!(code, Some(1));
    assert!(told.contains("start, centre and end lie on one line"), "{told}");
    assert!(told.contains("a.nc:2"), "{told}");
}

#[test]
fn pro_import_nc_ignored() {
    let plain = "F500\nG0 X0 Y0\nG1 X10\nG0 X50 Y50\nG1 X60\n";
    let full = "F500\nM3 S12000\nM7\nM8\nG0 X0 Y0\nG4 P1\nG1 X10\nM6 T2\nG81 X20 Y20 Z-5 R2\nX25\nG80\n\
                G81\nG0 X50 Y50\nG1 X60\nM9\nM30\n";
    assert_eq!(shapes(full), shapes(plain));
    let (_, listed, told) = kerf(full, "nc");
    assert!(told.contains("ignored: G4 1, G81 2, M3 1, M6 1, M7 1, M8 1, M9 1, M30 1"), "{told}");
    assert!(listed.iter().all(|shape| shape["group"] == "black" && shape["pause"] == false));
}
