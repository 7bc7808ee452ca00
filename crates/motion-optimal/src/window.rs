//! The path of a window in pieces, as fine as the speed to be expected asks for.

use crate::bounds::{Bounds, USED};
use crate::cells::Cell;
use crate::gate::Gate;
use crate::launch::{End, Launch};
use crate::leg::Leg;
use crate::node::Node;
use crate::passes::Passes;
use crate::pieces::{Limits, Piece};

/// Across a piece z = x^(3/4) changes by at most about this share.
const FINE: f64 = 0.15;

/// No piece is cut shorter, mm.
const LEAST_MM: f64 = 1e-4;

/// A window of path: its cells, its limits and its ends.
pub(crate) struct Window<'a, const N: usize> {
    pub cells: &'a [Cell<N>],
    pub bounds: &'a Bounds<N>,
    pub jerk: &'a [f64; N],
    pub legs: &'a [Leg],
    /// The motion without a limit of jerk.
    pub guide: &'a [Node],
    pub begin: End,
    pub end: Launch,
}

/// Nodes of the motion without a limit of jerk, from one squared speed at the beginning to rest.
pub(crate) fn guide<const N: usize>(
    cells: &[Cell<N>],
    bounds: &Bounds<N>,
    legs: &[Leg],
    x: f64,
) -> Vec<Node> {
    let Some(first) = cells.first() else { return Vec::new() };
    let mut passes = Passes::running(*bounds, first.at_mm, x);
    passes.gates.extend(cells.iter().map(|cell| Gate::new(cell, bounds, legs)));
    passes.settle(true);
    passes.nodes
}

impl<const N: usize> Window<'_, N> {
    /// Pieces of given lengths, then as fine as needed.
    pub fn pieces(&self, kept: &[f64]) -> Vec<Piece<N>> {
        let (Some(first), Some(last)) = (self.cells.first(), self.cells.last()) else {
            return Vec::new();
        };
        let end = last.at_mm + last.h - self.end.way_mm;
        let mut at = first.at_mm + self.begin.way_mm();
        let rate = (4.5 * self.jerk.iter().copied().fold(f64::INFINITY, f64::min)).sqrt();
        let slow = Slow::new(self, rate);
        let limits = Limits { accel: self.bounds.accel, jerk: self.jerk.map(|j| j * USED) };
        let mut speeds = Speeds { guide: self.guide, place: 0 };
        let mut pieces: Vec<Piece<N>> = Vec::new();
        let mut kept = kept.iter();
        let mut k = 0;
        while at < end {
            while k + 1 < self.cells.len() && self.cells[k + 1].at_mm <= at {
                k += 1;
            }
            let here = speeds.v(at, true).powf(1.5).min(slow.at(k, at));
            let (h, there) = match kept.next() {
                Some(h) if at + h < end => (*h, here),
                _ => {
                    kept = [].iter();
                    let next = (at + FINE * here / rate).min(end);
                    let mut last = k;
                    while last + 1 < self.cells.len() && self.cells[last + 1].at_mm < next {
                        last += 1;
                    }
                    let there = speeds.v(next, false).powf(1.5).min(slow.at(last, next));
                    let fine = (FINE * here.min(there) / rate).max(LEAST_MM);
                    (if end - at < 1.5 * fine { end - at } else { fine }, there)
                }
            };
            let guess = here.max(there).powf(4.0 / 3.0);
            let mut piece = Piece::new(at, h, guess);
            for cell in self.cells[k..].iter().take_while(|c| c.at_mm < at + h) {
                piece.add(cell, self.bounds, &limits, self.legs);
            }
            if pieces.is_empty() && matches!(self.begin, End::Motion(_)) {
                piece.settle();
            }
            pieces.push(piece);
            at = if h < end - at { at + h } else { end };
        }
        pieces
    }
}

/// Speeds that the jerk allows, as z = x^(3/4): from a slow place z can grow as the distance does.
struct Slow<'a, const N: usize> {
    cells: &'a [Cell<N>],
    /// In each cell, and at its start; one more at the end.
    within: Vec<f64>,
    starts: Vec<f64>,
    rate: f64,
}

impl<'a, const N: usize> Slow<'a, N> {
    fn new(window: &Window<'a, N>, rate: f64) -> Self {
        let (cells, jerk) = (window.cells, window.jerk);
        let steady = |cell: &Cell<N>| {
            let most = (0..N).map(|k| jerk[k] / cell.frame.twist[k].abs());
            most.fold(f64::INFINITY, f64::min).sqrt()
        };
        let within: Vec<f64> = cells.iter().map(steady).collect();
        let n = cells.len();
        let mut starts = vec![0.0; n + 1];
        starts[0] = match window.begin {
            End::Rest(launch) => 0.5 * rate * launch.way_mm,
            End::Motion([x, _]) => x.powf(0.75),
        };
        for k in 0..n {
            let next = within.get(k + 1).copied().unwrap_or(0.5 * rate * window.end.way_mm);
            starts[k + 1] = (starts[k] + rate * cells[k].h).min(within[k]).min(next);
        }
        for k in (0..n).rev() {
            starts[k] = starts[k].min(starts[k + 1] + rate * cells[k].h);
        }
        Self { cells, within, starts, rate }
    }

    fn at(&self, k: usize, at_mm: f64) -> f64 {
        let way = at_mm - self.cells[k].at_mm;
        let rise = self.starts[k] + self.rate * way;
        let fall = self.starts[k + 1] + self.rate * (self.cells[k].h - way);
        rise.min(fall).min(self.within[k])
    }
}

/// Speeds without a limit of jerk.
struct Speeds<'a> {
    guide: &'a [Node],
    place: usize,
}

impl Speeds<'_> {
    fn v(&mut self, at: f64, keep: bool) -> f64 {
        let mut i = self.place;
        while i + 2 < self.guide.len() && self.guide[i + 1].at_mm <= at {
            i += 1;
        }
        if keep {
            self.place = i;
        }
        let (a, b) = (&self.guide[i], &self.guide[i + 1]);
        let share = ((at - a.at_mm) / (b.at_mm - a.at_mm)).clamp(0.0, 1.0);
        (a.v * a.v + share * (b.v * b.v - a.v * a.v)).sqrt()
    }
}
