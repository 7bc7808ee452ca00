//! The part files that are measured: made here, the same on every machine, or real ones when they
//! lie beside the checkout.

use crate::shared::shared;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

/// A named part file, or several.
#[derive(Debug)]
pub struct Input {
    /// Its name in the tables.
    pub name: &'static str,
    /// Content, for people.
    pub about: &'static str,
    /// Names and bytes of the files; one, but for the corpus.
    pub files: Vec<(String, Vec<u8>)>,
}

impl Input {
    fn made(name: &'static str, about: &'static str, text: String) -> Self {
        Self { name, about, files: vec![(format!("{name}.sbp"), text.into_bytes())] }
    }

    /// Lines of all files.
    pub fn lines(&self) -> u64 {
        self.files
            .iter()
            .map(|(_, bytes)| kerf_sbp::read("".into(), &**bytes).lines.len() as u64)
            .sum()
    }

    /// Bytes of all files.
    pub fn bytes(&self) -> usize {
        self.files.iter().map(|(_, bytes)| bytes.len()).sum()
    }
}

/// Every input whose name contains a word.
pub fn inputs(word: &str) -> Vec<Input> {
    let makers: [fn() -> Option<Input>; 5] = [
        || Some(Input::made("m3-1m", "1,000,000 lines M3,x,y,z; 4 decimals", moves(1_000_000))),
        || {
            let about = "the same with blanks, comments and empty lines";
            Some(Input::made("m3-blanks-1m", about, moves_with_blanks(1_000_000)))
        },
        || {
            let about = "100,000 lines: expressions, IF, GOTO, labels, some moves; 2 of 10 lines are jumped over";
            Some(Input::made("logic-100k", about, logic(100_000)))
        },
        || Some(Input::made("arcs-100k", "100,000 lines CG: half circles", arcs(100_000))),
        corpus,
    ];
    let names = ["m3-1m", "m3-blanks-1m", "logic-100k", "arcs-100k", "corpus"];
    let wanted = names.iter().zip(makers).filter(|(name, _)| name.contains(word));
    wanted.filter_map(|(_, make)| make()).collect()
}

/// A wavy groove round and round a circle: no two lines alike, the direction changes everywhere.
fn place(i: u32) -> [f64; 3] {
    let t = f64::from(i) * 0.001;
    [20.0 + 15.0 * t.sin(), 20.0 + 15.0 * t.cos(), -0.25 * (t * 7.0).sin()]
}

fn moves(lines: u32) -> String {
    let mut text = String::new();
    for i in 0..lines {
        let [x, y, z] = place(i);
        _ = writeln!(text, "M3,{x:.4},{y:.4},{z:.4}");
    }
    text
}

fn moves_with_blanks(lines: u32) -> String {
    let mut text = String::new();
    for i in 0..lines {
        let [x, y, z] = place(i);
        _ = match i % 20 {
            0 => writeln!(text, "' pass {}", i / 20),
            1 => writeln!(text),
            2..6 => writeln!(text, "  M3, {x:.4}, {y:.4}, {z:.4}   ' {i}"),
            _ => writeln!(text, "M3 {x:.4}, {y:.4}, {z:.4}"),
        };
    }
    text
}

/// Writes blocks of ten lines that compute and jump; what the lines of a block share is the number of the block.
fn logic(lines: u32) -> String {
    let mut text =
        String::from("&start_x = 1.5\n&count = 0\n&y = 2\n&depth = -0.125\n&name = \"part\"\n");
    for i in 0..lines / 10 {
        let v = i % 90;
        _ = write!(
            text,
            "&x{v} = (&start_x + {v} * 0.25) / 2 - &y\n\
             IF &x{v} > {v}.5 THEN &y = &y + 1\n\
             IF &x{v} <= 3 THEN GOTO Low{i}\n\
             &z = SQR(&x{v} * &x{v} + 4) / ABS(&y + 1)\n\
             M2, &x{v} + {i} / 1000, &z\n\
             Low{i}:\n\
             &count = &count + 1\n\
             IF %(25) = 1 THEN &unit = \"mm \" & &name\n\
             M3, {v} / 10, , &depth - .125   'one level down\n\
             IF &count < 0 THEN GOTO Low{i}\n"
        );
    }
    text
}

/// Rows of half circles, to the left and to the right.
fn arcs(lines: u32) -> String {
    let mut text = String::new();
    for i in 0..lines {
        let (row, column) = (i / 500, i % 500);
        let step = if row % 2 == 0 { 0.05 } else { -0.05 };
        let place = if row % 2 == 0 { column + 1 } else { 499 - column };
        let turn = if column % 2 == 0 { 1 } else { -1 };
        let x = f64::from(place) * 0.05;
        _ = writeln!(text, "CG,,{x:.4},{:.4},{:.4},0,T,{turn}", f64::from(row) * 0.001, step / 2.0);
    }
    text
}

/// Real part files, in order of names.
fn corpus() -> Option<Input> {
    let folder = shared("corpus/sbp")?;
    let mut paths: Vec<PathBuf> = fs::read_dir(folder).ok()?.flatten().map(|e| e.path()).collect();
    paths.sort();
    let name = |path: &PathBuf| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let files = paths.iter().filter_map(|path| Some((name(path), fs::read(path).ok()?))).collect();
    Some(Input { name: "corpus", about: "real part files, each by itself", files })
}
