//! Axis-aligned boxes in space.

use serde::{Deserialize, Serialize};

/// The smallest box that holds what was added; empty until something is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds3 {
    /// Lowest X, Y, Z.
    pub min: [f64; 3],
    /// Highest X, Y, Z.
    pub max: [f64; 3],
}

impl Default for Bounds3 {
    fn default() -> Self {
        Self { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] }
    }
}

impl Bounds3 {
    /// True until a place was added.
    pub fn is_empty(&self) -> bool {
        self.min[0] > self.max[0]
    }

    /// Grows to hold a place.
    pub fn add(&mut self, place: [f64; 3]) {
        for (axis, value) in place.into_iter().enumerate() {
            self.min[axis] = self.min[axis].min(value);
            self.max[axis] = self.max[axis].max(value);
        }
    }

    /// Grows to hold another box.
    pub fn merge(&mut self, other: &Self) {
        if !other.is_empty() {
            self.add(other.min);
            self.add(other.max);
        }
    }

    /// Extent along each axis; zero when empty.
    pub fn size(&self) -> [f64; 3] {
        if self.is_empty() { [0.0; 3] } else { std::array::from_fn(|i| self.max[i] - self.min[i]) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grows_and_merges() {
        let mut b = Bounds3::default();
        assert!(b.is_empty());
        assert_eq!(b.size(), [0.0; 3]);
        b.add([1.0, 2.0, 3.0]);
        let mut c = Bounds3::default();
        c.merge(&b);
        c.add([0.0, 4.0, 3.0]);
        assert_eq!((c.min, c.max, c.size()), ([0.0, 2.0, 3.0], [1.0, 4.0, 3.0], [1.0, 2.0, 0.0]));
    }
}
