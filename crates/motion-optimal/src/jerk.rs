//! The fastest squared speed along pieces under limits of speed, acceleration and jerk.
//!
//! The squared speed x(s) is a quadratic spline over the pieces with one unknown for each piece, its
//! middle Bézier ordinate; the outer ones are the weighted means of neighbours. Speed and
//! acceleration are linear conditions. The condition of jerk, |f′|·√x ≤ J for an axis whose
//! acceleration is f, is written |f′| ≤ J/√x, and the right side, convex in x, is replaced by its tangent at
//! the present x: a linear condition that is safe (after Zhang et al. 2014, Lee et al. 2024). The time Σ ∫ds/√x is convex. An
//! interior-point iteration takes Newton's steps on time plus logarithmic barriers; the matrix has
//! five diagonals, so a step costs as much for each piece however long the path is.
//!
//! From rest, x grows as s^(4/3), which no parabola does: over the first and last bit of path, which
//! are straight, the jerk is constant instead, and only its size is unknown.

use crate::barriers::{Unit, diagonal, on_accel, on_speed};
use crate::condition::{NEARLY, Quad};
use crate::launch::End;
use crate::newton::{Local, System};
use crate::pieces::Part;
use crate::problem::Problem;

/// Most steps of the iteration, of which the first look only for a motion that keeps all limits.
const STEPS: u32 = 150;
const SETTLING: u32 = 10;

/// The same from a motion that is given; after twice as many no way is looked for any more.
const SETTLING_MOTION: u32 = 25;

/// By how much in the end, should a condition still be missed by rounding.
const SLOWER_YET: f64 = 0.9999;

/// Whole steps in a row with the full weight, after which nothing is left to gain.
const CALM: u32 = 1;

/// Growth of the weight of the time against the barriers, and the share of a step after which it grows.
const SHARPER: f64 = 5.0;
const CENTRED: f64 = 0.3;

/// A problem with what is the same in every step of the iteration.
struct Search<'a, const N: usize> {
    problem: &'a Problem<'a, N>,
    /// Shares of the neighbours' middle ordinates in the outer ordinates of each piece.
    shares: Vec<[[f64; 2]; 2]>,
    /// Rows of the conditions on the speed in each piece.
    caps: Vec<Quad>,
}

impl<const N: usize> Problem<'_, N> {
    /// Bézier ordinates of x over every piece; `None` when from a motion at the beginning no way
    /// within the limits is found.
    pub fn solve(&self) -> Option<Vec<[f64; 3]>> {
        Search::new(self).solve()
    }
}

impl<'a, const N: usize> Search<'a, N> {
    fn new(problem: &'a Problem<'a, N>) -> Self {
        let all = 0..problem.pieces.len();
        let (shares, caps) = all.map(|k| (problem.shares(k), problem.cap(k))).unzip();
        Self { problem, shares, caps }
    }

    fn solve(&self) -> Option<Vec<[f64; 3]>> {
        let n = self.problem.pieces.len();
        let mut b = self.problem.start();
        let slower = self.problem.slower();
        let axes: usize = self.problem.pieces.iter().flat_map(|p| &p.parts).map(Part::count).sum();
        let conditions = (14 * axes + 6 * n) as f64;
        let (mut weight, mut calm, mut found) = (0.0f64, 0, false);
        for step in 0..STEPS {
            let (system, time, kept) = self.newton(&b, weight);
            let d = system.solve();
            let scale = self.room(&b, &d);
            b.iter_mut().zip(&d).for_each(|(b, d)| *b += scale * d);
            found |= kept;
            if !found {
                let settling = match self.problem.begin {
                    End::Rest(_) => SETTLING,
                    End::Motion(_) if step > 2 * SETTLING_MOTION => return None,
                    End::Motion(_) => SETTLING_MOTION,
                };
                // Slower is gentler: sooner or later all conditions are met.
                if step >= settling {
                    b.iter_mut().zip(&slower).for_each(|(b, slower)| *b *= slower);
                }
                continue;
            }
            let sharpest = conditions / (self.problem.gap * time);
            let settled = weight >= sharpest && scale >= 1.0;
            calm = if settled { calm + 1 } else { 0 };
            if calm == CALM {
                break;
            }
            // The weight grows as the steps become whole ones: near the middle of what is allowed.
            if scale > CENTRED {
                let first = conditions / time;
                weight = (weight * SHARPER).max(first).min(sharpest);
            }
        }
        let mut slower_yet = SLOWER_YET;
        while !self.newton(&b, 0.0).2 {
            if matches!(self.problem.begin, End::Motion(_)) {
                return None;
            }
            b.iter_mut().for_each(|b| *b *= slower_yet);
            // Soon by much, should it be missed by more than rounding.
            slower_yet *= slower_yet;
        }
        Some((0..n).map(|k| self.local(&b, k)).collect())
    }

    /// Ordinates over a piece.
    fn local(&self, b: &[f64], k: usize) -> [f64; 3] {
        let mut x = self.change(b, k);
        if let (0, End::Motion([first, _])) = (k, self.problem.begin) {
            x[0] = first;
        }
        x
    }

    /// Returns the change of the ordinates of a piece with the unknowns.
    fn change(&self, b: &[f64], k: usize) -> [f64; 3] {
        let [[l0, l1], [r0, r1]] = self.shares[k];
        let before = if k > 0 { l0 * b[k - 1] } else { 0.0 };
        let after = b.get(k + 1).map_or(0.0, |b| r1 * b);
        [before + l1 * b[k], b[k], r0 * b[k] + after]
    }

    /// Newton's system for a weight of the time, the time, and whether all conditions are met.
    fn newton(&self, b: &[f64], weight: f64) -> (System, f64, bool) {
        let n = self.problem.pieces.len();
        let mut system = System::new(n);
        let (mut time, mut kept) = (0.0, true);
        for (k, piece) in self.problem.pieces.iter().enumerate() {
            let x = self.local(b, k);
            let mut local = Local::default();
            time += local.time(piece, &x, weight);
            kept &= local.barrier(&on_speed(&diagonal(&self.caps[k]), &x));
            for part in &piece.parts {
                let unit = Unit::new(part, &x);
                for (accel, gain) in part.axes() {
                    kept &= local.barrier(&on_accel(accel, &x));
                    kept &= local.barrier(&unit.on_jerk(gain, &x));
                }
                local.level(&unit.y, part);
            }
            system.add(k, &local, &self.shares[k]);
        }
        if matches!(self.problem.begin, End::Motion(_)) {
            system.hold_first();
        }
        (system, time, kept)
    }

    /// The greatest share of a step that keeps all conditions, and x above zero.
    fn room(&self, b: &[f64], d: &[f64]) -> f64 {
        let mut scale = 1.0f64;
        for (k, piece) in self.problem.pieces.iter().enumerate() {
            if d[k] < 0.0 {
                scale = scale.min(-NEARLY * b[k] / d[k]);
            }
            let (x, dx) = (self.local(b, k), self.change(d, k));
            scale = on_speed(&diagonal(&self.caps[k]), &x).room(&dx, scale);
            for part in &piece.parts {
                let unit = Unit::new(part, &x);
                for (accel, gain) in part.axes() {
                    scale = on_accel(accel, &x).room(&dx, scale);
                    scale = unit.on_jerk(gain, &x).room(&dx, scale);
                }
            }
        }
        scale
    }
}
