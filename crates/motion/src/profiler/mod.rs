//! The `profiler` model: smoothed sections at full speed, every other corner a stop (Profiler
//! reference, "Tool Path Smoothing" and "Maximum Machine Cutting Speeds"; readings, Speeds, Smoothing).
//!
//! Three steps.
//!
//! 1. Short segments that a spline follows closely enough become curves ([`sections`]); the
//!    smoothing factor says how closely.
//! 2. Each move gets its speed: what the program asks for, at most what its direction, its
//!    curvature and every axis allow ([`limits`]).
//! 3. Each joint gets its speed: that of the moves beside it where the path goes on in the same
//!    direction or turns by less than the stop angle; else the machine stands there.
//!
//! The look-ahead then sees to it that the accelerations suffice. Ramps are linear in time.

mod limits;
mod replan;
mod sections;
pub(crate) mod spline;

use crate::ahead::Ahead;
use crate::fit::Fit;
use crate::moves::Move;
use crate::plan::Plan;
use crate::planner::{Model, Planner};
use crate::profile::Profile;
use kerf_program::{Dynamics, Smoothing};
use limits::Limits;
use spline::{angle, unit};
use std::collections::VecDeque;

/// Directions that differ by less are the same, radians: rounding, not a corner.
const SAME_RAD: f64 = 1e-5;

/// Speeds and accelerations that are never reached, so that arithmetic stays finite.
const MOST: f64 = 1e12;

/// Smoothed sections at full speed, every other corner a stop.
#[derive(Clone, Copy, Debug)]
pub struct Profiler<'a> {
    /// Speeds and accelerations of the axes; jerk and tolerance are not looked at.
    pub dynamics: &'a Dynamics,
    /// Smoothing factor, stop angle, centripetal share, speeds by direction.
    pub smoothing: &'a Smoothing,
}

impl Model for Profiler<'_> {
    fn plan(&self, moves: Vec<Move>) -> Plan {
        let mut planner = ProfilerPlanner::new(self.dynamics, self.smoothing);
        planner.read = moves;
        planner.finish().unwrap_or_default()
    }
}

/// Plans a stack while it is read.
///
/// What is kept: the moves on which a curve may still depend, and those on which the tool may have
/// to slow for what comes.
#[derive(Clone, Debug)]
pub struct ProfilerPlanner {
    dynamics: Dynamics,
    smoothing: Smoothing,
    /// The last moves that were smoothed, as they were before.
    past: Vec<Move>,
    /// Moves that are not smoothed yet.
    read: Vec<Move>,
    /// Moves that have their curves, before those, and no speeds yet.
    curved: VecDeque<Move>,
    ahead: Ahead,
    fit: Fit,
    /// The next piece is looked for when so many moves are known.
    enough: usize,
    /// A piece that is known already.
    ready: Option<Plan>,
}

/// So many moves are read before a piece is looked for, to do the work in one go.
const BLOCK: usize = 4096;

/// After a stop or an override so many moves get their speeds together.
const AT_ONCE: usize = 256;

impl ProfilerPlanner {
    /// For a stack that is planned with these limits.
    pub fn new(dynamics: &Dynamics, smoothing: &Smoothing) -> Self {
        Self {
            dynamics: *dynamics,
            smoothing: *smoothing,
            past: Vec::new(),
            read: Vec::new(),
            curved: VecDeque::new(),
            ahead: Ahead::default(),
            fit: Fit::default(),
            enough: BLOCK,
            ready: None,
        }
    }

    fn piece(&mut self, complete: bool) -> Option<Plan> {
        while !self.curved.is_empty() {
            let count = self.curved.len().min(AT_ONCE);
            let some: Vec<Move> = self.curved.drain(..count).collect();
            some.into_iter().for_each(|made| self.cap(made));
            let known = self.ahead.moves.len() - 1;
            if let Some(plan) = self.fit.take(&mut self.ahead, known, false) {
                return Some(plan);
            }
        }
        let open = if complete { 0 } else { sections::CONTEXT };
        for made in self.smoothed(open) {
            self.cap(made);
        }
        // How the last one ends depends on the next.
        let known = self.ahead.moves.len().saturating_sub(usize::from(!complete));
        self.fit.take(&mut self.ahead, known, complete)
    }

    /// The moves read but for so many of the last, with their curves.
    fn smoothed(&mut self, open: usize) -> Vec<Move> {
        let count = self.read.len().saturating_sub(open);
        let mut all = self.past.clone();
        all.extend_from_slice(&self.read);
        sections::smooth(&mut all, self.smoothing.limit_mm());
        let past = self.past.len();
        self.past.extend(self.read.drain(..count));
        self.past.drain(..self.past.len().saturating_sub(sections::CONTEXT));
        all.truncate(past + count);
        all.drain(..past);
        all
    }

    /// Gives the next move its speeds, and the joint before it.
    fn cap(&mut self, mut made: Move) {
        let limits = Limits { dynamics: &self.dynamics, smoothing: &self.smoothing };
        made.accel_mm_s2 = limits.accel_mm_s2(&made).min(MOST);
        made.ramp_mm_s = 0.0;
        let mut cap = alone(&made, &limits);
        let before = self.ahead.moves.last().filter(|m| made.continues(m) && self.passes(m, &made));
        if let (Some(_), Some(last)) = (before, self.ahead.caps.last_mut()) {
            let v = last.v_peak.min(cap.v_peak);
            (last.v_exit, cap.v_entry) = (v, v);
        }
        self.ahead.moves.push(made);
        self.ahead.caps.push(cap);
    }

    /// Returns `true` if the machine does not slow at the joint of two moves.
    fn passes(&self, a: &Move, b: &Move) -> bool {
        let [before, after] = [a.derivative(1.0), b.derivative(0.0)].map(|d| unit(d.first3()));
        let turn = match (before, after) {
            (Some(before), Some(after)) => angle(before, after),
            (None, None) => 0.0,
            _ => return false,
        };
        turn < SAME_RAD.max(self.smoothing.stop_angle_deg.to_radians())
    }
}

impl Planner for ProfilerPlanner {
    fn push(&mut self, made: Move) {
        self.read.push(made);
    }

    fn take(&mut self) -> Option<Plan> {
        if self.ready.is_some() {
            return self.ready.take();
        }
        let known = self.read.len() + self.curved.len() + self.ahead.moves.len();
        if known < self.enough {
            return None;
        }
        let plan = self.piece(false);
        let known = self.curved.len() + self.ahead.moves.len();
        self.enough = if known > self.ahead.moves.len() { 0 } else { BLOCK.max(2 * known) };
        plan
    }

    fn finish(&mut self) -> Option<Plan> {
        if self.ready.is_some() {
            return self.ready.take();
        }
        let plan = self.piece(true);
        if self.curved.is_empty() && self.ahead.moves.is_empty() && self.read.is_empty() {
            *self = Self::new(&self.dynamics, &self.smoothing);
        }
        plan
    }

    fn withdraw(&mut self) -> Vec<Move> {
        let ready = self.ready.take().into_iter().flat_map(|plan| plan.moves);
        let left = ready.chain(self.ahead.moves.drain(..)).chain(self.curved.drain(..));
        let left = left.chain(self.read.drain(..)).collect();
        *self = Self::new(&self.dynamics, &self.smoothing);
        left
    }
}

/// The caps of a move by itself: it starts and ends at rest.
fn alone(m: &Move, limits: &Limits<'_>) -> Profile {
    let v_peak = limits.speed_mm_s(m).min(MOST);
    Profile { start_s: 0.0, v_entry: 0.0, v_peak, v_exit: 0.0 }
}
