//! Two arcs that leave one place in one direction and come to another in another.

use crate::{Point2, Segment, Vec2};

/// A place on a curve with the unit direction of travel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Station {
    pub at: Point2,
    pub along: Vec2,
}

/// The two arcs from one station to the next, with one tangent where they meet.
///
/// Both tangent lengths d are chosen equal: with v the way between the stations and t the sum of
/// the directions, the joint lies at (p₀ + p₁ + d·(t₀ − t₁)) / 2 and
/// 2·d²·(1 − t₀·t₁) + 2·d·(v·t) − v·v = 0 (K. M. Bolton, Biarc curves, Computer-Aided Design 7, 1975).
/// Nothing when the stations coincide or no such joint lies ahead.
pub(super) fn biarc(from: Station, to: Station) -> Option<[Segment; 2]> {
    let v = to.at - from.at;
    let squared = v.dot(v);
    if squared == 0.0 {
        return None;
    }
    let d = tangent_length(v, from.along, to.along)?;
    let joint = from.at.midpoint(to.at) + (from.along - to.along) * (0.5 * d);
    let first = leaving(from, joint);
    let second = leaving(Station { at: to.at, along: -to.along }, joint).reversed();
    Some([first, second])
}

fn tangent_length(v: Vec2, t0: Vec2, t1: Vec2) -> Option<f64> {
    let (squared, ahead, turn) = (v.dot(v), v.dot(t0 + t1), 1.0 - t0.dot(t1));
    let root = (ahead * ahead + 2.0 * turn * squared).sqrt();
    // The form of the solution that does not cancel when the directions are nearly one.
    let d = squared / (ahead + root);
    (d.is_finite() && d > 0.0).then_some(d)
}

/// The arc from a station to a place: its sweep is twice the angle between direction and chord.
fn leaving(from: Station, to: Point2) -> Segment {
    let chord = to - from.at;
    let half_sweep = from.along.cross(chord).atan2(from.along.dot(chord));
    Segment::bulged(from.at, to, (0.5 * half_sweep).tan())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn check(from: (f64, f64, f64), to: (f64, f64, f64)) {
        let station = |(x, y, degrees): (f64, f64, f64)| Station {
            at: Point2::new(x, y),
            along: Vec2::from_angle(degrees.to_radians()),
        };
        let (from, to) = (station(from), station(to));
        let [first, second] = biarc(from, to).unwrap();
        let near = |a: Vec2, b: Vec2| assert!((a - b).length() < 1e-9, "{a:?} {b:?}");
        assert!(first.end().distance(second.start()) < 1e-12);
        near(first.direction(0.0), from.along);
        near(first.direction(1.0), second.direction(0.0));
        near(second.direction(1.0), to.along);
    }

    #[test]
    fn tangents_are_kept_at_both_ends_and_at_the_joint() {
        check((0.0, 0.0, 30.0), (10.0, 2.0, -20.0));
        check((0.0, 0.0, 0.0), (10.0, 2.0, 0.0));
        check((0.0, 0.0, 45.0), (10.0, 0.0, 45.0));
        check((0.0, 0.0, 0.0), (10.0, 0.0, 0.0));
        check((0.0, 0.0, 90.0), (10.0, 0.0, -90.0));
    }
}
