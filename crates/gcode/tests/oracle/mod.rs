//! The same canonical moves as LinuxCNC's stand-alone interpreter `rs274`, where it is installed
//! (Debian package `linuxcnc-uspace`). Differences that are meant stand in `docs/gcode-differences.md`.
//!
//! `rs274` writes four decimals in the unit of the file. Generated programs are therefore ten thousand
//! times larger than a part, so that what is compared is a part to a millionth of a millimetre.

mod canon;
mod compare;
mod generate;
mod written;

use crate::find;
use crate::support::Quiet;
use canon::Move;
use compare::difference;
use generate::{PROGRAMS, SCALE, compensated, generated};
use kerf_gcode::{Interpreter, Options, Session, read};
use kerf_program::settings::{AxisUnit, LinearUnit};
use kerf_program::{Axes, Command as Given, MoveKind, Step, Tool};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Tools known to both: number, length and diameter in mm, for programs of a size.
fn tools(scale: f64) -> impl Iterator<Item = (u32, f64, f64)> {
    let n = (1..30).map(|n| (n, f64::from(n)));
    n.map(move |(number, n)| (number, n * 12.7 * scale, (0.254 + n * 0.0254) * scale))
}

fn is_installed() -> bool {
    Command::new("rs274").arg("-h").output().is_ok()
}

/// Moves that the other interpreter makes of a file; an error when it finds one or takes too long.
fn theirs(file: &Path, folder: &Path, scale: f64) -> Result<Vec<Move>, String> {
    let (table, out) = (folder.join("tool.tbl"), folder.join("out.txt"));
    // The table is in inches. Programs that just stop are ended, which it asks for.
    let tools = tools(scale).map(|(n, z, d)| format!("T{n} P{n} Z{} D{} ;\n", z / 25.4, d / 25.4));
    std::fs::write(&table, tools.collect::<String>()).unwrap();
    let mut bytes = std::fs::read(file).unwrap();
    bytes.extend_from_slice(b"\nM2\n");
    let file = &folder.join("in.ngc");
    std::fs::write(file, bytes).unwrap();
    let _ = std::fs::remove_file(folder.join("rs274ngc.var"));
    let done = Command::new("timeout")
        .args(["10", "rs274", "-g", "-n", "2", "-t"])
        .args([&table, file, &out])
        .current_dir(folder)
        // It keeps its tools in the home folder, where two at once disturb each other.
        .env("HOME", folder)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    let said: Vec<&str> = said.lines().filter(|l| *l != "executing").collect();
    if !said.is_empty() || !done.status.success() {
        return Err(said.join(" / "));
    }
    Ok(canon::parse(&std::fs::read_to_string(out).unwrap()))
}

/// Moves that Kerf makes of a file.
fn ours(file: &Path, scale: f64) -> Result<Vec<Move>, String> {
    let program = read("oracle.ngc".into(), &std::fs::read(file).unwrap());
    if let Some(error) = program.diagnostics.iter().find(|d| d.is_error()) {
        return Err(format!("{} line {}: {}", error.code, error.place.line, error.message));
    }
    let mut session = Session::default();
    session.settings.linear_unit = LinearUnit::Mm;
    session.settings.axis_count = 6;
    session.settings.rotary_units = [AxisUnit::Degrees; 3];
    for (number, z, diameter_mm) in tools(scale) {
        let offset = Axes::xyz(0.0, 0.0, z);
        let tool = Tool { diameter_mm, offset, ..Tool::default() };
        session.state.tools.insert(number, tool);
    }
    let options = Options { preview: true, max_lines: 2_000_000, ..Options::default() };
    let mut interpreter = Interpreter::new(program, session, options);
    let mut host = Quiet(file.parent().map(PathBuf::from).unwrap_or_default());
    let mut out = Vec::new();
    loop {
        if let Step::Done(_, error) = interpreter.run(&mut host, &mut out, 4096) {
            return match error {
                Some(e) => Err(format!("{} line {}: {}", e.code, e.place.line, e.message)),
                None => Ok(out.iter().filter_map(|s| as_move(&s.command)).collect()),
            };
        }
    }
}

