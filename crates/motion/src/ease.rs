//! Slows the clock of a plan down to a stand and starts it again as fast as it may, so that no axis
//! exceeds its acceleration and jerk.
//!
//! Any motion along the path that is slower than one within the limits leaves room: with the rate r
//! the plan's accelerations count r² as much. So a rate may always stay as it is, and without a limit
//! of jerk it may, step by step, change as much as the axes allow; nothing that is reached so can
//! be a dead end. A limit of jerk is kept by changing the rate smoothly, over the shortest time for
//! which all limits hold, which sampling shows.

use crate::chain::Clocked;
use crate::clock::Tick;
use kerf_program::{AXES, Axes, Dynamics};

/// The rate is chosen, and limits are looked at, so often, seconds.
const STEP_S: f64 = 1e-3;

/// The rate changes at most so fast, 1/s: where the plan itself hardly moves, no axis limits it.
const MOST_GAIN: f64 = 200.0;

/// Slower axes do not limit the change, mm/s.
const STILL_MM_S: f64 = 1e-9;

/// By how much limits may be exceeded: a plan at its limits could never be left otherwise.
const ACCEL_SLACK: f64 = 1.002;
const JERK_SLACK: f64 = 1.02;

/// A change that breaks a limit mostly shows at moments so many times farther apart.
const COARSE: f64 = 8.0;

/// Time between two moments of a sketch of the plan, seconds. Between them the sketch is inexact; so a limit
/// may be exceeded by so much.
const SKETCH_S: f64 = 2e-3;
const SKETCH_SLACK: f64 = 1.05;

/// Parts of constant third derivative of a smooth change.
const PARTS: usize = 24;

/// By how much a longer time is tried when a limit does not hold, and how often.
const LONGER: f64 = 1.2;
const TRIALS: u32 = 6;
const TRIALS_FROM_REST: u32 = 24;

/// Moments, so far apart, seconds, at which a smooth change may begin.
const WAIT_S: f64 = 0.02;
const WAITS: u32 = 50;

/// A stop within a limit of jerk may take so long, seconds, and so many times the least that the axes need.
const LATE_S: f64 = 0.25;
const LATE: f64 = 3.0;

/// At this rate a plan goes on that was started under a limit of jerk.
const STARTED: f64 = 0.5;

/// No change of the rate takes more steps.
const MOST_STEPS: usize = 100_000;

/// A plan whose rate is changed.
pub(crate) struct Easing<'a> {
    plan: &'a Clocked,
    dynamics: Dynamics,
    end_s: f64,
}

impl<'a> Easing<'a> {
    /// Of a plan within limits.
    pub fn new(plan: &'a Clocked, dynamics: Dynamics) -> Self {
        let end_s = plan.pieces.last().map_or(0.0, |piece| piece.duration_s());
        Self { plan, dynamics, end_s }
    }

    /// From a moment on down to a stand; the last tick is where the machine stands, unless the plan
    /// ends before. Where `settled` the rate has come to rest after a change that still goes on.
    ///
    /// A limit of jerk holds as long as the machine does not stand much later for it; else it brakes at
    /// once, as steeply as the accelerations allow: a stop must never be waited for.
    pub fn stand(&self, now: Tick, settled: Tick) -> Vec<Tick> {
        let Some(jerk) = self.dynamics.jerk_mm_s3 else { return self.steps(now, 0.0) };
        let [velocity, _] = self.plan.rates(now.plan_s);
        let latest_s = now.t_s + LATE_S + LATE * self.at_least(&velocity, &jerk.0);
        let ticks = self.smooth(settled, 0.0, &jerk.0, latest_s);
        match ticks.last() {
            Some(last) if self.rests_at(last) <= latest_s => ticks,
            _ => self.steps(now, 0.0),
        }
    }

    /// Returns the time at which the machine stands or the plan ends, if the rate stays as it is.
    fn rests_at(&self, tick: &Tick) -> f64 {
        let left_s = (self.end_s - tick.plan_s).max(0.0);
        tick.t_s + if tick.rate > 0.0 { left_s / tick.rate } else { 0.0 }
    }

