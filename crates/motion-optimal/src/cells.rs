//! The smoothed path as a row of cells: between the places where a bump begins, peaks or ends, the
//! path's slope is a polynomial.

use crate::axes::padded;
use crate::kernel::{CORNER, Kernel, PARTS};
use crate::leg::Leg;
use crate::track::{Track, norm};

/// A cell turns by no more, radians: how finely a sharp corner is resolved.
const MAX_TURN_RAD: f64 = 0.1;

/// The polynomials start afresh from the bumps after so many cells, so that rounding cannot add up.
const FRESH: u32 = 64;

/// Shorter cells are none, mm.
const NOTHING_MM: f64 = 1e-10;

/// Places where the polynomials of a bump change, as shares of its width: its triangles begin, they peak,
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
    /// Returns slope and derivatives after a length, the last one being constant.
    pub fn after(&self, h: f64) -> Self {
        let at = |k: usize| self.slope[k] + h * (self.bend[k] + 0.5 * h * self.twist[k]);
        Self {
            slope: std::array::from_fn(at),
            bend: std::array::from_fn(|k| self.bend[k] + h * self.twist[k]),
            twist: self.twist,
        }
    }

    /// The same with more axes, which stood still.
    pub fn widen<const M: usize>(&self) -> Frame<M> {
        Frame { slope: padded(&self.slope), bend: padded(&self.bend), twist: padded(&self.twist) }
    }
}

/// A part of the smoothed path on which the last derivative is constant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell<const N: usize> {
    /// Place where it begins, mm along the track.
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

impl<const N: usize> Cell<N> {
    /// Returns the part of it that lies after a place.
    pub fn after(&self, at_mm: f64) -> Self {
        let way = at_mm - self.at_mm;
        Self { at_mm, h: self.h - way, frame: self.frame.after(way), ..*self }
    }

    /// The same with more axes, which stood still.
    pub fn widen<const M: usize>(&self) -> Cell<M> {
        let Self { at_mm, h, straight, owner, .. } = *self;
        Cell { at_mm, h, frame: self.frame.widen(), straight, owner }
    }
}

/// The path of a walk as far as its widths are final.
#[derive(Clone, Copy)]
pub(crate) struct Known<'a> {
    pub track: &'a Track,
    pub widths: &'a [f64],
    pub legs: &'a [Leg],
    /// The last vertex of the run that is known.
    pub last: usize,
    /// The run ends there.
    pub ended: bool,
}

/// Walks along a run smoothed with triangles and gives its cells, as far as the path is known.
#[derive(Clone, Debug)]
pub(crate) struct Cells<const N: usize> {
    /// The next vertex at each of [`PLACES`] of its bump.
    next: [usize; PLACES.len()],
    /// The segment on which the walk is.
    segment: usize,
    at_mm: f64,
    frame: Frame<N>,
    age: u32,
    /// Number of cells left of an interval that is cut into equal ones.
    pieces: u32,
    piece_mm: f64,
}

impl<const N: usize> Cells<N> {
    /// A run that begins at a vertex where the machine stands.
    pub fn new(track: &Track, first: usize) -> Self {
        let frame = Frame { slope: track.direction(first), bend: [0.0; N], twist: [0.0; N] };
        let next = [first + 1; PLACES.len()];
        let at_mm = track.at_mm[first];
        Self { next, segment: first, at_mm, frame, age: 0, pieces: 0, piece_mm: 0.0 }
    }

    /// The same with more axes, which stood still.
    pub fn widen<const M: usize>(&self) -> Cells<M> {
        Cells {
            next: self.next,
            segment: self.segment,
            at_mm: self.at_mm,
            frame: self.frame.widen(),
            age: self.age,
            pieces: self.pieces,
            piece_mm: self.piece_mm,
        }
    }

    /// The first vertex that is still needed.
    pub fn needs(&self) -> usize {
        self.next[END].min(self.segment)
    }

    /// Forgets the first vertices.
    pub fn forget(&mut self, vertices: usize) {
        self.segment -= vertices;
        self.next.iter_mut().for_each(|vertex| *vertex -= vertices);
    }

    /// Looks again for the next vertices, among those that are known now.
    pub fn resume(&mut self, path: &Known<'_>) {
        self.next = std::array::from_fn(|which| self.corner_from(path, which, self.next[which]));
    }

    const fn active(&self) -> bool {
        self.next[0] > self.next[END]
    }

    /// The first vertex from one on, within the run, whose polynomials change at a place.
    fn corner_from(&self, path: &Known<'_>, which: usize, vertex: usize) -> usize {
        let changes = |j: &usize| {
            path.widths[*j] > 0.0
                && (matches!(which, 0 | PARTS | END)
                    || Kernel::Triangle.is_corner(norm(&path.track.turn::<N>(*j))))
        };
        (vertex..path.last).find(changes).unwrap_or(path.last.max(vertex))
    }

