//! The seven reference programs beside what other planners need.

use crate::machine::{cut, dynamics};
use crate::replan::machine;
use crate::shared::shared;
use anyhow::{Context, Result};
use kerf_motion::{Model, Move, Mover, Optimal, planner};
use kerf_program::{At, Axes, RampModel, Settings};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// A reference program, with the seconds published for others: the lower bound, LinuxCNC 2.9 and 2.10 with
/// G64 P0.01, and LinuxCNC 2.10 with its S-curve; and the best along parabolic blends for each of the
/// tolerances, where that is known.
pub struct Reference {
    pub name: &'static str,
    pub file: &'static str,
    others_s: [f64; 4],
    topp_s: [Option<f64>; 3],
}

/// Distances by which the path may leave that of the program, mm.
const TOLERANCES_MM: [f64; 3] = [0.01, 0.05, 0.5];

/// Times are compared to the thousandth of a second to which the others are published.
const ROUNDED_S: f64 = 5e-4;

#[rustfmt::skip]
pub const REFERENCES: [Reference; 7] = [
    reference("R1 rectangle", "R1_rect", [6.75, 6.992, 6.798, 6.943],
        [Some(6.769), Some(6.730), Some(6.579)]),
    reference("R2 circle, 2,000 chords", "R2_circle2000", [3.28, 3.511, 3.382, 14.5],
        [Some(3.340), Some(3.340), Some(3.340)]),
    reference("R3 spiral, 2,000 chords", "R3_spiral2000", [8.03, 8.783, 8.694, 49.7],
        [Some(8.457), Some(8.457), Some(8.457)]),
    reference("R4 zigzag, 100 × 5 mm", "R4_zigzag90_5mm", [15.36, 17.086, 17.020, 23.5],
        [Some(16.772), Some(16.590), Some(14.289)]),
    reference("R5 3D raster, 0.5 mm", "R5_raster3d_5000", [30.98, 38.088, 35.765, 96.1],
        [Some(34.992), Some(34.043), None]),
    reference("R6 Hilbert curve, 1 mm", "R6_hilbert_1mm", [62.93, 78.779, 78.748, 118.2],
        [Some(72.168), Some(62.102), Some(44.513)]),
    reference("R7 mixed", "R7_mixed", [7.61, 10.034, 10.007, 28.8],
        [Some(9.291), Some(9.174), Some(9.100)]),
];

const fn reference(
    name: &'static str,
    file: &'static str,
    others_s: [f64; 4],
    topp_s: [Option<f64>; 3],
) -> Reference {
    Reference { name, file, others_s, topp_s }
}

/// The times of the reference programs, as tables; nothing where they are not at hand.
pub fn tables() -> Result<String> {
    let Some(folder) = shared("anchors/motion") else { return Ok(String::new()) };
    let mut beside = String::from(
        "\nSeconds of machine time at 100 mm/s, 200 mm/s and 500 mm/s² an axis, tolerance 0.01 mm, from rest \
         to rest. *LB*: no motion within the limits is faster. *TOPP*: the fastest speed along parabolic \
         blends. LinuxCNC as published, G64 P0.01, and its S-curve with a jerk of 10,000 mm/s³. `shopbot` \
         and `profiler` have their own rules: ramps and smoothing as they are when nobody sets them.\n\n\
         | program | LB | TOPP | LinuxCNC 2.9 | 2.10 | kerf | 2.10 S-curve | kerf, same jerk | shopbot | profiler |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    let mut wider = String::from(
        "\nThe same without a limit of jerk at other tolerances; the goal is TOPP × 1.00 where that is known.\n\n\
         | program | tolerance, mm | TOPP | kerf | goal |\n| --- | --- | --- | --- | --- |\n",
    );
    for Reference { name, file, others_s: [least, old, new, scurve], topp_s } in REFERENCES {
        let moves = moves(&folder.join(file).with_extension("xyz"))?;
        let time = |jerk, tolerance_mm| {
            let dynamics = dynamics(jerk, tolerance_mm);
            Optimal { dynamics: &dynamics }.plan(moves.clone()).duration_s()
        };
        let limited = time(Some(10_000.0), TOLERANCES_MM[0]);
        let free = TOLERANCES_MM.map(|tolerance_mm| time(None, tolerance_mm));
        let [shopbot, profiler] =
            [RampModel::Shopbot, RampModel::Profiler].map(|model| by_rules(&moves, model));
        let topp = topp_s[0].unwrap_or_default();
        _ = writeln!(
            beside,
            "| {name} | {least:.2} | {topp:.3} | {old:.3} | {new:.3} | {:.3} | {scurve:.1} | {limited:.3} | {shopbot:.3} | {profiler:.3} |",
            free[0]
        );
        for ((tolerance_mm, topp_s), free_s) in TOLERANCES_MM.iter().zip(topp_s).zip(free) {
            _ = writeln!(wider, "| {name} | {tolerance_mm} | {}", blended(topp_s, free_s));
        }
    }
    Ok(beside + &wider)
}

/// The best along parabolic blends, ours, and whether that is as good.
fn blended(topp_s: Option<f64>, ours_s: f64) -> String {
    match topp_s {
        Some(topp_s) => {
            let met = if ours_s <= topp_s + ROUNDED_S { "met" } else { "missed" };
            format!("{topp_s:.3} | {ours_s:.3} | ≤ {topp_s:.3}: {met} |")
        }
        None => format!("– | {ours_s:.3} | |"),
    }
}

/// Returns the time that a model takes that has rules of its own, seconds.
fn by_rules(moves: &[Move], model: RampModel) -> f64 {
    let mut planner = planner(&machine(model, None));
    moves.iter().for_each(|made| planner.push(*made));
    std::iter::from_fn(|| planner.take().or_else(|| planner.finish()))
        .last()
        .map_or(0.0, |piece| piece.duration_s())
}

/// The moves of R5, the 3D raster; nothing where it is not at hand.
pub fn raster3d() -> Result<Option<Vec<Move>>> {
    shared("anchors/motion").map(|folder| moves(&folder.join("R5_raster3d_5000.xyz"))).transpose()
}

/// The moves through the places of a file, at 100 mm/s.
pub fn moves(file: &Path) -> Result<Vec<Move>> {
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
