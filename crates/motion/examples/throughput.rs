//! How many moves a second are made and planned: a million short 3D moves of a finishing raster.
//!
//! `cargo run --release -p kerf-motion --example throughput`
#![allow(clippy::print_stdout)]

use kerf_motion::{Move, Mover, Plan, plan_stack};
use kerf_program::settings::Ramps;
use kerf_program::{At, Axes, Feed, Line, MoveKind, Settings};
use std::time::Instant;

const MOVES: u32 = 1_000_000;

/// Rows of 400 moves of half a millimetre over a hilly surface, swaying a little sideways.
fn raster() -> impl Iterator<Item = Line> {
    (1..=MOVES).map(|k| {
        let (row, place) = (k / 400, k % 400);
        let along = f64::from(if row % 2 == 0 { place } else { 400 - place });
        let (x, y) = (along * 0.5, f64::from(row) + (along * 0.05).sin());
        let to = Axes::xyz(x, y, 3.0 * (x * 0.1).sin() * (y * 0.07).cos());
        Line { kind: MoveKind::Cut, to, feed: Feed::Axis }
    })
}

fn per_second(seconds: f64) -> f64 {
    f64::from(MOVES) / seconds / 1e6
}

fn plan(moves: &[Move], ramps: &Ramps) -> (Plan, f64) {
    let moves = moves.to_vec();
    let start = Instant::now();
    let plan = plan_stack(moves, ramps);
    (plan, start.elapsed().as_secs_f64())
}

fn main() {
    let settings = Settings::default();
    let lines: Vec<Line> = raster().collect();

    let start = Instant::now();
    let mut mover = Mover::new(Axes::default(), &settings);
    let moves: Vec<Move> = lines.iter().filter_map(|l| mover.line(At::default(), l)).collect();
    let made_s = start.elapsed().as_secs_f64();

    let mut best_s = f64::INFINITY;
    for _ in 0..7 {
        best_s = best_s.min(plan(&moves, &settings.ramps).1);
    }
    let (plan, _) = plan(&moves, &settings.ramps);

    let start = Instant::now();
    let samples = 1_000_000;
    let step_s = plan.duration_s() / f64::from(samples);
    let sum: f64 = (0..samples).map(|k| plan.at(f64::from(k) * step_s).position.0[2]).sum();
    let asked_s = start.elapsed().as_secs_f64();

    println!("a move: {} bytes; machine time {:.1} s", size_of::<Move>(), plan.duration_s());
    println!("made:    {:.2} million moves/s", per_second(made_s));
    println!("planned: {:.2} million moves/s", per_second(best_s));
    println!("asked:   {:.2} million times/s (mean Z {:.3})", per_second(asked_s), sum / 1e6);
}
