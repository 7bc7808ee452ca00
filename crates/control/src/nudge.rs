//! Small adjustments of where the workpiece is (MN).

use kerf_program::{Axes, Axis, Frame, Settings};
use std::fmt;

/// How far an axis is nudged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nudge {
    /// The axis.
    pub axis: Axis,
    /// How far: as somebody gives it in units of the axis, inside mm or degrees.
    pub distance: f64,
}

/// A place that the table limits do not allow.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{} would leave the table limits", axis.letter())]
pub struct Outside {
    /// The axis that would leave them.
    pub axis: Axis,
    /// The table base coordinate it would reach, mm or degrees.
    pub reached: f64,
}

impl Nudge {
    /// Reads `nudge y .05`, in units of the axis.
    pub fn read(words: &str) -> Option<Self> {
        let mut words = words.split_whitespace();
        let (command, axis, distance) = (words.next()?, words.next()?, words.next()?);
        let mut letters = axis.chars();
        let axis = Axis::from_letter(letters.next()?)?;
        let distance = distance.parse().ok().filter(|d: &f64| d.is_finite())?;
        let whole = letters.next().is_none() && words.next().is_none();
        (whole && command.eq_ignore_ascii_case("nudge")).then_some(Self { axis, distance })
    }

    /// As a displacement of all axes.
    pub(crate) fn way(self) -> Axes {
        let mut way = Axes::default();
        way[self.axis] = self.distance;
        way
    }

    /// Whether the table has room for it; the distance in mm or degrees.
    ///
    /// # Errors
    /// [`Outside`] when table limits are checked and do not allow the place it leads to.
    pub fn check(self, settings: &Settings, frame: &Frame, position: Axes) -> Result<(), Outside> {
        let (limits, axis) = (&settings.limits, self.axis);
        let reached = frame.base(position)[axis] + self.distance;
        if limits.check && !(limits.low[axis]..=limits.high[axis]).contains(&reached) {
            return Err(Outside { axis, reached });
        }
        Ok(())
    }
}

impl fmt::Display for Nudge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "nudge {} {}", self.axis.letter(), self.distance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nudge_has_an_axis_and_a_distance() {
        let y = Nudge { axis: Axis::Y, distance: 0.05 };
        assert_eq!(Nudge::read("nudge y .05"), Some(y));
        assert_eq!(Nudge::read(&y.to_string()), Some(y));
        assert_eq!(Nudge::read(" Nudge  Y  +0.05 "), Some(y));
        for wrong in ["", "nudge", "nudge y", "nudge yy 1", "nudge y 1 2", "nudge y inf", "y .05"] {
            assert_eq!(Nudge::read(wrong), None, "{wrong}");
        }
    }
}
