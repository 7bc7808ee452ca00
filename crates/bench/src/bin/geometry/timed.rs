//! Processor time of a run.

use crate::outcome::Outcome;
use crate::usage;

/// Processor time so far, seconds: what passes on an idle machine.
pub fn processor_s() -> f64 {
    usage::own().map_or(0.0, |own| own.cpu_s)
}

/// The least time of several runs in milliseconds. Short runs are repeated within one measurement.
pub fn timed(run: impl Fn() -> Outcome) -> (f64, Outcome) {
    let mut outcome = run();
    let mut repeats = 1;
    let mut least = f64::INFINITY;
    for _ in 0..7 {
        loop {
            let begun = processor_s();
            for _ in 0..repeats {
                outcome = run();
            }
            let took = processor_s() - begun;
            if took > 0.02 {
                least = least.min(took / f64::from(repeats) * 1e3);
                break;
            }
            repeats *= 4;
        }
    }
    (least, outcome)
}
