//! The path of a stack as a polyline over one length: arcs become chords far finer than the
//! tolerance, every axis counts (a degree as a millimetre), and the chain is cut where the machine
//! must stand.

use crate::leg::{Leg, Shape};
use kerf_program::{AXES, Axes};

/// Share of the tolerance that the chords of an arc may use.
const CHORD_SHARE: f64 = 0.125;

/// Arcs are smoothed within at least this, mm, also where corners must be exact: less than a step.
const ARC_TOLERANCE_MM: f64 = 1e-3;

/// No chord of an arc turns by more, radians.
const MAX_CHORD_RAD: f64 = 0.2;

/// No move is cut into more chords.
const MAX_CHORDS: f64 = 1e6;

/// Chords of a segment that another model had smoothed: it turns by 45° at most.
const CURVE_CHORDS: u32 = 16;

/// Ends of neighbouring moves that are closer are the same place, mm.
const SAME_PLACE_MM: f64 = 1e-6;

/// A polyline over its length, or the part of it that is still needed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Track {
    /// Axes that are stored: 3 when only X, Y and Z move, else all.
    pub dims: usize,
    /// Coordinates of the vertices, `dims` each.
    pub coords: Vec<f64>,
    /// Places of the axes that are not stored.
    rest: Axes,
    /// Length from the start to each vertex, mm.
    pub at_mm: Vec<f64>,
    /// The move to which the segment after each vertex belongs.
    pub owner: Vec<u32>,
    /// The vertices at which the chain is broken: its ends, and its beginnings.
    pub breaks: Vec<bool>,
    tolerance_mm: f64,
}

impl Track {
    /// Of no moves yet.
    pub fn new(dims: usize, tolerance_mm: f64) -> Self {
        Self { dims, tolerance_mm: tolerance_mm.max(0.0), ..Self::default() }
    }

    /// Returns `true` if the axes that are not stored stand still in a move.
    pub fn holds(&self, leg: &Leg) -> bool {
        let stays = |k: usize| self.len() == 0 || leg.from.0[k] == self.rest.0[k];
        !leg.moves_beyond(self.dims) && (self.dims..AXES).all(stays)
    }

    /// Number of vertices.
    pub const fn len(&self) -> usize {
        self.at_mm.len()
    }

    /// Adds the vertices of a move, whose position at a share of its path is asked for; the moves before have
    /// theirs.
    pub fn follow(&mut self, legs: &[Leg], index: usize, position: impl Fn(f64) -> Axes) {
        let m = &legs[index];
        let apart = self.len() == 0 || distance(&legs[index - 1].to, &m.from) > SAME_PLACE_MM;
        if apart {
            self.end();
            self.rest = m.from;
            self.push(&m.from, 0.0, index);
            self.end();
        }
        if let Some(last) = self.owner.last_mut() {
            *last = index as u32;
        }
        let chords = chords(m, self.tolerance_mm);
        let mut before = m.from;
        for k in 1..=chords {
            let place = position(f64::from(k) / f64::from(chords));
            self.push(&place, distance(&before, &place), index);
            before = place;
        }
    }

    /// The chain is broken at the last vertex.
    pub fn end(&mut self) {
        if let Some(last) = self.breaks.last_mut() {
            *last = true;
        }
    }

    fn push(&mut self, place: &Axes, way_mm: f64, owner: usize) {
        let at_mm = self.at_mm.last().map_or(0.0, |s| s + way_mm);
        self.coords.extend_from_slice(&place.0[..self.dims]);
        self.at_mm.push(at_mm);
        self.owner.push(owner as u32);
        self.breaks.push(false);
    }

    /// Stores all axes from here on.
    pub fn widen(&mut self) {
        let place = |v: &[f64]| {
            let mut all = self.rest.0;
            all[..v.len()].copy_from_slice(v);
            all
        };
        self.coords = self.coords.chunks_exact(self.dims).flat_map(place).collect();
        self.dims = AXES;
    }

    /// A part, from one vertex up to another; what lies beyond a last move counts to it.
    pub fn part(&self, from: usize, to: usize, last: usize) -> Self {
        Self {
            dims: self.dims,
            coords: self.coords[from * self.dims..to * self.dims].to_vec(),
            rest: self.rest,
            at_mm: self.at_mm[from..to].to_vec(),
            owner: self.owner[from..to].iter().map(|owner| (*owner).min(last as u32)).collect(),
            breaks: self.breaks[from..to].to_vec(),
            tolerance_mm: self.tolerance_mm,
        }
    }

