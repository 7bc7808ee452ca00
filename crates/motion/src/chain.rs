//! Pieces of plan that follow each other, run by another clock.

use crate::clock::{Clock, Tick};
use crate::ease::Easing;
use crate::moves::Move;
use crate::plan::Plan;
use crate::state::State;
use kerf_program::{Axes, Dynamics};
use std::sync::Arc;

/// A plan that is run by another clock. The path is that of the pieces, to the last bit.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Clocked {
    /// Pieces of one stack, in order.
    pub pieces: Vec<Arc<Plan>>,
    /// The move of the first piece with which it begins, and how much of that lies before.
    pub begin: (usize, f64),
    pub clock: Arc<Clock>,
}

impl Clocked {
    /// A piece as it is planned.
    pub fn plain(piece: Plan, clock: Arc<Clock>) -> Self {
        Self { pieces: vec![Arc::new(piece)], begin: (0, 0.0), clock }
    }

    /// Returns the limits of the axes.
    pub fn dynamics(&self) -> Option<Dynamics> {
        self.pieces.first()?.dynamics()
    }

    /// Returns the time at which the last piece is over.
    pub fn duration_s(&self) -> f64 {
        self.clock.when(self.plan_end_s())
    }

    pub fn plan_end_s(&self) -> f64 {
        self.pieces.last().map_or(0.0, |piece| piece.duration_s())
    }

    /// The piece in which a move lies, and its number there.
    fn piece(&self, index: usize) -> Option<(&Plan, usize)> {
        let mut index = index + self.begin.0;
        for piece in &self.pieces {
            let count = piece.moves().len();
            if index < count {
                return Some((piece, index));
            }
            index -= count;
        }
        None
    }

    pub fn start_s(&self, index: usize) -> f64 {
        match self.piece(index) {
            _ if index == 0 => self.time_at_share(0, 0.0),
            Some((piece, index)) => self.clock.when(piece.span_s(index).0),
            None => self.duration_s(),
        }
    }

    /// Returns the planned state at a time of the plan; the move is counted from the first of the first piece.
    pub fn planned(&self, plan_s: f64) -> State {
        let Some((piece, before)) = self.running(plan_s) else { return State::default() };
        let state = piece.at(plan_s);
        State { move_index: before + state.move_index, ..state }
    }

    /// Velocity and acceleration of every axis that the plan says at a time of its own.
    pub fn rates(&self, plan_s: f64) -> [Axes; 2] {
        self.running(plan_s).map_or_else(Default::default, |(piece, _)| piece.rates(plan_s))
    }

    /// The piece that runs at a time of the plan, and how many moves lie in those before.
    fn running(&self, plan_s: f64) -> Option<(&Plan, usize)> {
        let mut before = 0;
        let (last, others) = self.pieces.split_last()?;
        for piece in others {
            if plan_s < piece.duration_s() {
                return Some((piece, before));
            }
            before += piece.moves().len();
        }
        Some((last, before))
    }

    pub fn at(&self, t_s: f64) -> State {
        let tick = self.clock.at(t_s);
        let State { position, path_speed_mm_s, velocity, acceleration, move_index, share } =
            self.planned(tick.plan_s);
        let square = tick.rate * tick.rate;
        let (first, before) = self.begin;
        let share = if move_index == first { (share - before) / (1.0 - before) } else { share };
        State {
            position,
            path_speed_mm_s: path_speed_mm_s * tick.rate,
            velocity: Axes(velocity.0.map(|v| v * tick.rate)),
            acceleration: acceleration.zip(velocity, |a, v| a * square + v * tick.gain),
            move_index: move_index.saturating_sub(first),
            share: share.clamp(0.0, 1.0),
        }
    }

    /// The moves of the pieces, whole, those before the beginning too.
    pub fn planned_moves(&self) -> impl Iterator<Item = Move> {
        self.pieces.iter().flat_map(|piece| piece.moves().iter().copied())
    }

