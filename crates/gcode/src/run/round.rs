//! Circles in a plane: sweeps, radii that count as one, chords.

use kerf_program::{Arc, Axes, Feed, MoveKind, Settings};
use std::f64::consts::{PI, TAU};

/// Ends this close together make a whole turn, mm.
pub(super) const SAME_MM: f64 = 1e-7;
/// Radii at the two ends may differ by so much, whatever the radius (LinuxCNC, grbl: close to this).
const RADII_MM: f64 = 0.0254;
/// They may differ by this share of the radius …
const RADII_SHARE: f64 = 0.001;
/// … but never by more than this, mm.
const RADII_MOST_MM: f64 = 2.54;
/// Chords of one arc; more is a number out of all proportion.
const MOST_CHORDS: f64 = 100_000.0;

/// The swept angle of an arc about a centre, positive counter-clockwise; a whole turn when the ends
/// are one place.
pub(super) fn sweep(from: [f64; 2], centre: [f64; 2], to: [f64; 2], clockwise: bool) -> f64 {
    let a = [from[0] - centre[0], from[1] - centre[1]];
    let b = [to[0] - centre[0], to[1] - centre[1]];
    let turn = if (from[0] - to[0]).abs() < SAME_MM && (from[1] - to[1]).abs() < SAME_MM {
        TAU
    } else {
        let (cross, dot) = (a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        let left = cross.atan2(dot);
        let forward = if clockwise { -left } else { left };
        if forward <= 0.0 { forward + TAU } else { forward }
    };
    if clockwise { -turn } else { turn }
}

/// Returns `true` if two radii count as one.
pub(super) fn agree(r1: f64, r2: f64) -> bool {
    let difference = (r1 - r2).abs();
    difference <= RADII_MM || difference <= RADII_MOST_MM && difference <= RADII_SHARE * r1.max(r2)
}

/// Returns `true` if two places lie on one circle about a centre.
pub(super) fn is_round(from: [f64; 2], centre: [f64; 2], to: [f64; 2]) -> bool {
    let (r1, r2) = (distance(from, centre), distance(to, centre));
    r1 > 0.0 && r2 > 0.0 && agree(r1, r2)
}

/// The sweep of an arc in XY by its centre; `None` when it is none.
pub(super) fn checked_sweep(
    from: Axes,
    centre: [f64; 2],
    to: Axes,
    clockwise: bool,
) -> Option<f64> {
    let (from, to) = ([from.0[0], from.0[1]], [to.0[0], to.0[1]]);
    is_round(from, centre, to).then(|| sweep(from, centre, to, clockwise))
}

/// The distance of two places.
pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    (x * x + y * y).sqrt()
}

/// The command of an arc in XY, machine frame.
pub(super) fn command(
    settings: &Settings,
    from: Axes,
    centre: [f64; 2],
    sweep_rad: f64,
    to: Axes,
    feed: Feed,
) -> Arc {
    let radius = distance([from.0[0], from.0[1]], centre);
    let chords = radius * sweep_rad.abs() / settings.resolution.circle_mm.max(1e-3);
    Arc {
        kind: MoveKind::Cut,
        centre,
        sweep_rad,
        to,
        feed,
        chords: (chords.ceil().min(MOST_CHORDS) as u32).max(1),
        small: 2.0 * radius < settings.ramps.small_circle_mm,
    }
}

/// Returns the number of chords with which an arc stays within a tolerance.
pub(super) fn chords_within(radius: f64, sweep: f64, tolerance: f64) -> u32 {
    let share = (1.0 - tolerance / radius.max(tolerance)).clamp(-1.0, 1.0);
    let step = (2.0 * share.acos()).clamp(1e-3, PI / 4.0);
    (sweep.abs() / step).ceil().clamp(1.0, MOST_CHORDS) as u32
}
