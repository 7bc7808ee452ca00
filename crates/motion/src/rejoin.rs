//! Another feed under a limit of jerk: the plan that runs is left in motion.
//!
//! ```text
//!  speed ▲ ‾‾‾‾╲   the clock of the old plan slows to a lower feed …
//!        │      ╲___________
//!        │          ┊ … where the new plan begins, with that speed and acceleration
//!        └──────────┴────────► time
//! ```
//!
//! From there on the old plan, run at that rate, is within all limits of the new one: so there is a
//! way, and the search for a faster one begins with it.

use crate::chain::{Clocked, plain_clock};
use crate::clock::{Clock, Tick};
use crate::ease::Easing;
use crate::moves::Move;
use crate::optimal::Running;
use crate::plan::{Law, Plan};
use crate::retimed::Retimed;
use crate::splice::{same_course, speed};
use crate::state::State;
use crate::stop::Stop;
use kerf_motion_optimal::{Node, SpeedPiece};
use std::sync::Arc;

/// So many moves behind are enough for the same path.
const BEHIND: usize = 64;

/// Time, seconds, within which a machine that is going to stand is let come to that stand first: it brakes
/// already, and there may be no other way.
const STANDS_SOON_S: f64 = 0.25;

/// The old plan runs on for so long, seconds, while the new one is made.
const LEAD_S: f64 = 0.05;

/// Over so many pieces of plan a way to slow is looked for.
const PIECES: u32 = 3;

/// Slower than this is at rest, mm/s.
const REST_MM_S: f64 = 1e-3;

/// Speeds that differ by less are the same, as a share.
const SAME: f64 = 1e-6;

/// A plan that is left at a time for one that is still to be made.
#[derive(Clone, Debug)]
pub(crate) struct Lead {
    /// The plan as it would run on, at a rate that stays from that time on.
    uncut: Plan,
    at_s: f64,
    /// The new feed, if it is another.
    share: Option<f32>,
    /// It must be slowed first, because that feed is lower.
    fast: bool,
    /// It was planned anew meanwhile, because it held the way to a stand that is not needed.
    renewed: bool,
}

impl Lead {
    /// Of a plan that was started after a stand.
    pub const fn resumed(uncut: Plan, at_s: f64) -> Self {
        Self { uncut, at_s, share: None, fast: false, renewed: false }
    }

    /// Drops the part before the time, which is made.
    fn run_on(&mut self) {
        let uncut = std::mem::take(&mut self.uncut);
        let (Law::Clocked(law), Some(stop)) = (&uncut.law, uncut.stop(self.at_s, false)) else {
            return;
        };
        let left = law.left_after(&stop, Clock::of(vec![law.clock.at(self.at_s)]));
        let (_, moves) = uncut.cut(&stop);
        self.uncut = Plan { moves, law: Law::Clocked(Box::new(left)) };
    }
}

impl Retimed {
    /// Goes on with another feed. The plan that runs leads over to it: a short way as it is, which is
    /// there at once, then slowed where the feed is lower.
    pub(crate) fn feed_with_jerk(
        &mut self,
        piece: Plan,
        t_s: f64,
        share: f32,
    ) -> Option<(Plan, Stop)> {
        let mut all = self.uncut(piece);
        let clock = all.clock()?;
        let here = clock.at(t_s);
        // A smooth change that goes on is made to its end first.
        let from = if here.gain == 0.0 { here } else { clock.last() };
        while all.duration_s() <= from.t_s {
            let Some(next) = self.at_once() else { break };
            all.join(next);
        }
        let Law::Clocked(law) = &all.law else { return None };
        let stop = all.stop(from.t_s, false)?;
        let left = law.left_after(&stop, Clock::of(vec![Tick { t_s: 0.0, ..from }]));
        let fast = law.planned_share(from.plan_s, share).is_some_and(|rate| from.rate > rate);
        let (made, moves) = all.cut(&stop);
        self.last.clear();
        let uncut = Plan { moves, law: Law::Clocked(Box::new(left)) };
        self.lead(Lead { uncut, at_s: LEAD_S, share: Some(share), fast, renewed: false });
        Some((made, stop))
    }