    /// Returns the time of the plan at a share of a move, counted from the first of the first piece.
    pub fn planned_at(&self, index: usize, share: f64) -> Option<f64> {
        let whole = Self { begin: (0, 0.0), ..self.clone() };
        let (piece, index) = whole.piece(index)?;
        Some(piece.time_at_share(index, share))
    }

    pub fn time_at_share(&self, index: usize, share: f64) -> f64 {
        let Some((piece, planned)) = self.piece(index) else { return self.duration_s() };
        let before = if index == 0 { self.begin.1 } else { 0.0 };
        self.clock.when(piece.time_at_share(planned, before + share * (1.0 - before)))
    }

    /// Speeds of a move: at its start, the highest, at its end.
    pub fn speeds(&self, index: usize) -> [f64; 3] {
        let (t0_s, t1_s) = (self.start_s(index), self.start_s(index + 1));
        let peak = self
            .piece(index)
            .and_then(|(piece, index)| piece.span(index))
            .map_or(0.0, |s| s.v_peak);
        let rate = |t_s: f64| self.clock.at(t_s).rate;
        let v = |t_s: f64| self.at(t_s).path_speed_mm_s;
        let (entry, exit) = (v(t0_s), v(t1_s.next_down()));
        // Where the rate changes the speed is between those of the ends, or nearly so.
        let plain = rate(t0_s) >= 1.0 && rate(t1_s) >= 1.0;
        let middle = v(0.5 * (t0_s + t1_s));
        let peak = if plain { peak } else { middle.max(entry).max(exit).min(peak) };
        [entry.min(peak), peak, exit.min(peak)]
    }

    /// Returns what is left from a place in a move on, by a clock of its own.
    pub fn left(&self, index: usize, share: f64, clock: Clock) -> Self {
        let before = if index == 0 { self.begin.1 } else { 0.0 };
        let begin = (index + self.begin.0, before + share * (1.0 - before));
        Self { pieces: self.pieces.clone(), begin, clock: Arc::new(clock) }
    }

    /// Returns the plan as it comes to a stand when it is stopped at a time: ramped, or at once.
    pub fn stopped(&self, t_s: f64, ramped: bool) -> Self {
        let now = self.clock.at(t_s);
        let Some(dynamics) = self.dynamics().filter(|_| ramped) else {
            return self.by(vec![Tick { rate: 0.0, ..now.turned(0.0, 0.0) }]);
        };
        // A smooth change is made to its end first, if there is time.
        let settled = if now.gain == 0.0 { now } else { self.clock.last() };
        self.by(Easing::new(self, dynamics).stand(now, settled))
    }

    /// The same as steeply as the accelerations allow, whatever limit of jerk there is.
    pub fn braked(&self, t_s: f64) -> Option<Self> {
        let dynamics = Dynamics { jerk_mm_s3: None, ..self.dynamics()? };
        let now = self.clock.at(t_s);
        Some(self.by(Easing::new(self, dynamics).stand(now, now)))
    }

    /// Returns the time at which it begins to slow, not before a given one.
    pub fn slows_from(&self, t_s: f64) -> f64 {
        self.clock.turns_after(t_s).unwrap_or(t_s)
    }

    /// A clock from a stand up to the plan.
    pub fn started(&self, plan_s: f64) -> Clock {
        let ticks = self.dynamics().map(|dynamics| Easing::new(self, dynamics).start(plan_s));
        Clock::of(ticks.unwrap_or_else(|| vec![Tick::plain(0.0, plan_s)]))
    }

    /// The same with other ticks from the first of them on.
    fn by(&self, ticks: Vec<Tick>) -> Self {
        Self { clock: Arc::new(self.clock.then(ticks)), ..self.clone() }
    }
}

/// A plan that runs as planned.
pub(crate) fn plain_clock() -> Arc<Clock> {
    Arc::new(Clock::plain(0.0, 0.0))
}
