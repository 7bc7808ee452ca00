//! Place of the machine on record, and as it reads after somebody has zeroed axes.

use kerf_program::{Axes, Axis, Frame};
use serde::{Deserialize, Serialize};

/// Place of the machine, with the zero points that name it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Placed {
    /// Machine frame.
    pub position: Axes,
    /// The zero points.
    pub frame: Frame,
}

impl Placed {
    /// Returns the place of the machine in the frames of another moment: somebody may have zeroed axes since,
    /// because the machine was not where it was believed to be. Then their word counts, that about
    /// the table base before that about the working zero.
    pub fn seen_from(&self, then: &Frame) -> Axes {
        let mut position = self.position;
        for axis in Axis::ALL {
            let base = self.frame.base_zero[axis] - then.base_zero[axis];
            let working = self.frame.working_zero[axis] - then.working_zero[axis];
            position[axis] -= if base == 0.0 { working } else { base };
        }
        position
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64, working: f64, base: f64) -> Placed {
        let x_axis = |v| Axes([v, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let frame = Frame { working_zero: x_axis(working), base_zero: x_axis(base) };
        Placed { position: x_axis(x), frame }
    }

    #[test]
    fn whoever_zeroes_an_axis_says_where_the_machine_is() {
        let then = at(0.0, 10.0, 2.0).frame;
        let seen = |now: Placed| now.seen_from(&then)[Axis::X];
        assert_eq!(seen(at(30.0, 10.0, 2.0)), 30.0, "nothing was zeroed");
        assert_eq!(seen(at(31.0, 10.0, 3.0)), 30.0, "homed: it had lost 1");
        assert_eq!(seen(at(31.0, 11.0, 2.0)), 30.0, "zeroed at the workpiece");
        assert_eq!(seen(at(31.0, 31.0, 3.0)), 30.0, "homed, then zeroed elsewhere");
    }
}
