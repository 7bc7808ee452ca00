//! How wide each corner is smoothed.
//!
//! Along its length s the polyline turns at each vertex j by D = u₂ − u₁, the change of its unit
//! tangent. The smoothed path is the polyline plus one bump h(s − sⱼ)·Dⱼ for each vertex, where h″
//! is a kernel of area 1 and half-width c: the path then curves by the kernel times D where the
//! polyline had a kink. A box gives the parabolic blend; a triangle gives a curve whose curvature
//! is continuous, for motion with limited jerk. Bumps may overlap, so that a curve of many short
//! chords is smoothed over several of them.
//!
//! ```text
//!   bump h at the distance d from the vertex      its greatest, at the vertex
//!   box       (c − d)² / 4c                       c/4
//!   triangle  (c − d)³ / 6c²                      c/6
//! ```
//!
//! Between vertices every bump is convex in s, so the sum of their sizes is greatest at a vertex:
//! a path that is within tolerance at the vertices is so everywhere.

use super::track::{Track, norm};
use crate::moves::Move;

/// Bumps reach over at most so many vertices on each side.
const REACH: usize = 8;

/// Slighter turns are none.
const STRAIGHT: f64 = 1e-9;

/// A vertex at which a turn must be made on less path, mm, is a stop.
const SHARPEST_MM: f64 = 1e-6;

/// Steps of Newton's method; each from above, so that the width only shrinks.
const STEPS: usize = 8;

/// How far bumps may overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Overlap {
    /// Each bump stays on its half of the segments: best on even curves.
    None,
    /// As far as the tolerance allows: best where corners are close and uneven.
    Widest,
}

/// The shape of the smoothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Kernel {
    /// Curvature jumps: for motion limited in acceleration.
    #[default]
    Box,
    /// Curvature is continuous: for motion limited in jerk.
    Triangle,
}

/// A turn sharper than this, as change of the unit tangent, is a corner and not part of a curve.
const SHARP: f64 = 0.2;

/// Triangles of which the kernel of a corner is made: share of the area and of the width.
///
/// Together they are a broken line through the kernel of the fastest corner between axes limited in
/// jerk alone, K ∝ (1 − u²)/(1 + u²)³ at s ∝ u + u³/3, where one axis stops with its full jerk while
/// the other starts with its own.
pub(crate) const CORNER: [(f64, f64); PARTS] = [
    (0.25355, 1.0),
    (0.06040, 0.94),
    (0.08027, 0.88),
    (0.11670, 0.8),
    (0.14087, 0.7),
    (0.14475, 0.6),
    (0.12888, 0.5),
    (0.08639, 0.4),
    (0.02653, 0.3),
    (-0.01581, 0.2),
    (-0.02253, 0.1),
];

/// Triangles that a kernel has at most.
pub(crate) const PARTS: usize = 11;

impl Kernel {
    /// The triangles of which the kernel for a turn is made.
    pub fn parts(self, turn: f64) -> [(f64, f64); PARTS] {
        if self.is_corner(turn) {
            return CORNER;
        }
        let mut parts = [(0.0, 1.0); PARTS];
        parts[0] = (1.0, 1.0);
        parts
    }

    /// Whether the kernel for a turn is that of a corner.
    pub fn is_corner(self, turn: f64) -> bool {
        self == Self::Triangle && turn > SHARP
    }

    /// The bump of half-width `c` at a distance, and its derivative by the half-width.
    fn bump(self, turn: f64, c: f64, distance: f64) -> (f64, f64) {
        if self == Self::Box {
            let left = c - distance;
            return (left * left / (4.0 * c), left * (c + distance) / (4.0 * c * c));
        }
        let mut sum = (0.0, 0.0);
        for (share, width) in self.parts(turn) {
            let (c, left) = (c * width, c * width - distance);
            if share != 0.0 && left > 0.0 {
                let square = share * left * left / (6.0 * c * c);
                sum.0 += square * left;
                sum.1 += width * square * (c + 2.0 * distance) / c;
            }
        }
        sum
    }

    /// The share of the way to a stop over which a bump may reach: with limited jerk the first bit
    /// of path from rest must be straight.
    const fn straight_ends(self) -> f64 {
        match self {
            Self::Box => 1.0,
            Self::Triangle => 1.0 - super::limited::LAUNCH_SHARE,
        }
    }

