//! Another feed without a limit of jerk: the plan that runs is left for another, at once or where it has
//! slowed to the speed of the other.

use crate::chain::{Clocked, plain_clock};
use crate::clock::{Clock, Tick};
use crate::ease::Easing;
use crate::moves::Move;
use crate::plan::{Law, Plan};
use crate::retimed::Retimed;
use crate::state::State;
use crate::stop::Stop;
use kerf_program::{AXES, Axes};
use std::sync::Arc;

/// The plan with another feed is looked for at moments so far apart, seconds, and at so many.
const LOOK_S: f64 = 1e-3;
const LOOKS: u32 = 1000;

/// Places and directions that differ by less are the same, mm and share of the speed.
const SAME: f64 = 1e-6;

/// The other plan begins so many times farther behind than a straight line needs to be up to speed, and
/// at least so many moves: the path near a beginning is smoothed otherwise.
const RISES: f64 = 4.0;
const LEAST_BEHIND: usize = 64;

/// The place where one plan is left for another.
struct Splice {
    /// Time in the plan that is left, seconds.
    t_s: f64,
    /// The move in the other plan, and how much of it lies before.
    begin: (usize, f64),
    /// The clock of the other from there on.
    clock: Clock,
}

impl Retimed {
    /// Goes on at the present speed with another feed, where both plans are at the same place. Only
    /// what lies before the place where the machine could stand is planned for that.
    pub(crate) fn feed_clock(&mut self, piece: Plan, t_s: f64, share: f32) -> Option<(Plan, Stop)> {
        let (mut all, stand) = self.until_stand(piece.by(plain_clock()), t_s, true)?;
        let Law::Clocked(law) = &all.law else { return None };
        self.wait_with(Some(share));
        self.hurry();
        let planned: Vec<Move> = self.behind.iter().copied().chain(law.planned_moves()).collect();
        let here = law.planned(law.clock.at(t_s).plan_s);
        let first =
            first_needed(&planned[..=self.behind.len() + here.move_index], speed(&here), law);
        let planned: Vec<Move> = planned[first..].iter().map(|m| m.at_feed(share)).collect();
        // How many moves the other plan has before the first of this one, or less than none.
        let behind = self.behind.len() as isize - first as isize;
        let last = law.begin.0 + stand.move_index + 1;
        let count = last.saturating_add_signed(behind).min(planned.len());
        self.wait_first(&planned);
        self.clock = None;
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
}

/// The first of the moves, the last of which is being made, with which a plan from rest comes up to
/// this speed in time, by the same path.
fn first_needed(moves: &[Move], v_mm_s: f64, law: &Clocked) -> usize {
    let accels = law.dynamics().map_or([0.0; AXES], |dynamics| dynamics.accel_mm_s2.0);
    let least = accels.into_iter().fold(f64::INFINITY, f64::min);
    let needed_mm = RISES * v_mm_s * v_mm_s / (2.0 * least);
    let mut way_mm = 0.0;
    let near = |m: &&Move| {
        way_mm += m.length_mm;
        way_mm < needed_mm
    };
    let count = moves.iter().rev().take_while(near).count().max(LEAST_BEHIND) + 1;
    moves.len().saturating_sub(count)
}

/// Finds the splice of one plan to another whose moves begin so many earlier: at once, or where it has
/// slowed to the speed of the other; and the plan as it runs until then.
fn splice(from: &Clocked, to: &Clocked, behind: isize, t_s: f64) -> Option<(Splice, Clocked)> {
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
fn splice_at(from: &Clocked, to: &Clocked, behind: isize, t_s: f64) -> Option<Splice> {
    let tick = from.clock.at(t_s);
    let old = from.planned(tick.plan_s);
    let begin = (old.move_index.checked_add_signed(behind)?, old.share);
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

/// Returns `true` if two plans are at the same place and go in the same direction.
pub(crate) fn same_course(a: &State, b: &State) -> bool {
    let near = |d: Axes| d.0.iter().all(|d| d.abs() <= SAME);
    let (v, w) = (speed(a), speed(b));
    near(a.position.minus(b.position)) && near(a.velocity.zip(b.velocity, |x, y| x / v - y / w))
}
