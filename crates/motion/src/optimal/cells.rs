//! The smoothed path as a row of cells: between the places where a bump begins, peaks or ends, the
//! path's slope is a polynomial.

use super::track::{Track, norm};
use super::widths::Kernel;
use crate::moves::{Basis, Move};

/// A cell turns by no more, radians: how finely a sharp corner is resolved.
const MAX_TURN_RAD: f64 = 0.1;

/// The polynomials start afresh from the bumps after so many cells, so that rounding cannot add up.
const FRESH: u32 = 64;

/// Shorter cells are none, mm.
const NOTHING_MM: f64 = 1e-10;

/// Slope and its derivatives by the length: q′, q″, q‴.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame<const N: usize> {
    pub slope: [f64; N],
    pub bend: [f64; N],
    pub twist: [f64; N],
}

impl<const N: usize> Frame<N> {
    /// What they are after a length, the last one being constant.
    pub fn after(&self, h: f64) -> Self {
        let at = |k: usize| self.slope[k] + h * (self.bend[k] + 0.5 * h * self.twist[k]);
        Self {
            slope: std::array::from_fn(at),
            bend: std::array::from_fn(|k| self.bend[k] + h * self.twist[k]),
            twist: self.twist,
        }
    }
}

/// A part of the smoothed path on which the last derivative is constant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell<const N: usize> {
    /// Where it begins, mm along the track.
    pub at_mm: f64,
    /// Its length.
    pub h: f64,
    /// At its beginning.
    pub frame: Frame<N>,
    /// No bump reaches into it.
    pub straight: bool,
    /// The move that limits its speed.
    pub owner: u32,
}

/// Walks along a run and gives its cells.
pub(crate) struct Cells<'a, const N: usize> {
    track: &'a Track,
    widths: &'a [f64],
    kernel: Kernel,
    moves: &'a [Move],
    last: usize,
    /// The next vertex whose bump begins, peaks and ends.
    next: [usize; 3],
    /// The segment on which the walk is.
    segment: usize,
    at_mm: f64,
    frame: Frame<N>,
    age: u32,
    /// What is left of an interval that is cut into equal cells.
    pieces: u32,
    piece_mm: f64,
}

impl<'a, const N: usize> Cells<'a, N> {
    /// The run between two vertices of width zero.
    pub fn new(
        track: &'a Track,
        widths: &'a [f64],
        kernel: Kernel,
        moves: &'a [Move],
        [first, last]: [usize; 2],
    ) -> Self {
        let slope = track.direction(first);
        let frame = Frame { slope, bend: [0.0; N], twist: [0.0; N] };
        let corner = (first + 1..last).find(|j| widths[*j] > 0.0).unwrap_or(last);
        Self {
            track,
            widths,
            kernel,
            moves,
            last,
            next: [corner; 3],
            segment: first,
            at_mm: track.at_mm[first],
            frame,
            age: 0,
            pieces: 0,
            piece_mm: 0.0,
        }
    }

    /// From a place inside a run to the end of the run.
    pub fn from(
        track: &'a Track,
        widths: &'a [f64],
        kernel: Kernel,
        moves: &'a [Move],
        at_mm: f64,
    ) -> Self {
        let segment = track.segment(at_mm);
        let still = |vertex: &usize| widths[*vertex] == 0.0;
        let first = (0..=segment).rev().find(still).unwrap_or(0);
        let last = (segment + 1..track.len()).find(still).unwrap_or(track.len() - 1);
        let mut cells = Self::new(track, widths, kernel, moves, [first, last]);
        cells.at_mm = at_mm;
        cells.segment = segment;
        let ends = |vertex: &usize| track.at_mm[*vertex] + widths[*vertex].abs() <= at_mm;
        let begins = |vertex: &usize| track.at_mm[*vertex] - widths[*vertex].abs() > at_mm;
        let next_end = (first + 1..=segment).rev().find(ends).map_or(first + 1, |j| j + 1);
        let next_start = (segment + 1..last).find(begins).unwrap_or(last);
        cells.next = [next_start, segment + 1, next_end].map(|j| cells.corner_after(j));
        cells.frame = cells.fresh();
        cells
    }

    fn active(&self) -> bool {
        self.next[0] > self.next[2]
    }

    /// The first vertex from one on that is a corner, within the run.
    fn corner_after(&self, vertex: usize) -> usize {
        (vertex..self.last).find(|j| self.widths[*j] > 0.0).unwrap_or(self.last)
    }

    /// Where the next bump begins, peaks or ends.
    fn event(&self, which: usize) -> f64 {
        let j = self.next[which];
        if j >= self.last {
            return f64::INFINITY;
        }
        let offset = (which as f64 - 1.0) * self.widths[j];
        self.track.at_mm[j] + offset
    }

    /// The turn at a vertex.
    fn turn(&self, j: usize) -> [f64; N] {
        let (a, b) = (self.track.direction::<N>(j - 1), self.track.direction::<N>(j));
        std::array::from_fn(|k| b[k] - a[k])
    }

