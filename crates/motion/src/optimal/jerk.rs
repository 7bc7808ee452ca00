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

use super::condition::{Conditions, LANES, Lanes, NEARLY, Rows, dots, lanes};
use super::grid::End;
use super::launch::Launch;
use super::newton::{Local, System};
use super::pieces::{Part, Piece};

/// Part of the limit of jerk that is used, so that rounding never exceeds it.
pub(crate) const USED: f64 = 1.0 - 1e-6;

/// Most steps of the iteration, of which the first look only for a motion that keeps all limits.
const STEPS: u32 = 150;
const SETTLING: u32 = 10;

/// The same from a motion that is given; after twice as many no way is looked for any more.
const SETTLING_MOTION: u32 = 25;

/// By how much all is slowed in each step after that.
const SLOWER: f64 = 0.8;

/// After a motion that is given the search starts at least at this share of what is expected.
const SLOW: f64 = 0.4;

/// From a motion that is given on, slowing comes into its full within this share of the way.
const SLOWED: f64 = 0.2;

/// By how much in the end, should a condition still be missed by rounding.
const SLOWER_YET: f64 = 0.9999;

/// Whole steps in a row with the full weight, after which nothing is left to gain.
const CALM: u32 = 1;

/// How much the weight of the time against the barriers grows, and after which share of a step.
const SHARPER: f64 = 5.0;
const CENTRED: f64 = 0.3;

/// Where the search starts, as a share of what is expected.
const BEGIN: f64 = 0.6;

/// Limits, pieces and the unknowns.
pub(crate) struct Problem<'a, const N: usize> {
    pub pieces: &'a [Piece<N>],
    pub accel: [f64; N],
    pub jerk: [f64; N],
    pub begin: End,
    pub end: Launch,
    /// Squared speeds of a motion from the same beginning within the limits, in the middle of the
    /// pieces as far as it goes; for the first pieces, so many, it has the same.
    pub before: &'a [f64],
    pub kept: usize,
    /// What the barriers may cost at the end, as a share of the time.
    pub gap: f64,
}

/// A problem with what is the same in every step of the iteration.
struct Search<'a, const N: usize> {
    problem: &'a Problem<'a, N>,
    /// How the outer ordinates of each piece are made of the neighbours' middle ones.
    shares: Vec<[[f64; 2]; 2]>,
    /// Rows of the conditions on the speed in each piece.
    caps: Vec<Lanes>,
}

