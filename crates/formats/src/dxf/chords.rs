//! Paths as short lines.

use kerf_geom::{Point2, Polyarc, Segment};

/// Places along a path such that the chords between them stay within the tolerance.
pub(super) fn chords(path: &Polyarc, tolerance: f64) -> Vec<Point2> {
    let mut places: Vec<Point2> = path.start().into_iter().collect();
    for segment in path.segments() {
        let count = match segment {
            Segment::Line { .. } => 1,
            Segment::Arc { radius, sweep_rad, .. } => {
                let step = 2.0 * (1.0 - (tolerance / radius).min(1.0)).acos();
                (sweep_rad.abs() / step).ceil().clamp(1.0, 10_000.0) as u32
            }
        };
        places.extend((1..=count).map(|n| segment.at(f64::from(n) / f64::from(count))));
    }
    if path.closed {
        places.pop();
    }
    places
}