    /// A piece that came out, which may have been cut for another plan: as it would run on.
    pub(crate) fn uncut(&mut self, piece: Plan) -> Plan {
        match self.leads.take() {
            Some(lead) => lead.uncut,
            None => piece.by(plain_clock()),
        }
    }

    /// The plan that comes next runs until a time, and from there on another, with another feed if
    /// there is one.
    pub(crate) fn lead(&mut self, mut lead: Lead) {
        while lead.uncut.duration_s() <= lead.at_s {
            let Some(next) = self.at_once() else { break };
            lead.uncut.join(next);
        }
        let Lead { uncut, at_s, share, .. } = &lead;
        let cut = match &uncut.law {
            Law::Clocked(law) if law.stands_soon(&law.clock.at(*at_s)).is_none() => {
                uncut.stop(*at_s, false).filter(|_| *at_s < uncut.duration_s())
            }
            _ => None,
        };
        let Some(stop) = cut else {
            let (share, at_s) = (*share, *at_s);
            return self.run_to_stand(lead.uncut, at_s, share);
        };
        self.ready = Some(uncut.clone().cut(&stop).0);
        self.leads = Some(lead);
    }

    /// The plan that comes next runs to the stand that it comes to.
    fn run_to_stand(&mut self, uncut: Plan, at_s: f64, share: Option<f32>) {
        let Law::Clocked(law) = &uncut.law else { return };
        let end_s = law.stands_soon(&law.clock.at(at_s)).unwrap_or(uncut.duration_s());
        let Some(stop) = uncut.stop(end_s, false) else { return };
        let (made, rest) = uncut.cut(&stop);
        self.begin_anew(&rest, share);
        self.clock = Some(Arc::new(Clock::plain(stop.end_s, 0.0)));
        self.ready = Some(made);
    }

    /// Goes over to the plan that is led to; should none be found, the old one leads on.
    pub(crate) fn over(&mut self, lead: Lead) {
        let mut lead = lead;
        if lead.fast {
            return self.slow_over(lead);
        }
        if self.go_over(&lead, lead.share) {
            return;
        }
        lead.run_on();
        match lead.share {
            Some(_) => self.slow_over(lead),
            None => {
                lead.at_s += LEAD_S;
                self.lead(lead);
            }
        }
    }

    /// Goes over to the plan that is led to, with a feed if there is another; whether one was found.
    fn go_over(&mut self, lead: &Lead, share: Option<f32>) -> bool {
        let before = self.clone();
        let Some(plan) = self.joined(lead, share) else {
            *self = before;
            return false;
        };
        self.forget_made();
        self.clock = None;
        self.go_on(Some(plan));
        true
    }

    /// The plan that comes next is slowed to another feed; where the limits do not let it, it runs on to
    /// the next place where it is slow enough, or tries later.
    fn slow_over(&mut self, mut lead: Lead) {
        let before = self.clone();
        let (from_s, whole) = (lead.at_s, lead.clone());
        lead.run_on();
        let share = lead.share.unwrap_or(1.0);
        let slowed = self.slowed(&mut lead.uncut, from_s, share);
        let crosses = |slowed: &Clocked, joins: &Tick| {
            slowed.stand_after(&slowed.clock.at(from_s)).is_some_and(|s| s < joins.t_s)
        };
        if let Some((slowed, joins)) = slowed.filter(|(slowed, joins)| !crosses(slowed, joins)) {
            lead.uncut.law = Law::Clocked(Box::new(slowed));
            (lead.at_s, lead.fast) = (joins.t_s.max(from_s + LEAD_S), false);
            return self.lead(lead);
        }
        if !whole.renewed {
            *self = before;
            if self.go_over(&whole, None)
                && let Some(uncut) = self.ready.take()
            {
                return self.lead(Lead { uncut, at_s: from_s + LEAD_S, renewed: true, ..whole });
            }
            lead = whole;
            lead.run_on();
        }
        let slow_s = match &lead.uncut.law {
            Law::Clocked(law) => law.slow_place(from_s + LEAD_S, share),
            _ => None,
        };
        (lead.at_s, lead.fast) = (slow_s.unwrap_or(from_s + LEAD_S), slow_s.is_none());
        self.lead(lead);
    }

