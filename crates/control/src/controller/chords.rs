//! Moves as chords, for a machine that knows only straight ways.

use kerf_machine::driver::way_mm;
use kerf_motion::{Move, Path};
use kerf_program::Axes;
use std::f64::consts::TAU;

/// A move is never cut into more chords than this.
const MOST: usize = 1 << 14;

/// The ends of the chords of a move with their shares of it; none lies farther from it than the tolerance.
pub fn chords(made: &Move, tolerance_mm: f64) -> Vec<(f64, Axes)> {
    let count = match made.path {
        Path::Line => 1,
        Path::Arc { centre, sweep_rad, .. } => {
            let radius = (made.from.0[0] - centre[0]).hypot(made.from.0[1] - centre[1]);
            arc_chords(radius, sweep_rad.abs(), tolerance_mm)
        }
        Path::Curve { .. } => curve_chords(made, tolerance_mm),
    };
    let end = |n: usize| n as f64 / count as f64;
    let inner = (1..count).map(|n| (end(n), made.position(end(n))));
    inner.chain([(1.0, made.to)]).collect()
}

/// Arcs of a radius between these are made by a controller that makes arcs, mm: its numbers have seven digits.
const RADII_MM: [f64; 2] = [0.1, 1000.0];

/// The ends of an arc lie on circles that differ by less than this, mm: a controller refuses 0.005, and rounding takes
/// up to 0.0015.
const UNROUND_MM: f64 = 0.002;

/// Ends of an arc that are farther apart than this are two places for a controller, those closer than half a thousandth one, mm.
const APART_MM: f64 = 0.01;

/// Returns centre and swept angle of a move that a controller makes as an arc: one in X and Y, along which no axis turns, of a
/// turn at most. It lies within [`UNROUND_MM`] of the move, and its chords within the tolerance of the controller.
pub fn arc(made: &Move, tolerance_mm: f64) -> Option<([f64; 2], f64)> {
    let Path::Arc { centre, sweep_rad, .. } = made.path else { return None };
    let radius_mm = |at: Axes| (at.0[0] - centre[0]).hypot(at.0[1] - centre[1]);
    let (begin_mm, end_mm) = (radius_mm(made.from), radius_mm(made.to));
    let way = made.to.minus(made.from).0;
    let apart_mm = way[0].hypot(way[1]);
    let is_turn = (sweep_rad.abs() - TAU).abs() < 1e-6 && apart_mm < 0.000_5;
    let fits = (RADII_MM[0]..=RADII_MM[1]).contains(&begin_mm)
        && (begin_mm - end_mm).abs() < UNROUND_MM
        && way[3..].iter().all(|way| *way == 0.0)
        && (is_turn || sweep_rad.abs() < TAU && apart_mm > APART_MM);
    let several = arc_chords(begin_mm, sweep_rad.abs(), tolerance_mm) > 2;
    (fits && several).then_some((centre, sweep_rad))
}

/// A chord over the angle a lies r (1 - cos a/2) inside the arc.
fn arc_chords(radius_mm: f64, sweep_rad: f64, tolerance_mm: f64) -> usize {
    let inside = (1.0 - tolerance_mm / radius_mm).clamp(-1.0, 1.0);
    let angle = 2.0 * inside.acos();
    if angle > 0.0 { ((sweep_rad / angle).ceil() as usize).clamp(1, MOST) } else { 1 }
}

fn curve_chords(made: &Move, tolerance_mm: f64) -> usize {
    let mut count = 2;
    while count < MOST && sagitta(made, count) > tolerance_mm {
        count *= 2;
    }
    count
}

/// Returns the largest distance of the middle of a chord from the path.
fn sagitta(made: &Move, count: usize) -> f64 {
    let at = |n: f64| made.position(n / count as f64);
    let one = |n: usize| {
        let (a, b) = (at(n as f64), at(n as f64 + 1.0));
        way_mm(a.zip(b, |a, b| (a + b) / 2.0), at(n as f64 + 0.5))
    };
    (0..count).map(one).fold(0.0, f64::max)
}

/// The speed of a move along its way of all axes, mm/s; what the program asks for is along its reference
/// length.
pub fn speed_mm_s(made: &Move, chords: &[(f64, Axes)]) -> f64 {
    let mut from = made.from;
    let way: f64 = chords
        .iter()
        .map(|(_, to)| {
            let way = way_mm(from, *to);
            from = *to;
            way
        })
        .sum();
    let seconds = made.length_mm / made.top_mm_s();
    if way > 0.0 && seconds > 0.0 { way / seconds } else { made.top_mm_s() }
}

/// Returns the distance of a place from a straight way, and the share of the way at which it is nearest.
pub fn nearest(from: Axes, to: Axes, place: Axes) -> (f64, f64) {
    let way = to.minus(from);
    let square: f64 = way.0.iter().map(|v| v * v).sum();
    let along: f64 = place.minus(from).0.iter().zip(way.0).map(|(a, b)| a * b).sum();
    let share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 1.0 };
    let foot = from.zip(to, |from, to| from + (to - from) * share);
    (way_mm(foot, place), share)
}
