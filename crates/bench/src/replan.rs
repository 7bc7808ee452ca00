//! How long a new plan takes when the operator stops, holds or overrides a machine that moves: at any
//! point of a raster of short segments, until the next piece of plan is there.

use crate::figure::{Figure, Goal, Spread};
use crate::usage;
use anyhow::Result;
use kerf_motion::{Move, Mover, Plan, Replanner, planner};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, RampModel, Settings};

const NAME: &str = "raster3d-5k";

/// Segments of half a millimetre.
const SEGMENTS: u32 = 5000;

/// Moments of a run that are tried; fewer under a limit of jerk, where planning takes seconds.
const MOMENTS: u32 = 16;
const MOMENTS_WITH_JERK: u32 = 3;

/// Runs over all of them.
const RUNS: usize = 3;

/// A new plan has to be there within this, seconds.
const READY_S: f64 = 5e-3;

/// What is measured, and the figures; nothing when another input was asked for.
pub fn figures(word: &str) -> Result<(Vec<String>, Vec<Figure>)> {
    if !NAME.contains(word) {
        return Ok((Vec::new(), Vec::new()));
    }
    eprintln!("{NAME} …");
    let about = format!(
        "- `{NAME}`: 5,000 segments of 0.5 mm of a 3D raster, planned anew at {MOMENTS} moments; the slowest counts\n"
    );
    let mut figures = Vec::new();
    use RampModel::{Optimal, Profiler, Shopbot};
    let [shopbot, profiler, optimal] = [Shopbot, Profiler, Optimal];
    for ([stop, slow, fast], settings) in [
        (["stop, shopbot", "to 50%, shopbot", "to 150%, shopbot"], machine(shopbot, None)),
        (["stop, profiler", "to 50%, profiler", "to 150%, profiler"], machine(profiler, None)),
        (["stop, optimal", "to 50%, optimal", "to 150%, optimal"], machine(optimal, None)),
        (["stop, jerk", "to 50%, jerk", "to 150%, jerk"], machine(optimal, Some(10_000.0))),
    ] {
        let moves = raster(&settings);
        figures.push(figure(stop, &moves, &settings, &stops)?);
        figures.push(figure(slow, &moves, &settings, &slows)?);
        figures.push(figure(fast, &moves, &settings, &hurries)?);
    }
    Ok((vec![about], figures))
}

/// What changes a piece of plan at a time.
type Change<'a> = &'a dyn Fn(&mut dyn Replanner, Plan, f64);

fn stops(planner: &mut dyn Replanner, piece: Plan, t_s: f64) {
    drop(planner.stop(piece, t_s, true));
}

fn slows(planner: &mut dyn Replanner, piece: Plan, t_s: f64) {
    drop(planner.feed(piece, t_s, 0.5));
}

fn hurries(planner: &mut dyn Replanner, piece: Plan, t_s: f64) {
    drop(planner.feed(piece, t_s, 1.5));
}

/// A router at 100 mm/s, with 500 mm/s² an axis.
fn machine(model: RampModel, jerk: Option<f64>) -> Settings {
    let mut settings = Settings::default();
    (settings.speeds.cut.xy, settings.speeds.cut.z) = (100.0, 100.0);
    settings.ramp_model = Some(model);
    settings.dynamics = Some(Dynamics {
        speed_mm_s: Axes::splat(200.0),
        accel_mm_s2: Axes::splat(500.0),
        jerk_mm_s3: jerk.map(Axes::splat),
        tolerance_mm: 0.01,
    });
    settings
}

/// Rows of 100 segments over a hilly surface.
fn raster(settings: &Settings) -> Vec<Move> {
    let mut mover = Mover::new(Axes::default(), settings);
    let place = |k: u32| {
        let (row, column) = (k / 100, k % 100);
        let along = f64::from(if row.is_multiple_of(2) { column } else { 99 - column });
        let (x, y) = (0.5 * along, 0.5 * f64::from(row));
        Axes::xyz(x, y, 3.0 * (x * 0.2).sin() * (y * 0.15).cos())
    };
    let line = |to| Line { kind: MoveKind::Cut, to, feed: Feed::Axis };
    (1..=SEGMENTS).filter_map(|k| mover.line(At::default(), &line(place(k)))).collect()
}

/// The slowest of all moments, in each of some runs.
fn figure(
    stage: &'static str,
    moves: &[Move],
    settings: &Settings,
    change: Change<'_>,
) -> Result<Figure> {
    let end_s: f64 = pieces(moves, settings).last().map_or(0.0, Plan::duration_s);
    let jerk = settings.axis_dynamics().jerk_mm_s3;
    let count = jerk.map_or(MOMENTS, |_| MOMENTS_WITH_JERK);
    let mut slowest = [0.0f64; RUNS];
    for most_s in &mut slowest {
        for k in 0..count {
            let t_s = end_s * (f64::from(k) + 0.5) / f64::from(count);
            *most_s = most_s.max(takes_s(moves, settings, t_s, change)?);
        }
    }
    let wall_s = Spread::of(slowest.to_vec());
    let goal = Some(Goal::Within(READY_S, f64::INFINITY));
    let (count, unit) = (u64::from(count), "re-plans");
    Ok(Figure { input: NAME, stage, count, unit, cpu_s: wall_s, wall_s, peak: None, goal })
}

fn pieces(moves: &[Move], settings: &Settings) -> Vec<Plan> {
    let mut planner = reading(moves, settings);
    std::iter::from_fn(|| planner.take().or_else(|| planner.finish())).collect()
}

fn reading(moves: &[Move], settings: &Settings) -> Box<dyn Replanner> {
    let mut planner = planner(settings);
    moves.iter().for_each(|made| planner.push(*made));
    planner
}

/// How long a change at a moment takes, until the next piece of plan is there: processor time, so that
/// other work beside it does not count.
fn takes_s(moves: &[Move], settings: &Settings, t_s: f64, change: Change<'_>) -> Result<f64> {
    let mut planner = reading(moves, settings);
    let piece = std::iter::from_fn(|| planner.take().or_else(|| planner.finish()))
        .find(|piece| piece.duration_s() > t_s);
    let Some(piece) = piece else { return Ok(0.0) };
    let start = usage::own()?.cpu_s;
    change(planner.as_mut(), piece, t_s);
    std::hint::black_box(planner.take().or_else(|| planner.finish()));
    Ok(usage::own()?.cpu_s - start)
}
