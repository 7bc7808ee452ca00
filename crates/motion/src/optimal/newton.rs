//! Newton's system of the interior-point method: what each piece adds to it, and its solution.

use super::condition::{Condition, dot};
use super::pieces::{Part, Piece};

/// Below this share of what to expect, x is far from its goal.
const FAR_BELOW: f64 = 0.2;

/// Lower part of a symmetric matrix with five diagonals, and the right side.
pub(crate) struct System {
    rows: Vec<[f64; 3]>,
    right: Vec<f64>,
}

/// Gradient and matrix of one piece in its own ordinates.
#[derive(Default)]
pub(crate) struct Local {
    gradient: [f64; 3],
    matrix: [[f64; 3]; 3],
}

impl Local {
    fn add(&mut self, row: &[f64; 3], first: f64, second: f64) {
        for i in 0..3 {
            self.gradient[i] += first * row[i];
            for j in 0..=i {
                self.matrix[i][j] += second * row[i] * row[j];
            }
        }
    }

    pub fn barrier(&mut self, condition: &Condition) {
        let [upper, lower] = condition.slacks().map(|slack| condition.force(slack));
        let row = &condition.row;
        match &condition.tangent {
            None => self.add(row, lower[0] - upper[0], upper[1] + lower[1]),
            Some(tangent) => {
                let side = |sign: f64| std::array::from_fn(|k| tangent[k] + sign * row[k]);
                self.add(&side(-1.0), upper[0], upper[1]);
                self.add(&side(1.0), lower[0], lower[1]);
            }
        }
    }

    /// Makes barriers of J/√x − |f′| into those of J − |f′|·√x, which do not favour a small x.
    pub fn level<const N: usize>(&mut self, x: &[f64; 3], part: &Part<N>) {
        for row in &part.ordinates {
            let inverse = 1.0 / dot(row, x);
            let share = N as f64;
            self.add(row, -share * inverse, share * inverse * inverse);
        }
    }

    /// Simpson's rule; where x is far below what to expect the time counts as linear, which makes
    /// the first steps long.
    pub fn time<const N: usize>(&mut self, piece: &Piece<N>, x: &[f64; 3], weight: f64) -> f64 {
        let mut time = 0.0;
        for (row, share) in
            [([1.0, 0.0, 0.0], 1.0), ([0.25, 0.5, 0.25], 4.0), ([0.0, 0.0, 1.0], 1.0)]
        {
            let at = dot(&row, x);
            let least = FAR_BELOW * piece.guess;
            let seen = at.max(least);
            let inverse = 1.0 / seen.sqrt();
            let w = share * piece.h / 6.0;
            time += w / at.sqrt();
            let first = -0.5 * w * inverse / seen;
            let second = if at < least { 0.0 } else { 0.75 * w * inverse / (seen * seen) };
            self.add(&row, weight * first, weight * second);
        }
        time
    }
}

impl System {
    /// Of so many unknowns, with nothing in it.
    pub fn new(n: usize) -> Self {
        Self { rows: vec![[0.0; 3]; n], right: vec![0.0; n] }
    }

    /// Adds a piece, whose ordinates are made of three unknowns.
    pub fn add(&mut self, k: usize, part: &Local, shares: &[[f64; 2]; 2]) {
        let [[l0, l1], [r0, r1]] = *shares;
        // Columns: the unknown before, its own, the one after.
        let map = [[l0, l1, 0.0], [0.0, 1.0, 0.0], [0.0, r0, r1]];
        let m = |i: usize, j: usize| part.matrix[i.max(j)][i.min(j)];
        for c in 0..3 {
            let Some(i) = (k + c).checked_sub(1).filter(|i| *i < self.right.len()) else {
                continue;
            };
            self.right[i] -= (0..3).map(|a| map[a][c] * part.gradient[a]).sum::<f64>();
            for e in 0..=c {
                let Some(j) = (k + e).checked_sub(1) else { continue };
                let mut sum = 0.0;
                for a in 0..3 {
                    for b in 0..3 {
                        sum += map[a][c] * m(a, b) * map[b][e];
                    }
                }
                self.rows[i][i - j] += sum;
            }
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
