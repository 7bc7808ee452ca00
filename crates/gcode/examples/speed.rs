//! How fast G-code is read and interpreted: `cargo run --release -p kerf-gcode --example speed`.
//!
//! Prints lines a second on one core for a million G1 lines, a hundred thousand arcs and moves, and
//! for lines with expressions; the best of several runs counts. With files as arguments, those.
#![allow(clippy::print_stdout)]

use kerf_gcode::{Interpreter, Options, Session};
use kerf_program::Step;
use std::fmt::Write;
use std::time::Instant;
use support::Quiet;

#[path = "../tests/support/mod.rs"]
mod support;

fn main() {
    let files: Vec<String> = std::env::args().skip(1).collect();
    for file in &files {
        if let Ok(text) = std::fs::read_to_string(file) {
            report(file, &text);
        }
    }
    if files.is_empty() {
        report("G1 X Y Z", &moves(1_000_000));
        report("G2/G3 and G1", &arcs(100_000));
        report("laser, S", &raster(1_000_000));
        report("expressions", &expressions(100_000));
    }
}

fn moves(lines: u32) -> String {
    let mut text = String::from("G21 G90\nF1000\n");
    for i in 0..lines {
        let t = f64::from(i) * 0.001;
        let (x, y, z) = (100.0 + 50.0 * t.sin(), 100.0 + 50.0 * t.cos(), -2.0 * (t * 7.0).sin());
        _ = writeln!(text, "G1 X{x:.4} Y{y:.4} Z{z:.4}");
    }
    text
}

fn arcs(lines: u32) -> String {
    let mut text = String::from("G21 G90\nF1000\nG0 X0 Y0\n");
    for i in 0..lines / 2 {
        let x = f64::from(i) * 0.01;
        _ = writeln!(text, "G{} X{:.4} Y1.0000 I0.5000 J0.5000", 2 + i % 2, x + 1.0);
        _ = writeln!(text, "G1 X{:.4} Y0.0000", x + 0.01);
    }
    text
}

fn raster(lines: u32) -> String {
    let mut text = String::from("G21 G90\nG1 F1000\n");
    for i in 0..lines {
        _ = writeln!(text, "X{:.2} S{}", f64::from(i) * 0.1, i * 37 % 1000);
    }
    text
}

fn expressions(lines: u32) -> String {
    let mut text = String::from("G21 G90\nF1000\n#<step>=0.5\n");
    for i in 0..lines / 2 {
        _ = writeln!(text, "#1=[#<step> * {i} + 2]");
        _ = writeln!(text, "G1 X[#1 / 2] Y[SIN[#1] * 10]");
    }
    text
}

fn report(name: &str, text: &str) {
    let (mut best, mut reading, mut lines, mut commands) = (f64::INFINITY, 0.0, 0, 0);
    for _ in 0..5 {
        let start = Instant::now();
        let program = kerf_gcode::read("speed.ngc".into(), text.as_bytes());
        let read = start.elapsed().as_secs_f64();
        let mut interpreter = Interpreter::new(program, Session::default(), Options::default());
        let mut out = Vec::new();
        commands = 0;
        while interpreter.run(&mut Quiet::default(), &mut out, 4096) == Step::Ran {
            commands += out.len();
            out.clear();
        }
        commands += out.len();
        let all = start.elapsed().as_secs_f64();
        if all < best {
            (best, reading) = (all, read);
        }
        lines = interpreter.lines();
    }
    println!(
        "{name:14} {lines:8} lines {commands:8} commands: {:7.1} ms (reading {:6.1} ms), {:6.2} million lines/s",
        best * 1e3,
        reading * 1e3,
        lines as f64 / best / 1e6,
    );
}
