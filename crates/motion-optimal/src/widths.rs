//! Finds the width with which each corner is smoothed.
//!
//! A bump of half-width c at a vertex whose tangent turns by D is D·h(s), and its height is
//! proportional to c. Where bumps overlap their sum, which is convex between vertices, is greatest at
//! a vertex; there it is kept within the tolerance.
//!
//! Widths are found in passes over the vertices, each of which looks at most [`REACH`] vertices
//! ahead. So a width is final as soon as a few vertices after it are known, and a path can be
//! smoothed while it is read.

use crate::axes::padded;
use crate::kernel::Kernel;
use crate::leg::Leg;
use crate::track::{Track, norm};
use std::mem::take;
use std::ops::Range;

/// Bumps reach over at most so many vertices on each side.
pub(crate) const REACH: usize = 8;

/// Slighter turns are none.
const STRAIGHT: f64 = 1e-9;

/// A vertex at which a turn must be made on less path, mm, is a stop.
const SHARPEST_MM: f64 = 1e-6;

/// Steps of Newton's method; each from above, so that the width only shrinks.
const STEPS: usize = 8;

/// A bump may use this much more than the tolerance before it is narrowed, as a share.
const CLOSE: f64 = 1e-3;

/// Segments whose lengths differ by no more than this factor are even.
const UNEVEN: f64 = 1.1;

/// Slighter turns are those of a curve, sharper ones corners.
const CURVE: f64 = 0.2;

/// Widths under construction, and what they are made from: one of each for each vertex.
#[derive(Clone, Debug)]
pub(crate) struct Smoothing<const N: usize> {
    kernel: Kernel,
    /// Direction of the segment after the vertex.
    pub directions: Vec<[f64; N]>,
    /// Change of the tangent; for a stop more than it can be.
    turns: Vec<f64>,
    /// The widest bump that stays on its own half of the segments.
    pub narrow: Vec<f64>,
    /// The widest bump.
    pub wide: Vec<f64>,
    /// By how much the widest bumps must be narrowed.
    factors: Vec<f64>,
    /// Progress of each pass.
    done: Done,
    /// Width before the vertex at which the first and the fourth pass stand.
    before: [f64; 2],
    /// The last stop before the first pass.
    stop: usize,
}

#[derive(Clone, Copy, Debug, Default)]
struct Done {
    alone: usize,
    back: usize,
    summed: usize,
    held: usize,
    wide: usize,
}

/// Value of the turn at a stop.
const STOP: f64 = f64::INFINITY;

impl<const N: usize> Smoothing<N> {
    pub const fn new(kernel: Kernel) -> Self {
        Self {
            kernel,
            directions: Vec::new(),
            turns: Vec::new(),
            narrow: Vec::new(),
            wide: Vec::new(),
            factors: Vec::new(),
            done: Done { alone: 0, back: 0, summed: 0, held: 0, wide: 0 },
            before: [0.0; 2],
            stop: 0,
        }
    }

    /// Goes on with vertices that are new; `ended` when there will be no more. Gives for how many
    /// vertices the widest bumps are final.
    pub fn advance(&mut self, track: &Track, legs: &[Leg], ended: bool) -> usize {
        self.look(track, legs, ended);
        let known = self.turns.len();
        let behind = |n: usize| if ended { n } else { n.saturating_sub(REACH) };
        let alone = behind(known).max(self.done.alone);
        self.by_itself(track, legs, alone);
        self.narrow_back(&track.at_mm, self.done.back..alone);
        self.done.back = behind(alone).max(self.done.back);
        let summed = behind(self.done.back).max(self.done.summed);
        self.sum(track, legs, self.done.summed..summed);
        let held = behind(summed).max(self.done.held);
        self.hold(&track.at_mm, held);
        self.narrow_back(&track.at_mm, self.done.wide..held);
        self.done =
            Done { alone, summed, held, wide: behind(held).max(self.done.wide), ..self.done };
        self.done.wide
    }

