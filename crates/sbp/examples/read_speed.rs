//! How fast part files are read: `cargo run --release -p kerf-sbp --example read_speed`.
//!
//! Prints lines a second for a million plain moves and for a hundred thousand lines of variables,
//! conditions and computed moves; each is read several times and the best time counts. A word as
//! argument chooses the files whose name contains it.
#![allow(clippy::print_stdout)]

use std::fmt::Write;
use std::time::Instant;

fn main() {
    let wanted = std::env::args().nth(1).unwrap_or_default();
    let files: [(&str, Make); 3] = [
        ("M3,x,y,z", || moves(1_000_000, "M3,", ",")),
        ("M3 x, y, z", || moves(1_000_000, "M3 ", ", ")),
        ("expressions", || expressions(100_000)),
    ];
    for (name, text) in files.into_iter().filter(|(name, _)| name.contains(&wanted)) {
        report(name, &text());
    }
}

/// Makes the text of a file.
type Make = fn() -> String;

/// Lines as a CAM program writes them.
fn moves(lines: u32, head: &str, comma: &str) -> String {
    let mut text = String::new();
    for i in 0..lines {
        let t = f64::from(i) * 0.001;
        let (x, y, z) = (20.0 + 15.0 * t.sin(), 20.0 + 15.0 * t.cos(), -0.25 * (t * 7.0).sin());
        _ = writeln!(text, "{head}{x:.4}{comma}{y:.4}{comma}{z:.4}");
    }
    text
}

/// Lines as people write them.
fn expressions(lines: u32) -> String {
    let mut text = String::new();
    for i in 0..lines / 5 {
        _ = writeln!(text, "&x{} = (&start_x + {i} * 0.25) / 2 - %(1)", i % 90);
        _ = writeln!(text, "IF &x{} > {i}.5 THEN GOTO Done", i % 90);
        _ = writeln!(text, "M2, &x{} + &step * 2, SQR(&y * &y + 4)", i % 90);
        _ = writeln!(text, "IF %(25) = 1 THEN &units = \"mm \" & &name");
        _ = writeln!(text, "MZ, &depth - .125   'one level down");
    }
    text.push_str("Done:\n");
    text
}

fn report(name: &str, text: &str) {
    let mut best = f64::INFINITY;
    let mut lines = 0;
    for _ in 0..15 {
        let start = Instant::now();
        let program = kerf_sbp::read("speed.sbp".into(), text.as_bytes());
        best = best.min(start.elapsed().as_secs_f64());
        assert!(program.diagnostics.is_empty(), "{:?}", program.diagnostics.first());
        lines = program.lines.len();
    }
    let megabytes = text.len() as f64 / 1e6;
    println!(
        "{name:12} {lines:8} lines {megabytes:6.1} MB {:7.2} ms {:6.2} million lines/s {:5.0} MB/s",
        best * 1e3,
        lines as f64 / best / 1e6,
        megabytes / best,
    );
}