    /// Forgets the first vertices.
    pub fn forget(&mut self, vertices: usize) {
        self.coords.drain(..vertices * self.dims);
        self.at_mm.drain(..vertices);
        self.owner.drain(..vertices);
        self.breaks.drain(..vertices);
    }

    /// Counts moves from a later one on.
    pub fn count_from(&mut self, first: usize) {
        self.owner.iter_mut().for_each(|owner| *owner = owner.saturating_sub(first as u32));
    }

    /// A vertex.
    pub fn point<const N: usize>(&self, vertex: usize) -> [f64; N] {
        let from = vertex * self.dims;
        let stored = self.dims.min(N);
        let mut place = std::array::from_fn(|k| self.rest.0[k]);
        place[..stored].copy_from_slice(&self.coords[from..from + stored]);
        place
    }

    /// Direction of the segment after a vertex; zero for a segment without length.
    pub fn direction<const N: usize>(&self, segment: usize) -> [f64; N] {
        let way: [f64; N] = if N == self.dims {
            let both = &self.coords[segment * N..(segment + 2) * N];
            std::array::from_fn(|k| both[N + k] - both[k])
        } else {
            let (a, b) = (self.point::<N>(segment), self.point::<N>(segment + 1));
            std::array::from_fn(|k| b[k] - a[k])
        };
        let length = norm(&way);
        let scale = if length > 0.0 { 1.0 / length } else { 0.0 };
        way.map(|w| w * scale)
    }

    /// Change of the direction at a vertex.
    pub fn turn<const N: usize>(&self, vertex: usize) -> [f64; N] {
        let (a, b) = (self.direction::<N>(vertex - 1), self.direction::<N>(vertex));
        std::array::from_fn(|k| b[k] - a[k])
    }

    /// Returns the greatest distance of the path from the polyline at a vertex, mm.
    pub fn tolerance_mm(&self, vertex: usize, legs: &[Leg]) -> f64 {
        let (before, after) = (self.owner[vertex - 1], self.owner[vertex]);
        let arc = |owner: u32| matches!(legs[owner as usize].shape, Shape::Arc { .. });
        if before == after {
            return self.tolerance_mm.max(ARC_TOLERANCE_MM) * (1.0 - CHORD_SHARE);
        }
        let share = if arc(before) || arc(after) { 1.0 - CHORD_SHARE } else { 1.0 };
        self.tolerance_mm * share
    }

    /// Returns `true` if another speed holds after a vertex.
    pub fn feed_changes(&self, vertex: usize, legs: &[Leg]) -> bool {
        let (a, b) = (self.owner[vertex - 1], self.owner[vertex]);
        let (a, b) = (&legs[a as usize], &legs[b as usize]);
        a.basis != b.basis || a.speed_mm_s != b.speed_mm_s
    }

    /// The segment on which a length lies, between two vertices.
    pub fn segment(&self, s_mm: f64) -> usize {
        let later = self.at_mm.partition_point(|at| *at <= s_mm);
        later.clamp(1, self.len() - 1) - 1
    }
}

/// Chords into which a move is cut.
fn chords(m: &Leg, tolerance_mm: f64) -> u32 {
    let (radius_mm, sweep_rad) = match m.shape {
        Shape::Line => return 1,
        Shape::Curve => return CURVE_CHORDS,
        Shape::Arc { radius_mm, sweep_rad } => (radius_mm, sweep_rad),
    };
    let sagitta = tolerance_mm.max(ARC_TOLERANCE_MM) * CHORD_SHARE;
    let radius = radius_mm.max(sagitta);
    let chord_rad = (8.0 * sagitta / radius).sqrt().min(MAX_CHORD_RAD);
    (sweep_rad.abs() / chord_rad).ceil().clamp(1.0, MAX_CHORDS) as u32
}

fn distance(a: &Axes, b: &Axes) -> f64 {
    norm(&a.zip(*b, |a, b| a - b).0)
}

/// Euclidean length.
pub(crate) fn norm<const N: usize>(v: &[f64; N]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_direction_is_the_same_with_axes_that_stand() {
        let mut track = Track::new(3, 0.0);
        for (place, way_mm) in
            [([1.0, 2.0, 3.0], 0.0), ([1.0, 2.0, 3.0], 0.0), ([1.0, 6.0, 3.0], 4.0)]
        {
            track.push(&Axes::xyz(place[0], place[1], place[2]), way_mm, 0);
        }
        assert_eq!(track.direction::<3>(1), [0.0, 1.0, 0.0]);
        assert_eq!(track.direction::<6>(1), [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(track.direction::<6>(0), [0.0; 6], "nothing legs");
    }
}
