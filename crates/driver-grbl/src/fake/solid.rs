//! Things that the probe of the fake meets.

/// A thing of which a probe feels the outside; mm, machine frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// From one corner to the other.
    Block {
        /// The lower corner.
        low: [f64; 3],
        /// The upper corner.
        high: [f64; 3],
    },
    /// Everything around an upright bore.
    Bore {
        /// Its axis.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
    },
    /// Everything below a plane.
    Plate {
        /// Its height at X 0, Y 0.
        height: f64,
        /// Its rise along X and along Y, mm a mm.
        rise: [f64; 2],
    },
}

impl Solid {
    /// Returns `true` if the probe touches it there.
    pub(super) fn touches(&self, at: [f64; 3]) -> bool {
        match *self {
            Self::Block { low, high } => (0..3).all(|i| (low[i]..=high[i]).contains(&at[i])),
            Self::Plate { height, rise } => at[2] <= height + rise[0] * at[0] + rise[1] * at[1],
            Self::Bore { centre, radius } => (at[0] - centre[0]).hypot(at[1] - centre[1]) >= radius,
        }
    }
}
