//! Leaving a plan of the `optimal` model for another on the way.
//!
//! What has been planned is kept, path and all, and run by another clock ([`clock`](crate::clock)): to
//! a stand, from there up to the plan again, or from the present speed to that of a plan with
//! another feed, once both go through the same place in the same direction. With a limit of jerk the
//! clock is slowed to a lower feed, and the other plan begins there, at that speed and acceleration.

use crate::chain::{Clocked, plain_clock};
use crate::clock::{Clock, Tick};
use crate::ease::Easing;
use crate::moves::Move;
use crate::optimal::{OptimalPlanner, Running};
use crate::plan::{Law, Plan, State};
use crate::planner::{Planner, Replanner};
use crate::stop::Stop;
use kerf_program::Axes;
use std::collections::VecDeque;
use std::sync::Arc;

/// So many moves that were made are kept: a new plan begins so far behind, to be up to speed.
const BEHIND: usize = 512;

/// So many moves of those that wait are planned together: what is not needed at once is planned when
/// it is asked for.
const AT_ONCE: usize = 128;

/// The same with a limit of jerk.
const AT_ONCE_WITH_JERK: usize = 32;

/// The plan with another feed is looked for at moments so far apart, seconds, and at so many.
const LOOK_S: f64 = 1e-3;
const LOOKS: u32 = 1000;

/// Places and directions that differ by less are the same, mm and share of the speed.
const SAME: f64 = 1e-6;

/// A planner of the `optimal` model that can be stopped and overridden.
#[derive(Clone, Debug)]
pub struct Retimed {
    planner: OptimalPlanner,
    /// Moves that the planner does not have yet.
    waiting: VecDeque<Move>,
    /// What comes out next, before what the planner gives.
    ready: Option<Plan>,
    /// The clock for what the planner gives.
    clock: Option<Arc<Clock>>,
    /// The last moves that came out before the piece that came out last.
    pub(crate) behind: Vec<Move>,
    /// The moves of that.
    last: Vec<Move>,
}

/// Where one plan is left for another.
struct Splice {
    /// When, in the plan that is left, seconds.
    t_s: f64,
    /// The move in the other plan, and how much of it lies before.
    begin: (usize, f64),
    /// The clock of the other from there on.
    clock: Clock,
}

impl Retimed {
    /// Around a planner.
    pub const fn new(planner: OptimalPlanner) -> Self {
        Self {
            planner,
            waiting: VecDeque::new(),
            ready: None,
            clock: None,
            behind: Vec::new(),
            last: Vec::new(),
        }
    }

    /// The next piece; when the planner has none, what it would give if the stack were complete.
    pub(crate) fn next(&mut self) -> Option<Plan> {
        if let Some(piece) = self.known() {
            return Some(piece);
        }
        let last = self.planner.finish().map(|piece| self.by_clock(piece))?;
        // What is pushed from now on is another stack for the planner.
        self.clock = Some(Arc::new(Clock::plain(last.duration_s(), 0.0)));
        Some(last)
    }

    /// The next piece that no later move can change. Moves that wait are given to the planner as far
    /// as it takes to get one.
    fn known(&mut self) -> Option<Plan> {
        if self.ready.is_some() {
            return self.ready.take();
        }
        loop {
            if let Some(piece) = self.planner.take() {
                return Some(self.by_clock(piece));
            }
            if self.waiting.is_empty() {
                return None;
            }
            let jerk = self.planner.dynamics().jerk_mm_s3;
            let most = jerk.map_or(AT_ONCE, |_| AT_ONCE_WITH_JERK);
            let count = self.waiting.len().min(most);
            self.waiting.drain(..count).for_each(|m| self.planner.push(m));
        }
    }

    fn by_clock(&self, piece: Plan) -> Plan {
        match &self.clock {
            Some(clock) => piece.by(clock.clone()),
            None => piece,
        }
    }

    /// Remembers what comes out, of plans that can be run by another clock.
    fn out(&mut self, piece: Option<Plan>) -> Option<Plan> {
        let (moves, goes_on) = match &piece.as_ref()?.law {
            Law::Ramped(_) => (Vec::new(), false),
            Law::Clocked(law) => (law.planned_moves().collect(), law.begin != (0, 0.0)),
            Law::Timed(_) => (piece.as_ref()?.moves.clone(), false),
        };
        // What was left in the middle comes out with all of its moves.
        if !goes_on {
            self.behind.append(&mut self.last);
        }
        self.behind.drain(..self.behind.len().saturating_sub(BEHIND));
        self.last = moves;
        piece
    }

