//! Refusals: the reasons why something is not done.

use thiserror::Error;

/// Reason why something is not done. The words fit a screen of two lines of twenty characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Refusal {
    /// An arc point beside another one.
    #[error("arc point needs an end point")]
    ArcBesideArc,
    /// An arc point at an end of the path.
    #[error("point {0}: arc point has one end only")]
    ArcAtEnd(usize),
    /// An arc whose three points are no three places, or on one line and not in order.
    #[error("point {0}: no arc goes through it")]
    NoArc(usize),
    /// An arc point in three dimensions.
    #[error("no arcs in 3D: make them lines")]
    ArcInSpace,
    /// The current point is not the last one.
    #[error("not at end")]
    NotAtEnd,
    /// There are no points.
    #[error("no points yet: Enter records one")]
    NoPoints,
    /// Too few for a closed shape.
    #[error("closed: 3 points, or 2 with an arc")]
    TooFewToClose,
    /// All points are one place.
    #[error("all points are one place")]
    OnePlace,
    /// Coordinates that no shape can have.
    #[error("a point is too far away")]
    TooFar,
    /// There is nothing to load.
    #[error("there is no shape to load")]
    NoShape,
}