    /// The half-width of a bump of height 1.
    fn width(self, turn: f64) -> f64 {
        match self {
            Self::Box => 4.0,
            Self::Triangle => {
                6.0 / self.parts(turn).iter().map(|(share, width)| share * width).sum::<f64>()
            }
        }
    }

    /// Value, slope and curvature of the bump at an offset from its vertex; at the vertex itself the
    /// sign of the offset tells the side.
    pub fn shape(self, turn: f64, c: f64, offset: f64) -> [f64; 3] {
        let side = -offset.signum();
        if self == Self::Box {
            let left = c - offset.abs();
            return [left * left / (4.0 * c), side * left / (2.0 * c), 0.5 / c];
        }
        let mut sum = [0.0; 3];
        for (share, width) in self.parts(turn) {
            let left = c * width - offset.abs();
            if share != 0.0 && left > 0.0 {
                let scale = share / (c * width * c * width);
                sum[0] += scale * left * left * left / 6.0;
                sum[1] += side * 0.5 * scale * left * left;
                sum[2] += scale * left;
            }
        }
        sum
    }
}

/// Half-widths of all vertices; zero where the machine stands: at the breaks, at the end, and where
/// the tolerance leaves no room. Negative where there is no turn, and so no bump.
pub(crate) fn widths<const N: usize>(
    track: &Track,
    breaks: &[usize],
    moves: &[Move],
    kernel: Kernel,
    overlap: Overlap,
) -> Vec<f64> {
    let (turns, widths) = (turns::<N>(track), vec![0.0; track.len()]);
    let mut out = Widths { at: &track.at_mm, turns, kernel, overlap, widths };
    for (k, first) in breaks.iter().enumerate() {
        let last = breaks.get(k + 1).map_or(track.len(), |next| *next) - 1;
        out.run(*first, last, |vertex| track.tolerance_mm(vertex, moves));
    }
    out.widths
}

struct Widths<'a> {
    at: &'a [f64],
    turns: Vec<f64>,
    kernel: Kernel,
    overlap: Overlap,
    widths: Vec<f64>,
}

