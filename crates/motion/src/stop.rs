//! Stopping inside a plan, and what is left of it.
//!
//! With ramps a ramped stop slows along the path at the ramp's acceleration until ramp speed is reached,
//! where the machine stands; it may run on into later moves. As the plan itself never slows more
//! steeply, the stop never runs faster than the plan would have. A plan on a smoothed path is slowed by
//! its clock ([`ease`](crate::ease)), within the limits of every axis.

use crate::chain::{Clocked, plain_clock};
use crate::clock::{Clock, Tick};
use crate::moves::Move;
use crate::plan::{Law, Plan};
use crate::profile::Profile;
use crate::ramped::Ramped;
use crate::state::State;
use kerf_program::Axes;

/// Place and time at which a stop comes to rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// Time at which the stop began, seconds of the plan.
    pub begin_s: f64,
    /// Time at which the machine stands, seconds of the plan.
    pub end_s: f64,
    /// Place where it stands, machine frame.
    pub position: Axes,
    /// The move in which it stands.
    pub move_index: usize,
    /// Share of that move's path that has been made, 0 … 1.
    pub share: f64,
    pub(crate) law: Braked,
}

/// Motion of the stop.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Braked {
    /// Profiles of the moves from the one in which the stop began to the one in which it stands;
    /// the last only over its share.
    Ramped(Vec<Profile>),
    /// The plan by the clock that slows it.
    Clocked(Box<Clocked>),
}

/// Progress of the braking: in which move, how far into it, how fast.
struct Braking {
    index: usize,
    made_mm: f64,
    v: f64,
    profile: Profile,
}

impl Stop {
    /// Returns the number of moves of the plan that are made to their end.
    pub fn whole(&self) -> usize {
        self.move_index + usize::from(self.share >= 1.0)
    }

    /// Returns the share of a planned move that shares in the cut plan refer to: the move that a plan of ramps stops in
    /// ends there, and counts as a whole; a plan by a clock goes on to tell shares of what was planned.
    pub fn part(&self, index: usize) -> f64 {
        let ends = index == self.move_index && matches!(self.law, Braked::Ramped(_));
        if ends { self.share } else { 1.0 }
    }
}

impl Plan {
    /// A stop that begins at a time: ramped along the path, or at once. `None` only for a plan
    /// without moves.
    pub fn stop(&self, t_s: f64, ramped: bool) -> Option<Stop> {
        let begin_s = t_s.max(0.0).min(self.duration_s());
        if self.moves.is_empty() {
            return None;
        }
        Some(match &self.law {
            Law::Ramped(law) => law.stop(begin_s, ramped, &self.moves),
            Law::Timed(_) => return self.clone().by(plain_clock()).stop(t_s, ramped),
            Law::Clocked(law) => law.stop(begin_s, ramped),
        })
    }

    /// A stop that begins at a time and brakes as steeply as the accelerations allow, whatever limit of
    /// jerk there is; `None` for a plan without a clock.
    pub(crate) fn brake(&self, t_s: f64) -> Option<Stop> {
        let Law::Clocked(law) = &self.law else { return None };
        Some(Clocked::stands_by(law.braked(t_s)?, t_s))
    }

    /// The plan as it runs with this stop, and the moves that are left for resuming. The stop must
    /// come from this plan.
    pub fn cut(mut self, stop: &Stop) -> (Self, Vec<Move>) {
        let mut rest = self.moves.split_off(stop.move_index.min(self.moves.len()));
        if let Some(last) = rest.first_mut() {
            let (mut made, mut left) = last.split(stop.share);
            (made.to, left.from) = (stop.position, stop.position);
            *last = left;
            if stop.share > 0.0 {
                self.moves.push(made);
            }
        }
        if stop.share >= 1.0 {
            rest.remove(0);
            if let Some(next) = rest.first_mut() {
                next.from = stop.position;
            }
        }
        match (&mut self.law, &stop.law) {
            (Law::Ramped(law), Braked::Ramped(profiles)) => {
                law.cut(stop, profiles, self.moves.len());
            }
            (law, Braked::Clocked(slowed)) => *law = Law::Clocked(slowed.clone()),
            _ => {}
        }
        (self, rest)
    }
}

