//! Curves of G5 … G5.2 as functions of a parameter, and the lines that follow them.

use super::stop::{Refused, fail};
use kerf_diag::Code;
use serde::{Deserialize, Serialize};

/// Halvings of one curve at most.
const MOST_HALVINGS: u32 = 12;
/// Pieces that every curve is cut into before its flatness is looked at, so that no symmetry of the
/// curve deceives the test.
const PIECES: u32 = 4;
/// Control points of one G5.2 curve.
const MOST_POINTS: usize = 10_000;
/// Orders of a G5.2 curve.
const ORDERS: std::ops::RangeInclusive<f64> = 2.0..=10.0;

/// A curve of G5.2 that is being given.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Nurbs {
    order: usize,
    /// Control points in the plane, mm, and their weights.
    points: Vec<([f64; 2], f64)>,
}

/// The parameters, between 0 and 1, at which lines follow a curve within a tolerance, mm. The curve has as many
/// spans; its end is not among them.
pub(super) fn shares(at: &impl Fn(f64) -> [f64; 2], spans: u32, tolerance_mm: f64) -> Vec<f64> {
    let pieces = PIECES * spans;
    let mut shares = Vec::new();
    for i in 0..pieces {
        let (a, b) = (f64::from(i) / f64::from(pieces), f64::from(i + 1) / f64::from(pieces));
        flatten(at, a, b, tolerance_mm, MOST_HALVINGS, &mut shares);
    }
    shares.pop();
    shares
}

/// Parameters of the ends of lines that follow a curve from `a` to `b`.
fn flatten(
    at: &impl Fn(f64) -> [f64; 2],
    a: f64,
    b: f64,
    tolerance: f64,
    halvings: u32,
    ends: &mut Vec<f64>,
) {
    let (pa, pb) = (at(a), at(b));
    let off = [0.25, 0.5, 0.75].into_iter().map(|s| off_line(at(a + (b - a) * s), pa, pb));
    if halvings == 0 || off.fold(0.0, f64::max) <= tolerance {
        ends.push(b);
        return;
    }
    let middle = (a + b) / 2.0;
    flatten(at, a, middle, tolerance, halvings - 1, ends);
    flatten(at, middle, b, tolerance, halvings - 1, ends);
}

/// Distance of a point from a line between two others.
fn off_line(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let (px, py) = (p[0] - a[0], p[1] - a[1]);
    let square = dx * dx + dy * dy;
    let share = if square > 0.0 { ((px * dx + py * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    (px - share * dx).hypot(py - share * dy)
}

/// The place on a cubic Bézier curve at a parameter.
pub(super) fn cubic(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2], t: f64) -> [f64; 2] {
    let s = 1.0 - t;
    let (wa, wb, wc, wd) = (s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t);
    std::array::from_fn(|i| wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i])
}

impl Nurbs {
    /// A curve that begins at a point.
    pub(super) fn new(order: f64, start: [f64; 2]) -> Result<Self, Refused> {
        if order.fract() != 0.0 || !ORDERS.contains(&order) {
            let message = format!("L of G5.2 is the order of the curve, not {order}");
            return Err(fail(Code::OutOfRange, message, "L is 2 to 10, 3 when not given"));
        }
        Ok(Self { order: order as usize, points: vec![(start, 1.0)] })
    }

    /// Checks the weight of another point.
    pub(super) fn need_weight(&self, weight: f64) -> Result<(), Refused> {
        if weight <= 0.0 || self.points.len() >= MOST_POINTS {
            let message = "the weight P of a point is above zero";
            return Err(fail(Code::OutOfRange, message, "P1 is the usual weight"));
        }
        Ok(())
    }

    /// Gives another point.
    pub(super) fn push(&mut self, point: [f64; 2], weight: f64) {
        self.points.push((point, weight));
    }

    /// Refuses a curve of too few points.
    pub(super) fn need_points(&self) -> Result<(), Refused> {
        if self.points.len() >= self.order {
            return Ok(());
        }
        let message = format!("a curve of order {} needs as many points", self.order);
        Err(fail(Code::MissingWord, message, "the present place is the first of them"))
    }

    /// The last point.
    pub(super) fn end(&self) -> Option<[f64; 2]> {
        self.points.last().map(|(end, _)| *end)
    }

    /// The number of points.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// The place at a parameter 0 … 1: de Boor's algorithm on a clamped uniform knot vector.
    pub(super) fn at(&self, t: f64) -> [f64; 2] {
        let (n, degree) = (self.points.len(), self.order - 1);
        let spans = n - degree;
        let u = t.clamp(0.0, 1.0) * spans as f64;
        let span = (u.floor() as usize).min(spans - 1) + degree;
        let knot = |i: usize| i.saturating_sub(degree).min(spans) as f64;
        let mut d: Vec<[f64; 3]> = (0..=degree)
            .map(|j| {
                let ([x, y], w) = self.points[j + span - degree];
                [x * w, y * w, w]
            })
            .collect();
        for r in 1..=degree {
            for j in (r..=degree).rev() {
                let i = j + span - degree;
                let (low, high) = (knot(i), knot(i + degree - r + 1));
                let a = if high > low { (u - low) / (high - low) } else { 0.0 };
                d[j] = std::array::from_fn(|k| (1.0 - a) * d[j - 1][k] + a * d[j][k]);
            }
        }
        let [x, y, w] = d[degree];
        [x / w, y / w]
    }
}