    /// Returns the place where the next bump has one of its [`PLACES`].
    fn event(&self, path: &Known<'_>, which: usize) -> f64 {
        let j = self.next[which];
        if j >= path.last {
            return f64::INFINITY;
        }
        path.track.at_mm[j] + PLACES[which] * path.widths[j]
    }

    /// Takes all events up to here.
    fn take_events(&mut self, path: &Known<'_>) {
        for which in 0..PLACES.len() {
            while self.event(path, which) <= self.at_mm + NOTHING_MM {
                self.take(path, which);
                self.next[which] = self.corner_from(path, which, self.next[which] + 1);
            }
        }
        while self.segment + 1 < path.last
            && path.track.at_mm[self.segment + 1] <= self.at_mm + NOTHING_MM
        {
            self.segment += 1;
        }
        if !self.active() {
            let slope = path.track.direction(self.segment);
            self.frame = Frame { slope, bend: [0.0; N], twist: [0.0; N] };
            self.age = 0;
        } else if self.age > FRESH {
            self.frame = self.fresh(path);
            self.age = 0;
        }
    }

    fn take(&mut self, path: &Known<'_>, which: usize) {
        let j = self.next[which];
        let turn = path.track.turn::<N>(j);
        let twists = twists(&turn, path.widths[j]);
        let scale = match which {
            PARTS => -2.0 * twists.iter().sum::<f64>(),
            _ => twists[which.min(END - which)],
        };
        (0..N).for_each(|k| self.frame.twist[k] += scale * turn[k]);
    }

    /// The frame here, summed over the bumps that reach here.
    fn fresh(&self, path: &Known<'_>) -> Frame<N> {
        let slope = path.track.direction(self.segment);
        let mut frame = Frame { slope, bend: [0.0; N], twist: [0.0; N] };
        for j in (self.next[END]..self.next[0]).filter(|j| path.widths[*j] > 0.0) {
            let before = j > self.segment;
            let offset = (self.at_mm - path.track.at_mm[j]).abs();
            let offset = offset.max(f64::MIN_POSITIVE) * if before { -1.0 } else { 1.0 };
            let turn = path.track.turn::<N>(j);
            let [_, slope, bend] =
                Kernel::Triangle.shape(turn.iter().map(|x| x * x).sum(), path.widths[j], offset);
            // By the places passed, not by distances, which rounding may see otherwise.
            let within = |part: &usize| (self.next[END - part]..self.next[*part]).contains(&j);
            let twists = twists(&turn, path.widths[j]);
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

    /// Returns the end of the interval that begins here.
    fn interval_end(&self, path: &Known<'_>) -> f64 {
        let at = &path.track.at_mm;
        let events = (0..PLACES.len()).map(|which| self.event(path, which));
        let mut end = events.fold(at[path.last], f64::min);
        let mut vertex = self.segment + 1;
        while vertex < path.last && at[vertex] < end {
            if feed_changes(path, vertex) {
                end = at[vertex];
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

    /// The next cell; `None` at the end, or where the path is not known yet.
    pub fn next(&mut self, path: &Known<'_>) -> Option<Cell<N>> {
        let at = &path.track.at_mm;
        // Bumps of later vertices begin after that of the last that is known.
        let limit =
            if path.ended { f64::INFINITY } else { at[path.last] - path.widths[path.last].abs() };
        if self.pieces == 0 {
            // Past all events: a cell of no length would divide by nothing.
            while self.interval_end(path) <= self.at_mm + NOTHING_MM {
                if self.at_mm + NOTHING_MM >= at[path.last].min(limit) {
                    return None;
                }
                self.at_mm = self.interval_end(path).max(self.at_mm);
                self.take_events(path);
            }
            let end = self.interval_end(path);
            if end > limit {
                return None;
            }
            self.cut(end - self.at_mm);
        }
        let straight = !self.active();
        let owner = path.track.owner[self.segment];
        let (at_mm, h, frame) = (self.at_mm, self.piece_mm, self.frame);
        self.frame = frame.after(h);
        self.at_mm += h;
        self.age += 1;
        self.pieces -= 1;
        if self.pieces == 0 {
            self.at_mm = self.interval_end(path);
            self.take_events(path);
        }
        Some(Cell { at_mm, h, frame, straight, owner })
    }
}

/// Third derivatives of the triangles of a bump before its peak.
fn twists<const N: usize>(turn: &[f64; N], c: f64) -> [f64; PARTS] {
    Kernel::Triangle.parts(norm(turn)).map(|(share, width)| share / (c * width * c * width))
}

/// Returns `true` if another speed holds after a vertex.
fn feed_changes(path: &Known<'_>, vertex: usize) -> bool {
    let of = |segment: usize| &path.legs[path.track.owner[segment] as usize];
    let (a, b) = (of(vertex - 1), of(vertex));
    a.basis != b.basis || a.top_mm_s != b.top_mm_s
}
