//! G-code, read and interpreted, beside LinuxCNC's stand-alone interpreter on the same file in the
//! same run (`rs274`, Debian package `linuxcnc-uspace`, which `make bench` installs).

use crate::child;
use crate::figure::{Figure, Goal, Spread, timed};
use anyhow::{Context, Result};
use kerf_gcode::{Interpreter, Options, Session};
use kerf_program::Step;
use kerf_program::testing::Still;
use std::ffi::OsStr;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Lines between two looks at the commands.
const LINES_A_LOOK: u64 = 4096;

/// Runs of the other interpreter, which takes seconds.
const PEER_RUNS: usize = 3;

/// Factor by which Kerf has to be faster.
const TIMES: f64 = 20.0;

/// A file of G-code.
struct Input {
    name: &'static str,
    about: &'static str,
    text: fn() -> String,
}

const INPUTS: [Input; 2] = [
    Input { name: "g1-1m", about: "1,000,000 lines G1 X Y Z; 4 decimals", text: moves },
    Input { name: "g2-100k", about: "100,000 lines G2 and G3: half circles", text: arcs },
];

/// The figures of every input whose name contains a word, and lines about those inputs.
pub fn figures(word: &str) -> Result<(Vec<String>, Vec<Figure>)> {
    let (mut about, mut figures) = (Vec::new(), Vec::new());
    for input in INPUTS.iter().filter(|input| input.name.contains(word)) {
        let text = (input.text)();
        let megabytes = text.len() as f64 / 1e6;
        about.push(format!("- `{}`: {} ({megabytes:.1} MB)\n", input.name, input.about));
        let peer = peer(input, &text)?;
        figures.push(ours(input, &text, peer.as_ref().map(Figure::rate))?);
        figures.extend(peer);
    }
    Ok((about, figures))
}

fn ours(input: &Input, text: &str, peer: Option<f64>) -> Result<Figure> {
    let (count, cpu_s, wall_s) = timed(|| text, interpreted, |lines| *lines)?;
    Ok(Figure {
        input: input.name,
        stage: "read and interpret to commands",
        count,
        unit: "lines",
        cpu_s,
        wall_s,
        peak: None,
        goal: peer.map(|rate| Goal::Rate((TIMES * rate / 1e4).round() * 1e4)),
    })
}

/// Reads and interprets a text; gives the lines it executed.
fn interpreted(text: &str) -> u64 {
    let program = kerf_gcode::read("bench.ngc".into(), text.as_bytes());
    let mut interpreter = Interpreter::new(program, Session::default(), Options::default());
    let mut out = Vec::new();
    while interpreter.run(&mut Still, &mut out, LINES_A_LOOK) == Step::Ran {
        std::hint::black_box(&out);
        out.clear();
    }
    interpreter.lines()
}

/// The other interpreter on the same text; `None` where it is not installed.
fn peer(input: &Input, text: &str) -> Result<Option<Figure>> {
    if Command::new("rs274").arg("-h").output().is_err() {
        eprintln!("rs274 (Debian package linuxcnc-uspace) is not installed: no comparison");
        return Ok(None);
    }
    let folder = tempfile::tempdir().context("no folder for part files")?;
    let file = folder.path().join("in.ngc");
    fs::write(&file, text)?;
    let (tools, out) = (folder.path().join("tools.tbl"), folder.path().join("out.txt"));
    fs::write(&tools, "")?;
    let words = ["-g", "-n", "2", "-t"].map(OsStr::new);
    let files = [&tools, &file, &out].map(|p| p.as_os_str());
    let arguments: Vec<&OsStr> = words.into_iter().chain(files).collect();
    let taken = (0..PEER_RUNS).map(|_| child::run(Path::new("rs274"), &arguments, folder.path()));
    let taken = taken.collect::<Result<Vec<_>>>()?;
    Ok(Some(Figure {
        input: input.name,
        stage: "rs274 of LinuxCNC, a process",
        count: text.lines().count() as u64,
        unit: "lines",
        cpu_s: Spread::of(taken.iter().map(|t| t.cpu_s).collect()),
        wall_s: Spread::of(taken.iter().map(|t| t.seconds).collect()),
        peak: None,
        goal: None,
    }))
}

fn moves() -> String {
    let mut text = String::from("G21 G90\nF1000\n");
    for i in 0..1_000_000 {
        let t = f64::from(i) * 0.001;
        let (x, y, z) = (100.0 + 50.0 * t.sin(), 100.0 + 50.0 * t.cos(), -2.0 * (t * 7.0).sin());
        _ = writeln!(text, "G1 X{x:.4} Y{y:.4} Z{z:.4}");
    }
    text + "M2\n"
}

/// Half circles to the right and back, one above and one below.
fn arcs() -> String {
    let mut text = String::from("G21 G90\nF1000\nG0 X0 Y0\n");
    for i in 0..100_000 {
        let (x, centre) = if i % 2 == 0 { (5.0, 2.5) } else { (0.0, -2.5) };
        let y = f64::from(i / 2) * 0.0001;
        _ = writeln!(text, "G{} X{x:.4} Y{y:.4} I{centre:.4} J0.0000", 2 + i / 2 % 2);
    }
    text + "M2\n"
}