impl Widths<'_> {
    /// Splits a chain where a corner cannot be passed and smooths each part.
    fn run(&mut self, first: usize, last: usize, tolerance: impl Fn(usize) -> f64) {
        let mut start = first;
        for vertex in first + 1..=last {
            let widest =
                self.kernel.width(self.turns[vertex]) * tolerance_or(vertex, last, &tolerance);
            let sharp = self.turns[vertex] > STRAIGHT && widest < SHARPEST_MM * self.turns[vertex];
            if vertex == last || sharp {
                self.smooth(start, vertex, &tolerance);
                start = vertex;
            }
        }
    }

    fn smooth(&mut self, first: usize, last: usize, tolerance: &impl Fn(usize) -> f64) {
        match self.overlap {
            Overlap::None => self.part(first, last, tolerance),
            Overlap::Widest => self.spread(first, last, tolerance),
        }
        for j in first + 1..last {
            if self.turns[j] <= STRAIGHT {
                self.widths[j] = -self.widths[j];
            }
        }
    }

    /// Widths up to the middle of the segments.
    fn part(&mut self, first: usize, last: usize, tolerance: &impl Fn(usize) -> f64) {
        for j in first + 1..last {
            let (before, after) = (self.at[j] - self.at[j - 1], self.at[j + 1] - self.at[j]);
            let turn = self.turns[j].max(STRAIGHT);
            let alone = self.kernel.width(turn) * tolerance(j) / turn;
            self.widths[j] = alone.min(0.5 * before.min(after));
        }
    }

    fn spread(&mut self, first: usize, last: usize, tolerance: &impl Fn(usize) -> f64) {
        let mut before = 0.0;
        for j in first + 1..last {
            let room = before + (self.at[j] - self.at[j - 1]);
            before = self.widest(j, first, last, room, tolerance(j));
            self.widths[j] = before;
        }
        self.narrow_back(first, last);
        self.hold_tolerance(first, last, tolerance);
        self.narrow_forward(first, last);
        self.narrow_back(first, last);
    }

    /// The width at which this bump and its neighbours, were they as wide, just use the tolerance.
    fn widest(&self, j: usize, first: usize, last: usize, room: f64, tolerance: f64) -> f64 {
        let at = self.at[j];
        let reach = (self.at[(j + REACH).min(last)] - at)
            .min(at - self.at[j.saturating_sub(REACH).max(first)]);
        let turn = self.turns[j].max(STRAIGHT);
        let alone = self.kernel.width(turn) * tolerance / turn;
        let ends = (at - self.at[first]).min(self.at[last] - at);
        let mut c = reach.min(room).min(alone).min(self.kernel.straight_ends() * ends);
        for _ in 0..STEPS {
            let (mut sum, mut slope) = (0.0, 0.0);
            let mut add = |k: usize, distance: f64| {
                let (bump, by_width) = self.kernel.bump(self.turns[k], c, distance);
                sum += self.turns[k] * bump;
                slope += self.turns[k] * by_width;
            };
            add(j, 0.0);
            (j + 1..last)
                .take_while(|k| self.at[*k] - at < c)
                .for_each(|k| add(k, self.at[k] - at));
            (first + 1..j)
                .rev()
                .take_while(|k| at - self.at[*k] < c)
                .for_each(|k| add(k, at - self.at[k]));
            let over = sum - tolerance;
            if over <= 1e-3 * tolerance {
                break;
            }
            c = (c - over / slope).max(0.5 * c);
        }
        c
    }

    /// Bumps begin in the order of their vertices …
    fn narrow_back(&mut self, first: usize, last: usize) {
        for j in (first..last).rev() {
            let most = self.widths[j + 1] + (self.at[j + 1] - self.at[j]);
            self.widths[j] = self.widths[j].min(most);
        }
    }

    /// … and end in that order.
    fn narrow_forward(&mut self, first: usize, last: usize) {
        for j in first + 1..=last {
            let most = self.widths[j - 1] + (self.at[j] - self.at[j - 1]);
            self.widths[j] = self.widths[j].min(most);
        }
    }

    /// Narrows what overlaps too much: a bump shrinks at least as its width does, so narrowing all
    /// that reach a vertex by the same factor brings their sum there within the tolerance.
    fn hold_tolerance(&mut self, first: usize, last: usize, tolerance: &impl Fn(usize) -> f64) {
        let mut factors = vec![1.0f64; last + 1 - first];
        for j in first + 1..last {
            let sum: f64 = self
                .reaching(j, first, last)
                .map(|(k, d)| self.turns[k] * self.kernel.bump(self.turns[k], self.widths[k], d).0)
                .sum();
            let most = tolerance(j);
            if sum > most {
                let factor = most / sum;
                self.reaching(j, first, last).for_each(|(k, _)| {
                    factors[k - first] = factors[k - first].min(factor);
                });
            }
        }
        for (j, factor) in factors.iter().enumerate() {
            self.widths[first + j] *= factor;
        }
    }

    /// The vertices whose bumps reach this one, and their distances.
    fn reaching(&self, j: usize, first: usize, last: usize) -> impl Iterator<Item = (usize, f64)> {
        let at = self.at[j];
        let after = (j..last).map(move |k| (k, self.at[k] - at));
        let before = (first + 1..j).rev().map(move |k| (k, at - self.at[k]));
        let reaches = |(k, d): &(usize, f64)| *d < self.widths[*k];
        after.take_while(reaches).chain(before.take_while(reaches))
    }
}

fn tolerance_or(vertex: usize, last: usize, tolerance: &impl Fn(usize) -> f64) -> f64 {
    if vertex == last { 0.0 } else { tolerance(vertex) }
}

/// How much the tangent changes at each vertex.
fn turns<const N: usize>(track: &Track) -> Vec<f64> {
    let mut turns = vec![0.0; track.len()];
    let mut before = [0.0; N];
    for (j, turn) in turns.iter_mut().enumerate().take(track.len() - 1) {
        let after = track.direction::<N>(j);
        *turn = norm(&std::array::from_fn::<f64, N, _>(|k| after[k] - before[k]));
        before = after;
    }
    turns
}
