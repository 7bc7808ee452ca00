//! Real DXF files: what is read of each is written and read again, and is the same; what is broken is told
//! with its line. The files lie in `shared/corpus/dxf` beside the checkout or beside one of its parents, or
//! where `KERF_SHARED` says; without them nothing is tested here.

#![allow(clippy::print_stdout, clippy::unwrap_used, missing_docs)]

use kerf_drawing::Drawing;
use kerf_formats::{Imported, dxf, rsg};
use std::path::{Path, PathBuf};
use std::{env, fs};

fn files() -> Vec<PathBuf> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let own = env::var_os("KERF_SHARED").map(PathBuf::from);
    let mut all = own.into_iter().chain(here.ancestors().map(|a| a.join("../shared")));
    let folder = all.find_map(|shared| Some(shared.join("corpus/dxf")).filter(|f| f.is_dir()));
    let Some(folder) = folder else {
        println!("skipped: no corpus");
        return Vec::new();
    };
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    files
}

fn read(bytes: &[u8]) -> Imported {
    dxf::read(bytes, &dxf::Options::default())
}

/// How far two drawings are apart; why they cannot be compared.
fn apart(a: &Drawing, b: &Drawing, flat_only: bool) -> Result<f64, String> {
    if a.shapes.len() != b.shapes.len() {
        return Err(format!("{} shapes became {}", a.shapes.len(), b.shapes.len()));
    }
    let mut most = 0.0f64;
    for (n, (old, new)) in a.shapes.iter().zip(&b.shapes).enumerate() {
        let (from, to) = (&old.path.vertices, &new.path.vertices);
        if from.len() != to.len() || old.is_closed() != new.is_closed() {
            return Err(format!("shape {} became another", n + 1));
        }
        for (k, (v, w)) in from.iter().zip(to).enumerate() {
            let bulges = if old.z_mm.is_some() && flat_only { 0.0 } else { v.bulge - w.bulge };
            let heights = old.height_mm(k) - new.height_mm(k);
            most = most.max(v.at.distance(w.at)).max(bulges.abs()).max(heights.abs());
        }
    }
    Ok(most)
}

#[test]
fn what_is_read_is_written_and_read_again() {
    for file in files() {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        let first = read(&fs::read(&file).unwrap()).drawing;
        let as_dxf = read(dxf::write(&first).as_bytes()).drawing;
        assert_eq!(apart(&first, &as_dxf, true), Ok(0.0), "{name} as DXF");
        let as_rsg = rsg::read(rsg::write(&first).as_bytes()).drawing;
        assert_eq!(apart(&first, &as_rsg, false), Ok(0.0), "{name} as RSG");
    }
}

/// The mistakes of files that have some, as `line: text`, and nothing of the others.
#[test]
fn broken_files_tell_their_lines() {
    for file in files() {
        let bytes = fs::read(&file).unwrap();
        let text = String::from_utf8_lossy(&bytes).into_owned();
        if bytes.starts_with(b"AutoCAD Binary DXF") || text.lines().count() < 40 {
            continue;
        }
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        let plain = read(&bytes);
        // A word in place of a number, in the middle of the entities.
        let lines: Vec<&str> = text.lines().collect();
        let begin = lines.iter().position(|line| line.trim() == "ENTITIES").unwrap_or(0);
        let codes = (begin + 1..lines.len().saturating_sub(1)).step_by(2);
        let Some(code) = codes.filter(|n| lines[*n].trim() == "10").nth(1) else { continue };
        let mut broken: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
        broken[code + 1] = "twelve".into();
        let told = read(broken.join("\n").as_bytes());
        let line = code as u32 + 2;
        let found = told.findings.iter().any(|f| f.line == line && f.text.contains("twelve"));
        let skipped = told.drawing.shapes.len() == plain.drawing.shapes.len();
        assert!(found || skipped, "{name}:{line}: {:?}", told.findings);
        assert!(told.drawing.shapes.len() <= plain.drawing.shapes.len(), "{name}: invented");
        // The end is missing.
        let cut = read(&bytes[..bytes.len() / 2]);
        assert!(cut.drawing.shapes.len() <= plain.drawing.shapes.len(), "{name}: invented");
    }
}
