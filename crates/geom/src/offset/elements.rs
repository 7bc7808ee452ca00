//! Elements of the lists that an offset is made in.

use super::path::Origin;
use crate::{Point2, Segment, Vec2};

/// Unit directions of travel at the ends of a segment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ways {
    pub leaves: Vec2,
    pub arrives: Vec2,
}

impl Ways {
    pub fn of(segment: &Segment) -> Self {
        match *segment {
            Segment::Line { .. } => {
                let way = segment.direction(0.0);
                Self { leaves: way, arrives: way }
            }
            Segment::Arc { start, end, centre, radius, sweep_rad } => {
                let turned = sweep_rad.signum() / radius;
                let way = |at: Point2| (at - centre).left() * turned;
                Self { leaves: way(start), arrives: way(end) }
            }
        }
    }
}

/// From a number to before another.
pub(super) type Range2 = (usize, usize);

/// A parallel line or arc, or the arc about a corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub segment: Segment,
    pub origin: Origin,
    /// The piece that starts where this one ends.
    pub next: Option<usize>,
}

/// Shares on two neighbours where they are cut back.
pub(super) type Trim = Option<[f64; 2]>;

/// Number of a piece, and the share of it at which the raw offset is cut.
pub(super) type Cut = (usize, f64);

/// A piece's number and the shares between which it belongs to something.
pub(super) type Stretch = (usize, f64, f64);

/// A stretch of consecutive pieces without crossings inside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slice {
    /// Its stretches are these of the list of all.
    pub from: usize,
    pub to: usize,
    pub sure: bool,
    /// It was cut nowhere and comes back to where it begins.
    pub ring: bool,
}

/// One piece of a ring.
pub(super) type Part = (Segment, Origin);
