//! Newton's system of the interior-point method: what each piece adds to it, and its solution.

use crate::condition::{Conditions, Force, Quad, Rows, dots, quad, sum};
use crate::pieces::{Part, Piece};

/// Below this share of what to expect, x is far from its goal.
const FAR_BELOW: f64 = 0.2;

/// Lower part of a symmetric matrix with five diagonals, and the right side.
pub(crate) struct System {
    rows: Vec<[f64; 3]>,
    right: Vec<f64>,
}

/// Gradient and lower part of the matrix of one piece in its own ordinates, in parts that are summed in
/// the end.
#[derive(Default)]
pub(crate) struct Local {
    gradient: [Quad; 3],
    matrix: [[Quad; 3]; 3],
}

/// Simpson's rule over a piece: rows of its three places, and their weights.
const SIMPSON: (Rows, Quad) =
    ([[1.0, 0.25, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0], [0.0, 0.25, 1.0, 0.0]], [1.0, 4.0, 1.0, 0.0]);

/// Rows of a slack u ± v: t ± r.
#[inline]
fn slack_rows(limit_rows: &Rows, value_rows: &Rows, sign: f64) -> Rows {
    std::array::from_fn(|k| quad(|l| limit_rows[k][l] + sign * value_rows[k][l]))
}

impl Local {
    /// Adds a penalty whose slack has these rows: φ′·row to the gradient, φ″·row·rowᵀ to the matrix.
    #[inline]
    fn add(&mut self, rows: &Rows, force: &Force) {
        for i in 0..3 {
            let scaled = quad(|l| force.second[l] * rows[i][l]);
            let gradient = &mut self.gradient[i];
            *gradient = quad(|l| gradient[l] + force.first[l] * rows[i][l]);
            for (sum, row) in self.matrix[i][..=i].iter_mut().zip(rows) {
                *sum = quad(|l| sum[l] + scaled[l] * row[l]);
            }
        }
    }

    /// Adds the penalties φ(s⁺) + φ(s⁻) of conditions, by the chain rule; whether all are met.
    ///
    /// ```text
    ///  gradient += φ′(s⁺)·(t − r)         + φ′(s⁻)·(t + r)
    ///  matrix   += φ″(s⁺)·(t − r)(t − r)ᵀ + φ″(s⁻)·(t + r)(t + r)ᵀ
    /// ```
    ///
    /// A limit that does not change has t = 0, and one row serves for both: (φ′(s⁻) − φ′(s⁺))·r and
    /// (φ″(s⁻) + φ″(s⁺))·r rᵀ.
    #[inline]
    pub fn barrier(&mut self, conditions: &Conditions<'_>) -> bool {
        let kept = conditions.kept();
        let [above, below] = conditions.forces(kept);
        let value_rows = conditions.value_rows;
        match conditions.limit_rows {
            None => {
                let first = quad(|l| below.first[l] - above.first[l]);
                let second = quad(|l| below.second[l] + above.second[l]);
                self.add(value_rows, &Force { first, second });
            }
            Some(limit_rows) => {
                self.add(&slack_rows(limit_rows, value_rows, -1.0), &above);
                self.add(&slack_rows(limit_rows, value_rows, 1.0), &below);
            }
        }
        kept
    }

    /// Makes barriers of J/√x − |f′| into those of J − |f′|·√x, which do not favour a small x: −ln(J − |f′|·√x) is
    /// −ln(J/√x − |f′|) − ½·ln x, and two slacks an axis make −N·ln y of an ordinate y.
    #[inline]
    pub fn level<const N: usize>(&mut self, y: &Quad, part: &Part<N>) {
        let share = N as f64;
        let inverse = y.map(f64::recip);
        let first = inverse.map(|v| -share * v);
        let second = inverse.map(|v| share * v * v);
        self.add(&part.ordinates, &Force { first, second });
    }

