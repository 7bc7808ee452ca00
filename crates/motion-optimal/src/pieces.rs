//! Demands of a piece of path on the axes, as conditions on the squared speed along it.
//!
//! On a piece of length h the squared speed is a parabola with Bézier ordinates x₀, x₁, x₂. Path
//! slope q′ is quadratic and curvature q″ linear there, so the acceleration of an axis, q′·x′/2 +
//! q″·x, is a cubic whose four Bézier ordinates are linear in (x₀, x₁, x₂): it lies between them.
//! Its jerk is that cubic's derivative times √x.

use crate::bounds::Bounds;
use crate::cells::Cell;
use crate::condition::{LANES, Rows, quad};
use crate::leg::Leg;

/// Shorter parts are none, mm.
const NOTHING_MM: f64 = 1e-9;

/// A smaller part of a condition is rounding.
const SETTLED: f64 = 1e-9;

/// One piece: x is a single parabola on it, while the path may change its polynomials inside.
#[derive(Clone, Debug)]
pub(crate) struct Piece<const N: usize> {
    pub at_mm: f64,
    pub h: f64,
    /// Greatest squared speed.
    pub cap: f64,
    /// About the squared speed to expect: where a motion without a limit of jerk would be.
    pub guess: f64,
    pub parts: Vec<Part<N>>,
}

/// A part of a piece on which the path keeps its polynomials.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part<const N: usize> {
    /// Rows of the ordinates of x over the part.
    pub ordinates: Rows,
    /// Rows of the four ordinates of the acceleration of each axis that moves, as a share of its limit.
    accel: [Rows; N],
    /// The same of its derivative by s, as a share of the limit of jerk.
    gain: [Rows; N],
    /// Which axes move, and how many.
    pub moves: [bool; N],
    count: usize,
}

/// Coefficients of x₀, x₁ and x₂.
type Row = [f64; 3];

/// Limits of acceleration and jerk of the axes.
pub(crate) struct Limits<const N: usize> {
    pub accel: [f64; N],
    pub jerk: [f64; N],
}

impl<const N: usize> Part<N> {
    /// Rows of acceleration and its derivative, of each axis that moves.
    pub fn axes(&self) -> impl Iterator<Item = (&Rows, &Rows)> {
        self.accel.iter().zip(&self.gain).take(self.count)
    }

    /// Returns the number of axes that move.
    pub const fn count(&self) -> usize {
        self.count
    }

    /// Drops the conditions that the motion at the beginning has settled by x₀ and x₁.
    fn settle(&mut self) {
        for rows in self.accel.iter_mut().chain(&mut self.gain) {
            for lane in 0..LANES {
                let size = rows.iter().fold(0.0f64, |most, c| most.max(c[lane].abs()));
                if rows[2][lane].abs() <= SETTLED * size {
                    rows.iter_mut().for_each(|c| c[lane] = 0.0);
                }
            }
        }
    }
}

impl<const N: usize> Piece<N> {
    /// The piece over some cells, each with the bounds of its part in the piece.
    pub fn new(at_mm: f64, h: f64, guess: f64) -> Self {
        Self { at_mm, h, cap: f64::INFINITY, guess, parts: Vec::new() }
    }

    /// Adds what a cell, which may reach beyond the piece, asks within it.
    pub fn add(&mut self, cell: &Cell<N>, bounds: &Bounds<N>, limits: &Limits<N>, legs: &[Leg]) {
        let from = cell.at_mm.max(self.at_mm);
        let to = (cell.at_mm + cell.h).min(self.at_mm + self.h);
        let h = to - from;
        if h <= NOTHING_MM {
            return;
        }
        let frame = cell.frame.after(from - cell.at_mm);
        let end = frame.after(h);
        let middle: [f64; N] = std::array::from_fn(|k| frame.slope[k] + 0.5 * h * frame.bend[k]);
        for slope in [&frame.slope, &middle, &end.slope] {
            self.cap = self.cap.min(legs[cell.owner as usize].feed_cap(slope));
            for (most, slope) in bounds.speed.iter().zip(slope) {
                let v = most / slope.abs();
                self.cap = self.cap.min(v * v);
            }
        }
        let share = |s: f64| ((s - self.at_mm) / self.h).clamp(0.0, 1.0);
        let x = Course::new(share(from), share(to), self.h);
        let still = |k: usize| frame.slope[k] == 0.0 && middle[k] == 0.0 && end.slope[k] == 0.0;
        let moves = std::array::from_fn(|k| !still(k));
        let mut part = Part {
            ordinates: rows(&x.ordinates, 1.0),
            accel: [Rows::default(); N],
            gain: [Rows::default(); N],
            moves,
            count: 0,
        };
        for k in (0..N).filter(|k| moves[*k]) {
            let axis = Axis {
                slope: [frame.slope[k], middle[k], end.slope[k]],
                bend: [frame.bend[k], end.bend[k]],
                twist: frame.twist[k],
            };
            part.accel[part.count] = rows(&axis.accel(&x), 1.0 / limits.accel[k]);
            part.gain[part.count] = rows(&axis.gain(&x), 1.0 / limits.jerk[k]);
            part.count += 1;
        }
        self.parts.push(part);
    }

