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
}

impl Solid {
    /// Returns `true` if the probe touches it there.
    pub(super) fn touches(&self, at: [f64; 3]) -> bool {
        match *self {
            Self::Block { low, high } => (0..3).all(|i| (low[i]..=high[i]).contains(&at[i])),
            Self::Bore { centre, radius } => (at[0] - centre[0]).hypot(at[1] - centre[1]) >= radius,
        }
    }
}
