//! A planned stack of moves: where every axis is at time t, how fast, and in which move.

use crate::moves::Move;
use crate::profile::{Phases, Profile};
use kerf_program::Axes;

/// A planned stack. Starts and ends at rest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plan {
    pub(crate) moves: Vec<Move>,
    /// One for each move.
    pub(crate) profiles: Vec<Profile>,
    pub(crate) duration_s: f64,
}

/// What the machine does at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Where the axes are, machine frame.
    pub position: Axes,
    /// Speed along the reference length of the move (for cuts of OpenSBP, XY vector speed).
    pub path_speed_mm_s: f64,
    /// Speed of each axis, signed, mm/s or degrees/s.
    pub velocity: Axes,
    /// The move being made.
    pub move_index: usize,
    /// How much of its path has been made, 0 … 1.
    pub share: f64,
}

/// One move in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span<'a> {
    /// Number of the move in the plan.
    pub index: usize,
    /// The move.
    pub made: &'a Move,
    /// When it starts, seconds.
    pub t0_s: f64,
    /// When it ends, seconds.
    pub t1_s: f64,
    /// Speed at its start.
    pub v_entry: f64,
    /// Highest speed in it.
    pub v_peak: f64,
    /// Speed at its end.
    pub v_exit: f64,
}

impl Plan {
    /// Time of the whole stack, seconds.
    pub const fn duration_s(&self) -> f64 {
        self.duration_s
    }

    /// The moves, in order.
    pub fn moves(&self) -> &[Move] {
        &self.moves
    }

    /// Start and end time of a move, seconds. A number beyond the last move gives the end.
    pub fn span_s(&self, index: usize) -> (f64, f64) {
        let start = |i: usize| self.profiles.get(i).map_or(self.duration_s, |p| p.start_s);
        (start(index), start(index.saturating_add(1)))
    }

    /// The move being made at a time; the first before the start, the last after the end. `None`
    /// only for a plan without moves.
    pub fn index_at(&self, t_s: f64) -> Option<usize> {
        let later = self.profiles.partition_point(|p| p.start_s <= t_s);
        (!self.moves.is_empty()).then(|| later.saturating_sub(1))
    }

    /// What the machine does at a time: at the first position before the start, at the last one
    /// after the end. All zero for a plan without moves.
    pub fn at(&self, t_s: f64) -> State {
        let t_s = t_s.max(0.0);
        let Some(index) = self.index_at(t_s) else {
            return State {
                position: Axes::default(),
                path_speed_mm_s: 0.0,
                velocity: Axes::default(),
                move_index: 0,
                share: 0.0,
            };
        };
        let inside = t_s < self.duration_s;
        let (mm, v) = self.phases(index).at(t_s - self.profiles[index].start_s);
        self.state(index, mm / self.moves[index].length_mm, if inside { v } else { 0.0 })
    }

    /// When a share 0 … 1 of a move's path has been made, seconds.
    pub fn time_at_share(&self, index: usize, share: f64) -> f64 {
        match self.moves.get(index) {
            None => self.duration_s,
            Some(made) => {
                let within = self.phases(index).time_at(made.length_mm * share);
                self.profiles[index].start_s + within
            }
        }
    }

    /// The moves with their times and speeds, in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Span<'_>> {
        let both = self.moves.iter().zip(&self.profiles).enumerate();
        both.map(|(index, (made, profile))| self.span_of(index, made, profile))
    }

    /// One move with its times and speeds.
    pub fn span(&self, index: usize) -> Option<Span<'_>> {
        Some(self.span_of(index, self.moves.get(index)?, self.profiles.get(index)?))
    }

    fn span_of<'a>(&'a self, index: usize, made: &'a Move, profile: &Profile) -> Span<'a> {
        Span {
            index,
            made,
            t0_s: profile.start_s,
            t1_s: self.span_s(index).1,
            v_entry: profile.v_entry,
            v_peak: profile.v_peak,
            v_exit: profile.v_exit,
        }
    }

    pub(crate) fn phases(&self, index: usize) -> Phases {
        let made = &self.moves[index];
        self.profiles[index].phases(made.length_mm, made.accel_mm_s2)
    }

    fn state(&self, index: usize, share: f64, v: f64) -> State {
        let made = &self.moves[index];
        let share = share.clamp(0.0, 1.0);
        let rate = v / made.length_mm;
        State {
            position: made.position(share),
            path_speed_mm_s: v,
            velocity: Axes(made.derivative(share).0.map(|d| d * rate)),
            move_index: index,
            share,
        }
    }
}