fn as_move(command: &Given) -> Option<Move> {
    match command {
        Given::Line(l) => Some(Move::Straight { jog: l.kind == MoveKind::Jog, to: l.to.0 }),
        Given::Arc(a) => Some(Move::Arc {
            to: a.to.0,
            centre: a.centre,
            turns: a.sweep_rad / std::f64::consts::TAU,
        }),
        _ => None,
    }
}

/// Files of the corpus whose difference is meant, with the reason.
const MEANT: [(&str, &str); 3] = [
    ("cycles.nc", "R and depth of a cycle stay when the next one has another code"),
    ("linuxcnc__raster_test.ngc", "M11 is refused there and does nothing here"),
    (
        "linuxcnc__skeleton.ngc",
        "stand-alone, it forgets the tool's length at M6 with G43 in one block",
    ),
];

#[test]
fn real_files_give_the_moves_of_rs274() {
    if !is_installed() {
        println!("skipped: rs274 (Debian package linuxcnc-uspace) is not installed");
        return;
    }
    let scratch = tempfile::tempdir().unwrap();
    let (mut compared, mut bad) = (0, Vec::new());
    for file in find::all("gcode") {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        let small = std::fs::metadata(&file).unwrap().len() < 400_000;
        if !small || MEANT.iter().any(|(meant, _)| *meant == name) {
            continue;
        }
        match (ours(&file, 1.0), theirs(&file, scratch.path(), 1.0)) {
            (Ok(a), Ok(b)) => {
                compared += 1;
                if let Some(found) = difference(&a, &b) {
                    bad.push(format!("{name}: {found}"));
                }
            }
            (Err(_), Err(_)) => {}
            (Err(a), Ok(_)) => bad.push(format!("{name}: only ours fails: {a}")),
            (Ok(_), Err(b)) => bad.push(format!("{name}: only theirs fails: {b}")),
        }
    }
    println!("{compared} files compared");
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

#[test]
fn generated_programs_give_the_moves_of_rs274() {
    if !is_installed() {
        println!("skipped: rs274 (Debian package linuxcnc-uspace) is not installed");
        return;
    }
    let scratch = tempfile::tempdir().unwrap();
    let file = scratch.path().join("generated.ngc");
    let (mut both, mut bad) = (0, Vec::new());
    // SEED=207 shows one of them.
    let only = std::env::var("SEED").ok().and_then(|s| s.parse().ok());
    for seed in only.map_or(0..PROGRAMS, |s: u64| s..s + 1) {
        let text = if seed % 3 == 2 { compensated(seed) } else { generated(seed) };
        std::fs::write(&file, &text).unwrap();
        let found = match (ours(&file, SCALE), theirs(&file, scratch.path(), SCALE)) {
            (Ok(a), Ok(b)) => {
                both += 1;
                difference(&a, &b)
            }
            (Err(_), Err(_)) => None,
            (a, b) => Some(format!("ours {:?}, theirs {:?}", a.err(), b.err())),
        };
        if only.is_some() {
            println!("{text}");
        }
        bad.extend(found.map(|f| format!("seed {seed}: {f}")));
    }
    println!("{both} programs compared");
    assert!(bad.is_empty(), "{} of {PROGRAMS} differ\n{}", bad.len(), bad.join("\n"));
    assert!(only.is_some() || both > PROGRAMS / 2, "{both}");
}

#[test]
fn programs_by_hand_give_the_moves_of_rs274() {
    if !is_installed() {
        println!("skipped: rs274 (Debian package linuxcnc-uspace) is not installed");
        return;
    }
    let scratch = tempfile::tempdir().unwrap();
    let file = scratch.path().join("written.ngc");
    let mut bad = Vec::new();
    for (about, blocks) in written::WRITTEN {
        std::fs::write(&file, written::whole(blocks)).unwrap();
        let found = match (ours(&file, SCALE), theirs(&file, scratch.path(), SCALE)) {
            (Ok(a), Ok(b)) if b.len() > 3 => difference(&a, &b),
            (a, b) => Some(format!("ours {:?}, theirs {:?}", a.err(), b.err())),
        };
        bad.extend(found.map(|f| format!("{about}: {f}")));
    }
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}
