//! Moments at which an axis passes a value, for outputs that Z or A switches (command reference, VC).

use crate::plan::Plan;
use kerf_program::Axis;

/// An axis passes a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// Time, seconds of the plan.
    pub t_s: f64,
    /// The axis rises.
    pub upward: bool,
    /// The move in which it happens.
    pub move_index: usize,
}

impl Plan {
    /// The next time from `from_s` on at which an axis passes a value.
    ///
    /// A move passes a value when it ends beyond it and began at it or on the other side: reaching
    /// it and staying is not passing. X and Y are not looked at (`None`): on arcs they turn round
    /// inside a move, and no trigger watches them.
    pub fn time_when_axis_passes(&self, axis: Axis, value: f64, from_s: f64) -> Option<Pass> {
        if matches!(axis, Axis::X | Axis::Y) {
            return None;
        }
        let first = self.index_at(from_s)?;
        (first..self.moves.len())
            .filter_map(|index| self.pass_in(index, axis, value))
            .find(|pass| pass.t_s >= from_s)
    }

    /// The time at which an axis (not X or Y) passes a value inside one move.
    pub fn pass_in(&self, index: usize, axis: Axis, value: f64) -> Option<Pass> {
        let made = self.moves.get(index)?;
        let (a, b) = (made.from[axis], made.to[axis]);
        let upward = a < b;
        let passes = if upward { a <= value && value < b } else { a >= value && value > b };
        let t_s = self.time_at_share(index, (value - a) / (b - a));
        passes.then_some(Pass { t_s, upward, move_index: index })
    }
}
