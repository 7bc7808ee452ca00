//! Stopping inside a plan, and what is left of it.
//!
//! With the ramps of VR a ramped stop slows along the path at the ramp's acceleration until ramp speed is reached, where
//! the machine stands; it may run on into later moves. As the plan itself never slows more steeply,
//! the stop never runs faster than the plan would have. On a smoothed path it slows as steeply as
//! the axes' accelerations allow, down to rest; a limit of jerk does not hold for a stop.

use crate::moves::Move;
use crate::optimal::{Node, Push, Timed};
use crate::plan::{Law, Plan};
use crate::profile::Profile;
use crate::ramped::Ramped;
use kerf_program::Axes;

/// Where and when a stop comes to rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// When the stop began, seconds of the plan.
    pub begin_s: f64,
    /// When the machine stands, seconds of the plan.
    pub end_s: f64,
    /// Where it stands, machine frame.
    pub position: Axes,
    /// The move in which it stands.
    pub move_index: usize,
    /// How much of that move's path has been made, 0 … 1.
    pub share: f64,
    law: Braked,
}

/// How the stop runs.
#[derive(Clone, Debug, PartialEq)]
enum Braked {
    /// Profiles of the moves from the one in which the stop began to the one in which it stands;
    /// the last only over its share.
    Ramped(Vec<Profile>),
    /// Nodes from the time at which the stop began.
    Timed(Vec<Node>),
}

/// How far the braking has come: in which move, how far into it, how fast.
struct Braking {
    index: usize,
    made_mm: f64,
    v: f64,
    profile: Profile,
}

impl Stop {
    /// How many moves of the plan are made to their end.
    pub fn whole(&self) -> usize {
        self.move_index + usize::from(self.share >= 1.0)
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
            Law::Timed(law) => law.stop(begin_s, ramped, &self.moves),
        })
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
            (Law::Timed(law), Braked::Timed(nodes)) => law.cut(stop, nodes),
            _ => {}
        }
        (self, rest)
    }
}

impl Timed {
    fn stop(&self, begin_s: f64, ramped: bool, moves: &[Move]) -> Stop {
        let mut nodes = self.brake(begin_s, moves);
        if !ramped {
            nodes.truncate(1);
        }
        let stands = nodes[nodes.len() - 1];
        let (move_index, share) = self.share(stands.at_mm);
        Stop {
            begin_s,
            end_s: stands.t_s,
            position: self.geometry(stands.at_mm)[0],
            move_index,
            share,
            law: Braked::Timed(nodes),
        }
    }

    fn cut(&mut self, stop: &Stop, nodes: &[Node]) {
        let made = self.nodes.partition_point(|n| n.t_s < stop.begin_s);
        self.nodes.truncate(made);
        self.nodes.extend(nodes);
        if !self.pushes.is_empty() {
            self.pushes.truncate(made);
            let gain = |pair: &[Node]| (pair[1].v - pair[0].v) / (pair[1].t_s - pair[0].t_s);
            let even = |accel| Push { accel, jerk: Some(0.0) };
            self.pushes.extend(nodes.windows(2).map(|pair| even(gain(pair))));
            self.pushes.push(even(0.0));
        }
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