    /// Simpson's rule; where x is far below what to expect the time counts as linear, which makes
    /// the first steps long.
    #[inline]
    pub fn time<const N: usize>(&mut self, piece: &Piece<N>, x: &[f64; 3], weight: f64) -> f64 {
        let (rows, shares) = &SIMPSON;
        let least = FAR_BELOW * piece.guess;
        let mut at = dots(rows, x);
        at[3] = at[1];
        let seen = at.map(|at| at.max(least));
        let w = shares.map(|share| share * piece.h / 6.0);
        let inverse = quad(|l| w[l] / (seen[l] * seen[l].sqrt()));
        let first = quad(|l| -0.5 * weight * inverse[l]);
        let bends = |l: usize| if at[l] < least { 0.0 } else { 0.75 };
        let second = quad(|l| bends(l) * weight * inverse[l] / seen[l]);
        self.add(rows, &Force { first, second });
        sum(&quad(|l| w[l] / at[l].sqrt()))
    }
}

impl System {
    /// Of so many unknowns, with nothing in it.
    pub fn new(n: usize) -> Self {
        Self { rows: vec![[0.0; 3]; n], right: vec![0.0; n] }
    }

    /// Adds a piece, whose ordinates are l₀·b₋ + l₁·b, b and r₀·b + r₁·b₊ with its own unknown b and
    /// those before and after.
    pub fn add(&mut self, k: usize, part: &Local, shares: &[[f64; 2]; 2]) {
        let [[l0, l1], [r0, r1]] = *shares;
        let [g0, g1, g2] = part.gradient.map(|g| sum(&g));
        let [[a, ..], [b, c, _], [d, e, f]] = part.matrix.map(|row| row.map(|m| sum(&m)));
        self.right[k] -= l1 * g0 + g1 + r0 * g2;
        self.rows[k][0] += l1 * (l1 * a + 2.0 * (b + r0 * d)) + c + r0 * (2.0 * e + r0 * f);
        if k > 0 {
            self.right[k - 1] -= l0 * g0;
            self.rows[k - 1][0] += l0 * l0 * a;
            self.rows[k][1] += l0 * (l1 * a + b + r0 * d);
        }
        if let Some(next) = self.rows.get_mut(k + 1) {
            self.right[k + 1] -= r1 * g2;
            next[0] += r1 * r1 * f;
            next[1] += r1 * (l1 * d + e + r0 * f);
            next[2] += l0 * r1 * d;
        }
    }

    /// The first unknown stays what it is.
    pub fn hold_first(&mut self) {
        if let Some(row) = self.rows.first_mut() {
            (*row, self.right[0]) = ([1.0, 0.0, 0.0], 0.0);
        }
        for (k, row) in self.rows.iter_mut().enumerate().take(3).skip(1) {
            row[k] = 0.0;
        }
    }

    /// Solves by Cholesky's method without roots.
    pub fn solve(mut self) -> Vec<f64> {
        let n = self.right.len();
        for i in 0..n {
            let mut row = self.rows[i];
            if i >= 2 {
                let second = self.rows[i - 2];
                let factor = row[2] / second[0];
                row[0] -= factor * row[2];
                // Fill between i−1 and i through i−2.
                row[1] -= factor * self.rows[i - 1][1] * second[0];
                row[2] = factor;
                self.right[i] -= factor * self.right[i - 2];
            }
            if i >= 1 {
                let first = self.rows[i - 1];
                let factor = row[1] / first[0];
                row[0] -= factor * row[1];
                row[1] = factor;
                self.right[i] -= factor * self.right[i - 1];
            }
            self.rows[i] = row;
        }
        for i in (0..n).rev() {
            let mut value = self.right[i] / self.rows[i][0];
            if i + 1 < n {
                value -= self.rows[i + 1][1] * self.right[i + 1];
            }
            if i + 2 < n {
                value -= self.rows[i + 2][2] * self.right[i + 2];
            }
            self.right[i] = value;
        }
        self.right
    }
}
