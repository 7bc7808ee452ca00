//! The fastest straight way from rest to rest with limited speed, acceleration and jerk: up to seven
//! phases of constant jerk.

/// A phase of constant jerk.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phase {
    pub duration_s: f64,
    pub jerk: f64,
}

/// The phases over a length; those without duration are left out.
pub(crate) fn phases(length: f64, v: f64, a: f64, j: f64) -> impl Iterator<Item = Phase> {
    let a = a.min((v * j).sqrt());
    // Distance from rest to the top speed, twice: is there any left to cruise?
    let full = v * (v / a + a / j);
    let (rise, hold, cruise) = if length >= full {
        (a / j, v / a - a / j, (length - full) / v)
    } else if length >= 2.0 * a * a * a / (j * j) {
        let ratio = a / j;
        let top = 0.5 * a * ((ratio * ratio + 4.0 * length / a).sqrt() - ratio);
        (ratio, top / a - ratio, 0.0)
    } else {
        ((0.5 * length / j).cbrt(), 0.0, 0.0)
    };
    let row =
        [(rise, j), (hold, 0.0), (rise, -j), (cruise, 0.0), (rise, -j), (hold, 0.0), (rise, j)];
    row.into_iter()
        .filter(|(duration_s, _)| *duration_s > 0.0)
        .map(|(duration_s, jerk)| Phase { duration_s, jerk })
}
