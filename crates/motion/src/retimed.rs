//! Leaving a plan of the `optimal` model for another on the way.
//!
//! What has been planned is kept, path and all, and run by another clock ([`clock`](crate::clock)): to
//! a stand, from there up to the plan again, or from the present speed to that of a plan with
//! another feed, once both go through the same place in the same direction. With a limit of jerk the
//! clock is slowed to a lower feed, and the other plan begins there, at that speed and acceleration.

use crate::clock::Clock;
use crate::moves::Move;
use crate::optimal::{OptimalPlanner, Running};
use crate::plan::{Law, Plan};
use crate::planner::{Planner, Replanner};
use crate::rejoin::Lead;
use crate::stop::Stop;
use std::collections::VecDeque;
use std::sync::Arc;

/// So many moves that were made are kept: a new plan begins so far behind, to be up to speed.
const BEHIND: usize = 512;

/// So many moves of those that wait are planned together: what is not needed at once is planned when
/// it is asked for.
const AT_ONCE: usize = 128;

/// The same with a limit of jerk.
const AT_ONCE_WITH_JERK: usize = 32;

/// A machine mostly stands within so long, seconds.
const STANDS_S: f64 = 0.4;

/// A planner of the `optimal` model that can be stopped and overridden.
#[derive(Clone, Debug)]
pub struct Retimed {
    planner: OptimalPlanner,
    /// Moves that the planner does not have yet: it gets them as far as a piece of plan takes, so that
    /// it has little to give back when the operator intervenes.
    waiting: VecDeque<Move>,
    /// Number of them, from the first on, that have another feed, and its share.
    overridden: (usize, f32),
    /// The piece that comes out next, before what the planner gives.
    pub(crate) ready: Option<Plan>,
    /// The piece after that which came out last: it is there before it is needed, and a machine that
    /// slows may run on into it.
    ahead: Option<Plan>,
    /// The lead from what came out last, or comes out next, to a plan that is still to be made.
    pub(crate) leads: Option<Lead>,
    /// The clock for what the planner gives.
    pub(crate) clock: Option<Arc<Clock>>,
    /// The last moves that came out before the piece that came out last.
    pub(crate) behind: Vec<Move>,
    /// The moves of that.
    pub(crate) last: Vec<Move>,
}

impl Retimed {
    /// Around a planner.
    pub const fn new(planner: OptimalPlanner) -> Self {
        Self {
            planner,
            waiting: VecDeque::new(),
            overridden: (0, 1.0),
            ready: None,
            ahead: None,
            leads: None,
            clock: None,
            behind: Vec::new(),
            last: Vec::new(),
        }
    }

    /// The next piece; when the planner has none, what it would give if the stack were complete.
    pub(crate) fn next(&mut self) -> Option<Plan> {
        let known = self.ready.take().or_else(|| self.ahead.take());
        if let Some(piece) = known.or_else(|| self.planned()) {
            return Some(piece);
        }
        let last = self.planner.finish().map(|piece| self.by_clock(piece))?;
        // What is pushed from now on is another stack for the planner.
        self.clock = Some(Arc::new(Clock::plain(last.duration_s(), 0.0)));
        Some(last)
    }

    /// The next piece, without planning one if that can be.
    pub(crate) fn at_once(&mut self) -> Option<Plan> {
        let piece = self.early();
        if piece.is_some() || self.leads.is_some() { piece } else { self.next() }
    }

    /// The next piece that is planned; where none is, the way to a stand that the planner keeps ready.
    pub(crate) fn early(&mut self) -> Option<Plan> {
        let piece = self.ready.take().or_else(|| self.ahead.take());
        if piece.is_some() || self.leads.is_some() {
            return piece;
        }
        self.planner.take_early().map(|piece| self.by_clock(piece))
    }

    /// The next piece that no later move can change.
    fn known(&mut self) -> Option<Plan> {
        if self.ready.is_none()
            && let Some(lead) = self.leads.take()
        {
            self.over(lead);
        }
        if self.ready.is_some() {
            return self.ready.take();
        }
        let piece = self.ahead.take().or_else(|| self.planned());
        if piece.is_some() {
            self.ahead = self.planned();
        }
        piece
    }