    /// The same with more axes, which stood still.
    pub fn widen<const M: usize>(&mut self) -> Smoothing<M> {
        Smoothing {
            kernel: self.kernel,
            directions: self.directions.iter().map(padded).collect(),
            turns: take(&mut self.turns),
            narrow: take(&mut self.narrow),
            wide: take(&mut self.wide),
            factors: take(&mut self.factors),
            done: self.done,
            before: self.before,
            stop: self.stop,
        }
    }

    /// Returns `true` if the machine stands at a vertex.
    pub fn stops(&self, vertex: usize) -> bool {
        self.turns[vertex] == STOP
    }

    /// Returns `true` if there is nothing to smooth at a vertex.
    pub fn is_straight(&self, vertex: usize) -> bool {
        self.turns[vertex] <= STRAIGHT
    }

    /// Change of the direction at a vertex that is not the first.
    pub fn turn_at(&self, vertex: usize) -> [f64; N] {
        let (a, b) = (&self.directions[vertex - 1], &self.directions[vertex]);
        std::array::from_fn(|k| b[k] - a[k])
    }

    /// Forgets the first vertices.
    pub fn forget(&mut self, vertices: usize) {
        self.directions.drain(..vertices);
        for values in [&mut self.turns, &mut self.narrow, &mut self.wide, &mut self.factors] {
            values.drain(..vertices);
        }
        let Done { alone, back, summed, held, wide } = &mut self.done;
        for place in [alone, back, summed, held, wide] {
            *place -= vertices;
        }
        self.stop = self.stop.saturating_sub(vertices);
    }

    /// Finds the turns of the vertices whose next vertex is known.
    pub fn look(&mut self, track: &Track, legs: &[Leg], ended: bool) {
        let known = if ended { track.len() } else { track.len().saturating_sub(1) };
        for j in self.turns.len()..known {
            let direction = if j + 1 < track.len() { track.direction(j) } else { [0.0; N] };
            self.directions.push(direction);
            let mut turn = STOP;
            if !track.breaks[j] && j > 0 && j + 1 < track.len() {
                let exact = norm(&self.turn_at(j));
                let widest = self.kernel.width(exact) * track.tolerance_mm(j, legs);
                if exact <= STRAIGHT || widest >= SHARPEST_MM * exact {
                    turn = exact;
                }
            }
            self.turns.push(turn);
        }
    }

    /// First pass: every bump by itself, as narrow and as wide as it may be.
    fn by_itself(&mut self, track: &Track, legs: &[Leg], to: usize) {
        for j in self.done.alone..to {
            let (mut narrow, mut wide) = (0.0, 0.0);
            if self.stops(j) {
                self.stop = j;
            } else {
                let (at, tolerance) = (&track.at_mm, track.tolerance_mm(j, legs));
                let turn = self.turns[j].max(STRAIGHT);
                let alone = self.kernel.width(turn) * tolerance / turn;
                let (before, after) = (at[j] - at[j - 1], at[j + 1] - at[j]);
                narrow = alone.min(0.5 * before.min(after));
                wide = self.widest(j, at, alone.min(self.before[0] + before), tolerance);
            }
            self.before[0] = wide;
            self.narrow.push(narrow);
            self.wide.push(wide);
            self.factors.push(1.0);
        }
    }

    /// The width at which this bump and its neighbours, were they as wide, just use the tolerance.
    fn widest(&self, j: usize, at: &[f64], most: f64, tolerance: f64) -> f64 {
        let far = (j + REACH).min(self.turns.len() - 1);
        let stop = (j + 1..=far).find(|k| self.stops(*k));
        let before = at[j] - at[j.saturating_sub(REACH).max(self.stop)];
        let after = at[stop.unwrap_or(far)] - at[j];
        let straight = self.kernel.straight_ends();
        let mut c = most.min(before).min(after);
        c = c.min(straight * (at[j] - at[self.stop]));
        if stop.is_some() {
            c = c.min(straight * after);
        }
        for _ in 0..STEPS {
            let (sum, slope) = self.bumps(j, at, c);
            let over = sum - tolerance;
            if over <= CLOSE * tolerance {
                break;
            }
            c = (c - over / slope).max(0.5 * c);
        }
        self.even(j, at, c)
    }

