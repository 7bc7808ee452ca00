//! The smoothed path as a row of cells: between the places where a bump begins, peaks or ends, the
//! path's slope is a polynomial.

use super::kernel::{CORNER, Kernel, PARTS};
use super::track::{Track, norm};
use crate::moves::{Basis, Move};

/// A cell turns by no more, radians: how finely a sharp corner is resolved.
const MAX_TURN_RAD: f64 = 0.1;

/// The polynomials start afresh from the bumps after so many cells, so that rounding cannot add up.
const FRESH: u32 = 64;

/// Shorter cells are none, mm.
const NOTHING_MM: f64 = 1e-10;

/// Where the polynomials of a bump change, as shares of its width: its triangles begin, they peak,
/// and they end in reverse order.
const PLACES: [f64; 2 * PARTS + 1] = {
    let mut places = [0.0; 2 * PARTS + 1];
    let mut part = 0;
    while part < PARTS {
        places[part] = -CORNER[part].1;
        places[2 * PARTS - part] = CORNER[part].1;
        part += 1;
    }
    places
};

/// The last of them.
const END: usize = PLACES.len() - 1;

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
    /// The next vertex at each of [`PLACES`] of its bump.
    next: [usize; PLACES.len()],
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
        let mut cells = Self {
            track,
            widths,
            kernel,
            moves,
            last,
            next: [last; PLACES.len()],
            segment: first,
            at_mm: track.at_mm[first],
            frame,
            age: 0,
            pieces: 0,
            piece_mm: 0.0,
        };
        cells.next = std::array::from_fn(|which| cells.corner_from(which, first + 1));
        cells
    }

    fn active(&self) -> bool {
        self.next[0] > self.next[END]
    }

    /// The first vertex from one on, within the run, whose polynomials change at a place.
    fn corner_from(&self, which: usize, vertex: usize) -> usize {
        let changes = |j: &usize| {
            self.widths[*j] > 0.0
                && match (self.kernel, which) {
                    (_, 0 | END) => true,
                    (Kernel::Box, _) => false,
                    (Kernel::Triangle, PARTS) => true,
                    _ => self.kernel.is_corner(norm(&self.track.turn::<N>(*j))),
                }
        };
        if self.kernel == Kernel::Box && which != 0 && which != END {
            return self.last;
        }
        (vertex..self.last).find(changes).unwrap_or(self.last)
    }

    /// Where the next bump has one of its places.
    fn event(&self, which: usize) -> f64 {
        let j = self.next[which];
        if j >= self.last {
            return f64::INFINITY;
        }
        self.track.at_mm[j] + PLACES[which] * self.widths[j]
    }

    /// Takes all events up to here.
    fn take_events(&mut self) {
        for which in 0..PLACES.len() {
            while self.event(which) <= self.at_mm + NOTHING_MM {
                self.take(which);
                self.next[which] = self.corner_from(which, self.next[which] + 1);
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
        let turn = self.track.turn::<N>(j);
        if self.kernel == Kernel::Box {
            let scale = if which == 0 { 0.5 } else { -0.5 } / c;
            return (0..N).for_each(|k| self.frame.bend[k] += scale * turn[k]);
        }
        let twists = self.twists(&turn, c);
        let scale = match which {
            PARTS => -2.0 * twists.iter().sum::<f64>(),
            _ => twists[which.min(END - which)],
        };
        (0..N).for_each(|k| self.frame.twist[k] += scale * turn[k]);
    }

    /// Third derivatives of the triangles of a bump before its peak.
    fn twists(&self, turn: &[f64; N], c: f64) -> [f64; PARTS] {
        if self.kernel == Kernel::Box {
            return [0.0; PARTS];
        }
        self.kernel.parts(norm(turn)).map(|(share, width)| share / (c * width * c * width))
    }

    /// The frame here, summed over the bumps that reach here.
    fn fresh(&self) -> Frame<N> {
        let slope = self.track.direction(self.segment);
        let mut frame = Frame { slope, bend: [0.0; N], twist: [0.0; N] };
        for j in (self.next[END]..self.next[0]).filter(|j| self.widths[*j] > 0.0) {
            let before = j > self.segment;
            let offset = (self.at_mm - self.track.at_mm[j]).abs();
            let offset = offset.max(f64::MIN_POSITIVE) * if before { -1.0 } else { 1.0 };
            let turn = self.track.turn::<N>(j);
            let [_, slope, bend] = self.kernel.shape(norm(&turn), self.widths[j], offset);
            // By the places passed, not by distances, which rounding may see otherwise.
            let within = |part: &usize| (self.next[END - part]..self.next[*part]).contains(&j);
            let twists = self.twists(&turn, self.widths[j]);
            let twist: f64 = (0..PARTS).filter(within).map(|part| twists[part]).sum();
            let twist = if before { twist } else { -twist };
            for (k, turn) in turn.iter().enumerate() {
                frame.slope[k] += slope * turn;
                frame.bend[k] += bend * turn;
                frame.twist[k] += twist * turn;
            }
        }
        frame
    }

    /// Whether another speed holds after a vertex.
    fn feed_changes(&self, vertex: usize) -> bool {
        let of = |segment: usize| &self.moves[self.track.owner[segment] as usize];
        let (a, b) = (of(vertex - 1), of(vertex));
        a.basis != b.basis || a.top_mm_s() != b.top_mm_s()
    }

    /// Where the interval that begins here ends.
    fn interval_end(&self) -> f64 {
        let events = (0..PLACES.len()).map(|which| self.event(which));
        let mut end = events.fold(self.track.at_mm[self.last], f64::min);
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
    if square > 0.0 { m.top_mm_s() * m.top_mm_s() / square } else { f64::INFINITY }
}
