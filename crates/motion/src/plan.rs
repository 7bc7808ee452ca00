//! A planned stack of moves: where every axis is at time t, how fast, and in which move.

use crate::chain::{Clocked, plain_clock};
use crate::clock::Clock;
use crate::moves::Move;
use crate::ramped::Ramped;
use crate::state::State;
use kerf_motion_optimal::{Moment, Timed};
use kerf_program::{Axes, Dynamics, MoveKind};
use std::sync::Arc;

/// A planned stack, which starts and ends at rest; or a piece of one, whose times are told from the
/// start of the stack (see [`Planner`](crate::Planner)).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plan {
    pub(crate) moves: Vec<Move>,
    pub(crate) law: Law,
}

/// Law of motion of the moves.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Law {
    /// Exactly along each move, with a trapezoid of speed.
    Ramped(Ramped),
    /// Along a smoothed path.
    Timed(Box<Timed>),
    /// Pieces of plan by another clock.
    Clocked(Box<Clocked>),
}

impl Default for Law {
    fn default() -> Self {
        Self::Ramped(Ramped::default())
    }
}

/// One move in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span<'a> {
    /// Number of the move in the plan.
    pub index: usize,
    /// The move.
    pub made: &'a Move,
    /// Time at which it starts, seconds.
    pub t0_s: f64,
    /// Time at which it ends, seconds.
    pub t1_s: f64,
    /// Speed at its start.
    pub v_entry: f64,
    /// Highest speed in it.
    pub v_peak: f64,
    /// Speed at its end.
    pub v_exit: f64,
}

impl Plan {
    /// Adds the next piece of the same stack.
    pub(crate) fn join(&mut self, mut next: Self) {
        if let (Law::Ramped(law), Law::Ramped(other)) = (&mut self.law, &mut next.law) {
            law.profiles.append(&mut other.profiles);
            law.duration_s = other.duration_s;
        } else {
            let clock = self.clock().unwrap_or_else(plain_clock);
            *self = std::mem::take(self).by(clock.clone());
            next = next.by(clock);
            if let (Law::Clocked(law), Law::Clocked(other)) = (&mut self.law, &mut next.law) {
                law.pieces.append(&mut other.pieces);
            }
        }
        self.moves.append(&mut next.moves);
    }

    /// The same plan by a clock; one that has a clock keeps it, and one made of ramps has none.
    pub(crate) fn by(self, clock: Arc<Clock>) -> Self {
        if !matches!(self.law, Law::Timed(_)) {
            return self;
        }
        let moves = self.moves.clone();
        Self { moves, law: Law::Clocked(Box::new(Clocked::plain(self, clock))) }
    }

    /// The clock of a plan that has one.
    pub(crate) fn clock(&self) -> Option<Arc<Clock>> {
        match &self.law {
            Law::Clocked(law) => Some(law.clock.clone()),
            _ => None,
        }
    }

    /// Returns the limits of the axes, when it was planned with them.
    pub(crate) fn dynamics(&self) -> Option<Dynamics> {
        match &self.law {
            Law::Ramped(_) => None,
            Law::Timed(law) => Some(law.dynamics),
            Law::Clocked(law) => law.dynamics(),
        }
    }

    /// The time, from one on, at which another feed can begin, and the speed then: a jog is made to
    /// its end first.
    pub(crate) fn overridable(&self, t_s: f64) -> (f64, f64) {
        let here = self.at(t_s);
        match self.moves.get(here.move_index) {
            Some(jog) if jog.kind == MoveKind::Jog => (self.span_s(here.move_index).1, 0.0),
            _ => (t_s, here.path_speed_mm_s),
        }
    }

    /// Returns `true` if the machine stands at its end as it is planned.
    pub(crate) fn ends_at_rest(&self) -> bool {
        match &self.law {
            Law::Ramped(_) => true,
            Law::Timed(law) => law.nodes.last().is_none_or(|node| node.v == 0.0),
            Law::Clocked(law) => law.pieces.last().is_none_or(|piece| piece.ends_at_rest()),
        }
    }

    /// Time of the whole stack, seconds; of a piece of plan, the time at its end.
    pub fn duration_s(&self) -> f64 {
        match &self.law {
            Law::Ramped(law) => law.duration_s,
            Law::Timed(law) => law.duration_s(),
            Law::Clocked(law) => law.duration_s(),
        }
    }

