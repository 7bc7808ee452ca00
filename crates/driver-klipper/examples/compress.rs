//! Measures how fast steps become commands, and how many:
//! `cargo run --release -p kerf-driver-klipper --example compress`.
#![allow(clippy::print_stdout)]

use kerf_driver_klipper::compress::{Compressor, Limits, Steps, TooFast};
use std::time::Instant;

/// Ticks a second.
const FREQUENCY: f64 = 12e6;

fn main() -> Result<(), TooFast> {
    // Back and forth: a smooth start and a smooth end a second, at most `fast` steps a second in the middle.
    for fast in [5_000.0, 40_000.0, 150_000.0] {
        for error_us in [2.0, 5.0] {
            measure(&steps(fast, 2_000_000), fast, error_us)?;
        }
    }
    Ok(())
}

fn measure(steps: &[f64], fast: f64, error_us: f64) -> Result<(), TooFast> {
    let limits = Limits { error: error_us * 1e-6 * FREQUENCY, least: 24, turn: 120 };
    let mut out: Vec<Steps> = Vec::new();
    let since = Instant::now();
    let mut compressor = Compressor::new(limits, 0);
    for clock in steps {
        compressor.push(*clock, true, &mut out)?;
    }
    compressor.finish(&mut out)?;
    let took_s = since.elapsed().as_secs_f64();
    let late = worst(steps, &out) / FREQUENCY * 1e6;
    let lasts_s = steps.last().copied().unwrap_or(1.0) / FREQUENCY;
    println!(
        "{fast:7.0} steps/s at most, ±{error_us} µs: {:5.1} M steps/s a core, \
         {:5.1} steps a command, {:5.0} commands/s, worst {late:.2} µs",
        steps.len() as f64 / took_s / 1e6,
        steps.len() as f64 / out.len() as f64,
        out.len() as f64 / lasts_s,
    );
    Ok(())
}

/// Largest distance of a step from its moment, ticks.
fn worst(steps: &[f64], out: &[Steps]) -> f64 {
    let made = out.iter().flat_map(|steps| (1..=steps.count).map(|k| steps.at(k)));
    made.zip(steps).map(|(made, due)| (made as f64 - due).abs()).fold(0.0, f64::max)
}

/// Clocks of steps of moves that each take a second and end at rest.
fn steps(fast: f64, count: usize) -> Vec<f64> {
    let length = (fast / 1.875).floor();
    let place = |s: f64| length * s * s * s * (10.0 + s * (6.0 * s - 15.0));
    let one: Vec<f64> = (0..length as u32).map(|n| moment(place, f64::from(n) + 0.5)).collect();
    let moves = count.div_ceil(one.len());
    let shift = |n: usize| one.iter().map(move |s| (1.0 + n as f64 + s) * FREQUENCY);
    (0..moves).flat_map(shift).collect()
}

/// Share of a move at which a place is passed.
fn moment(place: impl Fn(f64) -> f64, wanted: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..52 {
        let middle = 0.5 * (low + high);
        if place(middle) < wanted { low = middle } else { high = middle }
    }
    high
}
