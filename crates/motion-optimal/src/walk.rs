//! Walks along a path smoothed with boxes and gives its cells: between the places where a bump
//! begins or ends its curvature is constant.

use crate::axes::padded;
use crate::cells::{Cell, Frame};
use crate::leg::Leg;
use crate::track::Track;
use crate::widths::Smoothing;

/// The polynomials start afresh from the bumps after so many cells, so that rounding cannot add up.
const FRESH: u32 = 64;

/// Shorter cells are none, mm.
const NOTHING_MM: f64 = 1e-9;

/// State of a walk along a smoothed path.
#[derive(Clone, Debug)]
pub(crate) struct Walk<const N: usize> {
    /// The segment on which it is.
    segment: usize,
    /// The next vertices whose bumps begin and end.
    begin: usize,
    end: usize,
    at_mm: f64,
    slope: [f64; N],
    bend: [f64; N],
    age: u32,
}

/// The smoothed path of a walk.
pub(crate) struct Smoothed<'a, const N: usize> {
    pub track: &'a Track,
    pub smoothing: &'a Smoothing<N>,
    /// Those that are final.
    pub widths: &'a [f64],
    pub legs: &'a [Leg],
}

impl<const N: usize> Walk<N> {
    /// At the first vertex.
    pub const fn new() -> Self {
        Self { segment: 0, begin: 1, end: 1, at_mm: 0.0, slope: [0.0; N], bend: [0.0; N], age: 0 }
    }

    /// The same with more axes, which stood still.
    pub fn widen<const M: usize>(&self) -> Walk<M> {
        Walk {
            segment: self.segment,
            begin: self.begin,
            end: self.end,
            at_mm: self.at_mm,
            slope: padded(&self.slope),
            bend: padded(&self.bend),
            age: self.age,
        }
    }

    /// The first vertex that is still needed.
    pub const fn needs(&self) -> usize {
        if self.end < self.segment { self.end } else { self.segment }
    }

    /// Forgets the first vertices.
    pub fn forget(&mut self, vertices: usize) {
        self.segment -= vertices;
        self.begin -= vertices;
        self.end -= vertices;
    }

    /// The next cell, and whether the machine stands where it begins; `None` where widths are not
    /// known yet.
    pub fn next(&mut self, path: &Smoothed<'_, N>) -> Option<(Cell<N>, bool)> {
        let at = &path.track.at_mm;
        let known = path.widths.len();
        loop {
            self.pass(path);
            let last = known.checked_sub(1)?;
            // Later bumps begin after the last that is known.
            let limit = at[last] - path.widths[last].abs();
            let end = self.interval_end(path).min(at[last]);
            if end > limit && !path.smoothing.stops(last) || self.segment >= last {
                return None;
            }
            let stands = self.stands(path);
            // From rest to rest a cell needs a place between where the speed is not zero.
            let end = if stands { 0.5 * (self.at_mm + end) } else { end };
            let h = end - self.at_mm;
            let begun = self.at_mm;
            self.at_mm = end;
            if h <= NOTHING_MM {
                continue;
            }
            let frame = Frame { slope: self.slope, bend: self.bend, twist: [0.0; N] };
            self.slope = frame.after(h).slope;
            self.age += 1;
            let straight = self.begin <= self.end;
            let owner = path.track.owner[self.segment];
            return Some((Cell { at_mm: begun, h, frame, straight, owner }, stands));
        }
    }

    /// Returns `true` if the machine stands here: another direction may follow.
    fn stands(&self, path: &Smoothed<'_, N>) -> bool {
        path.smoothing.stops(self.segment)
            && self.at_mm <= path.track.at_mm[self.segment] + NOTHING_MM
    }

    /// Takes all that changes up to here.
    fn pass(&mut self, path: &Smoothed<'_, N>) {
        let (at, widths) = (&path.track.at_mm, path.widths);
        let here = self.at_mm + NOTHING_MM;
        self.begin = self.bump(path, self.begin, |j| at[j] - widths[j] <= here, 0.5);
        self.end = self.bump(path, self.end, |j| at[j] + widths[j] <= here, -0.5);
        while self.segment + 1 < widths.len() && at[self.segment + 1] <= here {
            self.segment += 1;
        }
        if self.begin <= self.end {
            self.end = self.begin;
            self.slope = path.smoothing.directions[self.segment];
            self.bend = [0.0; N];
            self.age = 0;
        } else if self.age > FRESH || self.stands(path) {
            self.refresh(path);
        }
    }

    /// Goes on over vertices whose bumps begin or end here.
    fn bump(
        &mut self,
        path: &Smoothed<'_, N>,
        mut j: usize,
        here: impl Fn(usize) -> bool,
        half: f64,
    ) -> usize {
        while j < path.widths.len() {
            let width = path.widths[j];
            if width > 0.0 {
                if !here(j) {
                    break;
                }
                let turn = path.smoothing.turn_at(j);
                (0..N).for_each(|k| self.bend[k] += half / width * turn[k]);
            } else if half < 0.0 && j >= self.begin {
                break;
            }
            j += 1;
        }
        j
    }

    /// The sum of the bumps that reach here.
    fn refresh(&mut self, path: &Smoothed<'_, N>) {
        self.age = 0;
        self.slope = path.smoothing.directions[self.segment];
        self.bend = [0.0; N];
        for j in (self.end..self.begin).filter(|j| path.widths[*j] > 0.0) {
            let c = path.widths[j];
            let after = j <= self.segment;
            let left = c - (self.at_mm - path.track.at_mm[j]).abs();
            let slope = if after { -0.5 } else { 0.5 } * left / c;
            let turn = path.smoothing.turn_at(j);
            for (k, turn) in turn.iter().enumerate() {
                self.slope[k] += slope * turn;
                self.bend[k] += 0.5 / c * turn;
            }
        }
    }

    /// Returns the end of the interval that begins here.
    fn interval_end(&self, path: &Smoothed<'_, N>) -> f64 {
        let (at, widths) = (&path.track.at_mm, path.widths);
        let mut end = f64::INFINITY;
        if self.begin < widths.len() {
            end = at[self.begin] - widths[self.begin];
        }
        if self.end < self.begin {
            end = end.min(at[self.end] + widths[self.end]);
        }
        let mut vertex = self.segment + 1;
        while vertex < widths.len() && at[vertex] < end {
            if path.smoothing.stops(vertex) || path.track.feed_changes(vertex, path.legs) {
                return at[vertex];
            }
            vertex += 1;
        }
        end
    }
}