    /// The next piece that the planner gives. Moves that wait are given to it as far as that takes.
    pub(crate) fn planned(&mut self) -> Option<Plan> {
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
            self.give(count);
        }
    }

    /// Gives the planner the first moves that wait.
    fn give(&mut self, count: usize) {
        let (overridden, share) = &mut self.overridden;
        for (k, made) in self.waiting.drain(..count).enumerate() {
            self.planner.push(if k < *overridden { made.at_feed(*share) } else { made });
        }
        *overridden = overridden.saturating_sub(count);
    }

    /// These wait before all others, with their feed.
    pub(crate) fn wait_first(&mut self, moves: &[Move]) {
        moves.iter().rev().for_each(|m| self.waiting.push_front(*m));
        if self.overridden.0 > 0 {
            self.overridden.0 += moves.len();
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
        let (all, stop) = self.until_stand(all, t_s, true)?;
        let (made, rest) = all.cut(&stop);
        self.begin_anew(&rest, Some(share));
        Some((made, stop))
    }

    /// Another stack, from a stand: these moves before all that waits, with another feed if there is
    /// one.
    pub(crate) fn begin_anew(&mut self, moves: &[Move], share: Option<f32>) {
        self.wait_with(None);
        self.wait_first(moves);
        self.override_waiting(share);
        self.clock = None;
        self.forget_made();
    }

    /// Stops a plan that can be run by another clock; the rest keeps its path.
    fn stop_clock(&mut self, piece: Plan, t_s: f64, ramped: bool) -> Option<(Plan, Stop)> {
        let all = self.uncut(piece);
        let (all, stop) = self.until_stand(all, t_s, ramped)?;
        let Some((left, plan_s)) = all.left(&stop) else { return Some((all, stop)) };
        let (made, moves) = all.cut(&stop);
        let left = Plan { moves, law: Law::Clocked(Box::new(left)) };
        self.start(left, plan_s);
        Some((made, stop))
    }

    /// Goes on from a stand, by the clock of a plan that starts there.
    fn start(&mut self, mut left: Plan, plan_s: f64) {
        self.last.clear();
        while !left.moves.is_empty() {
            let Law::Clocked(law) = &mut left.law else { return };
            let clock = law.started(plan_s);
            let runs = clock.last();
            law.clock = Arc::new(clock);
            if runs.rate == 0.0 {
                return self.begin_anew(&left.moves, None);
            }
            if runs.plan_s < law.plan_end_s() {
                return match self.planner.dynamics().jerk_mm_s3 {
                    None => self.go_on(Some(left)),
                    Some(_) => self.lead(Lead::resumed(left, runs.t_s)),
                };
            }
            let Some(next) = self.at_once() else { break };
            left.join(next);
        }
        self.go_on(Some(left));
    }

    /// A piece and as many behind it as it takes to come to a stand, and where that is.
    pub(crate) fn until_stand(
        &mut self,
        mut all: Plan,
        t_s: f64,
        ramped: bool,
    ) -> Option<(Plan, Stop)> {
        if all.duration_s() < t_s + STANDS_S
            && let Some(next) = self.ahead.take_if(|_| self.ready.is_none())
        {
            all.join(next);
        }
        let mut stop = all.stop(t_s, ramped)?;
        while stop.end_s >= all.duration_s() && !all.ends_at_rest() {
            let mut next = self.early();
            if next.is_none() {
                // Nobody waits for a plan as long as the machine can stand without.
                let hard = all.brake(t_s).filter(|stop| stop.end_s < all.duration_s());
                if let Some(hard) = hard {
                    return Some((all, hard));
                }
                next = self.at_once();
            }
            let Some(next) = next else { break };
            all.join(next);
            stop = all.stop(t_s, ramped)?;
        }
        Some((all, stop))
    }

    /// Sets what comes out next, from time 0 on; what the planner gives follows it, by the same clock.
    pub(crate) fn go_on(&mut self, left: Option<Plan>) {
        let left = left.filter(|plan| !plan.moves.is_empty());
        let end_s = left.as_ref().map_or(0.0, Plan::duration_s);
        self.clock = match &self.clock {
            Some(clock) if clock.restarts() => Some(Arc::new(Clock::plain(end_s, 0.0))),
            _ => left.as_ref().and_then(Plan::clock),
        };
        self.ready = left;
    }

    /// The planner goes on in motion: with some moves at once, with more before all that waits.
    pub(crate) fn run_on(&mut self, now: &[Move], later: &[Move], running: Running) {
        self.wait_first(later);
        self.clock = None;
        self.planner.run_on(now, running);
    }

    /// Returns `true` if the planner found no way from the motion in which it began.
    pub(crate) fn is_lost(&self) -> bool {
        self.planner.is_lost()
    }

    /// Forgets the moves that were made: another plan has them.
    pub(crate) fn forget_made(&mut self) {
        (self.behind, self.last) = (Vec::new(), Vec::new());
    }

    /// The planner, which has nothing, gives its next pieces soon.
    pub(crate) fn hurry(&mut self) {
        self.planner.hurry();
    }

    /// Takes back from the planner what did not come out; it waits, with another feed if there is one.
    pub(crate) fn wait_with(&mut self, share: Option<f32>) {
        let planned = self.ready.take().into_iter().chain(self.ahead.take());
        let planned = planned.flat_map(|piece| piece.moves);
        let left: Vec<Move> = planned.chain(self.planner.withdraw()).collect();
        self.wait_first(&left);
        self.override_waiting(share);
        self.leads = None;
    }

    fn override_waiting(&mut self, share: Option<f32>) {
        if let Some(share) = share {
            self.overridden = (self.waiting.len(), share);
        }
    }

    /// Takes back a plan that is not run: what lies beyond so many moves waits again.
    pub(crate) fn take_back(&mut self, fresh: &[Move], beyond: usize) {
        let left = [fresh, &self.planner.withdraw()].concat();
        let beyond = beyond.min(left.len() + self.waiting.len());
        self.wait_first(left.get(beyond..).unwrap_or_default());
        let rest = beyond.saturating_sub(left.len());
        self.waiting.drain(..rest);
        self.overridden.0 = self.overridden.0.saturating_sub(rest);
    }
}

impl Planner for Retimed {
    fn push(&mut self, made: Move) {
        self.waiting.push_back(made);
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
        let mut left: Vec<Move> = ready.chain(self.planner.withdraw()).collect();
        self.give(self.waiting.len());
        left.append(&mut self.planner.withdraw());
        left
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