    /// Stops, and plans what is left with another feed.
    pub(crate) fn leave(&mut self, all: Plan, t_s: f64, share: f32) -> Option<(Plan, Stop)> {
        let stop = all.stop(t_s, true)?;
        let (made, rest) = all.cut(&stop);
        self.begin_anew(rest.into_iter().map(|m| m.at_feed(share)));
        Some((made, stop))
    }

    /// Another stack, from a stand, before all that waits.
    pub(crate) fn begin_anew(&mut self, moves: impl Iterator<Item = Move>) {
        (self.ready, self.clock) = (None, None);
        moves.for_each(|m| self.planner.push(m));
    }

    /// Stops a plan that can be run by another clock; the rest keeps its path.
    fn stop_clock(&mut self, piece: Plan, t_s: f64, ramped: bool) -> Option<(Plan, Stop)> {
        let (all, stop) = self.until_stand(piece, t_s, ramped)?;
        let left = all.left(&stop);
        let (made, moves) = all.cut(&stop);
        self.go_on(left.map(|law| Plan { moves, law: Law::Clocked(Box::new(law)) }));
        Some((made, stop))
    }

    /// A piece and as many behind it as it takes to come to a stand, and where that is.
    fn until_stand(&mut self, piece: Plan, t_s: f64, ramped: bool) -> Option<(Plan, Stop)> {
        let mut all = piece.by(plain_clock());
        let mut stop = all.stop(t_s, ramped)?;
        while stop.end_s >= all.duration_s() {
            let Some(next) = self.next() else { break };
            all.join(next);
            stop = all.stop(t_s, ramped)?;
        }
        Some((all, stop))
    }

    /// What comes out next, from time 0 on; what the planner gives follows it, by the same clock.
    pub(crate) fn go_on(&mut self, left: Option<Plan>) {
        let left = left.filter(|plan| !plan.moves.is_empty());
        let end_s = left.as_ref().map_or(0.0, Plan::duration_s);
        self.clock = match &self.clock {
            Some(clock) if clock.restarts() => Some(Arc::new(Clock::plain(end_s, 0.0))),
            _ => left.as_ref().and_then(Plan::clock),
        };
        self.ready = left;
    }

    /// Goes on at the present speed with another feed, where both plans are at the same place. Only
    /// what lies before the place where the machine could stand is planned for that.
    fn feed_clock(&mut self, piece: Plan, t_s: f64, share: f32) -> Option<(Plan, Stop)> {
        let (mut all, stand) = self.until_stand(piece, t_s, true)?;
        let Law::Clocked(law) = &all.law else { return None };
        self.wait_with(share);
        let behind = self.behind.len();
        let planned = self.behind.iter().copied().chain(law.planned_moves());
        let planned: Vec<Move> = planned.map(|m| m.at_feed(share)).collect();
        let count = (behind + law.begin.0 + stand.move_index + 1).min(planned.len());
        planned[count..].iter().rev().for_each(|m| self.waiting.push_front(*m));
        self.begin_anew(planned[..count].iter().copied());
        let mut fresh = self.next()?.by(plain_clock());
        while fresh.moves.len() < count {
            let Some(next) = self.next() else { break };
            fresh.join(next);
        }
        let Law::Clocked(other) = &fresh.law else { return None };
        let Some((splice, slowed)) = splice(law, other, behind, t_s) else {
            self.take_back(&fresh.moves, planned.len());
            return self.leave(all, t_s, share);
        };
        let (index, before) = splice.begin;
        let left =
            Clocked { begin: splice.begin, clock: Arc::new(splice.clock), ..(**other).clone() };
        all.law = Law::Clocked(Box::new(slowed));
        let stop = all.stop(splice.t_s, false)?;
        let (made, _) = all.cut(&stop);
        self.forget_made();
        let mut moves = fresh.moves.split_off(index);
        if let Some(first) = moves.first_mut() {
            *first = first.split(before).1;
        }
        self.go_on(Some(Plan { moves, law: Law::Clocked(Box::new(left)) }));
        Some((made, stop))
    }

    /// The planner goes on in motion: with some moves at once, with more before all that waits.
    pub(crate) fn run_on(&mut self, now: &[Move], later: &[Move], running: Running) {
        later.iter().rev().for_each(|m| self.waiting.push_front(*m));
        (self.ready, self.clock) = (None, None);
        self.planner.run_on(now, running);
    }

    /// Whether the planner found no way from the motion in which it began.
    pub(crate) fn is_lost(&self) -> bool {
        self.planner.is_lost()
    }

    /// What was made counts no more: another plan has its moves.
    pub(crate) fn forget_made(&mut self) {
        (self.behind, self.last) = (Vec::new(), Vec::new());
    }