    /// From a stand up to the rate of the plan, or with a limit of jerk to a part of it, which leaves
    /// room: another plan begins there.
    pub fn start(&self, plan_s: f64) -> Vec<Tick> {
        let from = Tick { plan_s, ..Tick::default() };
        match self.dynamics.jerk_mm_s3 {
            None => self.steps(from, 1.0),
            Some(jerk) => self.smooth(from, STARTED, &jerk.0, f64::INFINITY),
        }
    }

    /// From a moment on to another rate, of at most that of the plan; `None` when a limit of jerk does
    /// not let it.
    pub fn to_rate(&self, from: Tick, rate: f64) -> Option<Vec<Tick>> {
        let ticks = match self.dynamics.jerk_mm_s3 {
            None => self.steps(from, rate),
            Some(jerk) => self.smooth(from, rate, &jerk.0, f64::INFINITY),
        };
        ticks.last().is_some_and(|last| last.rate == rate).then_some(ticks)
    }

    /// From a lower rate to that of the plan; `None` when a limit of jerk does not let it.
    pub fn join(&self, from: Tick) -> Option<Vec<Tick>> {
        self.to_rate(from, 1.0)
    }

    /// Changes the rate as fast as the accelerations allow.
    fn steps(&self, from: Tick, goal: f64) -> Vec<Tick> {
        let mut ticks = Vec::new();
        let mut tick = from.turned(0.0, 0.0);
        while tick.rate != goal && tick.plan_s < self.end_s && ticks.len() < MOST_STEPS {
            let gain = self.gain(&tick, goal > tick.rate);
            tick = tick.turned(gain, 0.0);
            ticks.push(tick);
            let needs_s = (goal - tick.rate) / gain;
            let arrives = gain != 0.0 && (0.0..=STEP_S).contains(&needs_s);
            tick = tick.after(if arrives { needs_s } else { STEP_S });
            if arrives {
                tick.rate = goal;
            }
        }
        ticks.push(self.ended(tick, goal));
        ticks
    }

    /// The last tick: the goal, or the end of the plan, which is at rest.
    fn ended(&self, tick: Tick, goal: f64) -> Tick {
        let plan_s = tick.plan_s.min(self.end_s);
        let rate = if plan_s < self.end_s { goal } else { 1.0 };
        Tick { plan_s, rate, gain: 0.0, push: 0.0, ..tick }
    }

    /// The greatest change of the rate over a step, up or down.
    fn gain(&self, tick: &Tick, up: bool) -> f64 {
        let here = self.plan.rates(tick.plan_s);
        let next = self.plan.rates(tick.plan_s + tick.rate * STEP_S);
        // Where the curvature jumps, what lies between counts as well.
        let middle = self.plan.rates(tick.plan_s + 0.5 * tick.rate * STEP_S);
        let mut gain = 0.0;
        // The rate at the end of the step depends on what is sought.
        for _ in 0..2 {
            let after = (tick.rate + gain * STEP_S).max(0.0);
            let [a, b] = [self.room(&here, tick.rate), self.room(&next, after)];
            let [c, d] = [self.room(&here, after), self.room(&next, tick.rate)];
            let e = self.room(&middle, after.max(tick.rate));
            let low = a.0.max(b.0).max(c.0).max(d.0).max(e.0).max(-MOST_GAIN);
            let high = a.1.min(b.1).min(c.1).min(d.1).min(e.1).min(MOST_GAIN);
            gain = if up { high.max(0.0) } else { low.min(0.0) };
        }
        gain
    }

