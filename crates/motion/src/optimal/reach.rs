//! Which speeds can follow on which across one cell.
//!
//! With y = ṡ² linear in s over a cell of length h, s̈ = (y₁ − y₀)/2h is constant, and where the
//! path's curvature q″ is constant the acceleration of an axis, q′·s̈ + q″·y, is linear in s too: it
//! keeps its limit in the whole cell if it does at both ends. Each of these conditions is linear in
//! (y₀, y₁), as in the reachability analysis of Pham & Pham (2018), so what can be reached is an
//! interval, and the passes over a grid are exact for it.

use super::cells::{Cell, feed_cap};
use crate::moves::Move;

/// Lines looked at in search of the best exit; far more than there are.
const CROSSINGS: u32 = 40;

/// A cell across which the squared speed could change by more than this share is cut.
const COARSE: f64 = 0.02;

/// No cell is cut into more parts.
pub(crate) const MOST_PARTS: u32 = 32;

/// Coefficients this small are zero, 1/mm.
const NO_SHARE: f64 = 1e-12;

/// Halvings in search of the place where the machine stands; leaves less than rounding does.
const HALVINGS: u32 = 40;

/// Limits are kept with this much to spare, so that rounding never exceeds them.
const SPARE: f64 = 1.0 - 1e-9;

/// Limits of the axes that move.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds<const N: usize> {
    pub speed: [f64; N],
    pub accel: [f64; N],
}

impl<const N: usize> Bounds<N> {
    /// Of the first axes; a limit that is not above zero becomes very small instead.
    pub fn new(speed: &[f64], accel: &[f64]) -> Self {
        let least = |v: f64| v.max(1e-6) * SPARE;
        Self {
            speed: std::array::from_fn(|k| least(speed[k])),
            accel: std::array::from_fn(|k| least(accel[k])),
        }
    }
}

/// One cell as the speed passes see it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gate<const N: usize> {
    pub at_mm: f64,
    pub h: f64,
    /// Greatest y anywhere in the cell.
    pub cap: f64,
    slope: [f64; N],
    bend: [f64; N],
    twist: [f64; N],
    /// Greatest |s̈| were there no curvature.
    accel: f64,
    /// There is none.
    straight: bool,
    /// Equal parts, a power of two, into which the pass back has cut the cell.
    pub parts: u32,
}

impl<const N: usize> Gate<N> {
    pub fn new(cell: &Cell<N>, bounds: &Bounds<N>, moves: &[Move]) -> Self {
        let (a, b) = (cell.frame.slope, cell.frame.after(cell.h).slope);
        let m = &moves[cell.owner as usize];
        let mut cap = feed_cap(m, &a).min(feed_cap(m, &b)) * SPARE;
        let mut accel = f64::INFINITY;
        for k in 0..N {
            let fastest = a[k].abs().max(b[k].abs());
            if fastest > 0.0 {
                let v = bounds.speed[k] / fastest;
                cap = cap.min(v * v);
                accel = accel.min(bounds.accel[k] / fastest);
            }
        }
        let (at_mm, h, straight) = (cell.at_mm, cell.h, cell.straight);
        Self {
            at_mm,
            h,
            cap,
            slope: a,
            bend: cell.frame.bend,
            twist: cell.frame.twist,
            accel,
            straight,
            parts: 1,
        }
    }

    /// Greatest |s̈| on a straight.
    pub fn straight(&self) -> Option<f64> {
        self.straight.then_some(self.accel)
    }

    /// Equal parts, a power of two, into which the cell must be cut for s̈ to be constant in each, where the squared
    /// speed is about `y`.
    pub fn parts(&self, y: f64) -> u32 {
        let gain = 2.0 * self.accel * self.h;
        if self.straight || gain <= COARSE * y {
            return 1;
        }
        ((gain / (COARSE * y)).min(f64::from(MOST_PARTS)) as u32 + 1)
            .next_power_of_two()
            .min(MOST_PARTS)
    }

    /// One of the equal parts.
    pub fn part(&self, index: u32, of: u32) -> Self {
        let h = self.h / f64::from(of);
        let way = h * f64::from(index);
        let slope = std::array::from_fn(|k| self.slope_after(k, way));
        let bend = std::array::from_fn(|k| self.bend[k] + way * self.twist[k]);
        Self { at_mm: self.at_mm + way, h, slope, bend, ..*self }
    }

    /// Coefficients of the acceleration of an axis at both ends: α·y₀ + β·y₁.
    fn rows(&self, k: usize) -> [(f64, f64); 2] {
        let (p, c, g) = (self.slope[k], self.bend[k], 0.5 / self.h);
        let (end, c_end) = (self.slope_after(k, self.h), c + self.h * self.twist[k]);
        [(c - p * g, p * g), (-end * g, c_end + end * g)]
    }

    fn slope_after(&self, k: usize, way: f64) -> f64 {
        self.slope[k] + way * (self.bend[k] + 0.5 * way * self.twist[k])
    }