    /// Takes back from the planner what did not come out; it waits with another feed.
    pub(crate) fn wait_with(&mut self, share: f32) {
        let ready = self.ready.take().into_iter().flat_map(|piece| piece.moves);
        let mut left: VecDeque<Move> = ready.chain(self.planner.withdraw()).collect();
        left.append(&mut self.waiting);
        self.waiting = left;
        self.waiting.iter_mut().for_each(|m| *m = m.at_feed(share));
    }

    /// Takes back a plan that is not run: what lies beyond so many moves waits again.
    pub(crate) fn take_back(&mut self, fresh: &[Move], beyond: usize) {
        let left = [fresh, &self.planner.withdraw()].concat();
        left.into_iter().rev().for_each(|m| self.waiting.push_front(m));
        self.waiting.drain(..beyond.min(self.waiting.len()));
    }
}

/// Where one plan is left for another whose moves begin so many earlier: at once, or where it has
/// slowed to the speed of the other; and the plan as it runs until then.
fn splice(from: &Clocked, to: &Clocked, behind: usize, t_s: f64) -> Option<(Splice, Clocked)> {
    if let Some(splice) = splice_at(from, to, behind, t_s) {
        return Some((splice, from.clone()));
    }
    let slowed = from.stopped(t_s, true);
    let steps = ((slowed.duration_s() - t_s) / LOOK_S) as u32;
    let moments = (1..steps.min(LOOKS)).map(|k| t_s + f64::from(k) * LOOK_S);
    let splice = moments.into_iter().find_map(|t_s| splice_at(&slowed, to, behind, t_s))?;
    Some((splice, slowed))
}

/// The same at a moment; `None` where the other plan is slower, or elsewhere.
fn splice_at(from: &Clocked, to: &Clocked, behind: usize, t_s: f64) -> Option<Splice> {
    let tick = from.clock.at(t_s);
    let old = from.planned(tick.plan_s);
    let begin = (old.move_index + behind, old.share);
    let plan_s = to.planned_at(begin.0, begin.1)?;
    let new = to.planned(plan_s);
    let (v, w) = (speed(&old) * tick.rate, speed(&new));
    let rate = v / w;
    if !(v > 0.0 && rate <= 1.0 + SAME && same_course(&old, &new)) {
        return None;
    }
    // The acceleration along the path goes on as well.
    let along = |state: &State| dot(&state.acceleration, &new.velocity) / (w * w);
    let accel = along(&old) * tick.rate * tick.rate + tick.gain * v / (tick.rate * w);
    let gain = accel - along(&new) * rate * rate;
    let joins = Tick { t_s: 0.0, plan_s, rate: rate.min(1.0), gain, push: 0.0 };
    let ticks = Easing::new(to, to.dynamics()?).join(joins)?;
    Some(Splice { t_s, begin, clock: Clock::of(ticks) })
}

pub(crate) fn speed(state: &State) -> f64 {
    dot(&state.velocity, &state.velocity).sqrt()
}

fn dot(a: &Axes, b: &Axes) -> f64 {
    a.zip(*b, |a, b| a * b).0.iter().sum()
}

/// Whether two plans are at the same place and go in the same direction.
pub(crate) fn same_course(a: &State, b: &State) -> bool {
    let near = |d: Axes| d.0.iter().all(|d| d.abs() <= SAME);
    let (v, w) = (speed(a), speed(b));
    near(a.position.minus(b.position)) && near(a.velocity.zip(b.velocity, |x, y| x / v - y / w))
}

impl Planner for Retimed {
    fn push(&mut self, made: Move) {
        if self.waiting.is_empty() {
            self.planner.push(made);
        } else {
            self.waiting.push_back(made);
        }
    }

    fn take(&mut self) -> Option<Plan> {
        let piece = self.known();
        self.out(piece)
    }

    fn finish(&mut self) -> Option<Plan> {
        let piece = self.known();
        if piece.is_some() {
            return self.out(piece);
        }
        let piece = self.planner.finish().map(|piece| self.by_clock(piece));
        (self.clock, self.behind) = (None, Vec::new());
        piece
    }

    fn withdraw(&mut self) -> Vec<Move> {
        self.clock = None;
        let ready = self.ready.take().into_iter().flat_map(|piece| piece.moves);
        ready.chain(self.planner.withdraw()).chain(self.waiting.drain(..)).collect()
    }
}

impl Replanner for Retimed {
    fn stop(&mut self, piece: Plan, t_s: f64, ramped: bool) -> Option<(Plan, Stop)> {
        self.stop_clock(piece, t_s, ramped)
    }

    fn feed(&mut self, piece: Plan, t_s: f64, share: f32) -> Option<(Plan, Stop)> {
        match self.planner.dynamics().jerk_mm_s3 {
            None => self.feed_clock(piece, t_s, share),
            Some(_) => self.feed_with_jerk(piece, t_s, share),
        }
    }
}
