//! Elliptical arcs of paths, given by their end points.

use kerf_geom::fit::Ellipse;
use kerf_geom::{Point2, Vec2};

/// The words of an arc command besides its end.
#[derive(Clone, Copy, Debug)]
pub struct ArcWords {
    /// Half axes.
    pub rx: f64,
    /// Half axes.
    pub ry: f64,
    /// Turn of the first half axis, degrees.
    pub rotation_deg: f64,
    /// The arc of more than half a turn is meant.
    pub large: bool,
    /// The arc in the direction of growing angles is meant.
    pub sweep: bool,
}

/// The ellipse of an arc between two places; nothing when it is a line (SVG 1.1, appendix F.6).
pub fn ellipse(from: Point2, to: Point2, words: &ArcWords) -> Option<Ellipse> {
    let (mut rx, mut ry) = (words.rx.abs(), words.ry.abs());
    if rx == 0.0 || ry == 0.0 || from == to {
        return None;
    }
    let turn = words.rotation_deg.to_radians();
    // F.6.5, step 1: half of the way back, in the frame of the ellipse.
    let half = ((from - to) * 0.5).rotated(-turn);
    // F.6.6: half axes that do not reach are made longer.
    let lambda = (half.x / rx).powi(2) + (half.y / ry).powi(2);
    if lambda > 1.0 {
        (rx, ry) = (rx * lambda.sqrt(), ry * lambda.sqrt());
    }
    let (a, b) = (rx * half.y, ry * half.x);
    let reach = a * a + b * b;
    let factor = ((rx * ry).powi(2) - reach).max(0.0) / reach;
    let side = if words.large == words.sweep { -1.0 } else { 1.0 };
    // Step 2: the centre in the frame of the ellipse; step 3: in the plane.
    let middle = Vec2::new(rx * half.y / ry, -ry * half.x / rx) * (side * factor.sqrt());
    let centre = from.midpoint(to) + middle.rotated(turn);
    // Step 4: the parameters of both ends.
    let angle = |v: Vec2| (v.y / ry).atan2(v.x / rx);
    let (start, end) = (angle(half - middle), angle(-half - middle));
    let sweep = (end - start).rem_euclid(std::f64::consts::TAU);
    let sweep = if words.sweep { sweep } else { sweep - std::f64::consts::TAU };
    Some(Ellipse {
        centre,
        major: Vec2::new(rx, 0.0).rotated(turn),
        minor: Vec2::new(0.0, ry).rotated(turn),
        from_rad: start,
        to_rad: start + sweep,
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn check(large: bool, sweep: bool, centre: (f64, f64), degrees: f64) {
        let words = ArcWords { rx: 10.0, ry: 10.0, rotation_deg: 0.0, large, sweep };
        let (from, to) = (Point2::new(10.0, 0.0), Point2::new(0.0, 10.0));
        let arc = ellipse(from, to, &words).unwrap();
        assert!(arc.centre.distance(Point2::new(centre.0, centre.1)) < 1e-9, "{arc:?}");
        assert!(((arc.to_rad - arc.from_rad).to_degrees() - degrees).abs() < 1e-9, "{arc:?}");
        assert!(arc.at(arc.from_rad).0.distance(from) < 1e-9);
        assert!(arc.at(arc.to_rad).0.distance(to) < 1e-9);
    }

    #[test]
    fn all_four_arcs_between_two_places() {
        check(false, true, (0.0, 0.0), 90.0);
        check(true, true, (10.0, 10.0), 270.0);
        check(false, false, (10.0, 10.0), -90.0);
        check(true, false, (0.0, 0.0), -270.0);
    }

    #[test]
    fn axes_that_do_not_reach_are_made_longer() {
        let words = ArcWords { rx: 1.0, ry: 1.0, rotation_deg: 30.0, large: false, sweep: true };
        let arc = ellipse(Point2::new(-5.0, 0.0), Point2::new(5.0, 0.0), &words).unwrap();
        assert!(arc.centre.distance(Point2::default()) < 1e-9);
        assert!((arc.major.length() - 5.0).abs() < 1e-9);
    }
}