    /// A plan that goes on where another leads to.
    fn joined(&mut self, lead: &Lead, share: Option<f32>) -> Option<Plan> {
        let Law::Clocked(law) = &lead.uncut.law else { return None };
        let joins = law.clock.at(lead.at_s);
        let (old, ways) = (law.planned(joins.plan_s), law.ways(&joins));
        if ways.is_empty() {
            return None;
        }
        self.wait_with(share);
        self.behind.drain(..self.behind.len().saturating_sub(BEHIND));
        let ended = usize::from(old.share >= 1.0);
        let index = self.behind.len() + old.move_index + ended;
        let begin = (index, if ended > 0 { 0.0 } else { old.share });
        let planned = self.behind.iter().copied().chain(law.planned_moves());
        let planned: Vec<Move> = match share {
            Some(share) => planned.map(|m| m.at_feed(share)).collect(),
            None => planned.collect(),
        };
        self.run_on(planned.get(..=index)?, &planned[index + 1..], Running { begin, ways });
        let fresh = self.next()?;
        let mut left = goes_on(&fresh, &old, joins.rate).filter(|_| !self.is_lost())?;
        left.begin = begin;
        left.clock = Arc::new(Clock::plain(lead.at_s, 0.0));
        let mut moves = fresh.moves;
        moves.drain(..begin.0);
        if let Some(first) = moves.first_mut() {
            *first = first.split(begin.1).1;
        }
        Some(Plan { moves, law: Law::Clocked(Box::new(left)) })
    }

    /// A plan that is slowed to a share of its feed, if that is lower, and when it is; as much of the
    /// stack is planned as that takes. `None` at rest, and where the limits do not let it.
    fn slowed(&mut self, all: &mut Plan, t_s: f64, share: f32) -> Option<(Clocked, Tick)> {
        for _ in 0..PIECES {
            let Law::Clocked(law) = &all.law else { return None };
            let from = law.clock.at(t_s);
            let rate = law.planned_share(from.plan_s, share)?;
            let ticks = match from.rate <= rate {
                true => Some(vec![from]),
                false => Easing::new(law, law.dynamics()?).to_rate(from, rate),
            };
            let joins = ticks.as_ref().and_then(|ticks| ticks.last()).copied();
            if let (Some(ticks), Some(joins)) = (ticks, joins)
                && joins.plan_s < law.plan_end_s()
            {
                let slowed = Clocked { clock: Arc::new(law.clock.then(ticks)), ..(**law).clone() };
                let moves = speed(&slowed.planned(joins.plan_s)) * joins.rate > REST_MM_S;
                let goes = moves && !slowed.ways(&joins).is_empty();
                return goes.then_some((slowed, joins));
            }
            all.join(self.next()?);
        }
        None
    }
}

/// The fresh plan, if it goes on where the old one is left.
fn goes_on(fresh: &Plan, old: &State, rate: f64) -> Option<Clocked> {
    let Law::Clocked(law) = fresh.clone().by(plain_clock()).law else { return None };
    let new = law.planned(0.0);
    let (v, w) = (speed(old) * rate, speed(&new));
    let same = (v - w).abs() <= SAME * v && same_course(old, &new);
    same.then_some(*law)
}

