//! Small adjustments of where the workpiece is (MN).

use kerf_program::{Axes, Axis, Frame, Settings};
use std::fmt;

/// Nudge of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nudge {
    /// The axis.
    pub axis: Axis,
    /// Distance: as somebody gives it in units of the axis, inside mm or degrees.
    pub distance: f64,
}

/// A place that an axis may not be moved to; where it would be, mm or degrees.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Outside {
    /// Outside the table limits, in table base coordinates.
    #[error("{} would leave the table limits", .0.letter())]
    Table(Axis, f64),
    /// Beyond its length or below Z bottom, from home.
    #[error(
        "Out of bounds: {letter} would reach {reached:.3} from home; its length (axes.length) bounds it, and Z bottom \
         (zpos.bottom_mm)", letter = .0.letter(), reached = .1
    )]
    Room(Axis, f64),
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

    /// Checks that the table has room for it; the distance in mm or degrees.
    ///
    /// # Errors
    /// [`Outside`] when table limits are checked and do not allow the place it leads to.
    pub fn check(self, settings: &Settings, frame: &Frame, position: Axes) -> Result<(), Outside> {
        let (limits, axis) = (&settings.limits, self.axis);
        let reached = frame.base(position)[axis] + self.distance;
        if limits.check && !(limits.low[axis]..=limits.high[axis]).contains(&reached) {
            return Err(Outside::Table(axis, reached));
        }
        Ok(())
    }

    /// Checks that an axis that stands at a position has room for it, machine frame; the way back into its room always
    /// has.
    ///
    /// # Errors
    /// [`Outside`] when it leads out, or further out.
    pub fn within(self, (low, high): (f64, f64), position: Axes) -> Result<(), Outside> {
        let reached = position[self.axis] + self.distance;
        let leaves = if self.distance < 0.0 { reached < low } else { reached > high };
        if leaves { Err(Outside::Room(self.axis, reached)) } else { Ok(()) }
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
    fn a_nudge_stays_in_the_room_of_its_axis_or_leads_back() {
        let check = |at: f64, distance: f64, expected: bool| {
            let nudge = Nudge { axis: Axis::Z, distance };
            let within = nudge.within((-30.0, 0.0), Axes::xyz(0.0, 0.0, at));
            assert_eq!(within.is_ok(), expected, "{at} by {distance}: {within:?}");
        };
        check(-29.0, -1.0, true);
        check(-29.0, -2.0, false);
        check(-40.0, -1.0, false);
        check(-40.0, 5.0, true);
        check(-1.0, 2.0, false);
    }

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
