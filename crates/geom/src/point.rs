//! Places and displacements in the plane.

use serde::{Deserialize, Serialize};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A place in the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Point2 {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
}

/// A displacement in the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Vec2 {
    /// First component.
    pub x: f64,
    /// Second component.
    pub y: f64,
}

impl Point2 {
    /// The place with these coordinates.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Distance to another place.
    pub fn distance(self, other: Self) -> f64 {
        (other - self).length()
    }

    /// The place halfway to `other`.
    pub fn midpoint(self, other: Self) -> Self {
        self + (other - self) * 0.5
    }
}

impl Vec2 {
    /// The displacement with these components.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Unit vector at a mathematical angle.
    pub fn from_angle(rad: f64) -> Self {
        let (sin, cos) = rad.sin_cos();
        Self::new(cos, sin)
    }

    /// Euclidean length.
    pub fn length(self) -> f64 {
        self.x.hypot(self.y)
    }

    /// Mathematical angle in −π … π; 0 for the null vector.
    pub fn angle(self) -> f64 {
        self.y.atan2(self.x)
    }

    /// Inner product.
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// Signed area of the parallelogram, positive when `other` lies to the left.
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// Turned a quarter to the left.
    pub fn left(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// Turned counter-clockwise.
    pub fn rotated(self, rad: f64) -> Self {
        let (sin, cos) = rad.sin_cos();
        Self::new(self.x * cos - self.y * sin, self.x * sin + self.y * cos)
    }

    /// The same direction with length 1, or nothing for the null vector.
    pub fn normalized(self) -> Option<Self> {
        let length = self.length();
        (length > 0.0).then(|| self / length)
    }

    /// Each component scaled by its own factor.
    pub fn scaled(self, x: f64, y: f64) -> Self {
        Self::new(self.x * x, self.y * y)
    }
}

/// Unit vector at a clock angle: degrees, clockwise from +Y.
///
/// ```
/// let v = kerf_geom::clock_to_vec(90.0);
/// assert!((v.x - 1.0).abs() < 1e-15 && v.y.abs() < 1e-15);
/// ```
pub fn clock_to_vec(degrees: f64) -> Vec2 {
    // Quarter turns are exact, so that full and quarter circles end where they should.
    match degrees.rem_euclid(360.0) {
        0.0 => Vec2::new(0.0, 1.0),
        90.0 => Vec2::new(1.0, 0.0),
        180.0 => Vec2::new(0.0, -1.0),
        270.0 => Vec2::new(-1.0, 0.0),
        turn => {
            let (sin, cos) = turn.to_radians().sin_cos();
            Vec2::new(sin, cos)
        }
    }
}

/// Clock angle of a displacement in 0 … 360 degrees; 0 for the null vector.
pub fn vec_to_clock(v: Vec2) -> f64 {
    v.x.atan2(v.y).to_degrees().rem_euclid(360.0)
}

impl Sub for Point2 {
    type Output = Vec2;
    fn sub(self, other: Self) -> Vec2 {
        Vec2::new(self.x - other.x, self.y - other.y)
    }
}

impl Add<Vec2> for Point2 {
    type Output = Self;
    fn add(self, by: Vec2) -> Self {
        Self::new(self.x + by.x, self.y + by.y)
    }
}

impl AddAssign<Vec2> for Point2 {
    fn add_assign(&mut self, by: Vec2) {
        *self = *self + by;
    }
}

impl Sub<Vec2> for Point2 {
    type Output = Self;
    fn sub(self, by: Vec2) -> Self {
        Self::new(self.x - by.x, self.y - by.y)
    }
}

impl Add for Vec2 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Vec2 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl Neg for Vec2 {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl Mul<f64> for Vec2 {
    type Output = Self;
    fn mul(self, by: f64) -> Self {
        Self::new(self.x * by, self.y * by)
    }
}

impl Div<f64> for Vec2 {
    type Output = Self;
    fn div(self, by: f64) -> Self {
        Self::new(self.x / by, self.y / by)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clock_angles_name_points_clockwise_from_twelve() {
        for (clock, x, y) in
            [(0.0, 0.0, 1.0), (90.0, 1.0, 0.0), (-90.0, -1.0, 0.0), (540.0, 0.0, -1.0)]
        {
            assert_eq!(clock_to_vec(clock), Vec2::new(x, y), "{clock}");
        }
        let v = clock_to_vec(202.5);
        assert!((vec_to_clock(v) - 202.5).abs() < 1e-12);
    }

    #[test]
    fn left_is_a_quarter_turn_counter_clockwise() {
        let v = Vec2::new(3.0, 1.0);
        assert!(v.cross(v.left()) > 0.0 && v.dot(v.left()) == 0.0);
        assert!((v.rotated(std::f64::consts::FRAC_PI_2) - v.left()).length() < 1e-12);
    }
}
