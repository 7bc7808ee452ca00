//! In which direction a move starts and ends, and how much each axis takes part in it.

use crate::moves::{Basis, Move, Path};
use kerf_geom::{Point2, Vec2};

/// Direction and shares of a move.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course {
    /// Direction in XY at the start, of any length.
    pub start: Vec2,
    /// Direction in XY at the end.
    pub end: Vec2,
    /// XY speed for a speed of 1 along the reference length.
    pub xy: f64,
    /// Speed of Z, A, B and C for a speed of 1 along the reference length, signed.
    pub others: [f64; 4],
}

impl Course {
    pub fn of(m: &Move) -> Self {
        let per_mm = 1.0 / m.length_mm;
        let delta = |axis: usize| (m.to.0[axis] - m.from.0[axis]) * per_mm;
        let others = std::array::from_fn(|i| delta(i + 2));
        let (start, end, xy) = match m.path {
            Path::Line => {
                let along = Vec2::new(delta(0), delta(1));
                (along, along, along.dot(along).sqrt())
            }
            Path::Arc { centre, sweep_rad, .. } => tangents(m, centre, sweep_rad),
            Path::Curve { .. } => {
                let [start, end] = [0.0, 1.0].map(|share| {
                    let along = m.derivative(share);
                    Vec2::new(along.0[0] * per_mm, along.0[1] * per_mm)
                });
                (start, end, start.dot(start).sqrt())
            }
        };
        // What is 1 or 0 by definition must not become nearly so.
        let xy = match m.basis {
            Basis::Xy => 1.0,
            Basis::Space => xy,
            Basis::Axis(_) | Basis::Rotary => 0.0,
        };
        Self { start, end, xy, others }
    }

    /// Returns the turn of the direction in XY to the left from here into the next move, radians; 0 when
    /// one of them does not move in XY.
    pub fn turn_rad(&self, next: &Self) -> f64 {
        let (a, b) = (self.end, next.start);
        a.cross(b).atan2(a.dot(b))
    }
}

fn tangents(m: &Move, centre: [f64; 2], sweep_rad: f64) -> (Vec2, Vec2, f64) {
    let from = Point2::new(m.from.0[0], m.from.0[1]);
    let radius = (from - Point2::new(centre[0], centre[1])) / m.length_mm;
    let start = radius.left() * sweep_rad.signum();
    (start, start.rotated(sweep_rad), radius.length() * sweep_rad.abs())
}
