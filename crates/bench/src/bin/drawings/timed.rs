//! Processor time of a run.

use crate::usage;

/// Runs something some times and gives what it made and the least processor time, milliseconds.
pub fn timed<T>(runs: usize, run: impl Fn() -> T) -> (T, f64) {
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
