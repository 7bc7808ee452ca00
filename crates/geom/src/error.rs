//! Errors of geometry; their messages name the place where there is one.

use crate::Point2;
use thiserror::Error;

/// Reason why an operation on curves has no result. Vertices are numbered from 0, contours too.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GeomError {
    /// A coordinate or bulge is not a number, or infinite.
    #[error("vertex {vertex}: a coordinate or bulge is not a finite number")]
    NotFinite {
        /// Its number.
        vertex: usize,
    },
    /// A coordinate lies beyond [`crate::tol::FARTHEST_MM`].
    #[error("vertex {vertex}: farther than a million metres from the origin")]
    TooFar {
        /// Its number.
        vertex: usize,
    },
    /// Fewer vertices than the operation needs, once places that fall together are one.
    #[error("{found} different vertices, at least {needed} are needed")]
    TooFewVertices {
        /// Number of different vertices found.
        found: usize,
        /// Number of vertices needed.
        needed: usize,
    },
    /// The operation needs closed contours.
    #[error("contour {contour} is open; it has to be closed")]
    Open {
        /// Its number.
        contour: usize,
    },
    /// A contour crosses or touches itself, or another, where it may not.
    #[error("{} at {:.3}, {:.3}", crossing(*first, *second), at.x, at.y)]
    Crosses {
        /// One contour.
        first: usize,
        /// The other, or the same one.
        second: usize,
        /// Place of the crossing.
        at: Point2,
    },
    /// A length or tolerance that has to be positive and finite is not.
    #[error("{what} has to be a positive, finite number")]
    NotPositive {
        /// Its name.
        what: &'static str,
    },
    /// An offset by no number, or by more than [`crate::tol::FARTHEST_MM`].
    #[error("an offset is at most a million metres")]
    OffsetTooFar,
    /// The boundary of a combined region has an end: the contours lie too nearly on each other.
    #[error("the contours cannot be told apart near {:.3}, {:.3}", at.x, at.y)]
    Unclosed {
        /// Middle of a part of the boundary that has a loose end.
        at: Point2,
    },
    /// The arguments ask for something that does not exist there.
    #[error("{what} at {:.3}, {:.3}", at.x, at.y)]
    Impossible {
        /// Description of the problem.
        what: &'static str,
        /// Place of the problem.
        at: Point2,
    },
    /// A map makes a line of the plane.
    #[error("scaled to nothing in one direction")]
    Flattened,
    /// The result did not pass its own check; nothing is returned rather than something wrong.
    #[error("the offset fails its check near {:.3}, {:.3}: {why}", at.x, at.y)]
    Unproved {
        /// Finding of the check.
        why: &'static str,
        /// Place where the check failed.
        at: Point2,
    },
}

fn crossing(first: usize, second: usize) -> String {
    if first == second {
        "it crosses itself".into()
    } else {
        format!("contours {first} and {second} cross")
    }
}