    /// The greatest y₀ from which some y₁ up to `most` can be reached.
    ///
    /// For one y₁ the conditions leave an interval of y₀; its upper end is a concave function of y₁
    /// made of straight lines, and so is the interval's width. Mostly the greatest y₁ is best.
    /// Where it is not, the best lies where a rising and a falling line cross.
    pub fn entry(&self, most: f64, bounds: &Bounds<N>) -> f64 {
        if let Some(accel) = self.straight() {
            return self.cap.min(most + 2.0 * accel * self.h);
        }
        let (exit, right) = self.greatest_exit(most.min(self.cap), bounds);
        if right.high.slope >= 0.0 || exit <= 0.0 {
            return right.high.value.max(0.0);
        }
        let left = self.entries(0.0, bounds);
        if left.high.slope <= 0.0 {
            return left.high.value;
        }
        self.crossing((0.0, left.high), (exit, right.high), bounds)
    }

    /// The greatest exit up to `most` that any entry can reach.
    fn greatest_exit(&self, most: f64, bounds: &Bounds<N>) -> (f64, Entries) {
        let mut exit = most;
        let mut found = self.entries(exit, bounds);
        for _ in 0..CROSSINGS {
            let width = found.high.value - found.low.value;
            if width >= 0.0 {
                break;
            }
            let slope = found.high.slope - found.low.slope;
            exit = (exit - width / slope).clamp(0.0, exit);
            found = self.entries(exit, bounds);
        }
        (exit, found)
    }

    fn crossing(&self, mut left: (f64, Line), mut right: (f64, Line), bounds: &Bounds<N>) -> f64 {
        let mut best = left.1.value.max(right.1.value);
        for _ in 0..CROSSINGS {
            let ((x0, a), (x1, b)) = (left, right);
            let exit = (b.value - b.slope * x1 - a.value + a.slope * x0) / (a.slope - b.slope);
            let exit = exit.clamp(x0, x1);
            let found = self.entries(exit, bounds).high;
            best = best.max(found.value);
            let promised = a.value + a.slope * (exit - x0);
            if found.slope == 0.0 || found.value >= promised * (1.0 - 1e-12) {
                break;
            }
            if found.slope > 0.0 {
                left = (exit, found);
            } else {
                right = (exit, found);
            }
        }
        best
    }

    /// The entries for one exit.
    fn entries(&self, exit: f64, bounds: &Bounds<N>) -> Entries {
        let high = Line { value: self.cap, slope: 0.0 };
        let mut found = Entries { low: Line { value: 0.0, slope: 0.0 }, high };
        for k in 0..N {
            let a = bounds.accel[k];
            for (alpha, beta) in self.rows(k) {
                if alpha.abs() > NO_SHARE {
                    let scale = 1.0 / alpha.abs();
                    let slope = -beta * alpha.signum() * scale;
                    found.take(a * scale, slope * exit, slope);
                }
            }
        }
        found
    }

    /// The greatest y₁ up to `most` that can be reached from y₀.
    pub fn exit(&self, entry: f64, most: f64, bounds: &Bounds<N>) -> f64 {
        let mut high = most.min(self.cap);
        for k in 0..N {
            let a = bounds.accel[k];
            for (alpha, beta) in self.rows(k) {
                let size = beta.abs();
                if size > NO_SHARE {
                    high = high.min((a - alpha * beta.signum() * entry) / size);
                }
            }
        }
        high.max(0.0)
    }
}

impl<const N: usize> Gate<N> {
    /// Slows as steeply as can be from y₀: the way made, which ends inside the cell when the
    /// machine stands there, and the squared speed at its end (infinite when this grid finds none).
    pub fn slow(&self, entry: f64, bounds: &Bounds<N>) -> (f64, f64) {
        let exit = self.slowest(entry, bounds);
        if exit > 0.0 {
            return (self.h, exit);
        }
        if let Some(accel) = self.straight() {
            return ((entry / (2.0 * accel)).min(self.h), 0.0);
        }
        if !self.stands(entry, bounds) {
            return (self.h, f64::INFINITY);
        }
        let (mut low, mut high) = (0.0, self.h);
        for _ in 0..HALVINGS {
            let h = 0.5 * (low + high);
            let stands = Self { h, ..*self }.stands(entry, bounds);
            if stands { high = h } else { low = h }
        }
        (high, 0.0)
    }

    /// Whether y₁ = 0 can be reached from y₀.
    fn stands(&self, entry: f64, bounds: &Bounds<N>) -> bool {
        (0..N)
            .all(|k| self.rows(k).iter().all(|(alpha, _)| (alpha * entry).abs() <= bounds.accel[k]))
    }

    /// The least y₁ that can be reached from y₀; not above zero when the machine can stand before.
    fn slowest(&self, entry: f64, bounds: &Bounds<N>) -> f64 {
        if let Some(accel) = self.straight() {
            return entry - 2.0 * accel * self.h;
        }
        let mut low = f64::NEG_INFINITY;
        for k in 0..N {
            let a = bounds.accel[k];
            for (alpha, beta) in self.rows(k) {
                let size = beta.abs();
                if size > NO_SHARE {
                    low = low.max((-a - alpha * beta.signum() * entry) / size);
                }
            }
        }
        low
    }
}

/// Entries into a cell for one exit from it: the ends of an interval, and how they change with the
/// exit.
struct Entries {
    low: Line,
    high: Line,
}

#[derive(Clone, Copy)]
struct Line {
    value: f64,
    slope: f64,
}

impl Entries {
    /// Keeps to middle ± half.
    fn take(&mut self, half: f64, middle: f64, slope: f64) {
        if middle + half < self.high.value {
            self.high = Line { value: middle + half, slope };
        }
        if middle - half > self.low.value {
            self.low = Line { value: middle - half, slope };
        }
    }
}
