//! Axis-aligned boxes in the plane.

use crate::{Point2, Vec2};
use serde::{Deserialize, Serialize};

/// The smallest upright rectangle that holds what was added; empty until something is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds2 {
    /// Lower left corner.
    pub min: Point2,
    /// Upper right corner.
    pub max: Point2,
}

impl Default for Bounds2 {
    fn default() -> Self {
        let far = f64::INFINITY;
        Self { min: Point2::new(far, far), max: Point2::new(-far, -far) }
    }
}

impl Bounds2 {
    /// The box with two places as opposite corners.
    pub fn of(a: Point2, b: Point2) -> Self {
        Self {
            min: Point2::new(a.x.min(b.x), a.y.min(b.y)),
            max: Point2::new(a.x.max(b.x), a.y.max(b.y)),
        }
    }

    /// True until a place was added.
    pub fn is_empty(&self) -> bool {
        self.min.x > self.max.x
    }

    /// Grows to hold a place.
    pub fn add(&mut self, place: Point2) {
        self.min = Point2::new(self.min.x.min(place.x), self.min.y.min(place.y));
        self.max = Point2::new(self.max.x.max(place.x), self.max.y.max(place.y));
    }

    /// Grows to hold another box.
    pub fn merge(&mut self, other: &Self) {
        self.min = Point2::new(self.min.x.min(other.min.x), self.min.y.min(other.min.y));
        self.max = Point2::new(self.max.x.max(other.max.x), self.max.y.max(other.max.y));
    }

    /// The box with a margin on every side (a negative one shrinks it).
    pub fn grown(&self, margin: f64) -> Self {
        let by = Vec2::new(margin, margin);
        Self { min: self.min - by, max: self.max + by }
    }

    /// Width and height; zero when empty.
    pub fn size(&self) -> Vec2 {
        if self.is_empty() { Vec2::default() } else { self.max - self.min }
    }

    /// The middle.
    pub fn centre(&self) -> Point2 {
        self.min.midpoint(self.max)
    }

    /// Tells whether a place lies inside or on the edge.
    pub fn holds(&self, place: Point2) -> bool {
        self.min.x <= place.x
            && place.x <= self.max.x
            && self.min.y <= place.y
            && place.y <= self.max.y
    }

    /// Tells whether another box lies inside or on the edge.
    pub fn holds_box(&self, other: &Self) -> bool {
        self.holds(other.min) && self.holds(other.max)
    }

    /// Tells whether two boxes share a place.
    pub fn meets(&self, other: &Self) -> bool {
        self.min.x <= other.max.x
            && other.min.x <= self.max.x
            && self.min.y <= other.max.y
            && other.min.y <= self.max.y
    }

    /// Squared distance from a place; 0 inside.
    pub fn distance_squared(&self, place: Point2) -> f64 {
        let dx = (self.min.x - place.x).max(place.x - self.max.x).max(0.0);
        let dy = (self.min.y - place.y).max(place.y - self.max.y).max(0.0);
        dx * dx + dy * dy
    }
}

impl FromIterator<Point2> for Bounds2 {
    fn from_iter<I: IntoIterator<Item = Point2>>(places: I) -> Self {
        let mut bounds = Self::default();
        places.into_iter().for_each(|place| bounds.add(place));
        bounds
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_from_its_edge() {
        let b = Bounds2::of(Point2::new(2.0, 1.0), Point2::new(0.0, 0.0));
        assert!(b.holds(Point2::new(2.0, 0.5)) && !b.holds(Point2::new(2.1, 0.5)));
        assert_eq!(b.distance_squared(Point2::new(5.0, 5.0)), 25.0);
        assert_eq!(b.distance_squared(Point2::new(1.0, 0.5)), 0.0);
        assert!(Bounds2::default().is_empty() && !b.meets(&Bounds2::default()));
    }
}
