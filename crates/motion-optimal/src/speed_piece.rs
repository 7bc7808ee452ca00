//! A piece of motion along a path.

/// A piece of path with the Bézier ordinates of the squared speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedPiece {
    /// Its length, mm.
    pub h: f64,
    /// The ordinates.
    pub x: [f64; 3],
}
