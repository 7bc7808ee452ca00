//! The same canonical moves as LinuxCNC's stand-alone interpreter `rs274`, where it is installed
//! (Debian package `linuxcnc-uspace`). Differences that are meant stand in `docs/gcode-differences.md`.
//!
//! `rs274` writes four decimals in the unit of the file, so that is how close places are compared.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

mod support;

use kerf_gcode::{Interpreter, Options, Session, Tool, read};
use kerf_program::settings::LinearUnit;
use kerf_program::{Axes, Command as Given, MoveKind, Step};
use std::path::{Path, PathBuf};
use std::process::Command;
use support::Quiet;

/// Tools known to both: number, length and diameter in mm.
fn tools() -> impl Iterator<Item = (u32, f64, f64)> {
    (1..30).map(|n| (n, f64::from(n) * 12.7, 0.254 + f64::from(n) * 0.0254))
}

/// A move in the machine frame, mm.
#[derive(Clone, Debug)]
enum Move {
    Straight {
        jog: bool,
        to: [f64; 6],
    },
    Arc {
        to: [f64; 6],
        centre: [f64; 2],
        turns: f64,
    },
    /// An arc in another plane, or a curve: only its end is compared.
    Other {
        to: [f64; 6],
    },
}

impl Move {
    fn to(&self) -> &[f64; 6] {
        match self {
            Self::Straight { to, .. } | Self::Arc { to, .. } | Self::Other { to } => to,
        }
    }
}

/// Two of them at once disturb each other.
static ALONE: std::sync::Mutex<()> = std::sync::Mutex::new(());

fn is_installed() -> bool {
    Command::new("rs274").arg("-h").output().is_ok()
}

/// What the other interpreter makes of a file; `None` when it finds an error or takes too long.
fn theirs(file: &Path, folder: &Path) -> Result<Vec<Move>, String> {
    let _alone = ALONE.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let (table, out) = (folder.join("tool.tbl"), folder.join("out.txt"));
    // The table is in inches. Programs that just stop are ended, which it asks for.
    let tools = tools().map(|(n, z, d)| format!("T{n} P{n} Z{} D{} ;\n", z / 25.4, d / 25.4));
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
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    let said: Vec<&str> = said.lines().filter(|l| *l != "executing").collect();
    if !said.is_empty() || !done.status.success() {
        return Err(said.join(" / "));
    }
    Ok(parse(&std::fs::read_to_string(out).unwrap()))
}

/// The canonical calls as moves of the machine.
fn parse(text: &str) -> Vec<Move> {
    let mut state = Canon { unit: 1.0, ..Canon::default() };
    let mut moves = Vec::new();
    for line in text.lines() {
        let Some((head, rest)) = line.split_once('(') else { continue };
        let name = head.rsplit(' ').next().unwrap_or_default();
        let numbers: Vec<f64> =
            rest.split([',', ')', ' ']).filter_map(|n| n.trim().parse().ok()).collect();
        let six = |from: usize| -> [f64; 6] {
            std::array::from_fn(|i| numbers.get(from + i).copied().unwrap_or_default())
        };
        match name {
            "USE_LENGTH_UNITS" => {
                let unit = if rest.contains("INCHES") { 25.4 } else { 1.0 };
                state.unit = unit;
            }
            "SET_G5X_OFFSET" => state.g5x = state.mm(six(1)),
            "SET_G92_OFFSET" => state.g92 = state.mm(six(0)),
            "SET_XY_ROTATION" => state.rotation = numbers[0],
            "USE_TOOL_LENGTH_OFFSET" => state.tool = state.mm(six(0)),
            "SELECT_PLANE" => state.plane = rest.trim_end_matches(')').to_owned(),
            "STRAIGHT_TRAVERSE" => {
                moves.push(Move::Straight { jog: true, to: state.machine(six(0)) });
            }
            "STRAIGHT_FEED" | "STRAIGHT_PROBE" => {
                moves.push(Move::Straight { jog: false, to: state.machine(six(0)) });
            }
            "ARC_FEED" => moves.push(state.arc(&numbers)),
            _ => {}
        }
    }
    moves
}