    /// The changes of the rate that keep every axis within its acceleration.
    fn room(&self, [velocity, acceleration]: &[Axes; 2], rate: f64) -> (f64, f64) {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for k in 0..AXES {
            let (v, a) = (velocity.0[k], acceleration.0[k] * rate * rate);
            if v.abs() > STILL_MM_S {
                let most = self.dynamics.accel_mm_s2.0[k] * ACCEL_SLACK;
                let (one, other) = ((-most - a) / v, (most - a) / v);
                low = low.max(one.min(other));
                high = high.min(one.max(other));
            }
        }
        (low, high)
    }

    /// Changes the rate smoothly, as soon as the limits let it and in the shortest time; when they never
    /// do it stays.
    ///
    /// A plan that slows as steeply as it can leaves no room to slow more: then the change waits until
    /// that is over, but not beyond the latest moment.
    fn smooth(&self, from: Tick, goal: f64, jerk: &[f64; AXES], latest_s: f64) -> Vec<Tick> {
        let waits = if from.rate > 0.0 && from.gain == 0.0 { WAITS } else { 1 };
        let moments = (0..waits).map(|k| from.after(f64::from(k) * WAIT_S));
        let known = moments.take_while(|tick| tick.plan_s < self.end_s && tick.t_s < latest_s);
        let mut sketch = Sketch { plan: self.plan, from_s: from.plan_s, rates: Vec::new() };
        let mut changes = known.map(|tick| self.smooth_from(tick, goal, jerk, &mut sketch));
        changes.find_map(|ticks| ticks).unwrap_or_else(|| vec![from.turned(0.0, 0.0)])
    }

    /// The same from a moment on.
    fn smooth_from(
        &self,
        from: Tick,
        goal: f64,
        jerk: &[f64; AXES],
        sketch: &mut Sketch<'_>,
    ) -> Option<Vec<Tick>> {
        let [velocity, _] = self.plan.rates(from.plan_s);
        let mut takes_s = self.at_least(&velocity, jerk).max(2.0 * STEP_S);
        let trials = if from.rate > 0.0 { TRIALS } else { TRIALS_FROM_REST };
        for _ in 0..trials {
            let ticks = smooth(from, goal, takes_s);
            if [COARSE, 2.0].iter().all(|far| self.nearly_holds(&ticks, jerk, sketch, far * STEP_S))
                && self.holds(&ticks, jerk)
            {
                return Some(ticks);
            }
            takes_s *= LONGER;
        }
        None
    }

    /// No change from here is quicker, seconds: half of the peaks that it would have.
    fn at_least(&self, velocity: &Axes, jerk: &[f64; AXES]) -> f64 {
        let axes = velocity.0.iter().zip(&self.dynamics.accel_mm_s2.0).zip(jerk);
        axes.map(|((v, a), j)| (v.abs() / a).max((v.abs() / j).sqrt())).fold(0.0, f64::max)
    }

    /// Returns `true` if, by sampling, no axis exceeds its acceleration and jerk, and the plan does not end before.
    fn holds(&self, ticks: &[Tick], jerk: &[f64; AXES]) -> bool {
        let accel = self.dynamics.accel_mm_s2.0.map(|most| most * ACCEL_SLACK);
        let jerk = jerk.map(|most| most * JERK_SLACK);
        self.within(ticks, STEP_S, [accel, jerk], |plan_s| self.plan.rates(plan_s))
    }

    /// The same by a sketch, at moments so far apart; what it finds to hold may still not.
    fn nearly_holds(
        &self,
        ticks: &[Tick],
        jerk: &[f64; AXES],
        sketch: &mut Sketch<'_>,
        step_s: f64,
    ) -> bool {
        let accel = self.dynamics.accel_mm_s2.0.map(|most| most * SKETCH_SLACK);
        let jerk = jerk.map(|most| most * SKETCH_SLACK);
        self.within(ticks, step_s, [accel, jerk], |plan_s| sketch.at(plan_s))
    }

