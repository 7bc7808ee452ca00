//! Arcs of the fake, cut into chords as its tolerance (`$12`) says.

use kerf_machine::driver::Axes;
use std::f64::consts::TAU;

/// The ends of an arc may lie on circles that differ so much, mm.
const UNROUND_MM: f64 = 0.005;

/// The ends of the chords of an arc, the last one first; the number of the error where it is none.
pub fn chords(
    from: Axes,
    to: Axes,
    by: [f64; 2],
    counter: bool,
    tolerance_mm: f64,
) -> Result<Vec<Axes>, u16> {
    let centre = [from.0[0] + by[0], from.0[1] + by[1]];
    let radius_mm = by[0].hypot(by[1]);
    let end = [to.0[0] - centre[0], to.0[1] - centre[1]];
    if radius_mm == 0.0 || (end[0].hypot(end[1]) - radius_mm).abs() > UNROUND_MM {
        return Err(33);
    }
    let begin_rad = (-by[1]).atan2(-by[0]);
    let turned = (end[1].atan2(end[0]) - begin_rad).rem_euclid(TAU);
    let is_full = from.0[..2] == to.0[..2];
    let sweep_rad = match (is_full, counter) {
        (true, true) => TAU,
        (true, false) => -TAU,
        (false, true) => turned,
        (false, false) => turned - TAU,
    };
    let half_mm = (tolerance_mm * (2.0 * radius_mm - tolerance_mm)).sqrt();
    let count = ((0.5 * sweep_rad.abs() * radius_mm / half_mm) as usize).max(1);
    let chord = |n: usize| {
        let share = n as f64 / count as f64;
        let (sine, cosine) = (begin_rad + share * sweep_rad).sin_cos();
        let mut at = from.zip(to, |from, to| from + (to - from) * share);
        (at.0[0], at.0[1]) = (centre[0] + radius_mm * cosine, centre[1] + radius_mm * sine);
        at
    };
    Ok([to].into_iter().chain((1..count).rev().map(chord)).collect())
}
