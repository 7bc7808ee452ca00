//! The reasons why a region cannot be cleared.

use kerf_geom::GeomError;
use thiserror::Error;

/// Reason why there are no paths.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PocketError {
    /// A tool or a step out of bounds.
    #[error("{what} is {value} mm: it must be {bound}")]
    Bound {
        /// Name of the value.
        what: &'static str,
        /// Its value, millimetres.
        value: f64,
        /// Bound, in words.
        bound: &'static str,
    },
    /// A contour is open.
    #[error("contour {contour} is open")]
    Open {
        /// Which, counted from 0.
        contour: usize,
    },
    /// There is no end to the rings: they grow.
    #[error("the contours go the wrong way round: outer ones must run counter-clockwise")]
    Directions,
    /// So many rings are a slip of the decimal point.
    #[error("{rings:.0} rings: make the tool larger or its overlap smaller")]
    TooMany {
        /// About how many.
        rings: f64,
    },
    /// The rings cannot be made.
    #[error(transparent)]
    Geometry(#[from] GeomError),
}
