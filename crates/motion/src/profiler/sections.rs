//! Which segments are smoothed, and into what curves (Profiler reference, "Tool Path Smoothing";
//! readings, Smoothing).
//!
//! A *run* is a chain of straight cuts between corners of more than 45°. In a run of at least three
//! segments every vertex gets the direction of the circle through it and its neighbours, and a
//! segment is smoothed where the curve with these directions stays within the limit. Next to a
//! segment that is not smoothed the curve ends in that segment's direction where the limit allows
//! it, so that the machine does not stop between a straight and a curve that touches it.

use super::spline::{Spline, Vec3, angle, dot, length, minus, scaled, unit};
use crate::moves::{Move, Path};
use kerf_program::MoveKind;

/// Sharper corners are never smoothed.
const SHARP_RAD: f64 = std::f64::consts::FRAC_PI_4;
/// Corners drawn at just the limit, with a few decimals, belong to it.
const ANGLE_TOLERANCE_RAD: f64 = 1e-6;
/// Shorter runs are corners and not curves.
const FEWEST: usize = 3;
/// Number of neighbours on either side that may decide what becomes of a move: a direction depends on two
/// segments, the choice of a segment on its directions, its ends on the choice of its neighbours.
pub(crate) const CONTEXT: usize = 8;
/// Directions closer than this make a straight line, radians.
const STRAIGHT_RAD: f64 = 1e-7;

/// Makes curves of the straight moves that may be smoothed within a limit.
pub(crate) fn smooth(moves: &mut [Move], limit_mm: f64) {
    if limit_mm <= 0.0 {
        return;
    }
    let mut first = 0;
    while first < moves.len() {
        let count = run(&moves[first..]);
        if count >= FEWEST {
            smooth_run(&mut moves[first..first + count], limit_mm);
        }
        first += count.max(1);
    }
}

/// Returns the number of moves from here on that make a run; 0 where none begins.
fn run(moves: &[Move]) -> usize {
    let straight = |m: &Move| m.kind == MoveKind::Cut && m.path == Path::Line && way(m).is_some();
    if !moves.first().is_some_and(straight) {
        return 0;
    }
    let goes_on = |pair: &[Move]| {
        let (a, b) = (&pair[0], &pair[1]);
        let turn = match (way(a), way(b)) {
            (Some(a), Some(b)) => angle(a, b),
            _ => return false,
        };
        straight(b) && b.continues(a) && turn <= SHARP_RAD + ANGLE_TOLERANCE_RAD
    };
    1 + moves.windows(2).take_while(|pair| goes_on(pair)).count()
}

/// The direction of a straight move; `None` when only rotary axes turn.
fn way(m: &Move) -> Option<Vec3> {
    unit(minus(m.to.first3(), m.from.first3()))
}

/// A run, at least three segments long.
struct Run {
    /// Direction and length of every segment.
    ways: Vec<(Vec3, f64)>,
    /// Direction of the curve at every vertex.
    directions: Vec<Vec3>,
}

fn smooth_run(moves: &mut [Move], limit_mm: f64) {
    let run = Run::of(moves);
    let fits = |m: &Move, start, end| {
        Spline::new(m.from.first3(), m.to.first3(), start, end).height() <= limit_mm
    };
    let ends = |k: usize| (run.directions[k], run.directions[k + 1]);
    let chosen: Vec<bool> =
        moves.iter().enumerate().map(|(k, m)| fits(m, ends(k).0, ends(k).1)).collect();
    for k in (0..moves.len()).filter(|k| chosen[*k]) {
        let (mut start, mut end) = ends(k);
        if k > 0 && !chosen[k - 1] && fits(&moves[k], run.ways[k - 1].0, end) {
            start = run.ways[k - 1].0;
        }
        if k + 1 < moves.len() && !chosen[k + 1] && fits(&moves[k], start, run.ways[k + 1].0) {
            end = run.ways[k + 1].0;
        }
        bend(&mut moves[k], start, end);
    }
}

impl Run {
    fn of(moves: &[Move]) -> Self {
        let step = |m: &Move| minus(m.to.first3(), m.from.first3());
        let ways: Vec<(Vec3, f64)> =
            moves.iter().map(|m| (unit(step(m)).unwrap_or_default(), length(step(m)))).collect();
        let mut directions = vec![ways[0].0; 1];
        directions.extend(ways.windows(2).map(|pair| through(pair[0], pair[1])));
        let last = ways.len() - 1;
        directions[0] = mirrored(directions[1], ways[0].0);
        directions.push(mirrored(directions[last], ways[last].0));
        Self { ways, directions }
    }
}

/// The direction of the circle through three places at the middle one, from the ways to and from it.
fn through((a, a_mm): (Vec3, f64), (b, b_mm): (Vec3, f64)) -> Vec3 {
    let sum: Vec3 = std::array::from_fn(|k| a[k] * b_mm + b[k] * a_mm);
    unit(sum).unwrap_or(a)
}

/// The direction of a circle at one end of a chord, from that at the other.
fn mirrored(direction: Vec3, chord: Vec3) -> Vec3 {
    minus(scaled(chord, 2.0 * dot(direction, chord)), direction)
}

/// Makes a curve of a straight move, unless it is straight after all.
fn bend(m: &mut Move, start: Vec3, end: Vec3) {
    let Some(chord) = way(m) else { return };
    if angle(start, chord).max(angle(end, chord)) < STRAIGHT_RAD {
        return;
    }
    let spline = Spline::new(m.from.first3(), m.to.first3(), start, end);
    // Speeds go on referring to the same kind of length, XY or XYZ.
    let axes = m.basis.axes();
    let (straight, curved) =
        (length_of(minus(m.to.first3(), m.from.first3()), axes), spline.length(axes));
    if straight > 0.0 {
        m.length_mm *= curved / straight;
        m.path = Path::Curve { start: start.map(|v| v as f32), end: end.map(|v| v as f32) };
    }
}

fn length_of(way: Vec3, axes: usize) -> f64 {
    way[..axes].iter().map(|v| v * v).sum::<f64>().sqrt()
}