    /// The moves, in order.
    pub fn moves(&self) -> &[Move] {
        &self.moves
    }

    /// Start and end time of a move, seconds. A number beyond the last move gives the end. On a
    /// smoothed path a move starts in the middle of the corner before it.
    pub fn span_s(&self, index: usize) -> (f64, f64) {
        (self.start_s(index), self.start_s(index.saturating_add(1)))
    }

    fn start_s(&self, index: usize) -> f64 {
        if index >= self.moves.len() {
            return self.duration_s();
        }
        match &self.law {
            Law::Ramped(law) => law.profiles[index].start_s,
            Law::Timed(law) => law.time_at(law.start_mm(index)),
            Law::Clocked(law) => law.start_s(index),
        }
    }

    /// The move being made at a time; the first before the start, the last after the end. `None`
    /// only for a plan without moves.
    pub fn index_at(&self, t_s: f64) -> Option<usize> {
        if self.moves.is_empty() {
            return None;
        }
        match &self.law {
            Law::Ramped(law) => Some(law.index_at(t_s)),
            Law::Timed(law) => Some(law.share(law.along(t_s).at_mm).0),
            Law::Clocked(law) => Some(law.at(t_s).move_index),
        }
    }

    /// Returns the state of the machine at a time: at the first position before the start, at the last one
    /// after the end. All zero for a plan without moves.
    pub fn at(&self, t_s: f64) -> State {
        let t_s = t_s.max(0.0);
        if self.moves.is_empty() {
            return State::default();
        }
        match &self.law {
            Law::Ramped(law) => law.at(t_s, &self.moves),
            Law::Timed(law) => state_of(&law.at(t_s), &self.moves),
            Law::Clocked(law) => law.at(t_s),
        }
    }

    /// Velocity and acceleration of every axis at a time.
    pub(crate) fn rates(&self, t_s: f64) -> [Axes; 2] {
        match &self.law {
            Law::Timed(law) if !self.moves.is_empty() => law.rates(t_s.max(0.0)),
            _ => {
                let state = self.at(t_s);
                [state.velocity, state.acceleration]
            }
        }
    }

    /// Returns the time at which a share 0 … 1 of a move's path has been made, seconds.
    pub fn time_at_share(&self, index: usize, share: f64) -> f64 {
        let Some(made) = self.moves.get(index) else { return self.duration_s() };
        match &self.law {
            Law::Ramped(law) => law.time_at_share(index, share, made),
            Law::Timed(law) => {
                let (a, b) = (law.start_mm(index), law.start_mm(index + 1));
                law.time_at(a + share.clamp(0.0, 1.0) * (b - a))
            }
            Law::Clocked(law) => law.time_at_share(index, share.clamp(0.0, 1.0)),
        }
    }

    /// The moves with their times and speeds, in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Span<'_>> {
        self.moves.iter().enumerate().map(|(index, made)| self.span_of(index, made))
    }

    /// One move with its times and speeds.
    pub fn span(&self, index: usize) -> Option<Span<'_>> {
        Some(self.span_of(index, self.moves.get(index)?))
    }

    fn span_of<'a>(&'a self, index: usize, made: &'a Move) -> Span<'a> {
        let (t0_s, t1_s) = self.span_s(index);
        let [v_entry, v_peak, v_exit] = match &self.law {
            Law::Ramped(law) => law.speeds(index),
            Law::Timed(law) => speeds_of(law, index, made),
            Law::Clocked(law) => law.speeds(index),
        };
        Span { index, made, t0_s, t1_s, v_entry, v_peak, v_exit }
    }
}

/// State of the machine at a moment of a smoothed path.
fn state_of(moment: &Moment, moves: &[Move]) -> State {
    let Moment { position, velocity, acceleration, move_index, share } = *moment;
    let made = &moves[move_index.min(moves.len() - 1)];
    let path_speed_mm_s = made.basis.square(&velocity.0).sqrt();
    State { position, path_speed_mm_s, velocity, acceleration, move_index, share }
}

/// Speeds of a move on a smoothed path along its reference length: at its start, the highest, at its end.
fn speeds_of(law: &Timed, index: usize, made: &Move) -> [f64; 3] {
    let length = law.length_mm(index);
    let scale = if length > 0.0 { made.length_mm / length } else { 1.0 };
    // Along the smoothed path, which is shorter, the tool is no faster than it may be.
    law.speeds(index).map(|v| (v * scale).min(made.top_mm_s()))
}
