//! The law of motion of ramps: every move along its own path, with a trapezoid of speed.

use crate::moves::Move;
use crate::profile::{Phases, Profile};
use crate::state::State;
use kerf_program::Axes;

/// Profiles of a stack of moves.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Ramped {
    /// One for each move.
    pub profiles: Vec<Profile>,
    pub duration_s: f64,
}

impl Ramped {
    /// The move being made at a time, of a stack that is not empty.
    pub fn index_at(&self, t_s: f64) -> usize {
        self.profiles.partition_point(|p| p.start_s <= t_s).saturating_sub(1)
    }

    pub fn at(&self, t_s: f64, moves: &[Move]) -> State {
        let index = self.index_at(t_s);
        let made = &moves[index];
        let (mm, v, accel) = self.phases(index, made).at(t_s - self.profiles[index].start_s);
        let inside = t_s < self.duration_s;
        let (v, accel) = if inside { (v, accel) } else { (0.0, 0.0) };
        state(index, made, mm / made.length_mm, v, accel)
    }

    pub fn time_at_share(&self, index: usize, share: f64, made: &Move) -> f64 {
        let within = self.phases(index, made).time_at(made.length_mm * share);
        self.profiles[index].start_s + within
    }

    /// Speeds of a move: at its start, the highest, at its end.
    pub fn speeds(&self, index: usize) -> [f64; 3] {
        let p = &self.profiles[index];
        [p.v_entry, p.v_peak, p.v_exit]
    }

    pub fn phases(&self, index: usize, made: &Move) -> Phases {
        self.profiles[index].phases(made.length_mm, made.accel_mm_s2)
    }
}

fn state(index: usize, made: &Move, share: f64, v: f64, accel: f64) -> State {
    let share = share.clamp(0.0, 1.0);
    let (rate, gain) = (v / made.length_mm, accel / made.length_mm);
    let along = made.derivative(share);
    let across = made.second_derivative(share);
    State {
        position: made.position(share),
        path_speed_mm_s: v,
        velocity: Axes(along.0.map(|d| d * rate)),
        acceleration: along.zip(across, |d, c| d * gain + c * rate * rate),
        move_index: index,
        share,
    }
}
