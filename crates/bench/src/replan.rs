//! Measures how long a new plan takes when the operator stops, holds or overrides a machine that moves: at any
//! point of a raster of short segments, until the next piece of plan is there.

use crate::figure::{Figure, Goal, Spread};
use crate::usage;
use anyhow::Result;
use kerf_motion::{
    Move, Mover, OptimalPlanner, Plan, ProfilerPlanner, Replanner, Retimed, ShopBotPlanner,
};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, RampModel, Settings};

const NAME: &str = "raster3d-5k";

/// Segments of half a millimetre.
const SEGMENTS: u32 = 5000;

/// Moments of the run that are tried, evenly spread.
const MOMENTS: u32 = 1000;

/// A new plan has to be there within this, seconds.
const READY_S: f64 = 5e-3;

/// Measures; gives what is measured, and the figures: nothing when another input was asked for.
pub fn figures(word: &str) -> Result<(Vec<String>, Vec<Figure>)> {
    if !NAME.contains(word) {
        return Ok((Vec::new(), Vec::new()));
    }
    eprintln!("{NAME} …");
    let about = format!(
        "- `{NAME}`: 5,000 segments of 0.5 mm of a 3D raster (R5 where the reference programs are at hand), \
         planned anew at {MOMENTS} moments of the run; the time is that of the slowest, *99 of 100* that of all but \
         the slowest hundredth, *median* that of the one in the middle\n"
    );
    let mut figures = Vec::new();
    use RampModel::{Optimal, Profiler, Shopbot};
    let settings = machine(Shopbot, None);
    figures.extend(changes(&ShopBotPlanner::new(&settings.ramps), &settings, "shopbot")?);
    let settings = machine(Profiler, None);
    let planner = ProfilerPlanner::new(&settings.axis_dynamics(), &settings.smoothing);
    figures.extend(changes(&planner, &settings, "profiler")?);
    for (jerk, name) in [(None, "optimal"), (Some(10_000.0), "jerk")] {
        let settings = machine(Optimal, jerk);
        let planner = Retimed::new(OptimalPlanner::new(&settings.axis_dynamics()));
        figures.extend(changes(&planner, &settings, name)?);
    }
    Ok((vec![about], figures))
}

/// Change that has a piece of plan made anew at a time.
#[derive(Clone, Copy)]
enum Change {
    Stop,
    Feed(f32),
}

/// The figures of a stop, a lower and a higher feed.
fn changes<P: Replanner + Clone>(
    planner: &P,
    settings: &Settings,
    name: &str,
) -> Result<Vec<Figure>> {
    let mut planner = planner.clone();
    let moves = crate::references::raster3d()?.unwrap_or_else(|| raster(settings));
    moves.into_iter().for_each(|made| planner.push(made));
    let mut figures = Vec::new();
    for (what, change) in
        [("stop", Change::Stop), ("to 50%", Change::Feed(0.5)), ("to 150%", Change::Feed(1.5))]
    {
        let mut takes_s = latencies(&planner, change)?;
        takes_s.sort_by(f64::total_cmp);
        let last = takes_s.len().saturating_sub(1);
        let goal = Some(Goal::Within(READY_S, f64::INFINITY));
        for (stage, index, goal) in [
            (format!("{what}, {name}"), last, goal),
            (format!("{what}, {name}: 99 of 100"), last - last / 100, None),
            (format!("{what}, {name}: median"), last / 2, None),
        ] {
            let cpu_s = Spread::of(takes_s.get(index).copied().into_iter().collect());
            let stage: &'static str = stage.leak();
            let (count, unit) = (1, "re-plans");
            figures.push(Figure {
                input: NAME,
                stage,
                count,
                unit,
                cpu_s,
                wall_s: cpu_s,
                peak: None,
                goal,
            });
        }
    }
    Ok(figures)
}

/// Measures how long a change takes at many moments, until the next piece of plan is there: processor time,
/// so that other work beside it does not count.
fn latencies<P: Replanner + Clone>(planner: &P, change: Change) -> Result<Vec<f64>> {
    let mut all = planner.clone();
    let end_s =
        std::iter::from_fn(|| next(&mut all)).last().map_or(0.0, |piece| piece.duration_s());
    let moment = |k: u32| end_s * (f64::from(k) + 0.5) / f64::from(MOMENTS);
    let (mut planner, mut k, mut takes_s) = (planner.clone(), 0, Vec::new());
    while let Some(piece) = next(&mut planner) {
        while k < MOMENTS && moment(k) < piece.duration_s() {
            let (mut planner, piece) = (planner.clone(), piece.clone());
            let start = usage::own()?.cpu_s;
            let left = match change {
                Change::Stop => planner.stop(piece, moment(k), true),
                Change::Feed(share) => planner.feed(piece, moment(k), share),
            };
            let ready = next(&mut planner);
            takes_s.push(usage::own()?.cpu_s - start);
            drop((left, ready));
            k += 1;
        }
    }
    Ok(takes_s)
}

/// The next piece of plan.
fn next(planner: &mut impl Replanner) -> Option<Plan> {
    planner.take().or_else(|| planner.finish())
}

/// A router at 100 mm/s, with 500 mm/s² an axis.
pub fn machine(model: RampModel, jerk: Option<f64>) -> Settings {
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