    /// Returns `true` if no axis exceeds limits of acceleration and jerk at moments so far apart.
    fn within(
        &self,
        ticks: &[Tick],
        step_s: f64,
        [most, jerk]: [[f64; AXES]; 2],
        mut rates: impl FnMut(f64) -> [Axes; 2],
    ) -> bool {
        let (Some(first), Some(last)) = (ticks.first(), ticks.last()) else { return true };
        let steps = ((last.t_s - first.t_s) / step_s).ceil().max(1.0) as usize;
        let h = (last.t_s - first.t_s) / steps as f64;
        let mut accel = |tick: &Tick| {
            let [Axes(v), Axes(a)] = rates(tick.plan_s);
            let square = tick.rate * tick.rate;
            std::array::from_fn::<f64, AXES, _>(|k| a[k] * square + v[k] * tick.gain)
        };
        let mut before = accel(first);
        let mut k = 0;
        for i in 1..=steps {
            let t_s = first.t_s + i as f64 * h;
            while k + 1 < ticks.len() && ticks[k + 1].t_s <= t_s {
                k += 1;
            }
            let tick = ticks[k].after(t_s - ticks[k].t_s);
            if tick.plan_s >= self.end_s {
                return false;
            }
            let now = accel(&tick);
            let fits = (0..AXES)
                .all(|k| now[k].abs() <= most[k] && (now[k] - before[k]).abs() <= jerk[k] * h);
            if !fits {
                return false;
            }
            before = now;
        }
        true
    }
}

/// Velocities and accelerations of a plan at moments evenly apart, as far as they were asked for.
struct Sketch<'a> {
    plan: &'a Clocked,
    from_s: f64,
    rates: Vec<[Axes; 2]>,
}

impl Sketch<'_> {
    /// About what the plan says at a time of its own.
    fn at(&mut self, plan_s: f64) -> [Axes; 2] {
        let place = (plan_s - self.from_s).max(0.0) / SKETCH_S;
        let (before, share) = (place as usize, place.fract());
        while self.rates.len() < before + 2 {
            self.rates.push(self.plan.rates(self.from_s + self.rates.len() as f64 * SKETCH_S));
        }
        let (a, b) = (&self.rates[before], &self.rates[before + 1]);
        std::array::from_fn(|k| a[k].zip(b[k], |a, b| a + share * (b - a)))
    }
}

/// A smooth change of the rate over a time. Its second derivative begins and ends at nothing, but for
/// what brings a change that goes on already to an end.
fn smooth(from: Tick, goal: f64, takes_s: f64) -> Vec<Tick> {
    let h = takes_s / PARTS as f64;
    let shape = |k: usize| {
        let x = (k as f64 + 0.5) / PARTS as f64;
        x * (1.0 - x) * (1.0 - 2.0 * x)
    };
    // What the parts bring about by themselves, so that the goal is met.
    let unit: f64 = (0..PARTS).map(|k| shape(k) * (PARTS as f64 - k as f64 - 0.5) * h * h).sum();
    let scale = (goal - from.rate) / unit;
    // g·t·(1 − x)² begins with the change g, ends without one, and comes back to nothing.
    let calm = |k: usize| (6.0 * (k as f64 + 0.5) / PARTS as f64 - 4.0) * from.gain / takes_s;
    let mut tick = from;
    let mut ticks = Vec::with_capacity(PARTS + 1);
    for k in 0..PARTS {
        tick.push = scale * shape(k) + calm(k);
        ticks.push(tick);
        tick = tick.after(h);
    }
    ticks.push(Tick { rate: goal, gain: 0.0, push: 0.0, ..tick });
    ticks
}

#[cfg(test)]
mod tests {
    use super::{PARTS, Tick, smooth};

    #[test]
    fn a_change_that_goes_on_already_ends_at_the_goal_too() {
        for gain in [-2.0, 0.0, 2.0] {
            let from = Tick { gain, ..Tick::plain(0.0, 0.0) };
            let ticks = smooth(from, 0.25, 0.5);
            let end = ticks[PARTS - 1].after(0.5 / PARTS as f64);
            assert!((end.rate - 0.25).abs() < 0.01 && end.gain.abs() < 1e-9, "{end:?}");
        }
    }
}
