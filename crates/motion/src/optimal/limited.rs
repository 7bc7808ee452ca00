//! Times of a run under a limit of jerk: grid, solution, nodes.

use super::cells::{Cell, Cells, feed_cap};
use super::jerk::{Launch, Problem};
use super::kernel::Kernel;
use super::pieces::Piece;
use super::reach::{Bounds, Gate};
use super::scurve::phases;
use super::speeds::{Node, Passes};
use super::timed::{Push, swing};
use super::track::Track;
use crate::moves::Move;

/// Across a piece z = x^(3/4) changes by at most about this share.
const FINE: f64 = 0.15;

/// No piece is cut shorter, mm.
const LEAST_MM: f64 = 1e-4;

/// Newton's steps in search of a time; each doubles the digits.
const NEWTON: u32 = 8;

/// Share of the first and last segment on which the path is straight for the launch.
pub(crate) const LAUNCH_SHARE: f64 = 0.25;

/// Limits of a run.
pub(crate) struct Limited<'a, const N: usize> {
    pub track: &'a Track,
    pub widths: &'a [f64],
    pub moves: &'a [Move],
    pub bounds: Bounds<N>,
    pub jerk: [f64; N],
}

impl<const N: usize> Limited<'_, N> {
    /// Appends the nodes of a run from rest to rest, after the one at its start.
    pub fn run(&self, run: [usize; 2], nodes: &mut Vec<Node>, pushes: &mut Vec<Push>) {
        let [first, last] = run;
        let length = self.track.at_mm[last] - self.track.at_mm[first];
        if length <= 0.0 {
            return;
        }
        let mut cells = Cells::new(self.track, self.widths, Kernel::Triangle, self.moves, run);
        match cells.next() {
            Some(cell) if cell.straight && cell.h >= length * (1.0 - 1e-12) => {
                self.straight(&cell, nodes, pushes);
            }
            _ => self.curved(run, nodes, pushes),
        }
    }

    /// Limits along a straight direction: speed, acceleration, jerk.
    fn along(&self, slope: &[f64; N]) -> [f64; 3] {
        let most = |limits: &[f64; N]| {
            (0..N).map(|k| limits[k] / slope[k].abs()).fold(f64::INFINITY, f64::min)
        };
        [most(&self.bounds.speed), most(&self.bounds.accel), most(&self.jerk)]
    }

    fn straight(&self, cell: &Cell<N>, nodes: &mut Vec<Node>, pushes: &mut Vec<Push>) {
        let [v, a, j] = self.along(&cell.frame.slope);
        let feed = feed_cap(&self.moves[cell.owner as usize], &cell.frame.slope).sqrt();
        let Some(mut node) = nodes.last().copied() else { return };
        let mut accel = 0.0;
        pushes.pop();
        for phase in phases(cell.h, v.min(feed), a, j) {
            pushes.push(Push { accel, jerk: Some(phase.jerk) });
            let t = phase.duration_s;
            node.at_mm += t * (node.v + t * (0.5 * accel + t * phase.jerk / 6.0));
            node.v += t * (accel + 0.5 * t * phase.jerk);
            node.t_s += t;
            accel += t * phase.jerk;
            nodes.push(node);
        }
        if let Some(end) = nodes.last_mut() {
            // Sums of phases are rounded; the end of a run is a vertex, and at rest.
            (end.at_mm, end.v) = (cell.at_mm + cell.h, 0.0);
        }
        pushes.push(Push { accel: 0.0, jerk: None });
    }

    fn curved(&self, run: [usize; 2], nodes: &mut Vec<Node>, pushes: &mut Vec<Push>) {
        let launches = [self.launch(run[0]), self.launch(run[1] - 1)];
        let pieces = self.pieces(run, &launches);
        let problem =
            Problem { pieces: &pieces, accel: self.bounds.accel, jerk: self.jerk, launches };
        let ordinates = problem.solve();
        let Some(mut t_s) = nodes.last().map(|n| n.t_s) else { return };
        pushes.pop();
        let x = ordinates[0][0];
        let jerk = launches[0].jerk(x);
        pushes.push(Push { accel: 0.0, jerk: Some(jerk) });
        t_s += launch_s(&launches[0], jerk);
        for (piece, x) in pieces.iter().zip(&ordinates) {
            nodes.push(Node { at_mm: piece.at_mm, v: x[0].sqrt(), t_s });
            let accel = (x[1] - x[0]) / piece.h;
            pushes.push(Push { accel, jerk: None });
            t_s += piece_s(x, piece.h);
        }
        let (Some(piece), Some(x)) = (pieces.last(), ordinates.last()) else { return };
        let jerk = launches[1].jerk(x[2]);
        nodes.push(Node { at_mm: piece.at_mm + piece.h, v: x[2].sqrt(), t_s });
        pushes.push(Push { accel: (x[2] - x[1]) / piece.h, jerk: Some(jerk) });
        t_s += launch_s(&launches[1], jerk);
        nodes.push(Node { at_mm: self.track.at_mm[run[1]], v: 0.0, t_s });
        pushes.push(Push { accel: 0.0, jerk: None });
    }

    /// From rest over the straight part of a segment.
    fn launch(&self, segment: usize) -> Launch {
        let length = self.track.at_mm[segment + 1] - self.track.at_mm[segment];
        let [v, a, j] = self.along(&self.track.direction(segment));
        let way = (a * a * a / (6.0 * j * j)).min(0.9 * LAUNCH_SHARE * length);
        let feed = feed_cap(
            &self.moves[self.track.owner[segment] as usize],
            &self.track.direction::<N>(segment),
        );
        let launch = Launch::new(way, a, j);
        Launch { most: launch.most.min(feed).min(v * v), ..launch }
    }

    /// The path between the launches in pieces as fine as the speed asks for.
    fn pieces(&self, run: [usize; 2], launches: &[Launch; 2]) -> Vec<Piece<N>> {
        let cells = || Cells::<N>::new(self.track, self.widths, Kernel::Triangle, self.moves, run);
        let from = self.track.at_mm[run[0]];
        let mut passes = Passes::new(self.bounds, from);
        let gate = |cell| Gate::new(&cell, &self.bounds, self.moves);
        passes.gates.extend(cells().map(gate));
        passes.settle(true);
        let begin = from + launches[0].way_mm;
        let end = self.track.at_mm[run[1]] - launches[1].way_mm;
        let cells: Vec<Cell<N>> = cells().collect();
        let rate = (4.5 * self.jerk.iter().copied().fold(f64::INFINITY, f64::min)).sqrt();
        let slow = Slow::new(&cells, &self.jerk, rate, launches);
        let mut grid = Grid { guide: &passes.nodes, place: 0 };
        let mut pieces: Vec<Piece<N>> = Vec::new();
        let (mut at, mut k) = (begin, 0);
        while at < end {
            while k + 1 < cells.len() && cells[k + 1].at_mm <= at {
                k += 1;
            }
            let here = grid.v(at, true).powf(1.5).min(slow.at(k, at));
            let next = (at + FINE * here / rate).min(end);
            let mut last = k;
            while last + 1 < cells.len() && cells[last + 1].at_mm < next {
                last += 1;
            }
            let there = grid.v(next, false).powf(1.5).min(slow.at(last, next));
            let fine = (FINE * here.min(there) / rate).max(LEAST_MM);
            let h = if end - at < 1.5 * fine { end - at } else { fine };
            let guess = here.max(there).powf(4.0 / 3.0);
            let mut piece = Piece::new(at, h, guess);
            for cell in cells[k..].iter().take_while(|c| c.at_mm < at + h) {
                piece.add(cell, &self.bounds, self.moves);
            }
            pieces.push(piece);
            at = if h < end - at { at + h } else { end };
        }
        pieces
    }
}