impl Plan {
    /// Returns what is left after a stop, along the same path, by a clock that stands, and the time of the plan
    /// at which it does; `None` for a plan of ramps.
    pub(crate) fn left(&self, stop: &Stop) -> Option<(Clocked, f64)> {
        let Braked::Clocked(slowed) = &stop.law else { return None };
        let stands = Tick { t_s: 0.0, rate: 0.0, ..slowed.clock.last().turned(0.0, 0.0) };
        Some((slowed.left_after(stop, Clock::of(vec![stands])), stands.plan_s))
    }
}

impl Clocked {
    /// Returns what is left after a stop, by a clock of its own.
    pub(crate) fn left_after(&self, stop: &Stop, clock: Clock) -> Self {
        let whole = stop.share >= 1.0;
        let (index, share) =
            if whole { (stop.move_index + 1, 0.0) } else { (stop.move_index, stop.share) };
        self.left(index, share, clock)
    }

    fn stop(&self, t_s: f64, ramped: bool) -> Stop {
        Self::stands_by(self.stopped(t_s, ramped), t_s)
    }

    /// The stop of a plan that is slowed from a time on.
    fn stands_by(slowed: Self, t_s: f64) -> Stop {
        let begin_s = slowed.slows_from(t_s);
        // A stop at once ends when it begins, whatever rounding says.
        let end_s = slowed.duration_s().max(begin_s);
        let State { position, move_index, share, .. } = slowed.at(end_s);
        let law = Braked::Clocked(Box::new(slowed));
        Stop { begin_s, end_s, position, move_index, share, law }
    }
}

impl Ramped {
    fn stop(&self, begin_s: f64, ramped: bool, moves: &[Move]) -> Stop {
        let mut braking = self.braking(begin_s, moves);
        let mut profiles = Vec::new();
        let mut end_s = begin_s;
        loop {
            let made = &moves[braking.index];
            let (way_mm, v_exit) = if ramped { braking.brake(made) } else { (0.0, braking.v) };
            // Mean speed times time is way, for constant acceleration.
            end_s += if way_mm > 0.0 { 2.0 * way_mm / (braking.v + v_exit) } else { 0.0 };
            braking.profile.v_exit = v_exit;
            profiles.push(braking.profile);
            let made_mm = braking.made_mm + way_mm;
            let stands = made_mm < made.length_mm || v_exit <= made.ramp_mm_s || !ramped;
            match moves.get(braking.index + 1) {
                Some(next) if !stands && next.continues(made) => {
                    braking = Braking::entering(braking.index + 1, v_exit, end_s);
                }
                _ => {
                    let share = (made_mm / made.length_mm).min(1.0);
                    let position = made.position(share);
                    let (move_index, law) = (braking.index, Braked::Ramped(profiles));
                    return Stop { begin_s, end_s, position, move_index, share, law };
                }
            }
        }
    }

    fn cut(&mut self, stop: &Stop, profiles: &[Profile], moves: usize) {
        self.profiles.truncate((stop.move_index + 1).saturating_sub(profiles.len()));
        self.profiles.extend(profiles);
        self.profiles.truncate(moves);
        self.duration_s = stop.end_s;
    }

    fn braking(&self, t_s: f64, moves: &[Move]) -> Braking {
        let index = self.index_at(t_s);
        let mut profile = self.profiles[index];
        let since = t_s - profile.start_s;
        let phases = self.phases(index, &moves[index]);
        let (made_mm, v, _) = phases.at(since);
        if phases.rises_at(since) {
            profile.v_peak = v;
        }
        Braking { index, made_mm, v, profile }
    }
}

impl Braking {
    fn entering(index: usize, v: f64, start_s: f64) -> Self {
        let profile = Profile { start_s, v_entry: v, v_peak: v, v_exit: v };
        Self { index, made_mm: 0.0, v, profile }
    }

    /// The way still made in this move, and the speed at its end.
    fn brake(&self, made: &Move) -> (f64, f64) {
        let left_mm = made.length_mm - self.made_mm;
        let (v, ramp, a) = (self.v, made.ramp_mm_s, made.accel_mm_s2);
        if v <= ramp {
            return (0.0, v);
        }
        let needed_mm = (v * v - ramp * ramp) / (2.0 * a);
        if needed_mm <= left_mm {
            (needed_mm, ramp)
        } else {
            (left_mm, (v * v - 2.0 * a * left_mm).max(0.0).sqrt())
        }
    }
}