impl<const N: usize> Problem<'_, N> {
    /// Bézier ordinates of x over every piece; `None` when from a motion at the beginning no way
    /// within the limits is found.
    pub fn solve(&self) -> Option<Vec<[f64; 3]>> {
        Search::new(self).solve()
    }

    /// By how much each piece is slowed in a step: not at all where the motion is given.
    fn slower(&self) -> Vec<f64> {
        let begin = self.pieces.get(self.kept).map_or(0.0, |p| p.at_mm);
        let end = self.pieces.last().map_or(0.0, |p| p.at_mm);
        let full = SLOWED * (end - begin).max(f64::MIN_POSITIVE);
        let share = |p: &Piece<N>| match self.begin {
            End::Rest(_) => 1.0,
            End::Motion(_) => ((p.at_mm - begin) / full).clamp(0.0, 1.0),
        };
        self.pieces.iter().map(|p| 1.0 - (1.0 - SLOWER) * share(p)).collect()
    }

    /// Where the search starts: about what the jerk allows. From a slow place x^(3/4) can grow as
    /// the distance does; so it is kept from changing faster, at a good part of that rate.
    fn start(&self) -> Vec<f64> {
        let jerk = self.jerk.iter().copied().fold(f64::INFINITY, f64::min);
        let rate = BEGIN * (4.5 * jerk).sqrt();
        let mut z: Vec<f64> =
            self.pieces.iter().map(|p| BEGIN * self.steady(p).powf(0.75)).collect();
        let n = z.len();
        let half = |k: usize| 0.5 * self.pieces[k].h;
        let mut last = match self.begin {
            End::Rest(launch) => rate * launch.way_mm,
            End::Motion([x, _]) => x.powf(0.75),
        };
        for (k, z) in z.iter_mut().enumerate() {
            last += rate * (half(k) + if k > 0 { half(k - 1) } else { 0.0 });
            last = last.min(*z);
            *z = last;
        }
        last = rate * self.end.way_mm;
        for (k, z) in z.iter_mut().enumerate().rev() {
            last += rate * (half(k) + if k + 1 < n { half(k + 1) } else { 0.0 });
            last = last.min(*z);
            *z = last;
        }
        let mut x: Vec<f64> = z.iter().map(|z| z.powf(4.0 / 3.0)).collect();
        for _ in 0..4 {
            let before = x.clone();
            for k in 1..n.saturating_sub(1) {
                x[k] = 0.25 * (before[k - 1] + 2.0 * before[k] + before[k + 1]);
            }
        }
        self.begin_with(&mut x);
        x
    }

    /// Begins with the motion before, as long as it is not slow, and goes over to what is expected; at
    /// the end as slow as it takes to stand there.
    fn begin_with(&self, x: &mut [f64]) {
        let End::Motion([at, accel]) = self.begin else { return };
        for (k, x) in x.iter_mut().enumerate() {
            let before = self.before.get(k).copied().unwrap_or(0.0);
            let least = SLOW * *x;
            let near = (1.0 - before / (3.0 * least)).max(0.0);
            *x = before + if k < self.kept { 0.0 } else { least * near * near };
        }
        let moves =
            |axis: &usize| self.pieces.iter().any(|p| p.parts.iter().any(|p| p.moves[*axis]));
        let least = |limits: &[f64; N]| {
            (0..N).filter(moves).map(|axis| limits[axis]).fold(f64::INFINITY, f64::min)
        };
        let (rate, gain) = ((4.5 * least(&self.jerk)).sqrt(), 2.0 * least(&self.accel));
        let mut left = self.end.way_mm;
        for (piece, x) in self.pieces.iter().zip(x.iter_mut()).skip(self.kept).rev() {
            left += piece.h;
            let most = (BEGIN * rate * left).powf(4.0 / 3.0);
            *x = x.min(most).min(BEGIN * gain * left);
        }
        x[0] = at + accel * self.pieces[0].h;
    }

    /// The squared speed that a piece allows without s̈.
    fn steady(&self, piece: &Piece<N>) -> f64 {
        let mut x = piece.cap.min(piece.guess);
        let mut steepest = 0.0f64;
        for (_, gain) in piece.parts.iter().flat_map(Part::axes) {
            let each = dots(gain, &[1.0; 3]);
            steepest = each.iter().fold(steepest, |most, gain| most.max(gain.abs()));
        }
        if steepest > 0.0 {
            x = x.min(steepest.powf(-2.0 / 3.0));
        }
        x
    }

    /// How the outer ordinates are made of the neighbours' middle ones.
    fn shares(&self, k: usize) -> [[f64; 2]; 2] {
        let h = |i: usize| self.pieces[i].h;
        let mean = |i: usize| {
            let whole = h(i - 1) + h(i);
            [h(i) / whole, h(i - 1) / whole]
        };
        let left = match self.begin {
            _ if k > 0 => mean(k),
            End::Rest(launch) => [0.0, launch.share(h(0))],
            End::Motion(_) => [0.0, 0.0],
        };
        let last = k + 1 == self.pieces.len();
        let right = if last { [self.end.share(h(k)), 0.0] } else { mean(k + 1) };
        [left, right]
    }

    /// Conditions on the speed in a piece, between zero and the cap: as shares of half of it.
    fn cap(&self, k: usize) -> Lanes {
        let mut caps = [self.pieces[k].cap; 3];
        if let (0, End::Rest(launch)) = (k, &self.begin) {
            caps[0] = caps[0].min(launch.most);
        }
        if k + 1 == self.pieces.len() {
            caps[2] = caps[2].min(self.end.most);
        }
        // What the motion at the beginning has settled nothing can change.
        let free = if k == 0 && matches!(self.begin, End::Motion(_)) { 2 } else { 0 };
        lanes(|m| if (free..3).contains(&m) { 2.0 / caps[m] } else { 0.0 })
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

    /// How they change with the unknowns.
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

/// Rows of one ordinate each.
fn diagonal(v: &Lanes) -> Rows {
    std::array::from_fn(|k| lanes(|lane| if lane == k { v[k] } else { 0.0 }))
}

/// The conditions on the speed: about half of the cap, and not farther than half of it.
fn on_speed<'a>(rows: &'a Rows, x: &[f64; 3]) -> Conditions<'a> {
    let half = lanes(|lane| if lane < 3 && rows[lane][lane] > 0.0 { 1.0 } else { 0.0 });
    let value = dots(rows, x);
    let value = lanes(|lane| value[lane] - half[lane]);
    Conditions { value, rows, limit: [1.0; LANES], tangent: None }
}

/// The conditions on the acceleration of an axis.
fn on_accel<'a>(rows: &'a Rows, x: &[f64; 3]) -> Conditions<'a> {
    Conditions { value: dots(rows, x), rows, limit: [1.0; LANES], tangent: None }
}

/// 1/√x over a part, which is nowhere below its tangent at the mean of x.
struct Unit {
    /// Ordinates of x over the part; what stands in the last lane is no more than their mean.
    y: Lanes,
    limit: Lanes,
    tangent: Rows,
}

impl Unit {
    fn new<const N: usize>(part: &Part<N>, x: &[f64; 3]) -> Self {
        let mut y = dots(&part.ordinates, x);
        let third = 1.0 / 3.0;
        let mean = (y[0] + y[1] + y[2]) * third;
        y[3] = mean;
        let (inverse, root) = (1.0 / mean, 1.0 / mean.sqrt());
        let own = -0.5 * root * inverse;
        let others = y.map(|y| 0.75 * root * inverse * (y * inverse - 1.0));
        let tangent = std::array::from_fn(|k| {
            let row = &part.ordinates[k];
            let by_mean = (row[0] + row[1] + row[2]) * third;
            lanes(|m| own * row[m] + others[m] * by_mean)
        });
        let limit = y.map(|y| root * (1.5 - 0.5 * y * inverse));
        Self { y, limit, tangent }
    }

    /// The conditions on the jerk of an axis.
    fn on_jerk<'a>(&'a self, rows: &'a Rows, x: &[f64; 3]) -> Conditions<'a> {
        Conditions { value: dots(rows, x), rows, limit: self.limit, tangent: Some(&self.tangent) }
    }
}
