//! Counts offsets that could not be proved, or differ from a polygon library's, over families of hard
//! shapes: `cargo run --release -p kerf-geom --example offset_families -- [COUNT] [FAMILY]`.
#![allow(clippy::print_stdout)]

#[path = "../tests/families/mod.rs"]
mod families;

use kerf_geom::offset;
use std::time::Instant;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count: u64 = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(1000);
    let word = arguments.next().unwrap_or_default();
    let first: u64 = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(0);
    for (name, make) in families::FAMILIES.iter().filter(|f| f.0.contains(&word)) {
        let started = Instant::now();
        let mut failed = 0;
        for seed in first..first + count {
            let (shape, distance) = make(seed);
            if let Err(why) = offset(&shape, distance) {
                failed += 1;
                if failed <= 3 {
                    println!("  {name} {seed}: {why} (offset {distance})");
                }
            }
        }
        let each = started.elapsed().as_secs_f64() * 1e6 / count as f64;
        println!("{name}: {failed} of {count} not proved, {each:.0} us each");
    }
}
