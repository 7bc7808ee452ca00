//! Calculations that the models share: directions of moves, lengths in space, and the time of a trapezoid.

use crate::moves::Move;
use kerf_program::{AXES, Axes, MoveKind};

/// A direction over all axes; of length 1 in XYZ, or over the rotary axes where nothing else moves.
pub(super) type Direction = [f64; AXES];

/// Shorter differences are rounding, mm or degrees.
const NOTHING_MM: f64 = 1e-9;

/// The direction and length of a straight way; `None` where nothing moves.
pub(super) fn way(from: Axes, to: Axes) -> Option<(Direction, f64)> {
    let delta = to.minus(from).0;
    let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let space = norm(&delta[..3]);
    let mm = if space > NOTHING_MM { space } else { norm(&delta[3..]) };
    (mm > NOTHING_MM).then(|| (delta.map(|d| d / mm), mm))
}

/// The length of a move that its feed counts on controllers that speak G-code, mm or degrees: in
/// XYZ, or over the rotary axes where nothing else moves.
pub(super) fn path_mm(m: &Move) -> f64 {
    match m.arc() {
        Some(arc) => arc.length().hypot(m.to.0[2] - m.from.0[2]),
        None => way(m.from, m.to).map_or(0.0, |(_, mm)| mm),
    }
}

/// The feed of a move along that length, mm/s; rapids go as fast as the axes can.
pub(super) fn feed_mm_s(m: &Move) -> f64 {
    match m.kind {
        MoveKind::Jog => f64::INFINITY,
        MoveKind::Cut => m.speed_mm_s * path_mm(m) / m.length_mm,
    }
}

/// The speed or acceleration in a direction at which no axis exceeds its own.
pub(super) fn within_axes(own: &Axes, way: &Direction) -> f64 {
    let limits = own.0.iter().zip(way).filter(|(_, share)| share.abs() > 1e-12);
    limits.map(|(own, share)| own / share.abs()).fold(f64::INFINITY, f64::min)
}

/// Seconds for a length with squared speeds at its ends, the highest speed and the acceleration.
pub(super) fn trapezoid_s(mm: f64, entry_sqr: f64, exit_sqr: f64, top: f64, accel: f64) -> f64 {
    let meet_sqr = 0.5 * (entry_sqr + exit_sqr) + accel * mm;
    let peak = meet_sqr.sqrt().min(top).max(entry_sqr.max(exit_sqr).sqrt());
    if peak <= 0.0 {
        return 0.0;
    }
    let ramps_s = (2.0 * peak - entry_sqr.sqrt() - exit_sqr.sqrt()) / accel;
    let ramps_mm = (2.0 * peak * peak - entry_sqr - exit_sqr) / (2.0 * accel);
    ramps_s + (mm - ramps_mm).max(0.0) / peak
}
