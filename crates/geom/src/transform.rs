//! Moves, turns, scalings and mirrorings of the plane.

use crate::{Point2, Vec2};
use serde::{Deserialize, Serialize};

/// An affine map: x' = a·x + c·y + e, y' = b·x + d·y + f.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Transform2 {
    /// Image of the unit vector along X.
    pub x_axis: Vec2,
    /// Image of the unit vector along Y.
    pub y_axis: Vec2,
    /// Image of the origin.
    pub origin: Vec2,
}

impl Default for Transform2 {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Transform2 {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self {
        x_axis: Vec2::new(1.0, 0.0),
        y_axis: Vec2::new(0.0, 1.0),
        origin: Vec2::new(0.0, 0.0),
    };

    /// Moves by a displacement.
    pub const fn moved(by: Vec2) -> Self {
        Self { origin: by, ..Self::IDENTITY }
    }

    /// Turns counter-clockwise about a place. Quarter turns are exact.
    pub fn turned(about: Point2, rad: f64) -> Self {
        let quarters = rad / std::f64::consts::FRAC_PI_2;
        let x_axis = if quarters == quarters.round() {
            let axes = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
            let (x, y) = axes[quarters.rem_euclid(4.0) as usize % 4];
            Vec2::new(x, y)
        } else {
            Vec2::from_angle(rad)
        };
        Self { x_axis, y_axis: x_axis.left(), ..Self::IDENTITY }.about(about)
    }

    /// Scales X and Y about a place.
    pub fn scaled(about: Point2, x: f64, y: f64) -> Self {
        Self { x_axis: Vec2::new(x, 0.0), y_axis: Vec2::new(0.0, y), ..Self::IDENTITY }.about(about)
    }

    /// Mirrors at the line through a place along a direction; the identity for a null direction.
    pub fn mirrored(at: Point2, along: Vec2) -> Self {
        let Some(u) = along.normalized() else { return Self::IDENTITY };
        let (cos, sin) = (u.x * u.x - u.y * u.y, 2.0 * u.x * u.y);
        let (x_axis, y_axis) = (Vec2::new(cos, sin), Vec2::new(sin, -cos));
        Self { x_axis, y_axis, ..Self::IDENTITY }.about(at)
    }

    /// The same map with `place` in the role of the origin.
    #[must_use]
    pub fn about(self, place: Point2) -> Self {
        let to = place - Point2::default();
        Self { origin: self.origin + to - self.turn(to), ..self }
    }

    /// First this, then another.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        Self {
            x_axis: next.turn(self.x_axis),
            y_axis: next.turn(self.y_axis),
            origin: next.turn(self.origin) + next.origin,
        }
    }

    /// The map that undoes this one; nothing when it flattens the plane.
    pub fn inverse(&self) -> Option<Self> {
        let det = self.determinant();
        if det == 0.0 || !det.is_finite() {
            return None;
        }
        let x_axis = Vec2::new(self.y_axis.y, -self.x_axis.y) / det;
        let y_axis = Vec2::new(-self.y_axis.x, self.x_axis.x) / det;
        let back = Self { x_axis, y_axis, ..Self::IDENTITY };
        Some(Self { origin: -back.turn(self.origin), ..back })
    }

    /// Maps a place.
    pub fn apply(&self, place: Point2) -> Point2 {
        Point2::default() + self.turn(place - Point2::default()) + self.origin
    }

    /// Maps a displacement.
    pub fn turn(&self, v: Vec2) -> Vec2 {
        self.x_axis * v.x + self.y_axis * v.y
    }

    /// Returns the factor by which areas grow; negative when it mirrors.
    pub fn determinant(&self) -> f64 {
        self.x_axis.cross(self.y_axis)
    }

    /// Tells whether circles stay circles: the axes stay square to each other and equally long.
    pub fn keeps_circles(&self) -> bool {
        let (x, y) = (self.x_axis, self.y_axis);
        let size = x.dot(x).max(y.dot(y));
        x.dot(y).abs() <= 1e-12 * size && (x.dot(x) - y.dot(y)).abs() <= 1e-12 * size
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: Point2, b: Point2) -> bool {
        a.distance(b) < 1e-9
    }

    #[test]
    fn maps_and_their_inverses() {
        let p = Point2::new(3.0, 1.0);
        let c = Point2::new(1.0, 1.0);
        let quarter = Transform2::turned(c, std::f64::consts::FRAC_PI_2);
        assert_eq!(quarter.apply(p), Point2::new(1.0, 3.0));
        assert_eq!(Transform2::scaled(c, 2.0, 1.0).apply(p), Point2::new(5.0, 1.0));
        let mirror = Transform2::mirrored(c, Vec2::new(1.0, 1.0));
        assert!(close(mirror.apply(p), Point2::new(1.0, 3.0)));
        assert!(mirror.determinant() < 0.0 && mirror.keeps_circles());
        let both = quarter.then(&Transform2::scaled(c, 2.0, 3.0));
        assert!(close(both.inverse().expect("an inverse").apply(both.apply(p)), p));
        assert!(!both.keeps_circles());
        assert!(Transform2::scaled(c, 0.0, 1.0).inverse().is_none());
    }
}
