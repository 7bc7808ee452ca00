//! From drawing to tool path, measured: reading DXF, the order of cutting, tool paths. `make bench` builds
//! and runs it; ezdxf reads the same file where Python has it. Processor time, least of some runs.
#![allow(clippy::print_stdout)]

mod bound;
mod dxf;
mod paths;
#[path = "../../../../drawing/tests/plates/mod.rs"]
mod plates;
mod travel;
#[allow(dead_code)]
#[path = "../../usage.rs"]
mod usage;

use anyhow::Result;

fn main() -> Result<()> {
    println!("| what | by | result | milliseconds |");
    println!("|---|---|---|---|");
    dxf::measure()?;
    travel::measure();
    paths::measure()
}

/// Runs something some times and gives what it made and the least processor time, milliseconds.
fn timed<T>(runs: usize, run: impl Fn() -> T) -> (T, f64) {
    let once = || {
        let begun = processor_s();
        let made = run();
        (made, (processor_s() - begun) * 1e3)
    };
    let first = once();
    (1..runs).fold(first, |best, _| {
        let next = once();
        if next.1 < best.1 { next } else { best }
    })
}

fn processor_s() -> f64 {
    usage::own().map_or(0.0, |own| own.cpu_s)
}