    /// On a curve of even chords, narrows a bump so that it begins and ends where others do: at a
    /// vertex or in the middle between two. The sum of all then has the same curvature everywhere.
    fn even(&self, j: usize, at: &[f64], c: f64) -> f64 {
        if self.kernel != Kernel::Box {
            return c;
        }
        let (before, after) = (at[j] - at[j - 1], at[j + 1] - at[j]);
        let short = before.min(after);
        if before.max(after) > UNEVEN * short || c < 0.5 * short || self.turns[j] > CURVE {
            return c;
        }
        let mut even = 0.5 * short;
        for k in 1..=REACH.min(j) {
            if j + k + 1 >= at.len() {
                break;
            }
            let full = (at[j + k] - at[j]).min(at[j] - at[j - k]);
            if full > c {
                break;
            }
            even = full;
            if k < j {
                let half = 0.5 * (at[j + k] + at[j + k + 1]) - at[j];
                let half = half.min(at[j] - 0.5 * (at[j - k] + at[j - k - 1]));
                if half > c {
                    break;
                }
                even = half;
            }
        }
        even
    }

    /// The sum of all bumps at a vertex, were they as wide as its own, and how it grows with that.
    fn bumps(&self, j: usize, at: &[f64], c: f64) -> (f64, f64) {
        let (mut sum, mut slope) = (0.0, 0.0);
        let mut add = |k: usize, distance: f64| {
            let (bump, by_width) = self.kernel.bump(self.turns[k], c, distance);
            sum += self.turns[k] * bump;
            slope += self.turns[k] * by_width;
        };
        add(j, 0.0);
        let mut k = j + 1;
        while k < self.turns.len() && at[k] - at[j] < c {
            add(k, at[k] - at[j]);
            k += 1;
        }
        let mut k = j;
        while k > self.stop + 1 && at[j] - at[k - 1] < c {
            k -= 1;
            add(k, at[j] - at[k]);
        }
        (sum, slope)
    }

    /// Bumps end in the order of their vertices.
    fn narrow_back(&mut self, at: &[f64], range: Range<usize>) {
        back(&mut self.wide, at, range);
    }

    /// Narrows bumps that overlap too much: a bump shrinks at least as its width does, so narrowing all that reach
    /// a vertex by the same factor brings their sum there within the tolerance.
    fn sum(&mut self, track: &Track, legs: &[Leg], range: Range<usize>) {
        for j in range {
            if self.stops(j) {
                continue;
            }
            let (from, to, sum) = self.reaching(j, &track.at_mm);
            let most = track.tolerance_mm(j, legs);
            if sum > most {
                for factor in &mut self.factors[from..to] {
                    *factor = factor.min(most / sum);
                }
            }
        }
    }

    /// The vertices whose bumps reach this one, and how high they are there together.
    fn reaching(&self, j: usize, at: &[f64]) -> (usize, usize, f64) {
        let bump =
            |k: usize, d: f64| self.turns[k] * self.kernel.bump(self.turns[k], self.wide[k], d).0;
        let (mut from, mut to, mut sum) = (j, j + 1, bump(j, 0.0));
        while to < self.wide.len() && at[to] - at[j] < self.wide[to] {
            sum += bump(to, at[to] - at[j]);
            to += 1;
        }
        while from > 0 && at[j] - at[from - 1] < self.wide[from - 1] {
            from -= 1;
            sum += bump(from, at[j] - at[from]);
        }
        (from, to, sum)
    }

    /// Narrows, so that the bumps begin in the order of their vertices.
    fn hold(&mut self, at: &[f64], to: usize) {
        for j in self.done.held..to {
            let mut width = self.wide[j] * self.factors[j];
            if j > 0 {
                width = width.min(self.before[1] + (at[j] - at[j - 1]));
            }
            self.wide[j] = width;
            self.before[1] = width;
        }
    }
}

/// Narrows, so that bumps end in the order of their vertices.
pub(crate) fn back(widths: &mut [f64], at: &[f64], range: Range<usize>) {
    for j in range.rev().skip(1) {
        let most = widths[j + 1] + (at[j + 1] - at[j]);
        widths[j] = widths[j].min(most);
    }
}
