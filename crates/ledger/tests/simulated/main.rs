//! Whole runs thrown together from a seed: part files, G-code and jobs on random machines, with faults,
//! stops, kills and the way back.
//!
//! ```text
//!  seed ─► case ─► a run that nobody kills ──┐ the same path
//!             └──► killed, taken up, killed … ┘
//! ```
//!
//! What has to hold at any time is in [`watch`]; what has to hold of a run that was killed in [`life`].
//! A failure prints its seed; `KERF_SIM_SEED=n KERF_SIM_RUNS=1` makes exactly that run again.
//! `make soak` runs as many as it is told.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod case;
mod dice;
mod jobs;
mod life;
mod path;
mod programs;
mod watch;

use case::Case;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// How many runs are made unless KERF_SIM_RUNS says otherwise.
const RUNS: u64 = 200;

/// Seeds that found something once.
const FOUND: [u64; 16] = [
    116, 1347, 1080, 3096, 255, 575, 248, 4071, 5014, 10044, 3174, 100069, 100222, 100430, 111899,
    200751,
];

/// What the runs came to.
#[derive(Debug, Default)]
struct Count {
    runs: u64,
    kills: u64,
    resumes: u64,
    paths_compared: u64,
    faults: u64,
}

fn number(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(usual)
}

#[test]
fn whole_runs_hold_what_is_promised() {
    let (first, runs) = (number("KERF_SIM_SEED", 1), number("KERF_SIM_RUNS", RUNS));
    let mut count = Count::default();
    let mut failed = Vec::new();
    let found = FOUND.into_iter().filter(|_| runs == RUNS);
    for seed in found.chain(first..first + runs) {
        let case = Case::of(seed);
        let lived = catch_unwind(AssertUnwindSafe(|| life::live(&case)));
        count.runs += 1;
        let Ok(lived) = lived else {
            eprintln!("{case}\nKERF_SIM_SEED={seed} KERF_SIM_RUNS=1 makes this run again");
            failed.push(seed);
            continue;
        };
        count.kills += lived.kills;
        count.resumes += lived.resumes;
        count.paths_compared += u64::from(lived.compared);
        count.faults += case.inputs.len() as u64 + case.wishes.len() as u64;
    }
    eprintln!("{count:?}");
    assert!(failed.is_empty(), "{} of {} runs failed, seeds {failed:?}", failed.len(), count.runs);
}

/// A wall clock that is set forward or back before or between runs changes dates in logs, nothing else.
#[test]
fn a_wall_clock_that_jumps_changes_nothing() {
    for seed in [3, 14, 15, 92, 65, 116] {
        let case = Case::of(seed);
        let other = Case { started: Case::of(seed + 1).started, ..case.clone() };
        assert_ne!(case.started, other.started);
        let told = |case: &Case| format!("{:?}", life::events(case));
        assert_eq!(told(&case), told(&other), "seed {seed}");
    }
}

/// The same seed gives the same run, event by event.
#[test]
fn a_seed_replays_exactly() {
    for seed in [3, 14, 15, 92, 65] {
        let told = || format!("{:?}", life::events(&Case::of(seed)));
        assert_eq!(told(), told(), "seed {seed}");
    }
}
