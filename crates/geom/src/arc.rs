//! Circular arcs in the plane.

use crate::{Point2, Vec2};
use serde::{Deserialize, Serialize};

/// An arc given by where it starts, its centre and the angle swept.
///
/// `sweep_rad` is positive counter-clockwise and may exceed a turn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Arc2 {
    /// Start of travel.
    pub start: Point2,
    /// Centre of the circle.
    pub centre: Point2,
    /// Swept angle, radians, positive counter-clockwise.
    pub sweep_rad: f64,
}

impl Arc2 {
    /// Radius of the circle.
    pub fn radius(&self) -> f64 {
        self.start.distance(self.centre)
    }

    /// Length of the path.
    pub fn length(&self) -> f64 {
        self.radius() * self.sweep_rad.abs()
    }

    /// The place after a share of the path, 0 … 1.
    pub fn at(&self, share: f64) -> Point2 {
        self.centre + (self.start - self.centre).rotated(self.sweep_rad * share)
    }

    /// Returns the place where travel ends.
    pub fn end(&self) -> Point2 {
        self.at(1.0)
    }

    /// Unit direction of travel after a share of the path.
    pub fn direction(&self, share: f64) -> Vec2 {
        let radial = (self.start - self.centre).rotated(self.sweep_rad * share);
        let along = if self.sweep_rad < 0.0 { -radial.left() } else { radial.left() };
        along.normalized().unwrap_or_default()
    }

    /// Calls `visit` with the start, the end and every point where the arc touches its bounding box.
    ///
    /// These places span the exact bounds of the arc.
    pub fn extremes(&self, mut visit: impl FnMut(Point2)) {
        visit(self.start);
        visit(self.end());
        let from = (self.start - self.centre).angle();
        let radius = self.radius();
        let quarter = std::f64::consts::FRAC_PI_2;
        for k in 0..4 {
            let angle = quarter * f64::from(k);
            let turn = if self.sweep_rad < 0.0 { from - angle } else { angle - from };
            if turn.rem_euclid(4.0 * quarter) <= self.sweep_rad.abs() {
                let axis = [
                    Vec2::new(1.0, 0.0),
                    Vec2::new(0.0, 1.0),
                    Vec2::new(-1.0, 0.0),
                    Vec2::new(0.0, -1.0),
                ];
                visit(self.centre + axis[k as usize] * radius);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    fn arc(sx: f64, sy: f64, sweep_rad: f64) -> Arc2 {
        Arc2 { start: Point2::new(sx, sy), centre: Point2::default(), sweep_rad }
    }

    fn bounds(a: &Arc2) -> (f64, f64, f64, f64) {
        let mut b = (f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY);
        a.extremes(|p| b = (b.0.min(p.x), b.1.min(p.y), b.2.max(p.x), b.3.max(p.y)));
        b
    }

    #[test]
    fn runs_where_it_should() {
        let a = arc(2.0, 0.0, -FRAC_PI_2);
        assert!(a.end().distance(Point2::new(0.0, -2.0)) < 1e-12);
        assert!((a.direction(0.0) - Vec2::new(0.0, -1.0)).length() < 1e-12);
        assert!((a.length() - PI).abs() < 1e-12);
    }

    #[test]
    fn bounds_hold_the_bulge_and_nothing_else() {
        let near = |a: (f64, f64, f64, f64), b: (f64, f64, f64, f64)| {
            (a.0 - b.0).abs() + (a.1 - b.1).abs() + (a.2 - b.2).abs() + (a.3 - b.3).abs() < 1e-9
        };
        assert!(near(bounds(&arc(1.0, 0.0, TAU)), (-1.0, -1.0, 1.0, 1.0)));
        assert!(near(bounds(&arc(1.0, 0.0, PI)), (-1.0, 0.0, 1.0, 1.0)));
        let short = bounds(&arc(0.8, 0.6, 0.1));
        assert!(short.2 < 0.81 && short.3 < 0.7, "{short:?}");
        let across = bounds(&arc(0.8, -0.6, 1.4));
        assert!((across.2 - 1.0).abs() < 1e-12);
    }
}