/// What the jerk allows, as z = x^(3/4): from a slow place it can grow as the distance does.
struct Slow<'a, const N: usize> {
    cells: &'a [Cell<N>],
    /// In each cell, and at its start; one more at the end.
    within: Vec<f64>,
    starts: Vec<f64>,
    rate: f64,
}

impl<'a, const N: usize> Slow<'a, N> {
    fn new(cells: &'a [Cell<N>], jerk: &[f64; N], rate: f64, launches: &[Launch; 2]) -> Self {
        let steady = |cell: &Cell<N>| {
            let most = (0..N).map(|k| jerk[k] / cell.frame.twist[k].abs());
            most.fold(f64::INFINITY, f64::min).sqrt()
        };
        let within: Vec<f64> = cells.iter().map(steady).collect();
        let n = cells.len();
        let mut starts = vec![0.0; n + 1];
        starts[0] = 0.5 * rate * launches[0].way_mm;
        for k in 0..n {
            let next = within.get(k + 1).copied().unwrap_or(0.5 * rate * launches[1].way_mm);
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

/// What the speed would be without a limit of jerk.
struct Grid<'a> {
    guide: &'a [Node],
    place: usize,
}

impl Grid<'_> {
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

fn launch_s(launch: &Launch, jerk: f64) -> f64 {
    (6.0 * launch.way_mm / jerk).cbrt()
}

/// Time over a piece, by Newton's method from the mean of the speeds at its ends.
fn piece_s(x: &[f64; 3], h: f64) -> f64 {
    let start = Node { at_mm: 0.0, v: x[0].sqrt(), t_s: 0.0 };
    let (a0, a1) = ((x[1] - x[0]) / h, (x[2] - x[1]) / h);
    let mut t = 2.0 * h / (start.v + x[2].sqrt());
    for _ in 0..NEWTON {
        let here = swing(&start, a0, (a1 - a0) / h, t);
        if here.v > 0.0 {
            t = (t + (h - here.at_mm) / here.v).max(0.5 * t);
        }
    }
    t
}
