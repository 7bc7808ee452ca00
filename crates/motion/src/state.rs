//! State of the machine at one time of a plan.

use kerf_program::Axes;

/// State of the machine at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Place of the axes, machine frame.
    pub position: Axes,
    /// Speed along the reference length of the move (for cuts of OpenSBP, XY vector speed).
    pub path_speed_mm_s: f64,
    /// Speed of each axis, signed, mm/s or degrees/s.
    pub velocity: Axes,
    /// Acceleration of each axis, mm/s² or degrees/s². With the ramps of VR the speed jumps where
    /// the direction does; that is not in it.
    pub acceleration: Axes,
    /// The move being made.
    pub move_index: usize,
    /// Share of its path that has been made, 0 … 1.
    pub share: f64,
}