    /// Takes all events up to here.
    fn take_events(&mut self) {
        for which in 0..3 {
            while self.event(which) <= self.at_mm + NOTHING_MM {
                self.take(which);
                self.next[which] = self.corner_after(self.next[which] + 1);
            }
        }
        while self.segment + 1 < self.last
            && self.track.at_mm[self.segment + 1] <= self.at_mm + NOTHING_MM
        {
            self.segment += 1;
        }
        if !self.active() {
            let slope = self.track.direction(self.segment);
            self.frame = Frame { slope, bend: [0.0; N], twist: [0.0; N] };
            self.age = 0;
        } else if self.age > FRESH {
            self.frame = self.fresh();
            self.age = 0;
        }
    }

    fn take(&mut self, which: usize) {
        let j = self.next[which];
        let c = self.widths[j];
        match (self.kernel, which) {
            (Kernel::Box, 1) => {}
            (Kernel::Box, _) => {
                let scale = (1.0 - which as f64) * 0.5 / c;
                let turn = self.turn(j);
                (0..N).for_each(|k| self.frame.bend[k] += scale * turn[k]);
            }
            (Kernel::Triangle, _) => {
                let scale = if which == 1 { -2.0 } else { 1.0 } / (c * c);
                let turn = self.turn(j);
                (0..N).for_each(|k| self.frame.twist[k] += scale * turn[k]);
            }
        }
    }

    /// The frame here, summed over the bumps that reach here.
    fn fresh(&self) -> Frame<N> {
        let slope = self.track.direction(self.segment);
        let mut frame = Frame { slope, bend: [0.0; N], twist: [0.0; N] };
        for j in (self.next[2]..self.next[0]).filter(|j| self.widths[*j] > 0.0) {
            let before = j > self.segment;
            let offset = (self.at_mm - self.track.at_mm[j]).abs() * if before { -1.0 } else { 1.0 };
            let offset = if before { offset.min(-f64::MIN_POSITIVE) } else { offset };
            let [_, slope, bend] = self.kernel.shape(self.widths[j], offset);
            let twist = self.kernel.twist(self.widths[j], before);
            let turn = self.turn(j);
            for k in 0..N {
                frame.slope[k] += slope * turn[k];
                frame.bend[k] += bend * turn[k];
                frame.twist[k] += twist * turn[k];
            }
        }
        frame
    }

    /// Whether another speed holds after a vertex.
    fn feed_changes(&self, vertex: usize) -> bool {
        let of = |segment: usize| &self.moves[self.track.owner[segment] as usize];
        let (a, b) = (of(vertex - 1), of(vertex));
        a.basis != b.basis || a.speed_mm_s != b.speed_mm_s
    }

    /// Where the interval that begins here ends.
    fn interval_end(&self) -> f64 {
        let peak = if self.kernel == Kernel::Box { f64::INFINITY } else { self.event(1) };
        let mut end = self.track.at_mm[self.last].min(self.event(0)).min(peak).min(self.event(2));
        let mut vertex = self.segment + 1;
        while vertex < self.last && self.track.at_mm[vertex] < end {
            if self.feed_changes(vertex) {
                end = self.track.at_mm[vertex];
            }
            vertex += 1;
        }
        end
    }

    fn cut(&mut self, length: f64) {
        let end = self.frame.after(length);
        let turn = norm(&std::array::from_fn::<f64, N, _>(|k| end.slope[k] - self.frame.slope[k]));
        self.pieces = (turn / MAX_TURN_RAD).ceil().max(1.0) as u32;
        self.piece_mm = length / f64::from(self.pieces);
    }
}

impl<const N: usize> Iterator for Cells<'_, N> {
    type Item = Cell<N>;

    fn next(&mut self) -> Option<Cell<N>> {
        if self.pieces == 0 {
            // Past all events: a cell of no length would divide by nothing.
            while self.interval_end() <= self.at_mm + NOTHING_MM {
                if self.at_mm + NOTHING_MM >= self.track.at_mm[self.last] {
                    return None;
                }
                self.at_mm = self.interval_end().max(self.at_mm);
                self.take_events();
            }
            self.cut(self.interval_end() - self.at_mm);
        }
        let straight = !self.active();
        let owner = self.track.owner[self.segment];
        let (at_mm, h, frame) = (self.at_mm, self.piece_mm, self.frame);
        self.frame = frame.after(h);
        self.at_mm += h;
        self.age += 1;
        self.pieces -= 1;
        if self.pieces == 0 {
            self.at_mm = self.interval_end();
            self.take_events();
        }
        Some(Cell { at_mm, h, frame, straight, owner })
    }
}

/// The highest squared speed along the track at which the tool keeps the feed of a move, seen at a
/// slope.
pub(crate) fn feed_cap<const N: usize>(m: &Move, slope: &[f64; N]) -> f64 {
    let counts = |k: usize| match m.basis {
        Basis::Xy => k < 2,
        Basis::Space => k < 3,
        Basis::Axis(axis) => k == axis as usize + 2,
        Basis::Rotary => k > 2,
    };
    let square: f64 = (0..N).filter(|k| counts(*k)).map(|k| slope[k] * slope[k]).sum();
    if square > 0.0 { m.speed_mm_s * m.speed_mm_s / square } else { f64::INFINITY }
}
