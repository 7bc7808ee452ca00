//! The six axes and values that each of them has.

use serde::{Deserialize, Serialize};
use std::ops::{Index, IndexMut};

/// Number of axes.
pub const AXES: usize = 6;

/// The letters of the axes in order.
pub const AXIS_LETTERS: [char; AXES] = ['X', 'Y', 'Z', 'A', 'B', 'C'];

/// One axis of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[allow(missing_docs)]
pub enum Axis {
    X,
    Y,
    Z,
    A,
    B,
    C,
}

impl Axis {
    /// All axes in order.
    pub const ALL: [Self; AXES] = [Self::X, Self::Y, Self::Z, Self::A, Self::B, Self::C];

    /// Position in [`Axes`].
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Its letter.
    pub const fn letter(self) -> char {
        AXIS_LETTERS[self as usize]
    }

    /// The axis of a letter, in either case.
    pub fn from_letter(letter: char) -> Option<Self> {
        Self::ALL.into_iter().find(|a| a.letter() == letter.to_ascii_uppercase())
    }
}

/// One number for each axis: a position or a distance, millimetres or degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Axes(pub [f64; AXES]);

impl Axes {
    /// The same value on every axis.
    pub const fn splat(value: f64) -> Self {
        Self([value; AXES])
    }

    /// X, Y and Z, the others zero.
    pub const fn xyz(x: f64, y: f64, z: f64) -> Self {
        Self([x, y, z, 0.0, 0.0, 0.0])
    }

    /// Applies a function to each pair of values.
    #[must_use]
    pub fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|i| f(self.0[i], other.0[i])))
    }

    /// Sum, axis by axis.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    /// Difference, axis by axis.
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }

    /// Returns `true` if going from here to there moves nothing: what is left of a change of units in
    /// the last bits of a number is no motion.
    pub fn same_place(&self, there: &Self) -> bool {
        self.0.iter().zip(&there.0).all(|(a, b)| (a - b).abs() <= 1e-9)
    }

    /// The first three values.
    pub fn first3(self) -> [f64; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }
}

impl Index<Axis> for Axes {
    type Output = f64;
    fn index(&self, axis: Axis) -> &f64 {
        &self.0[axis.index()]
    }
}

impl IndexMut<Axis> for Axes {
    fn index_mut(&mut self, axis: Axis) -> &mut f64 {
        &mut self.0[axis.index()]
    }
}

/// A set of axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct AxisSet(u8);

impl AxisSet {
    /// No axis.
    pub const EMPTY: Self = Self(0);

    /// Adds an axis.
    pub const fn insert(&mut self, axis: Axis) {
        self.0 |= 1 << axis.index();
    }

    /// Removes an axis.
    pub fn remove(&mut self, axis: Axis) {
        self.0 &= !(1 << axis.index());
    }

    /// The set with one more axis.
    #[must_use]
    pub const fn with(mut self, axis: Axis) -> Self {
        self.insert(axis);
        self
    }

    /// The first `n` axes.
    pub fn first(n: usize) -> Self {
        Axis::ALL.into_iter().take(n).fold(Self::EMPTY, Self::with)
    }

    /// The axes of both.
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The axes that the other set has not.
    #[must_use]
    pub const fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Returns `true` if the axis is in the set.
    pub const fn contains(self, axis: Axis) -> bool {
        self.0 & (1 << axis.index()) != 0
    }

    /// True without any axis.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The axes in order.
    pub fn iter(self) -> impl Iterator<Item = Axis> {
        Axis::ALL.into_iter().filter(move |a| self.contains(*a))
    }
}
