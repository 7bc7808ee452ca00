//! Figures of measurements, and how one is made of several runs.

use crate::usage::own;
use anyhow::Result;
use std::time::Instant;

/// Runs after one to warm up.
pub const RUNS: usize = 5;

/// The median of several runs, with the smallest and the largest.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// The one in the middle.
    pub median: f64,
    /// The smallest.
    pub low: f64,
    /// The largest.
    pub high: f64,
}

impl Spread {
    /// Of some values; all zero for none.
    pub fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let at = |i: usize| values.get(i).copied().unwrap_or_default();
        Self { median: at(values.len() / 2), low: at(0), high: at(values.len().saturating_sub(1)) }
    }
}

/// Goal of a figure.
#[derive(Clone, Copy, Debug)]
pub enum Goal {
    /// So many a second at least.
    Rate(f64),
    /// Not longer, seconds, and not more memory, bytes.
    Within(f64, f64),
}

/// One figure.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The input.
    pub input: &'static str,
    /// Name of what was done with it.
    pub stage: &'static str,
    /// Number of units that were done.
    pub count: u64,
    /// Name of the unit.
    pub unit: &'static str,
    /// Processor time, user and system, seconds.
    pub cpu_s: Spread,
    /// Time it took on this machine with all that it does besides, seconds.
    pub wall_s: Spread,
    /// Peak memory of a process of its own, bytes.
    pub peak: Option<f64>,
    /// Goal of the figure.
    pub goal: Option<Goal>,
}

impl Figure {
    /// Returns the number of units a second of processor time, by the median.
    pub fn rate(&self) -> f64 {
        self.count as f64 / self.cpu_s.median
    }

    /// Tells whether it is as good as asked; `None` when nothing is asked.
    pub fn meets(&self) -> Option<bool> {
        Some(match self.goal? {
            Goal::Rate(least) => self.rate() >= least,
            Goal::Within(seconds, bytes) => {
                self.cpu_s.median <= seconds && self.peak.is_none_or(|peak| peak <= bytes)
            }
        })
    }
}

/// Prepares and does something several times; only what is done is timed, not throwing away what
/// came of it. Gives how many it was, its processor time and its time.
pub fn timed<P, R>(
    mut prepare: impl FnMut() -> P,
    mut work: impl FnMut(P) -> R,
    counted: impl Fn(&R) -> u64,
) -> Result<(u64, Spread, Spread)> {
    let mut count = 0;
    let (mut cpu, mut wall) = (Vec::new(), Vec::new());
    for run in 0..=RUNS {
        let prepared = prepare();
        let (start, before) = (Instant::now(), own()?);
        let made = std::hint::black_box(work(prepared));
        let (after, elapsed) = (own()?, start.elapsed());
        count = counted(&made);
        if run > 0 {
            cpu.push(after.cpu_s - before.cpu_s);
            wall.push(elapsed.as_secs_f64());
        }
    }
    Ok((count, Spread::of(cpu), Spread::of(wall)))
}
