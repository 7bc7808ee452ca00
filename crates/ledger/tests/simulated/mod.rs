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

mod alike;
mod case;
mod dice;
mod exported;
mod jobs;
mod levels;
mod life;
mod path;
mod programs;
mod watch;

use case::Case;
use kerf_ledger::traces::{self, Traces};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;

/// Number of runs unless KERF_SIM_RUNS says otherwise.
const RUNS: u64 = 200;

/// The first seed of wider programs; those below were run before there were any, and stay what they were.
const FIRST_WIDER: u64 = 10_000_000;

/// Number of those runs unless KERF_SIM_RUNS says otherwise.
const WIDER_RUNS: u64 = 100;

/// Seeds that found something once.
const FOUND: &[u64] = &[
    116, 1347, 1080, 3096, 255, 575, 248, 4071, 5014, 10044, 3174, 100069, 100222, 100430, 111899,
    200751, 202145, 204624, 300584, 303007, 303255, 304793, 307058, 311491, 401779, 408099, 605245,
    610279, 1501968, 1004181, 4001872, 9002490, 9108665, 9300082, 9340787, 9341625, 9342162,
    9350361, 9404970, 9413044, 9414598, 9416074, 9446704, 9450458, 9457248, 9504240, 9511112,
];

/// Totals of the runs.
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

/// One run; nothing when it fails, after its case was told.
fn one(seed: u64) -> Option<Count> {
    let case = Case::of(seed);
    let Ok(lived) = catch_unwind(AssertUnwindSafe(|| life::live(&case))) else {
        eprintln!("{case}\nKERF_SIM_SEED={seed} KERF_SIM_RUNS=1 makes this run again");
        return None;
    };
    Some(Count {
        runs: 1,
        kills: lived.kills,
        resumes: lived.resumes,
        paths_compared: u64::from(lived.compared),
        faults: case.inputs.len() as u64 + case.requests.len() as u64,
    })
}

impl Count {
    fn add(&mut self, other: &Self) {
        self.runs += other.runs;
        self.kills += other.kills;
        self.resumes += other.resumes;
        self.paths_compared += other.paths_compared;
        self.faults += other.faults;
    }
}

#[test]
fn whole_runs_hold_what_is_promised() {
    let (first, runs) = (number("KERF_SIM_SEED", 1), number("KERF_SIM_RUNS", RUNS));
    let wider = FIRST_WIDER..FIRST_WIDER + WIDER_RUNS;
    let found = FOUND.iter().copied().chain(wider).filter(|_| runs == RUNS);
    let seeds = Mutex::new(found.chain(first..first + runs));
    let (count, failed) = (Mutex::new(Count::default()), Mutex::new(Vec::new()));
    let next = || seeds.lock().unwrap().next();
    let works = || {
        while let Some(seed) = next() {
            match one(seed) {
                Some(lived) => count.lock().unwrap().add(&lived),
                None => failed.lock().unwrap().push(seed),
            }
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(works))));
    let (count, failed) = (count.into_inner().unwrap(), failed.into_inner().unwrap());
    eprintln!("{count:?}");
    assert!(failed.is_empty(), "{} runs failed, seeds {failed:?}", failed.len());
}

/// With KERF_TRACES: the traces of 2,000 runs that nobody kills are those that were recorded.
#[test]
fn traces_are_the_recorded_ones() {
    if traces::folder().is_none() {
        return;
    }
    let mut traces = Traces::default();
    for seed in (1..1001).chain(FIRST_WIDER..FIRST_WIDER + 1000) {
        traces.add(&seed.to_string(), life::trace(&Case::of(seed)));
    }
    traces.hold("runs.txt");
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
