//! Times at which each motor makes its steps.
//!
//! A motor has made ⌊p + ½⌋ steps where p is its axis' position in steps: it steps when p passes a
//! half. So what it has made and what it should have made never differ by more than half a step, at
//! any time and however long the program. The times are those at which the plan passes the halves;
//! nothing is added up.
//!
//! The plan is looked at nine times a millisecond. Five places make a polynomial for each axis, four are compared with
//! it; where they differ, as about a jump of the speed, the stretch is halved. The halves are sought on the
//! polynomials, and on the plan itself where a stretch has become too short for them.

use crate::quartic::{CHECKS, NODES, Quartic};
use kerf_program::{AXES, Axes};

/// Longest stretch of time looked at in one go, seconds. An axis is taken to turn round once at most in it.
pub(crate) const SLICE_S: f64 = 0.001;
/// A stretch that is shorter is looked at without a polynomial, seconds.
const SHORT_S: f64 = 1e-6;
/// Number of parts of such a stretch; its first and last show whether an axis turns round in it.
const NEAR: f64 = 64.0;
/// Exactness with which the time of a step is sought, seconds: far below the clock of any board.
const EXACT_S: f64 = 1e-9;
/// Share of it that is left to the search on a polynomial.
const OF_SEARCH: f64 = 0.01;
/// Difference between plan and polynomial that is none, steps, and as a share of the place: rounding.
const SAME: [f64; 2] = [1e-8, 1e-13];
/// Steps by which a place differs from what was made when the axis was not moved there: less is rounding.
const JUMP: f64 = 1.0;
/// Steps by which an axis is away from its motor's before that makes one: a half, and more than rounding makes of it. So a motor
/// does not step there and back where its axis stands or passes at a half.
pub(crate) const HALF: f64 = 0.5 + 1e-8;
/// Halvings in search of a time.
const HALVINGS: u32 = 40;

/// One step of one motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Time at which it is made, seconds.
    pub t_s: f64,
    /// The axis of the motion that turns it.
    pub axis: usize,
    /// Its count rises.
    pub forward: bool,
}

/// A stretch of time, over which the time of a polynomial goes from −1 to 1.
#[derive(Clone, Copy)]
struct Stretch {
    middle_s: f64,
    half_s: f64,
}

/// Finds steps, stretch by stretch of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Stepper {
    /// Steps for a millimetre or a degree.
    pub(crate) per_unit: Axes,
    /// Steps made.
    pub(crate) made: [i64; AXES],
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
        let (mut k, mut from) = (0.0, place(from_s));
        while k < slices {
            let (since, to) = (steps.len(), place(time(k + 1.0)));
            self.stretch([time(k), time(k + 1.0)], [from, to], &place, &mut steps);
            steps[since..].sort_by(|a, b| a.t_s.total_cmp(&b.t_s));
            (k, from) = (k + 1.0, to);
        }
        steps
    }

    /// Steps of a stretch of time between two places.
    fn stretch(
        &mut self,
        span_s: [f64; 2],
        [from, to]: [Axes; 2],
        place: &impl Fn(f64) -> Axes,
        steps: &mut Vec<Step>,
    ) {
        let half_s = 0.5 * (span_s[1] - span_s[0]);
        let middle_s = span_s[0] + half_s;
        if 2.0 * half_s < SHORT_S {
            return self.slice(span_s, place, steps);
        }
        let at = |x: f64| place(middle_s + half_s * x);
        let nodes = [from, at(NODES[1]), at(NODES[2]), at(NODES[3]), to];
        let Some(courses) = self.courses(&nodes, &CHECKS.map(at), half_s) else {
            self.stretch([span_s[0], middle_s], [from, nodes[2]], place, steps);
            return self.stretch([middle_s, span_s[1]], [nodes[2], to], place, steps);
        };
        let stretch = Stretch { middle_s, half_s };
        for (axis, course) in courses.iter().enumerate() {
            let end = to.0[axis] * self.per_unit.0[axis];
            let mut since = -1.0;
            if let Some(turn) = course.turn() {
                self.along((axis, course), [since, turn], course.at(turn), stretch, steps);
                since = turn;
            }
            self.along((axis, course), [since, 1.0], end, stretch, steps);
        }
    }

    /// Places of all axes as polynomials in steps; nothing where they do not meet those in between.
    fn courses(
        &self,
        nodes: &[Axes; 5],
        checks: &[Axes; 4],
        half_s: f64,
    ) -> Option<[Quartic; AXES]> {
        let mut courses = [Quartic::through([0.0; 5]); AXES];
        for (axis, course) in courses.iter_mut().enumerate() {
            let n = self.per_unit.0[axis];
            let nodes = nodes.map(|place| place.0[axis] * n);
            *course = Quartic::through(nodes);
            let way = (nodes[4] - nodes[0]).abs();
            let same = SAME[0] + SAME[1] * nodes[0].abs() + EXACT_S * way / (2.0 * half_s);
            let is_met =
                |(x, place): (&f64, &Axes)| (course.at(*x) - place.0[axis] * n).abs() <= same;
            if !CHECKS.iter().zip(checks).all(is_met) {
                return None;
            }
        }
        Some(courses)
    }

    /// Steps of an axis that goes one way along a polynomial, to an end.
    fn along(
        &mut self,
        (axis, course): (usize, &Quartic),
        [mut since, until]: [f64; 2],
        end: f64,
        stretch: Stretch,
        steps: &mut Vec<Step>,
    ) {
        let exact = OF_SEARCH * EXACT_S / stretch.half_s;
        // Each step is guessed from the time between those before it, and how that grows.
        let (mut gap, mut growth, mut is_first) = (0.0, 0.0, true);
        loop {
            let made = self.made[axis] as f64;
            let forward = end > made;
            if (end - made).abs() <= HALF {
                return;
            }
            let half = if forward { made + 0.5 } else { made - 0.5 };
            let x = course.passes(half, forward, [since, until], since + gap + growth, exact);
            growth = if is_first { 0.0 } else { x - since - gap };
            (gap, since, is_first) = (x - since, x, false);
            self.made[axis] += if forward { 1 } else { -1 };
            let t_s = stretch.middle_s + stretch.half_s * x;
            steps.push(Step { t_s, axis, forward });
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
            let forward = end > made;
            if (end - made).abs() <= HALF {
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
