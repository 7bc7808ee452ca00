//! Things on the table that switches feel: what an input reads where the tool is.
//!
//! ```text
//!   input 1 on in box 4,4,-1 6,5,0          a touch plate, a limit switch, a probe and what it touches
//!   input 2 on in box 10,*,* *,*,*          everything beyond X 10
//! ```

use kerf_program::{Axes, Axis};
use serde::{Deserialize, Serialize};

/// A body; lengths in millimetres, machine frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Body {
    /// From one corner to the other. A bound that is missing is none.
    Box {
        /// The lower corner.
        low: [Option<f64>; 3],
        /// The upper corner.
        high: [Option<f64>; 3],
    },
    /// A ball.
    Sphere {
        /// Its centre.
        centre: [f64; 3],
        /// Its radius.
        radius: f64,
    },
    /// A round disk or post that stands upright.
    Cylinder {
        /// Its axis.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
        /// Its bottom and its top.
        z: [f64; 2],
    },
}

/// An input that changes where the tool is inside of a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Touch {
    /// The number of the input.
    pub input: u8,
    /// Its state inside; outside it has the other.
    pub on: bool,
    /// Body that it feels.
    pub body: Body,
}

impl Body {
    /// Tells whether a place is inside or on its surface.
    pub fn holds(&self, at: [f64; 3]) -> bool {
        match *self {
            Self::Box { low, high } => (0..3).all(|i| {
                low[i].is_none_or(|low| at[i] >= low) && high[i].is_none_or(|high| at[i] <= high)
            }),
            Self::Sphere { centre, radius } => {
                let off = [0, 1, 2].map(|i| at[i] - centre[i]);
                off.iter().map(|v| v * v).sum::<f64>() <= radius * radius
            }
            Self::Cylinder { centre, radius, z } => {
                let off = (at[0] - centre[0]).hypot(at[1] - centre[1]);
                off <= radius && (z[0]..=z[1]).contains(&at[2])
            }
        }
    }
}

/// The inputs that touches change.
pub(crate) fn inputs(touches: &[Touch]) -> Vec<u8> {
    let mut inputs: Vec<u8> = touches.iter().map(|touch| touch.input).collect();
    inputs.sort_unstable();
    inputs.dedup();
    inputs
}

/// The contact of an input where the tool is there: that of the first body around it, else the other state
/// of the first that is known.
pub(crate) fn contact(touches: &[Touch], input: u8, at: &Axes) -> Option<bool> {
    let at = [at[Axis::X], at[Axis::Y], at[Axis::Z]];
    let mut of_input = touches.iter().filter(|touch| touch.input == input);
    let inside = of_input.clone().find(|touch| touch.body.holds(at)).map(|touch| touch.on);
    inside.or_else(|| of_input.next().map(|touch| !touch.on))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_hold_their_inside() {
        let half = Body::Box { low: [Some(10.0), None, None], high: [None; 3] };
        let ball = Body::Sphere { centre: [0.0, 0.0, -5.0], radius: 5.0 };
        let post = Body::Cylinder { centre: [3.0, 4.0], radius: 5.0, z: [-10.0, -1.0] };
        for (body, at, inside) in [
            (half, [10.0, -500.0, 99.0], true),
            (half, [9.9, 0.0, 0.0], false),
            (ball, [3.0, 0.0, -1.0], true),
            (ball, [3.0, 0.0, -0.9], false),
            (post, [0.0, 0.0, -1.0], true),
            (post, [0.0, 0.0, -0.5], false),
            (post, [8.1, 4.0, -5.0], false),
        ] {
            assert_eq!(body.holds(at), inside, "{body:?} {at:?}");
        }
    }

    #[test]
    fn the_first_body_around_the_tool_says_what_its_input_is() {
        let body = |x: f64| Body::Box { low: [Some(x), None, None], high: [None; 3] };
        let touches = [
            Touch { input: 1, on: true, body: body(5.0) },
            Touch { input: 2, on: false, body: body(7.0) },
        ];
        let read = |input, x| contact(&touches, input, &Axes::xyz(x, 0.0, 0.0));
        assert_eq!([read(1, 4.0), read(1, 6.0)], [Some(false), Some(true)]);
        assert_eq!([read(2, 6.0), read(2, 8.0), read(3, 8.0)], [Some(true), Some(false), None]);
        assert_eq!(inputs(&touches), [1, 2]);
    }
}
