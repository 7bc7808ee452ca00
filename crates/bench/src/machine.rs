//! Motion: the seven reference programs beside what other planners need, and how fast a program of
//! any length is planned while it is read.

use crate::child;
use crate::figure::{Figure, Goal, Spread};
use anyhow::{Context, Result};
use kerf_motion::{Model, Move, Mover, Optimal, OptimalPlanner, Planner, Queue};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, Settings};
use std::ffi::OsStr;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, iter};

/// The word with which this program plans a raster and does nothing else.
pub const RASTER: &str = "--plan-raster";

/// The word with which it only holds the moves of one.
pub const HELD: &str = "--hold-raster";

/// What runs in a process of its own, for its memory, by the first word of its command line.
pub const IN_A_CHILD: [Work; 2] = [(RASTER, plan_raster), (HELD, hold_raster)];

/// A word, and what is done with so many moves.
type Work = (&'static str, fn(u32));

/// A million moves in flight take less, seconds and bytes with the whole process.
const HOLDS: Goal = Goal::Within(1.0, 100e6);

/// Runs of a raster after one to warm up.
const RUNS: usize = 3;

/// A reference program, with the seconds published for others: the lower bound, the best along
/// parabolic blends, LinuxCNC 2.9 and 2.10 with G64 P0.01, and LinuxCNC 2.10 with its S-curve.
struct Reference {
    name: &'static str,
    file: &'static str,
    others_s: [f64; 5],
}

const REFERENCES: [Reference; 7] = [
    reference("R1 rectangle", "R1_rect", [6.75, 6.769, 6.992, 6.798, 6.943]),
    reference("R2 circle, 2,000 chords", "R2_circle2000", [3.28, 3.340, 3.511, 3.382, 14.5]),
    reference("R3 spiral, 2,000 chords", "R3_spiral2000", [8.03, 8.457, 8.783, 8.694, 49.7]),
    reference("R4 zigzag, 100 × 5 mm", "R4_zigzag90_5mm", [15.36, 16.772, 17.086, 17.020, 23.5]),
    reference("R5 3D raster, 0.5 mm", "R5_raster3d_5000", [30.98, 34.992, 38.088, 35.765, 96.1]),
    reference("R6 Hilbert curve, 1 mm", "R6_hilbert_1mm", [62.93, 72.168, 78.779, 78.748, 118.2]),
    reference("R7 mixed", "R7_mixed", [7.61, 9.291, 10.034, 10.007, 28.8]),
];

const fn reference(name: &'static str, file: &'static str, others_s: [f64; 5]) -> Reference {
    Reference { name, file, others_s }
}

/// 200 mm/s and 500 mm/s² an axis, 0.01 mm.
fn dynamics(jerk_mm_s3: Option<f64>) -> Dynamics {
    Dynamics {
        speed_mm_s: Axes::splat(200.0),
        accel_mm_s2: Axes::splat(500.0),
        jerk_mm_s3: jerk_mm_s3.map(Axes::splat),
        tolerance_mm: 0.01,
    }
}

/// The times of the reference programs, as a table; nothing where they are not at hand.
pub fn references() -> Result<String> {
    let Some(folder) = folder() else { return Ok(String::new()) };
    let mut text = String::from(
        "\nSeconds of machine time at 100 mm/s, 200 mm/s and 500 mm/s² an axis, tolerance 0.01 mm, from rest \
         to rest. *LB*: no motion within the limits is faster. *TOPP*: the fastest speed along parabolic \
         blends. LinuxCNC as published, G64 P0.01, and its S-curve with a jerk of 10,000 mm/s³.\n\n\
         | program | LB | TOPP | LinuxCNC 2.9 | 2.10 | kerf | 2.10 S-curve | kerf, same jerk |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for Reference { name, file, others_s: [least, topp, old, new, scurve] } in REFERENCES {
        let moves = moves(&folder.join(file).with_extension("xyz"))?;
        let time = |jerk| {
            let dynamics = dynamics(jerk);
            Optimal { dynamics: &dynamics }.plan(moves.clone()).duration_s()
        };
        let (free, limited) = (time(None), time(Some(10_000.0)));
        _ = writeln!(
            text,
            "| {name} | {least:.2} | {topp:.3} | {old:.3} | {new:.3} | {free:.3} | {scurve:.1} | {limited:.3} |"
        );
    }
    Ok(text)
}

/// The moves of R5, the 3D raster; nothing where it is not at hand.
pub fn raster3d() -> Result<Option<Vec<Move>>> {
    folder().map(|folder| moves(&folder.join("R5_raster3d_5000.xyz"))).transpose()
}

/// `anchors/motion` in the folder `shared` beside the checkout or one of its parents, or where
/// `KERF_SHARED` says.
fn folder() -> Option<PathBuf> {
    let here = env::current_dir().unwrap_or_default();
    let named = env::var_os("KERF_SHARED").map(PathBuf::from);
    let beside = here.ancestors().map(|folder| folder.join("shared"));
    named.into_iter().chain(beside).map(|shared| shared.join("anchors/motion")).find(|f| f.is_dir())
}

fn moves(file: &Path) -> Result<Vec<Move>> {
    let text = fs::read_to_string(file).with_context(|| file.display().to_string())?;
    let mut places = Vec::new();
    for line in text.lines() {
        let numbers = line.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let [x, y, z] = numbers[..] else { continue };
        places.push(Axes::xyz(x, y, z));
    }
    let start = *places.first().context("an empty reference program")?;
    let mut mover = Mover::new(start, &Settings::default());
    Ok(places.iter().filter_map(|to| mover.line(At::default(), &cut(*to))).collect())
}

fn cut(to: Axes) -> Line {
    Line { kind: MoveKind::Cut, to, feed: Feed::Path(100.0) }
}

/// How fast rasters of 10⁴ … 10⁷ moves are made and planned while they are read, and in how much
/// memory, each in a process of its own.
pub fn figures() -> Result<Vec<Figure>> {
    let sizes = [10_000, 100_000, 1_000_000, 10_000_000];
    let names = ["raster-10k", "raster-100k", "raster-1m", "raster-10m"];
    let planned = names.into_iter().zip(sizes).map(|(name, moves)| {
        let goal = (moves >= 1_000_000).then_some(Goal::Rate(1e6));
        figure(name, "optimal, streamed", RASTER, moves, goal)
    });
    let held = figure("raster-1m", "moves that wait in flight", HELD, 1_000_000, Some(HOLDS));
    planned.chain(iter::once_with(|| held)).collect()
}

fn figure(
    input: &'static str,
    stage: &'static str,
    word: &str,
    moves: u32,
    goal: Option<Goal>,
) -> Result<Figure> {
    let own = env::current_exe().context("where is this program?")?;
    let size = moves.to_string();
    let folder = env::temp_dir();
    let run = |_| child::run(&own, &[OsStr::new(word), OsStr::new(&size)], &folder);
    let taken = (0..=RUNS).map(run).skip(1).collect::<Result<Vec<_>>>()?;
    let spread = |f: fn(&child::Taken) -> f64| Spread::of(taken.iter().map(f).collect());
    Ok(Figure {
        input,
        stage,
        count: u64::from(moves),
        unit: "moves",
        cpu_s: spread(|t| t.cpu_s),
        wall_s: spread(|t| t.seconds),
        peak: Some(spread(|t| t.peak).median),
        goal,
    })
}

/// Makes and plans a raster.
pub fn plan_raster(moves: u32) {
    let mut planner = OptimalPlanner::new(&dynamics(None));
    for made in raster(moves) {
        planner.push(made);
        std::hint::black_box(planner.take());
    }
    std::hint::black_box(planner.finish());
}

/// Makes a raster and keeps its moves as a stack keeps those that wait.
pub fn hold_raster(moves: u32) {
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
