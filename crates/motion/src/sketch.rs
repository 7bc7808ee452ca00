//! The steps of a motion that is made only when something goes wrong: quickly found, by marks of several each.

use crate::steps::{HALF, SLICE_S, Step, Stepper};
use kerf_program::{AXES, Axes};

/// Marks of an axis in a stretch of a sketch, one or two more where it turns round or begins.
const MARKS: i64 = 4;

/// Steps of one motor at even times, up to the next mark of its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Time of the last of them, seconds.
    pub t_s: f64,
    /// The axis of the motion that turns it.
    pub axis: usize,
    /// Its count rises.
    pub forward: bool,
    /// Number of steps since the mark before.
    pub count: u16,
}

impl From<Step> for Mark {
    fn from(Step { t_s, axis, forward }: Step) -> Self {
        Self { t_s, axis, forward, count: 1 }
    }
}

impl Stepper {
    /// Marks of the steps of a motion, in order of time for each axis. A place between two moments that are `SLICE_S` apart
    /// is taken from a straight line: some µs off where speeds change, and much quicker. For motion that is made only when
    /// something goes wrong.
    pub fn sketch(&mut self, from_s: f64, to_s: f64, place: impl Fn(f64) -> Axes) -> Vec<Mark> {
        let (mut marks, mut from) = (Vec::new(), place(from_s));
        let slices = ((to_s - from_s) / SLICE_S).ceil().max(1.0);
        let time = |k: f64| from_s + (to_s - from_s) * k / slices;
        let (mut k, mut ways) = (0.0, [None; AXES]);
        while k < slices {
            let (span_s, to) = ([time(k), time(k + 1.0)], place(time(k + 1.0)));
            for (axis, way) in ways.iter_mut().enumerate() {
                self.straight(axis, span_s, [from.0[axis], to.0[axis]], way, &mut marks);
            }
            (from, k) = (to, k + 1.0);
        }
        marks
    }

    /// Marks of an axis that goes straight from one place to another. The first step another way than before has a mark of
    /// its own: the driver needs time to turn round.
    fn straight(
        &mut self,
        axis: usize,
        [since_s, until_s]: [f64; 2],
        [from, to]: [f64; 2],
        way: &mut Option<bool>,
        marks: &mut Vec<Mark>,
    ) {
        let [from, to] = [from, to].map(|place| place * self.per_unit.0[axis]);
        let made = self.made[axis];
        let forward = to > made as f64;
        let sign = if forward { 1 } else { -1 };
        let steps = ((to - made as f64).abs() - HALF).ceil().max(0.0) as i64;
        let each = ((steps + MARKS - 1) / MARKS).clamp(1, i64::from(u16::MAX));
        let mut done = 0;
        while done < steps {
            let count = if *way == Some(forward) { each.min(steps - done) } else { 1 };
            (done, *way) = (done + count, Some(forward));
            let half = (made + sign * done) as f64 - 0.5 * sign as f64;
            let share = ((half - from) / (to - from)).clamp(0.0, 1.0);
            let t_s = since_s + share * (until_s - since_s);
            marks.push(Mark { t_s, axis, forward, count: count as u16 });
        }
        self.made[axis] += sign * done;
    }
}
