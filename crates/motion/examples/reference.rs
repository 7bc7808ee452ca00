//! Times of the `optimal` model on the reference programs, beside what a perfect planner with
//! parabolic blends needs.
//!
//! `cargo run --release -p kerf-motion --example reference`
#![allow(clippy::print_stdout)]

use kerf_motion::{Model, Move, Mover, Optimal, Plan};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, Settings};
use std::path::PathBuf;
use std::time::Instant;

fn folder() -> Option<PathBuf> {
    let shared = std::env::var_os("KERF_SHARED").map(PathBuf::from);
    let here = std::env::current_dir().ok()?;
    let beside = here.ancestors().map(|a| a.join("../shared"));
    shared.into_iter().chain(beside).map(|s| s.join("anchors/motion")).find(|f| f.is_dir())
}

fn moves(text: &str) -> Vec<Move> {
    let places: Vec<Axes> = text
        .lines()
        .map(|l| {
            let v: Vec<f64> = l.split_whitespace().filter_map(|w| w.parse().ok()).collect();
            Axes::xyz(v[0], v[1], v[2])
        })
        .collect();
    let mut mover = Mover::new(places[0], &Settings::default());
    let line = |to: &Axes| Line { kind: MoveKind::Cut, to: *to, feed: Feed::Path(100.0) };
    places[1..].iter().filter_map(|to| mover.line(At::default(), &line(to))).collect()
}

/// Greatest ratio of acceleration and jerk to their limits, sampled.
fn worst(plan: &Plan, d: &Dynamics) -> [f64; 3] {
    let step = 1e-4;
    let n = (plan.duration_s() / step) as usize;
    let mut worst = [0.0f64; 3];
    let mut before = plan.at(0.0);
    for k in 1..n {
        let s = plan.at(k as f64 * step);
        let v: f64 = s.velocity.0[..3].iter().map(|v| v * v).sum();
        worst[0] = worst[0].max(v.sqrt() / 100.0);
        for axis in 0..3 {
            worst[1] = worst[1].max(s.acceleration.0[axis].abs() / d.accel_mm_s2.0[axis]);
            let j = (s.acceleration.0[axis] - before.acceleration.0[axis]) / step;
            worst[2] = worst[2].max(j.abs() / 10_000.0);
        }
        before = s;
    }
    worst
}

fn main() {
    let Some(folder) = folder() else {
        println!("skipped: no reference programs beside the checkout");
        return;
    };
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e == "xyz"));
    files.sort();
    let only_jerk = std::env::args().nth(1).is_some();
    for (tolerance_mm, jerk) in [(0.01, None), (0.05, None), (0.5, None), (0.01, Some(10_000.0))] {
        for file in &files {
            if only_jerk && jerk.is_none() {
                continue;
            }
            let moves = moves(&std::fs::read_to_string(file).unwrap());
            let d = Dynamics {
                speed_mm_s: Axes::splat(200.0),
                accel_mm_s2: Axes::splat(500.0),
                jerk_mm_s3: jerk.map(Axes::splat),
                tolerance_mm,
            };
            let copy = moves.clone();
            let start = Instant::now();
            let plan = Optimal { dynamics: &d }.plan(copy);
            let took = start.elapsed().as_secs_f64();
            let w = if plan.duration_s() < 1e3 { worst(&plan, &d) } else { [0.0; 3] };
            println!(
                "{:24} {tolerance_mm} {:9.4} s  {:5.2} M/s  v {:.5} a {:.5} j {:.2}",
                file.file_stem().unwrap().to_string_lossy(),
                plan.duration_s(),
                moves.len() as f64 / took / 1e6,
                w[0],
                w[1],
                w[2]
            );
        }
    }
}
