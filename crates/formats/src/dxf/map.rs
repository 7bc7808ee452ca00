//! Places in space, and the maps between the frames of a DXF file.
//!
//! Flat entities are drawn in a frame of their own whose Z axis is the *extrusion*; the axis
//! (0, 0, −1) mirrors the drawing (DXF reference, "Object coordinate systems").

use kerf_geom::{Point2, Transform2, Vec2};

/// A place or a direction in space, millimetres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3 {
    /// Along X.
    pub x: f64,
    /// Along Y.
    pub y: f64,
    /// Along Z.
    pub z: f64,
}

impl Vec3 {
    /// The vector with these components.
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// Without its height.
    pub fn flat(self) -> Point2 {
        Point2::new(self.x, self.y)
    }

    fn plus(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }

    fn times(self, by: f64) -> Self {
        Self::new(self.x * by, self.y * by, self.z * by)
    }

    /// At right angles to both, right-handed.
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    fn unit(self) -> Option<Self> {
        let length = (self.x * self.x + self.y * self.y + self.z * self.z).sqrt();
        (length > 0.0 && length.is_finite()).then(|| self.times(1.0 / length))
    }
}

/// An affine map of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Map3 {
    /// Images of the unit vectors.
    axes: [Vec3; 3],
    /// Image of the origin.
    origin: Vec3,
}

impl Map3 {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self {
        axes: [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0)],
        origin: Vec3::new(0.0, 0.0, 0.0),
    };

    /// Moves by a distance.
    pub const fn moved(by: Vec3) -> Self {
        Self { origin: by, ..Self::IDENTITY }
    }

    /// Scales along the axes.
    pub fn scaled(x: f64, y: f64, z: f64) -> Self {
        let [a, b, c] = Self::IDENTITY.axes;
        Self { axes: [a.times(x), b.times(y), c.times(z)], ..Self::IDENTITY }
    }

    /// Turns about Z, counter-clockwise.
    pub fn turned(degrees: f64) -> Self {
        let map = Transform2::turned(Point2::default(), degrees.to_radians());
        let flat = |v: Vec2| Vec3::new(v.x, v.y, 0.0);
        let axes = [flat(map.x_axis), flat(map.y_axis), Self::IDENTITY.axes[2]];
        Self { axes, ..Self::IDENTITY }
    }

    /// From the frame of an extrusion to the world (DXF reference, "Arbitrary axis algorithm").
    pub fn of_extrusion(extrusion: Vec3) -> Self {
        let Some(z) = extrusion.unit() else { return Self::IDENTITY };
        if z == Self::IDENTITY.axes[2] {
            return Self::IDENTITY;
        }
        let near_z = z.x.abs() < 1.0 / 64.0 && z.y.abs() < 1.0 / 64.0;
        let helper = Self::IDENTITY.axes[if near_z { 1 } else { 2 }];
        let x = helper.cross(z).unit().unwrap_or(Self::IDENTITY.axes[0]);
        Self { axes: [x, z.cross(x), z], ..Self::IDENTITY }
    }

    /// First this, then another.
    pub fn then(&self, next: &Self) -> Self {
        Self { axes: self.axes.map(|axis| next.turn(axis)), origin: next.apply(self.origin) }
    }

    /// Maps a place.
    pub fn apply(&self, place: Vec3) -> Vec3 {
        self.turn(place).plus(self.origin)
    }

    /// Maps a direction.
    pub fn turn(&self, v: Vec3) -> Vec3 {
        let [x, y, z] = self.axes;
        x.times(v.x).plus(y.times(v.y)).plus(z.times(v.z))
    }

    /// Returns what it does to a plane at a height, seen from above.
    pub fn plane(&self, height: f64) -> Transform2 {
        let [x, y, _] = self.axes;
        let origin = self.apply(Vec3::new(0.0, 0.0, height));
        Transform2 {
            x_axis: Vec2::new(x.x, x.y),
            y_axis: Vec2::new(y.x, y.y),
            origin: Vec2::new(origin.x, origin.y),
        }
    }

    /// Tells whether a level plane stays level.
    pub fn keeps_level(&self) -> bool {
        let [x, y, _] = self.axes;
        let size = x.x.hypot(x.y).max(y.x.hypot(y.y));
        x.z.abs().max(y.z.abs()) <= 1e-9 * size
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extrusion_downwards_mirrors_x() {
        let map = Map3::of_extrusion(Vec3::new(0.0, 0.0, -1.0));
        assert_eq!(map.apply(Vec3::new(3.0, 4.0, 5.0)), Vec3::new(-3.0, 4.0, -5.0));
        assert!(map.plane(0.0).determinant() < 0.0 && map.keeps_level());
    }

    #[test]
    fn a_slanted_extrusion_is_a_turn() {
        let map = Map3::of_extrusion(Vec3::new(1.0, 2.0, 3.0));
        let [x, y, z] = map.axes;
        let cross = x.cross(y);
        assert!((cross.x - z.x).hypot(cross.y - z.y).hypot(cross.z - z.z) < 1e-15);
        assert!(!map.keeps_level());
    }

    #[test]
    fn maps_follow_each_other() {
        let both = Map3::scaled(2.0, 3.0, 1.0).then(&Map3::turned(90.0));
        let both = both.then(&Map3::moved(Vec3::new(10.0, 0.0, 1.0)));
        assert_eq!(both.apply(Vec3::new(1.0, 1.0, 0.0)), Vec3::new(7.0, 2.0, 1.0));
    }
}