impl Clocked {
    /// The rate at which a move, made at a time of the plan, has another feed; at most that of the plan.
    fn planned_share(&self, plan_s: f64, share: f32) -> Option<f64> {
        let made = self.planned_moves().nth(self.planned(plan_s).move_index)?;
        Some(f64::from(made.at_feed(share).feed / made.feed).min(1.0))
    }

    /// The next time, not before one, at which the plan is slowest between faster places and not faster
    /// than another feed allows.
    fn slow_place(&self, from_s: f64, share: f32) -> Option<f64> {
        let from = self.clock.at(from_s);
        let nodes: Vec<Node> = self.nodes().filter(|node| node.t_s >= from.plan_s).collect();
        let slow = |both: &&[Node]| {
            let place = both[1];
            let state = self.planned(place.t_s);
            let least = place.v <= both[0].v && place.v <= both[2].v;
            least
                && self.planned_moves().nth(state.move_index).is_some_and(|made| {
                    state.path_speed_mm_s * from.rate <= made.at_feed(share).top_mm_s()
                })
        };
        let place = nodes.windows(3).find(slow)?[1];
        Some(self.clock.when(place.t_s))
    }

    /// The nodes of the pieces, in order.
    fn nodes(&self) -> impl Iterator<Item = Node> {
        let timed = self.pieces.iter().filter_map(|piece| match &piece.law {
            Law::Timed(timed) => Some(&timed.nodes),
            _ => None,
        });
        timed.flatten().copied()
    }

    /// Returns the time at which the machine stands, if that is soon after a moment.
    fn stands_soon(&self, from: &Tick) -> Option<f64> {
        self.stand_after(from).filter(|end_s| *end_s < from.t_s + STANDS_SOON_S)
    }

    /// Returns the time at which the machine stands after a moment, as far as it is known.
    fn stand_after(&self, from: &Tick) -> Option<f64> {
        let stand = self.nodes().find(|node| node.v == 0.0 && node.t_s > from.plan_s)?;
        Some(self.clock.when(stand.t_s))
    }

    /// The motion along the path from a moment on, by a clock whose rate stays, as far as it is known.
    fn ways(&self, from: &Tick) -> Vec<SpeedPiece> {
        let ends = |piece: &&Arc<Plan>| piece.duration_s() <= from.plan_s;
        let timed = self.pieces.iter().skip_while(ends).map_while(|piece| match &piece.law {
            Law::Timed(timed) => Some(timed),
            _ => None,
        });
        let mut all = Vec::new();
        for timed in timed {
            let (ways, whole) = timed.ways_from(from.plan_s, from.rate);
            all.extend(ways);
            if !whole {
                break;
            }
        }
        all
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::{Model, Mover, Optimal};
    use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, Settings};

    /// The rate is that of the feed that is asked for to the feed of the plan, which may be overridden already.
    #[test]
    fn another_feed_is_reached_at_its_share_of_the_planned_one() {
        let dynamics = Dynamics {
            speed_mm_s: Axes::splat(200.0),
            accel_mm_s2: Axes::splat(500.0),
            jerk_mm_s3: Some(Axes::splat(20_000.0)),
            tolerance_mm: 0.02,
        };
        let to = Axes::xyz(50.0, 0.0, 0.0);
        let line = Line { kind: MoveKind::Cut, to, feed: Feed::Axis };
        let mut mover = Mover::new(Axes::default(), &Settings::default());
        let made = mover.line(At::default(), &line).unwrap();
        for (planned, asked, rate) in
            [(0.5, 0.25, 0.5), (0.5, 0.5, 1.0), (0.5, 2.0, 1.0), (1.0, 0.1, 0.1)]
        {
            let plan = Optimal { dynamics: &dynamics }.plan(vec![made.at_feed(planned)]);
            let Law::Clocked(law) = plan.by(plain_clock()).law else { panic!("it has a clock") };
            let found = law.planned_share(0.1, asked).unwrap();
            assert!((found - rate).abs() < 1e-6, "{planned} {asked}: {found}");
        }
    }
}
