//! Reach of a jog.

use kerf_program::{AXES, Axes, Axis, Settings};

/// Longest way when no table limit is in its way, mm or degrees.
const FAR: f64 = 10_000.0;

/// Returns the way from a table base coordinate in a direction, as a factor of it: the distance that
/// somebody wants, or to the table limits where they are checked.
pub fn reach(
    settings: &Settings,
    base: Axes,
    direction: [f64; AXES],
    distance: Option<f64>,
) -> f64 {
    let mut far = distance.unwrap_or(FAR);
    for axis in Axis::ALL.into_iter().filter(|_| settings.limits.check) {
        let way = direction[axis.index()];
        let limit = if way > 0.0 { settings.limits.high } else { settings.limits.low }[axis];
        if way != 0.0 {
            far = far.min(((limit - base[axis]) / way).max(0.0));
        }
    }
    far
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_jog_ends_at_its_distance_or_at_the_limits() {
        let mut settings = Settings::default();
        settings.limits.low = Axes::splat(0.0);
        settings.limits.high = Axes::splat(100.0);
        let at = Axes::xyz(40.0, 90.0, 0.0);
        let check = |settings: &Settings, x: f64, y: f64, distance, expected: f64| {
            let far = reach(settings, at, [x, y, 0.0, 0.0, 0.0, 0.0], distance);
            assert!((far - expected).abs() < 1e-9, "{x} {y}: {far}");
        };
        settings.limits.check = false;
        check(&settings, 1.0, 0.0, None, FAR);
        settings.limits.check = true;
        check(&settings, 1.0, 0.0, None, 60.0);
        check(&settings, -1.0, 0.0, None, 40.0);
        check(&settings, 1.0, 1.0, None, 10.0);
        check(&settings, 1.0, 0.0, Some(5.0), 5.0);
        check(&settings, 0.0, 0.5, Some(50.0), 20.0);
    }
}
