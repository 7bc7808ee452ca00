//! Times at which each motor makes its steps.
//!
//! A motor has made ⌊p + ½⌋ steps where p is its axis' position in steps: it steps when p passes a
//! half. So what it has made and what it should have made never differ by more than half a step, at
//! any time and however long the program. The times are those at which the plan passes the halves,
//! sought on the plan itself; nothing is added up.

use kerf_program::{AXES, Axes};

/// Longest stretch of time looked at in one go, seconds.
const SLICE_S: f64 = 0.001;
/// Number of parts of a stretch; its first and last show whether an axis turns round in it. It is
/// taken to turn once at most.
const NEAR: f64 = 64.0;
/// Exactness with which the time of a step is sought, seconds: far below the clock of any board.
const EXACT_S: f64 = 1e-9;
/// Steps by which a place differs from what was made when the axis was not moved there: less is rounding.
const JUMP: f64 = 1.0;
/// Halvings in search of a time.
const HALVINGS: u32 = 40;

/// One step of one motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Time at which it is made, seconds.
    pub t_s: f64,
    /// Which axis of the motion turns it.
    pub axis: usize,
    /// Its count rises.
    pub forward: bool,
}

/// Finds steps, stretch by stretch of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Stepper {
    /// Steps for a millimetre or a degree.
    per_unit: Axes,
    /// Steps made.
    made: [i64; AXES],
}

impl Stepper {
    /// Motors with so many steps for a millimetre or a degree, negative where they turn the other
    /// way, that stand where the axes are.
    pub fn new(per_unit: Axes, at: Axes) -> Self {
        let made = at.zip(per_unit, |p, n| (p * n).round()).0.map(|steps| steps as i64);
        Self { per_unit, made }
    }

    /// Steps made by each motor.
    pub const fn made(&self) -> [i64; AXES] {
        self.made
    }

    /// The axes stand there. One that is elsewhere than its steps have brought it is counted anew, as when it was
    /// found to be at its home: no motor moved for that. Tells which axes.
    pub fn stands(&mut self, at: Axes) -> Vec<usize> {
        let steps = at.zip(self.per_unit, |p, n| p * n).0;
        let jumped = |axis: &usize| (steps[*axis] - self.made[*axis] as f64).abs() > JUMP;
        let anew: Vec<usize> = (0..AXES).filter(jumped).collect();
        anew.iter().for_each(|axis| self.made[*axis] = steps[*axis].round() as i64);
        anew
    }

    /// The steps of a motion from one time to another, in order of time. `place` tells where the
    /// axes are, and may jump in speed but not in place.
    pub fn follow(&mut self, from_s: f64, to_s: f64, place: impl Fn(f64) -> Axes) -> Vec<Step> {
        let mut steps = Vec::new();
        let slices = ((to_s - from_s) / SLICE_S).ceil().max(1.0);
        let time = |k: f64| if k == slices { to_s } else { from_s + (to_s - from_s) * k / slices };
        let mut k = 0.0;
        while k < slices {
            let since = steps.len();
            self.slice([time(k), time(k + 1.0)], &place, &mut steps);
            steps[since..].sort_by(|a, b| a.t_s.total_cmp(&b.t_s));
            k += 1.0;
        }
        steps
    }

    /// The same where a place between two moments that are `SLICE_S` apart is taken from a straight line: some µs off where
    /// speeds change, and much quicker. For motion that is made only when something goes wrong.
    pub fn sketch(&mut self, from_s: f64, to_s: f64, place: impl Fn(f64) -> Axes) -> Vec<Step> {
        let (mut steps, mut from) = (Vec::new(), place(from_s));
        let slices = ((to_s - from_s) / SLICE_S).ceil().max(1.0);
        let time = |k: f64| from_s + (to_s - from_s) * k / slices;
        let mut k = 0.0;
        while k < slices {
            let (since, to) = (steps.len(), place(time(k + 1.0)));
            for axis in 0..AXES {
                self.straight(
                    axis,
                    [time(k), time(k + 1.0)],
                    [from.0[axis], to.0[axis]],
                    &mut steps,
                );
            }
            steps[since..].sort_by(|a: &Step, b| a.t_s.total_cmp(&b.t_s));
            (from, k) = (to, k + 1.0);
        }
        steps
    }

    /// Steps of an axis that goes straight from one place to another.
    fn straight(
        &mut self,
        axis: usize,
        [since_s, until_s]: [f64; 2],
        [from, to]: [f64; 2],
        steps: &mut Vec<Step>,
    ) {
        let [from, to] = [from, to].map(|place| place * self.per_unit.0[axis]);
        loop {
            let made = self.made[axis] as f64;
            let forward = to > made + 0.5;
            if !forward && to >= made - 0.5 {
                return;
            }
            let half = if forward { made + 0.5 } else { made - 0.5 };
            let share = ((half - from) / (to - from)).clamp(0.0, 1.0);
            self.made[axis] += if forward { 1 } else { -1 };
            steps.push(Step { t_s: since_s + share * (until_s - since_s), axis, forward });
        }
    }

    fn slice(&mut self, span_s: [f64; 2], place: &impl Fn(f64) -> Axes, steps: &mut Vec<Step>) {
        let near_s = (span_s[1] - span_s[0]) / NEAR;
        let [a, b, c, d] =
            [span_s[0], span_s[0] + near_s, span_s[1] - near_s, span_s[1]].map(place);
        for axis in 0..AXES {
            let n = self.per_unit.0[axis];
            let at = |t_s: f64| place(t_s).0[axis] * n;
            let [start, end] = [(a, b), (c, d)].map(|(from, to)| (to.0[axis] - from.0[axis]) * n);
            let mut since_s = span_s[0];
            if start * end < 0.0 {
                let turn_s = turning(span_s, start.signum(), at);
                self.one_way(axis, [since_s, turn_s], at, steps);
                since_s = turn_s;
            }
            self.one_way(axis, [since_s, span_s[1]], at, steps);
        }
    }

    /// Steps of an axis that does not turn round in a stretch of time.
    fn one_way(
        &mut self,
        axis: usize,
        [mut since_s, until_s]: [f64; 2],
        at: impl Fn(f64) -> f64,
        steps: &mut Vec<Step>,
    ) {
        let end = at(until_s);
        loop {
            let made = self.made[axis] as f64;
            let forward = end > made + 0.5;
            if !forward && end >= made - 0.5 {
                return;
            }
            let half = if forward { made + 0.5 } else { made - 0.5 };
            let passed = |t_s: f64| if forward { at(t_s) > half } else { at(t_s) < half };
            since_s = first(since_s, until_s, passed);
            self.made[axis] += if forward { 1 } else { -1 };
            steps.push(Step { t_s: since_s, axis, forward });
        }
    }
}

/// Finds the time at which something begins to hold, between one at which it may not and one at which it does.
fn first(mut low_s: f64, mut high_s: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        if high_s - low_s < EXACT_S {
            break;
        }
        let middle = 0.5 * (low_s + high_s);
        if holds(middle) { high_s = middle } else { low_s = middle }
    }
    high_s
}

/// Finds the time at which a value that first goes one way is farthest, by thirds.
fn turning([mut low_s, mut high_s]: [f64; 2], sign: f64, at: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..HALVINGS {
        let third = (high_s - low_s) / 3.0;
        let [a, b] = [low_s + third, high_s - third];
        if sign * at(a) < sign * at(b) { low_s = a } else { high_s = b }
    }
    0.5 * (low_s + high_s)
}
