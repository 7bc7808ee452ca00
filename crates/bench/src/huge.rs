//! A program of ten million lines: how soon it moves, how long its estimate takes, in how much memory.

use crate::child::{self, What};
use crate::figure::{Figure, Goal};
use anyhow::{Context, Result};
use std::ffi::OsStr;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

const NAME: &str = "nc-10m";
const LINES: u32 = 10_000_000;

/// Runs after one to warm up.
const RUNS: usize = 3;

/// The first move is made within so many seconds of processor time.
const BEGINS_S: f64 = 2.0;

/// Memory that reading, planning and running may take, bytes: the text once, and little more.
const MOST_MEMORY: f64 = 3.5e8;

/// Measures; gives what is measured, and the figures: nothing when another input was asked for.
pub fn figures(word: &str) -> Result<(Vec<String>, Vec<Figure>)> {
    if !NAME.contains(word) {
        return Ok((Vec::new(), Vec::new()));
    }
    eprintln!("{NAME} …");
    let folder = tempfile::tempdir().context("no folder for part files")?;
    let file = folder.path().join("huge.nc");
    write(&file)?;
    let size = std::fs::metadata(&file)?.len() as f64 / 1e6;
    let about = format!(
        "- `{NAME}`: 10,000,000 lines G1 X Y Z of a 3D raster, 3 decimals ({size:.0} MB); *until it moves* is a \
         run that is stopped a tenth of a second after its first move began\n"
    );
    let begins = Goal::Within(BEGINS_S, MOST_MEMORY);
    let figures = vec![
        figure(
            &file,
            "kerf run, until it moves",
            &["run", "--stop-at", "0.1", "--quiet"],
            Some(begins),
        )?,
        figure(&file, "kerf time, shopbot", &["time", "--ramps", "shopbot"], None)?,
        figure(&file, "kerf time, optimal", &["time", "--ramps", "optimal"], None)?,
    ];
    Ok((vec![about], figures))
}

fn figure(file: &Path, stage: &'static str, words: &[&str], goal: Option<Goal>) -> Result<Figure> {
    let kerf = child::own()?.with_file_name("kerf");
    let mut arguments: Vec<&OsStr> = words.iter().map(OsStr::new).collect();
    arguments.push(file.as_os_str());
    let folder = file.parent().unwrap_or(file);
    let what = What { input: NAME, stage, count: u64::from(LINES), unit: "lines", goal };
    what.measured(RUNS, || child::run(&kerf, &arguments, folder))
}

/// Rows of 1,000 moves of half a millimetre over a hilly surface.
fn write(file: &Path) -> Result<()> {
    let mut out = BufWriter::with_capacity(1 << 20, File::create(file)?);
    writeln!(out, "G21 F3000")?;
    for k in 1..LINES {
        let (row, place) = (k / 1000, k % 1000);
        let along = if row % 2 == 0 { place } else { 999 - place };
        let (x, y) = (0.5 * f64::from(along), 0.5 * f64::from(row % 1000));
        let z = 3.0 * (x * 0.2).sin() * (y * 0.15).cos();
        writeln!(out, "G1X{x:.3}Y{y:.3}Z{z:.3}")?;
    }
    Ok(out.flush()?)
}
