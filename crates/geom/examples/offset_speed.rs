//! Time of single offsets, least of many runs: `cargo run --release -p kerf-geom --example offset_speed`.
//! Peers are measured beside it by `make bench-geometry`.
#![allow(clippy::print_stdout)]

#[path = "../tests/families/mod.rs"]
mod families;

use kerf_geom::{Point2, Polyarc, offset};
use std::time::Instant;

fn main() {
    let word = std::env::args().nth(1).unwrap_or_default();
    let slot = Polyarc::rounded_rectangle(Point2::new(0., 0.), Point2::new(20., 5.), 2.0);
    for (name, shape, by) in [
        ("gear +1.5", families::gear(), 1.5),
        ("gear -1.5", families::gear(), -1.5),
        ("slot +1", slot.clone(), 1.0),
        ("slot -1", slot, -1.0),
        ("smooth -2", families::smooth_10_000(), -2.0),
        ("smooth +2", families::smooth_10_000(), 2.0),
        ("noisy +2", families::noisy_10_000(), 2.0),
    ] {
        if !name.contains(&word) {
            continue;
        }
        let (mut least, mut count) = (f64::INFINITY, 0);
        for _ in 0..60 {
            let begun = Instant::now();
            count = offset(&shape, by).map_or(0, |f| f.iter().map(|r| r.path.vertices.len()).sum());
            least = least.min(begun.elapsed().as_secs_f64());
        }
        println!("{name}: {:.1} us, {count} vertices", least * 1e6);
    }
}