#[derive(Default)]
struct Canon {
    unit: f64,
    g5x: [f64; 6],
    g92: [f64; 6],
    rotation: f64,
    tool: [f64; 6],
    plane: String,
    last: std::cell::Cell<[f64; 6]>,
}

impl Canon {
    fn mm(&self, mut values: [f64; 6]) -> [f64; 6] {
        values[..3].iter_mut().for_each(|v| *v *= self.unit);
        values
    }

    fn machine(&self, values: [f64; 6]) -> [f64; 6] {
        let place = self.mm(values);
        let mut p: [f64; 6] = std::array::from_fn(|i| place[i] + self.g92[i]);
        let (sin, cos) = self.rotation.to_radians().sin_cos();
        (p[0], p[1]) = (p[0] * cos - p[1] * sin, p[0] * sin + p[1] * cos);
        let p = std::array::from_fn(|i| p[i] + self.g5x[i] + self.tool[i]);
        self.last.set(p);
        p
    }

    fn arc(&self, n: &[f64]) -> Move {
        let mut to = [0.0, 0.0, 0.0, n[6], n[7], n[8]];
        let axes = if self.plane.contains("XZ") {
            [2, 0, 1]
        } else if self.plane.contains("YZ") {
            [1, 2, 0]
        } else {
            [0, 1, 2]
        };
        (to[axes[0]], to[axes[1]], to[axes[2]]) = (n[0], n[1], n[5]);
        let end = self.machine(to);
        if axes[2] != 2 {
            return Move::Other { to: end };
        }
        let mut centre = to;
        (centre[0], centre[1]) = (n[2], n[3]);
        let centre = self.machine(centre);
        self.last.set(end);
        Move::Arc { to: end, centre: [centre[0], centre[1]], turns: n[4] }
    }
}

