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
use crate::optimal::{Running, Way};
use crate::plan::{Law, Plan, State};
use crate::retimed::{Retimed, same_course, speed};
use crate::stop::Stop;
use std::sync::Arc;

/// So many moves behind are enough for the same path.
const BEHIND: usize = 64;

/// When the machine will stand within this, seconds, it is let come to that stand first: it brakes
/// already, and there may be no other way.
const STANDS_SOON_S: f64 = 0.25;

/// Slower than this is at rest, mm/s.
const REST_MM_S: f64 = 1e-3;

/// Speeds that differ by less are the same, as a share.
const SAME: f64 = 1e-6;

impl Retimed {
    /// Goes on with another feed; from a stand where no way is found.
    pub(crate) fn feed_with_jerk(
        &mut self,
        piece: Plan,
        t_s: f64,
        share: f32,
    ) -> Option<(Plan, Stop)> {
        let mut all = piece.by(plain_clock());
        let Some((slowed, joins)) = self.slowed(&mut all, t_s, share) else {
            return self.leave(all, t_s, share);
        };
        if let Some(end_s) = slowed.stands_soon(&joins) {
            all.law = Law::Clocked(Box::new(slowed));
            let stop = all.stop(end_s, false)?;
            let (made, rest) = all.cut(&stop);
            self.wait_with(share);
            self.begin_anew(rest.into_iter().map(|m| m.at_feed(share)));
            return Some((made, stop));
        }
        self.wait_with(share);
        self.behind.drain(..self.behind.len().saturating_sub(BEHIND));
        let old = slowed.planned(joins.plan_s);
        let ended = usize::from(old.share >= 1.0);
        let index = self.behind.len() + old.move_index + ended;
        let begin = (index, if ended > 0 { 0.0 } else { old.share });
        let planned = self.behind.iter().copied().chain(slowed.planned_moves());
        let planned: Vec<Move> = planned.map(|m| m.at_feed(share)).collect();
        let count = planned.len();
        let running = Running { begin, ways: slowed.ways(&joins) };
        self.run_on(&planned[..=index], &planned[index + 1..], running);
        let fresh = self.next()?;
        let Some(mut left) = goes_on(&fresh, &old, joins.rate).filter(|_| !self.is_lost()) else {
            self.take_back(&fresh.moves, count);
            return self.leave(all, t_s, share);
        };
        left.begin = begin;
        all.law = Law::Clocked(Box::new(slowed));
        let stop = all.stop(joins.t_s, false)?;
        let (made, _) = all.cut(&stop);
        let mut moves = fresh.moves;
        moves.drain(..begin.0);
        if let Some(first) = moves.first_mut() {
            *first = first.split(begin.1).1;
        }
        self.forget_made();
        self.go_on(Some(Plan { moves, law: Law::Clocked(Box::new(left)) }));
        Some((made, stop))
    }

    /// A plan that is slowed to a share of its feed, if that is lower, and when it is; as much of the
    /// stack is planned as that takes. `None` at rest, and where the limits do not let it.
    fn slowed(&mut self, all: &mut Plan, t_s: f64, share: f32) -> Option<(Clocked, Tick)> {
        let made = all.moves.get(all.index_at(t_s)?)?;
        let rate = f64::from(made.at_feed(share).feed / made.feed).min(1.0);
        loop {
            let Law::Clocked(law) = &all.law else { return None };
            let here = law.clock.at(t_s);
            // A smooth change that goes on is made to its end first.
            let from = if here.gain == 0.0 { here } else { law.clock.last() };
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
    }
}

/// The fresh plan, if it goes on where the old one is left.
fn goes_on(fresh: &Plan, old: &State, rate: f64) -> Option<Clocked> {
    let Law::Clocked(law) = fresh.clone().by(plain_clock()).law else { return None };
    let new = law.planned(0.0);
    let (v, w) = (speed(old) * rate, speed(&new));
    let same = (v - w).abs() <= SAME * v && same_course(old, &new);
    same.then(|| Clocked { clock: Arc::new(Clock::plain(0.0, 0.0)), ..*law })
}

impl Clocked {
    /// When the machine stands, if that is soon after a moment.
    fn stands_soon(&self, from: &Tick) -> Option<f64> {
        let timed = self.pieces.iter().filter_map(|piece| match &piece.law {
            Law::Timed(timed) => Some(&timed.nodes),
            _ => None,
        });
        let stand = timed.flatten().find(|node| node.v == 0.0 && node.t_s > from.plan_s)?;
        let end_s = self.clock.when(stand.t_s);
        (end_s < from.t_s + STANDS_SOON_S).then_some(end_s)
    }

    /// The motion along the path from a moment on, by a clock whose rate stays, as far as it is known.
    fn ways(&self, from: &Tick) -> Vec<Way> {
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