    /// The piece begins in motion, at a speed and s̈ that are given.
    pub fn settle(&mut self) {
        self.parts.iter_mut().for_each(Part::settle);
    }
}

/// Rows side by side, scaled.
fn rows<const M: usize>(of: &[Row; M], scale: f64) -> Rows {
    std::array::from_fn(|k| quad(|lane| of.get(lane).map_or(0.0, |row| row[k] * scale)))
}

/// Rows of x and its derivatives over a part of a piece. They are not taken as differences over the
/// part, which may be so short that nothing but rounding would be left.
struct Course {
    ordinates: [Row; 3],
    /// Of x′/2 at both ends.
    half: [Row; 2],
    /// Of x″/2.
    rate: Row,
}

impl Course {
    fn new(from: f64, to: f64, h: f64) -> Self {
        let blossom =
            |a: f64, b: f64| [(1.0 - a) * (1.0 - b), a * (1.0 - b) + b * (1.0 - a), a * b];
        let half = |a: f64| [(a - 1.0) / h, (1.0 - 2.0 * a) / h, a / h];
        Self {
            ordinates: [blossom(from, from), blossom(from, to), blossom(to, to)],
            half: [half(from), half(to)],
            rate: [1.0, -2.0, 1.0].map(|c| c / (h * h)),
        }
    }
}

/// Bézier ordinates of q′ and q″ of one axis, and q‴.
struct Axis {
    slope: [f64; 3],
    bend: [f64; 2],
    twist: f64,
}

impl Axis {
    /// Rows of q′·x′/2 + q″·x.
    fn accel(&self, x: &Course) -> [Row; 4] {
        let ([p0, p1, p2], [c0, c1]) = (self.slope, self.bend);
        let ([y0, y1, y2], [d0, d1]) = (&x.ordinates, &x.half);
        let third = 1.0 / 3.0;
        [
            sum(&[(p0, d0), (c0, y0)]),
            sum(&[
                (p0 * third, d1),
                (2.0 * p1 * third, d0),
                (2.0 * c0 * third, y1),
                (c1 * third, y0),
            ]),
            sum(&[
                (2.0 * p1 * third, d1),
                (p2 * third, d0),
                (c0 * third, y2),
                (2.0 * c1 * third, y1),
            ]),
            sum(&[(p2, d1), (c1, y2)]),
        ]
    }

    /// Rows of its derivative, q′·x″/2 + 3·q″·x′/2 + q‴·x.
    fn gain(&self, x: &Course) -> [Row; 3] {
        let ([p0, p1, p2], [c0, c1]) = (self.slope, self.bend);
        let ([y0, y1, y2], [d0, d1]) = (&x.ordinates, &x.half);
        [
            sum(&[(p0, &x.rate), (3.0 * c0, d0), (self.twist, y0)]),
            sum(&[(p1, &x.rate), (1.5 * c0, d1), (1.5 * c1, d0), (self.twist, y1)]),
            sum(&[(p2, &x.rate), (3.0 * c1, d1), (self.twist, y2)]),
        ]
    }
}

fn sum(terms: &[(f64, &Row)]) -> Row {
    std::array::from_fn(|k| terms.iter().map(|(factor, row)| factor * row[k]).sum())
}
