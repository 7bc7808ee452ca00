//! G5, G5.1, G5.2: curves, given as lines that lie within the tolerance.

use super::context::{Context, Stop};
use super::state::Plane;
use crate::syntax::gathered::{Gathered, letters};
use kerf_diag::Code;
use kerf_program::{Axes, MoveKind};
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

impl Context<'_> {
    fn need_xy(&self, code: &str) -> Result<(), Stop> {
        self.need_straight()?;
        if self.core.compensator.is_some() {
            return Err(self.not_compensated("a curve"));
        }
        if self.core.state.modal.plane == Plane::Xy {
            return Ok(());
        }
        Err(self.fail(
            Code::ArcPlane,
            format!("{code} outside the XY plane"),
            "write G17 before it",
        ))
    }

    /// G5 (cubic) and G5.1 (quadratic).
    pub(super) fn spline(
        &mut self,
        g: &Gathered,
        motion: i32,
        before: Option<[f64; 2]>,
    ) -> Result<(), Stop> {
        let name = Self::name_of(g, motion);
        self.need_xy(&name)?;
        if g.has_any(letters(b"ZABC")) {
            let message = format!("{name} with an axis beside X and Y");
            return Err(self.fail(Code::ArcPlane, message, "curves lie in XY"));
        }
        let here = self.core.place_of(self.core.position);
        let from = [here.0[0], here.0[1]];
        let to = self.target(g)?;
        let end = self.core.place_of(to);
        let end = [end.0[0], end.0[1]];
        let offset = |a: u8, b: u8| {
            let scale = self.core.scale;
            (g.has(a) || g.has(b)).then(|| [g.or_zero(a) * scale[0], g.or_zero(b) * scale[1]])
        };
        let first = offset(b'I', b'J');
        if motion == 51 {
            let Some(d) = first.filter(|_| !g.has_any(letters(b"PQ"))) else {
                return Err(self.fail(
                    Code::MissingWord,
                    "G5.1 needs I and J",
                    "they lead from the start to the control point",
                ));
            };
            let control = [from[0] + d[0], from[1] + d[1]];
            let third = |a: f64, b: f64| a + (b - a) * 2.0 / 3.0;
            let c1 = [third(from[0], control[0]), third(from[1], control[1])];
            let c2 = [third(end[0], control[0]), third(end[1], control[1])];
            return self.curve(|t| cubic(from, c1, c2, end, t), to);
        }
        let (Some(first), Some(last)) =
            (first.or(before.map(|[p, q]| [-p, -q])), offset(b'P', b'Q'))
        else {
            let hint = "I J lead from the start to the first control point, P Q from the end to the second";
            return Err(self.fail(Code::MissingWord, "G5 needs I, J, P and Q", hint));
        };
        let c1 = [from[0] + first[0], from[1] + first[1]];
        let c2 = [end[0] + last[0], end[1] + last[1]];
        self.curve(|t| cubic(from, c1, c2, end, t), to)?;
        self.core.spline_end = Some(last);
        Ok(())
    }

    /// G5.2 begins a curve and gives points of it, G5.3 ends it.
    pub(super) fn nurbs(&mut self, g: &Gathered, motion: i32) -> Result<(), Stop> {
        self.need_xy(&Self::name_of(g, motion))?;
        if motion == 53 {
            self.core.state.modal.motion = None;
            return self.end_nurbs();
        }
        let here = self.core.place_of(self.core.position);
        let mut nurbs = match self.core.nurbs.take() {
            Some(nurbs) => nurbs,
            None => {
                let order = g.get(b'L').unwrap_or(3.0);
                if order.fract() != 0.0 || !ORDERS.contains(&order) {
                    let message = format!("L of G5.2 is the order of the curve, not {order}");
                    return Err(self.fail(
                        Code::OutOfRange,
                        message,
                        "L is 2 to 10, 3 when not given",
                    ));
                }
                Nurbs { order: order as usize, points: vec![([here.0[0], here.0[1]], 1.0)] }
            }
        };
        let weight = g.get(b'P').unwrap_or(1.0);
        if weight <= 0.0 || nurbs.points.len() >= MOST_POINTS {
            return Err(self.fail(
                Code::OutOfRange,
                "the weight P of a point is above zero",
                "P1 is the usual weight",
            ));
        }
        if g.has_any(letters(b"XY")) {
            let at = self.core.place_of(self.target(g)?);
            nurbs.points.push(([at.0[0], at.0[1]], weight));
        }
        self.core.nurbs = Some(nurbs);
        Ok(())
    }

    fn end_nurbs(&mut self) -> Result<(), Stop> {
        let Some(nurbs) = self.core.nurbs.take() else {
            return Err(self.fail(Code::MissingWord, "G5.3 without G5.2", "G5.2 begins the curve"));
        };
        if nurbs.points.len() < nurbs.order {
            let message = format!("a curve of order {} needs as many points", nurbs.order);
            return Err(self.fail(
                Code::MissingWord,
                message,
                "the present place is the first of them",
            ));
        }
        let Some((end, _)) = nurbs.points.last().copied() else { return Ok(()) };
        let to = self.core.moved(self.core.position, [(0, end[0]), (1, end[1])].into_iter());
        self.curve_pieces(|t| nurbs.at(t), to, nurbs.points.len() as u32)
    }

    fn curve(&mut self, at: impl Fn(f64) -> [f64; 2], to: Axes) -> Result<(), Stop> {
        self.curve_pieces(at, to, 1)
    }

    /// Lines along a curve with parameter 0 … 1, ending at a machine position.
    fn curve_pieces(
        &mut self,
        at: impl Fn(f64) -> [f64; 2],
        to: Axes,
        spans: u32,
    ) -> Result<(), Stop> {
        let pieces = PIECES * spans;
        let mut shares = Vec::new();
        for i in 0..pieces {
            let (a, b) = (f64::from(i) / f64::from(pieces), f64::from(i + 1) / f64::from(pieces));
            flatten(&at, a, b, self.core.options.tolerance_mm, MOST_HALVINGS, &mut shares);
        }
        shares.pop();
        let feed = self.feed(self.core.position, to)?;
        let feed = match feed {
            kerf_program::Feed::Time(s) => kerf_program::Feed::Time(s / (shares.len() + 1) as f64),
            feed => feed,
        };
        for share in shares {
            let [x, y] = at(share);
            let next = self.core.moved(self.core.position, [(0, x), (1, y)].into_iter());
            self.line_at(MoveKind::Cut, next, feed)?;
        }
        self.line_at(MoveKind::Cut, to, feed)
    }
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

fn cubic(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2], t: f64) -> [f64; 2] {
    let s = 1.0 - t;
    let (wa, wb, wc, wd) = (s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t);
    std::array::from_fn(|i| wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i])
}

impl Nurbs {
    /// The place at a parameter 0 … 1: de Boor's algorithm on a clamped uniform knot vector.
    fn at(&self, t: f64) -> [f64; 2] {
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