/// What Kerf makes of a file.
fn ours(file: &Path) -> Result<Vec<Move>, String> {
    let program = read("oracle.ngc".into(), &std::fs::read(file).unwrap());
    if let Some(error) = program.diagnostics.iter().find(|d| d.is_error()) {
        return Err(format!("{} line {}: {}", error.code, error.place.line, error.message));
    }
    let mut session = Session::default();
    session.settings.linear_unit = LinearUnit::Mm;
    session.settings.axis_count = 6;
    for (number, z, diameter_mm) in tools() {
        let tool = Tool { diameter_mm, offset: Axes::xyz(0.0, 0.0, z) };
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

/// How far places may be apart, mm: rounding to four decimals of an inch, of place and offsets.
const CLOSE_MM: f64 = 0.006;

fn close(a: &[f64; 6], b: &[f64; 6]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < CLOSE_MM)
}

/// The first difference between two lists of moves.
fn difference(ours: &[Move], theirs: &[Move]) -> Option<String> {
    let (mut i, mut j) = (0, 0);
    let mut at = [0.0; 6];
    loop {
        let still = |m: Option<&Move>, at: &[f64; 6]| {
            m.is_some_and(|m| matches!(m, Move::Straight { to, .. } if close(to, at)))
        };
        // Moves that go nowhere are given by one and not by the other.
        while still(theirs.get(j), &at) && !same(ours.get(i), theirs.get(j)) {
            j += 1;
        }
        while still(ours.get(i), &at) && !same(ours.get(i), theirs.get(j)) {
            i += 1;
        }
        match (ours.get(i), theirs.get(j)) {
            (None, None) => return None,
            (Some(_), Some(Move::Other { to })) => {
                // Chords stand for it; the last of them ends where it ends.
                let chords = ours[i..].iter().position(|m| close(m.to(), to));
                let Some(chords) = chords else {
                    return Some(format!("no end of {:?}", theirs[j]));
                };
                i += chords;
            }
            (a, b) if same(a, b) => {}
            (a, b) => return Some(format!("move {j}: ours {a:?}, theirs {b:?}, from {at:?}")),
        }
        at = *theirs[j].to();
        i += 1;
        j += 1;
    }
}

fn same(a: Option<&Move>, b: Option<&Move>) -> bool {
    match (a, b) {
        (Some(Move::Straight { jog: a, to: p }), Some(Move::Straight { jog: b, to: q })) => {
            a == b && close(p, q)
        }
        (
            Some(Move::Arc { to: p, centre: c, turns: a }),
            Some(Move::Arc { to: q, centre: d, turns: b }),
        ) => {
            // They count whole turns: 1 is anything up to a turn.
            let near = (c[0] - d[0]).hypot(c[1] - d[1]) < CLOSE_MM;
            close(p, q) && near && (a.abs() - 1e-6).ceil() == b.abs() && a.signum() == b.signum()
        }
        _ => false,
    }
}

fn corpus() -> Option<PathBuf> {
    if let Some(shared) = std::env::var_os("KERF_SHARED") {
        return Some(PathBuf::from(shared).join("corpus/gcode")).filter(|p| p.is_dir());
    }
    let here = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().map(|a| a.join("../shared/corpus/gcode")).find(|p| p.is_dir())
}

/// Files of the corpus whose difference is meant, with the reason.
const MEANT: [(&str, &str); 2] = [
    ("linuxcnc__raster_test.ngc", "M11 is refused there and does nothing here"),
    (
        "linuxcnc__skeleton.ngc",
        "stand-alone, it forgets the tool's length at M6 with G43 in one block",
    ),
];

#[test]
fn real_files_give_the_moves_of_rs274() {
    let Some(folder) = corpus() else {
        println!("skipped: no corpus");
        return;
    };
    if !is_installed() {
        println!("skipped: rs274 (Debian package linuxcnc-uspace) is not installed");
        return;
    }
    let scratch = tempfile::tempdir().unwrap();
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    let (mut compared, mut bad) = (0, Vec::new());
    for file in files {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        let small = std::fs::metadata(&file).unwrap().len() < 400_000;
        if !small || MEANT.iter().any(|(meant, _)| *meant == name) {
            continue;
        }
        match (ours(&file), theirs(&file, scratch.path())) {
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

/// A small generator of numbers: the same on every machine.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % sides
    }
    fn number(&mut self) -> f64 {
        (self.roll(20_001) as f64 - 10_000.0) / 1000.0
    }
}

/// A program of random blocks that are all allowed.
fn generated(seed: u64) -> String {
    let mut dice = Dice(seed);
    let mut text = String::from("G21 G90 G94 G17 F100 S100 M3\nG0 X1 Y2 Z3\n");
    for _ in 0..40 {
        let (a, b, c) = (dice.number(), dice.number(), dice.number());
        let block = match dice.roll(26) {
            0..=3 => format!("G1 X{a} Y{b}"),
            4 => format!("G0 X{a} Z{c}"),
            5 => format!("G1 A{a} B{b} C{c}"),
            // With a tool offset in force it keeps the number when the unit changes.
            6 => format!("G49\nG20 G0 X{a}"),
            7 => format!("G49\nG21 G1 Y{b}"),
            8 => format!("G91 G1 X{a} Y{b}\nZ{c}\nG90"),
            9 => format!("G91 G2 X{a} Y{b} R{}", a.hypot(b) * 0.7 + 0.1),
            10 => format!("G91 G3 X{a} Y{b} R-{}", a.hypot(b) * 0.9 + 0.1),
            11 => format!("G91\nG3 X{a} Y{a} I{a} J0 Z{c} P{}\nG90", 1 + dice.roll(3)),
            12 => format!("G2 I{a} J{b}"),
            13 => format!("G18 G91 G2 X{a} Z{a} I{a} K0\nG17 G90"),
            14 => format!("G19 G91 G3 Y{a} Z{a} J{a} K0\nG17 G90"),
            15 => format!("G10 L2 P{} X{a} Y{b} Z{c}", 1 + dice.roll(9)),
            16 => format!("G10 L20 P{} X{a} Y{b}", 1 + dice.roll(9)),
            17 => format!("G5{}\nG0 X{a}", 4 + dice.roll(6)),
            18 => format!("G92 X{a} Z{c}\nG0 X{b}"),
            19 => ["G92.1", "G92.2", "G92.3"][dice.roll(3) as usize].into(),
            20 => format!("G10 L2 P0 R{}\nG0 X{a} Y{b}", dice.roll(360)),
            21 => format!("G52 X{a}\nG1 Y{b}"),
            22 => format!("G43 H{}\nG0 Z{c}", 1 + dice.roll(9)),
            23 => format!("G49\nG0 Z{c}"),
            24 => cycle(&mut dice),
            _ => format!("G53 G0 X{a} Z{c}"),
        };
        text.push_str(&block.replace("--", ""));
        text.push('\n');
        if block.starts_with("G91") {
            text.push_str("G90\n");
        }
    }
    text + "M2\n"
}

fn cycle(dice: &mut Dice) -> String {
    let code = [73, 81, 82, 83, 84, 85, 86, 89][dice.roll(8) as usize];
    let (x, y, z) = (dice.number(), dice.number(), dice.number());
    let mut text = format!("G9{}\n", 8 + dice.roll(2));
    let word = match code {
        73 | 83 => format!("Q{}", 0.4 + dice.roll(30) as f64 / 10.0),
        82 | 84 | 86 | 89 => "P0.1".into(),
        _ => String::new(),
    };
    text += &format!("G{code} X{x} Y{y} Z{z} R{} {word}", z + 2.0);
    text += &format!("\nX{y}\nG91 Z-1.5 R0.5 X{x} L{} {word}\nG90 G80", 1 + dice.roll(3));
    text
}

/// A path of lines and arcs with compensation, most of which fits.
fn compensated(seed: u64) -> String {
    let mut dice = Dice(seed);
    let mut text = format!("G21 G90 G17 F100\nT{} M6\nG0 X0 Y0\n", 1 + dice.roll(20));
    text += &format!("G4{} G1 X20 Y{}\nG91\n", 1 + dice.roll(2), dice.number());
    for _ in 0..12 {
        let (a, b) = (dice.number() * 2.0, dice.number() * 2.0);
        text += &match dice.roll(6) {
            0..=2 => format!("G1 X{a} Y{b}\n"),
            3 => format!("G2 X{a} Y{b} R{}\n", a.hypot(b) * 0.8 + 2.0),
            4 => format!("G3 X{a} Y{b} R{}\n", a.hypot(b) * 0.6 + 2.0),
            _ => format!("G1 Z{a}\n"),
        };
    }
    text + "G90 G40\nG0 X0 Y0 Z9\nM2\n"
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
    for seed in 0..400 {
        let text = if seed % 3 == 2 { compensated(seed) } else { generated(seed) };
        std::fs::write(&file, &text).unwrap();
        let found = match (ours(&file), theirs(&file, scratch.path())) {
            (Ok(a), Ok(b)) => {
                both += 1;
                difference(&a, &b)
            }
            (Err(_), Err(_)) => None,
            (a, b) => Some(format!("ours {:?}, theirs {:?}", a.err(), b.err())),
        };
        if std::env::var("SHOW").is_ok_and(|s| s == seed.to_string()) {
            println!("{text}");
        }
        bad.extend(found.map(|f| format!("seed {seed}: {f}")));
    }
    println!("{both} programs compared");
    assert!(bad.is_empty(), "{} of 400 differ\n{}", bad.len(), bad.join("\n"));
    assert!(both > 75, "{both}");
}
