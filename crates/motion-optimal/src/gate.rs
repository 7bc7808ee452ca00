//! Which speeds can follow on which across one cell.
//!
//! With y = ṡ² linear in s over a cell of length h, s̈ = (y₁ − y₀)/2h is constant, and where the
//! path's curvature q″ is constant the acceleration of an axis, q′·s̈ + q″·y, is linear in s too: it
//! keeps its limit in the whole cell if it does at both ends. Each of these conditions is linear in
//! (y₀, y₁), as in the reachability analysis of Pham & Pham (2018), so what can be reached is an
//! interval, and the passes over a grid are exact for it.

use crate::axes::padded;
use crate::bounds::{Bounds, SPARE};
use crate::cells::Cell;
use crate::leg::Leg;

/// Lines looked at in search of the best exit; far more than there are.
const CROSSINGS: u32 = 40;

/// A cell is cut where the acceleration of an axis that is at its limit at one end would be below it
/// by more than this share at the other.
const COARSE: f64 = 3e-3;

/// No cell is cut into more parts.
pub(crate) const MOST_PARTS: u32 = 32;

/// Coefficients this small are zero, 1/mm.
const NO_SHARE: f64 = 1e-12;

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
    /// The machine stands where it begins.
    pub stands: bool,
    /// Greatest share of the acceleration of an axis that the curvature takes for a y of 1.
    load: f64,
    /// Equal parts, a power of two, into which the pass back has cut the cell.
    pub parts: u32,
}

impl<const N: usize> Gate<N> {
    pub fn new(cell: &Cell<N>, bounds: &Bounds<N>, legs: &[Leg]) -> Self {
        let (a, b) = (cell.frame.slope, cell.frame.after(cell.h).slope);
        let m = &legs[cell.owner as usize];
        let feed = m.feed_cap(&a).min(m.feed_cap(&b)) * SPARE;
        let (mut speed, mut accel, mut load) = (0.0f64, 0.0f64, 0.0f64);
        let end = cell.frame.after(cell.h).bend;
        for k in 0..N {
            load = load.max(cell.frame.bend[k].abs().max(end[k].abs()) * bounds.per_accel[k]);
            let fastest = a[k].abs().max(b[k].abs());
            speed = speed.max(fastest * bounds.per_speed[k]);
            accel = accel.max(fastest * bounds.per_accel[k]);
        }
        Self {
            at_mm: cell.at_mm,
            h: cell.h,
            cap: feed.min(1.0 / (speed * speed)),
            slope: a,
            bend: cell.frame.bend,
            twist: cell.frame.twist,
            accel: 1.0 / accel,
            straight: cell.straight,
            stands: false,
            load,
            parts: 1,
        }
    }

    /// The same with more axes, which stood still.
    pub fn widen<const M: usize>(&self) -> Gate<M> {
        Gate {
            at_mm: self.at_mm,
            h: self.h,
            cap: self.cap,
            slope: padded(&self.slope),
            bend: padded(&self.bend),
            twist: padded(&self.twist),
            accel: self.accel,
            straight: self.straight,
            stands: self.stands,
            load: self.load,
            parts: self.parts,
        }
    }

    /// Equal parts, a power of two, into which the cell must be cut for s̈ to be constant in each,
    /// where the squared speed changes from one value to another across it.
    ///
    /// The acceleration of an axis with constant q″ then changes by 3·q″·h·s̈ = 3/2·q″·(y₁ − y₀).
    pub fn parts(&self, from: f64, to: f64) -> u32 {
        let lost = 1.5 * self.load * (to - from).abs();
        if lost <= COARSE {
            return 1;
        }
        ((lost / COARSE).min(f64::from(MOST_PARTS)).ceil() as u32).next_power_of_two()
    }

    /// Greatest |s̈| on a straight.
    pub fn straight(&self) -> Option<f64> {
        self.straight.then_some(self.accel)
    }

    /// One of the equal parts.
    pub fn part(&self, index: u32, of: u32) -> Self {
        let h = self.h / f64::from(of);
        let way = h * f64::from(index);
        let slope = std::array::from_fn(|k| self.slope_after(k, way));
        let bend = std::array::from_fn(|k| self.bend[k] + way * self.twist[k]);
        let stands = self.stands && index == 0;
        Self { at_mm: self.at_mm + way, h, slope, bend, stands, ..*self }
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
