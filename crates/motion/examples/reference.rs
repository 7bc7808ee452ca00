//! Times of the `optimal` model on the reference programs, beside what a perfect planner with
//! parabolic blends needs (no limit of jerk) and what LinuxCNC's S-curve planner needs (10,000
//! mm/s³).
//!
//! `cargo run --release -p kerf-motion --example reference`
#![allow(clippy::print_stdout, clippy::unwrap_used)]

#[path = "../../../tests/corpus/shared.rs"]
mod shared;

use kerf_motion::{Model, Move, Mover, Optimal};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, Settings};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Tolerance, jerk, and the seconds to be reached on R1 … R7.
const TARGETS: [(f64, Option<f64>, [f64; 7]); 4] = [
    (0.01, None, [6.769, 3.340, 8.457, 16.772, 34.992, 72.168, 9.292]),
    (0.05, None, [6.730, 3.340, 8.457, 16.590, 34.043, 62.102, 9.174]),
    (0.5, None, [6.579, 3.340, 8.457, 14.289, 33.297, 44.514, 9.100]),
    (0.01, Some(10_000.0), [6.94, 14.5, 49.7, 23.5, 96.1, 118.2, 28.8]),
];

fn moves(file: &Path) -> Vec<Move> {
    let text = std::fs::read_to_string(file).unwrap();
    let place = |line: &str| {
        let v: Vec<f64> = line.split_whitespace().map(|w| w.parse().unwrap()).collect();
        Axes::xyz(v[0], v[1], v[2])
    };
    let places: Vec<Axes> = text.lines().map(place).collect();
    let mut mover = Mover::new(places[0], &Settings::default());
    let line = |to: &Axes| Line { kind: MoveKind::Cut, to: *to, feed: Feed::Path(100.0) };
    places[1..].iter().filter_map(|to| mover.line(At::default(), &line(to))).collect()
}

/// Plans several times; the time of the plan and the best time of planning, seconds.
fn plan(moves: &[Move], dynamics: &Dynamics) -> (f64, f64) {
    let mut best = f64::INFINITY;
    let mut duration_s = 0.0;
    for _ in 0..3 {
        let copy = moves.to_vec();
        let start = Instant::now();
        duration_s = Optimal { dynamics }.plan(copy).duration_s();
        best = best.min(start.elapsed().as_secs_f64());
    }
    (duration_s, best)
}

fn main() {
    let Some(folder) = shared::shared("anchors/motion") else {
        println!("skipped: no reference programs beside the checkout");
        return;
    };
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e == "xyz"));
    files.sort();
    for (tolerance_mm, jerk, targets) in TARGETS {
        println!("tolerance {tolerance_mm} mm, jerk {jerk:?}");
        let dynamics = Dynamics {
            speed_mm_s: Axes::splat(200.0),
            accel_mm_s2: Axes::splat(500.0),
            jerk_mm_s3: jerk.map(Axes::splat),
            tolerance_mm,
        };
        for (file, target) in files.iter().zip(targets) {
            let moves = moves(file);
            let (time, took) = plan(&moves, &dynamics);
            println!(
                "  {:24} {time:9.4} s  target {target:8.3}  ratio {:.4}  {:8.3} k moves/s",
                file.file_stem().unwrap().to_string_lossy(),
                time / target,
                moves.len() as f64 / took / 1e3
            );
        }
    }
}
