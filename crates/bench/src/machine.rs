//! Motion: how fast a program of any length is planned while it is read, and in how much memory.

use crate::child::{self, What};
use crate::figure::{Figure, Goal};
use anyhow::Result;
use kerf_motion::{Move, Mover, OptimalPlanner, Planner, Queue};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, Settings};
use std::env;
use std::ffi::OsStr;

/// The word with which this program plans a raster and does nothing else.
const RASTER: &str = "--plan-raster";

/// The word with which it plans one under a limit of jerk.
const WITH_JERK: &str = "--plan-raster-with-jerk";

/// The word with which it only holds the moves of one.
const HELD: &str = "--hold-raster";

/// Work that runs in a process of its own, for its memory, by the first word of its command line.
pub const IN_A_CHILD: [Work; 3] =
    [(RASTER, plan_raster), (WITH_JERK, plan_with_jerk), (HELD, hold_raster)];

/// A word, and what is done with so many moves.
type Work = (&'static str, fn(u32));

/// A million moves in flight take less, seconds and bytes with the whole process.
const HOLDS: Goal = Goal::Within(1.0, 100e6);

/// Runs of a raster after one to warm up.
const RUNS: usize = 3;

/// 200 mm/s and 500 mm/s² an axis, within so much of the path.
pub fn dynamics(jerk_mm_s3: Option<f64>, tolerance_mm: f64) -> Dynamics {
    Dynamics {
        speed_mm_s: Axes::splat(200.0),
        accel_mm_s2: Axes::splat(500.0),
        jerk_mm_s3: jerk_mm_s3.map(Axes::splat),
        tolerance_mm,
    }
}

/// A cut at 100 mm/s.
pub fn cut(to: Axes) -> Line {
    Line { kind: MoveKind::Cut, to, feed: Feed::Path(100.0) }
}

/// Measures how fast rasters of 10⁴ … 10⁷ moves are made and planned while they are read, and in how much
/// memory, each in a process of its own.
pub fn figures() -> Result<Vec<Figure>> {
    let sizes = [10_000, 100_000, 1_000_000, 10_000_000];
    let names = ["raster-10k", "raster-100k", "raster-1m", "raster-10m"];
    let planned = names.into_iter().zip(sizes).map(|(name, moves)| {
        let goal = (moves >= 1_000_000).then_some(Goal::Rate(1e6));
        figure(name, "optimal, streamed", RASTER, moves, goal)
    });
    let held = figure("raster-1m", "moves that wait in flight", HELD, 1_000_000, Some(HOLDS));
    let jerk = figure("raster-10k", "optimal with jerk, streamed", WITH_JERK, 10_000, None);
    planned.chain([jerk, held]).collect()
}

fn figure(
    input: &'static str,
    stage: &'static str,
    word: &str,
    moves: u32,
    goal: Option<Goal>,
) -> Result<Figure> {
    let (own, size, folder) = (child::own()?, moves.to_string(), env::temp_dir());
    let what = What { input, stage, count: u64::from(moves), unit: "moves", goal };
    what.measured(RUNS, || child::run(&own, &[OsStr::new(word), OsStr::new(&size)], &folder))
}

/// Makes and plans a raster.
fn plan_raster(moves: u32) {
    plan(moves, None);
}

fn plan_with_jerk(moves: u32) {
    plan(moves, Some(10_000.0));
}

fn plan(moves: u32, jerk_mm_s3: Option<f64>) {
    let mut planner = OptimalPlanner::new(&dynamics(jerk_mm_s3, 0.01));
    for made in raster(moves) {
        planner.push(made);
        std::hint::black_box(planner.take());
    }
    std::hint::black_box(planner.finish());
}

/// Makes a raster and keeps its moves as a stack keeps those that wait.
fn hold_raster(moves: u32) {
    std::hint::black_box(raster(moves).collect::<Queue>());
}

/// Rows of 400 moves of half a millimetre over a hilly surface, swaying a little sideways.
fn raster(moves: u32) -> impl Iterator<Item = Move> {
    let mut mover = Mover::new(Axes::default(), &Settings::default());
    (1..=moves).filter_map(move |k| {
        let (row, place) = (k / 400, k % 400);
        let along = f64::from(if row % 2 == 0 { place } else { 400 - place });
        let (x, y) = (along * 0.5, f64::from(row) + (along * 0.05).sin());
        let to = Axes::xyz(x, y, 3.0 * (x * 0.1).sin() * (y * 0.07).cos());
        mover.line(At::default(), &cut(to))
    })
}
