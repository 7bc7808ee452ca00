//! Single moves and programs of exact stops under a limit of jerk, beside Ruckig: a library that plans
//! such moves for robots and proves that nothing is faster.

use anyhow::{Result, anyhow};
use kerf_motion::{Model, Move, Mover, Optimal};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, Settings};
use rsruckig::prelude::{InputParameter, Ruckig, ThrowErrorHandler, Trajectory};
use std::fmt::Write as _;

/// Each axis: mm/s, mm/s², mm/s³.
const SPEED: f64 = 200.0;
const ACCEL: f64 = 500.0;
const JERK: f64 = 10_000.0;

/// Single moves that are compared.
const SINGLE: u32 = 1000;

/// Both may differ by this share.
const CLOSE: f64 = 1e-3;

/// Seconds that both need, and by which share a single move differs at most.
#[derive(Clone, Copy, Debug)]
pub struct Compared {
    pub kerf_s: f64,
    pub ruckig_s: f64,
    pub apart: f64,
}

/// The comparisons, by name.
pub fn compared() -> Result<Vec<(&'static str, Compared)>> {
    Ok(vec![
        ("1,000 single moves, 1 µm … 1 m, in all directions", single()?),
        ("zigzag of 100 × 5 mm, exact stops", program(&zigzag())?),
        ("rectangle 200 × 100 mm, exact stops", program(&rectangle())?),
    ])
}

/// The same as a table.
pub fn table() -> Result<String> {
    let mut text = String::from(
        "\nWith a limit of jerk, 200 mm/s, 500 mm/s² and 10,000 mm/s³ an axis, beside Ruckig (crate `rsruckig`), \
         seconds of machine time:\n\n| moves | Ruckig | kerf | largest difference of one | goal |\n| --- | --- | --- | --- | --- |\n",
    );
    for (name, Compared { kerf_s, ruckig_s, apart }) in compared()? {
        let met = if apart < CLOSE { "met" } else { "missed" };
        let (apart, goal) = (100.0 * apart, 100.0 * CLOSE);
        writeln!(
            text,
            "| {name} | {ruckig_s:.4} | {kerf_s:.4} | {apart:.4}% | < {goal}%: {met} |"
        )?;
    }
    Ok(text)
}

fn single() -> Result<Compared> {
    let places = (0..SINGLE).map(|k| {
        let k = f64::from(k);
        let length = 10f64.powf(-3.0 + 6.0 * k / f64::from(SINGLE));
        let (turn, rise) = (2.4 * k, (1.7 * k).sin());
        Axes::xyz(length * turn.cos(), length * turn.sin(), length * rise)
    });
    let mut all = Compared { kerf_s: 0.0, ruckig_s: 0.0, apart: 0.0 };
    for place in places {
        let one = program(&[Axes::default(), place])?;
        all.kerf_s += one.kerf_s;
        all.ruckig_s += one.ruckig_s;
        all.apart = all.apart.max(one.apart);
    }
    Ok(all)
}

fn zigzag() -> Vec<Axes> {
    (0..=100)
        .map(|k: i32| Axes::xyz(f64::from((k + 1) / 2) * 5.0, f64::from(k / 2) * 5.0, 0.0))
        .collect()
}

fn rectangle() -> Vec<Axes> {
    [(0.0, 0.0), (200.0, 0.0), (200.0, 100.0), (0.0, 100.0), (0.0, 0.0)]
        .map(|(x, y)| Axes::xyz(x, y, 0.0))
        .to_vec()
}

/// Straight moves from place to place, with a stop at each.
fn program(places: &[Axes]) -> Result<Compared> {
    let dynamics = Dynamics {
        speed_mm_s: Axes::splat(SPEED),
        accel_mm_s2: Axes::splat(ACCEL),
        jerk_mm_s3: Some(Axes::splat(JERK)),
        tolerance_mm: 0.0,
    };
    let mut mover = Mover::new(places[0], &Settings::default());
    let line = |to: &Axes| Line { kind: MoveKind::Cut, to: *to, feed: Feed::Path(1e6) };
    let moves: Vec<Move> =
        places[1..].iter().filter_map(|to| mover.line(At::default(), &line(to))).collect();
    let plan = Optimal { dynamics: &dynamics }.plan(moves);
    let mut all = Compared { kerf_s: plan.duration_s(), ruckig_s: 0.0, apart: 0.0 };
    for (k, pair) in places.windows(2).enumerate() {
        let theirs = ruckig_s(&pair[1].minus(pair[0]))?;
        let (t0, t1) = plan.span_s(k);
        all.ruckig_s += theirs;
        all.apart = all.apart.max(((t1 - t0) / theirs - 1.0).abs());
    }
    Ok(all)
}

/// Returns the time that Ruckig takes from rest to rest, seconds.
fn ruckig_s(way: &Axes) -> Result<f64> {
    let mut input = InputParameter::<3>::new(None);
    for k in 0..3 {
        input.target_position[k] = way.0[k];
        (input.max_velocity[k], input.max_acceleration[k], input.max_jerk[k]) =
            (SPEED, ACCEL, JERK);
    }
    let mut trajectory = Trajectory::new(None);
    let mut ruckig = Ruckig::<3, ThrowErrorHandler>::new(None, 1e-3);
    ruckig.calculate(&input, &mut trajectory).map_err(|error| anyhow!("{error:?}"))?;
    Ok(trajectory.get_duration())
}

#[cfg(test)]
mod tests {
    #[test]
    #[allow(clippy::unwrap_used)]
    fn single_moves_and_exact_stops_take_what_ruckig_takes() {
        for (name, compared) in super::compared().unwrap() {
            assert!(compared.apart < super::CLOSE, "{name}: {compared:?}");
            assert!((compared.kerf_s / compared.ruckig_s - 1.0).abs() < super::CLOSE, "{name}");
        }
    }
}
