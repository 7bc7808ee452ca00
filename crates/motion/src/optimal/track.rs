//! The path of a stack as a polyline over one length: arcs become chords far finer than the
//! tolerance, every axis counts (a degree as a millimetre), and the chain is cut into runs where the
//! machine must stand.

use crate::moves::{Move, Path};
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

/// A polyline over its length.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Track {
    /// Axes that are stored: 3 when only X, Y and Z move, else all.
    pub dims: usize,
    /// Coordinates of the vertices, `dims` each.
    coords: Vec<f64>,
    /// Length from the start to each vertex, mm.
    pub at_mm: Vec<f64>,
    /// The move to which the segment after each vertex belongs.
    pub owner: Vec<u32>,
    tolerance_mm: f64,
}

impl Track {
    /// The polyline of moves, and the vertices at which the chain is broken.
    pub fn of(moves: &[Move], tolerance_mm: f64) -> (Self, Vec<usize>) {
        let flat = |m: &Move| (3..AXES).all(|k| m.from.0[k] == m.to.0[k]);
        let dims = if moves.iter().all(flat) { 3 } else { AXES };
        let mut track = Self { dims, tolerance_mm, ..Self::default() };
        track.coords.reserve((moves.len() + 1) * dims);
        let mut breaks = Vec::new();
        for (i, m) in moves.iter().enumerate() {
            let apart = i == 0 || distance(&moves[i - 1].to, &m.from) > SAME_PLACE_MM;
            if apart {
                breaks.push(track.len());
                track.push(&m.from, 0.0, i);
            }
            track.follow(m, i);
        }
        (track, breaks)
    }

    /// Number of vertices.
    pub const fn len(&self) -> usize {
        self.at_mm.len()
    }

    fn push(&mut self, place: &Axes, way_mm: f64, owner: usize) {
        let at_mm = self.at_mm.last().map_or(0.0, |s| s + way_mm);
        self.coords.extend_from_slice(&place.0[..self.dims]);
        self.at_mm.push(at_mm);
        self.owner.push(owner as u32);
    }

    /// Adds the vertices of a move after its start.
    fn follow(&mut self, m: &Move, index: usize) {
        if let Some(last) = self.owner.last_mut() {
            *last = index as u32;
        }
        let chords = chords(m, self.tolerance_mm);
        let mut before = m.from;
        for k in 1..=chords {
            let place = m.position(f64::from(k) / f64::from(chords));
            self.push(&place, distance(&before, &place), index);
            before = place;
        }
    }

    /// A vertex.
    pub fn point<const N: usize>(&self, vertex: usize) -> [f64; N] {
        let mut place = [0.0; N];
        let from = vertex * self.dims;
        let stored = self.dims.min(N);
        place[..stored].copy_from_slice(&self.coords[from..from + stored]);
        place
    }

    /// Direction of the segment after a vertex; zero for a segment without length.
    pub fn direction<const N: usize>(&self, segment: usize) -> [f64; N] {
        let (a, b) = (self.point::<N>(segment), self.point::<N>(segment + 1));
        let way: [f64; N] = std::array::from_fn(|k| b[k] - a[k]);
        let length = norm(&way);
        let scale = if length > 0.0 { 1.0 / length } else { 0.0 };
        way.map(|w| w * scale)
    }

    /// Change of the direction at a vertex.
    pub fn turn<const N: usize>(&self, vertex: usize) -> [f64; N] {
        let (a, b) = (self.direction::<N>(vertex - 1), self.direction::<N>(vertex));
        std::array::from_fn(|k| b[k] - a[k])
    }

    /// How far the path may leave the polyline at a vertex, mm.
    pub fn tolerance_mm(&self, vertex: usize, moves: &[Move]) -> f64 {
        let (before, after) = (self.owner[vertex - 1], self.owner[vertex]);
        let arc = |owner: u32| matches!(moves[owner as usize].path, Path::Arc { .. });
        if before == after {
            return self.tolerance_mm.max(ARC_TOLERANCE_MM) * (1.0 - CHORD_SHARE);
        }
        let share = if arc(before) || arc(after) { 1.0 - CHORD_SHARE } else { 1.0 };
        self.tolerance_mm * share
    }

    /// The segment on which a length lies, between two vertices.
    pub fn segment(&self, s_mm: f64) -> usize {
        let later = self.at_mm.partition_point(|at| *at <= s_mm);
        later.clamp(1, self.len() - 1) - 1
    }
}

/// Chords into which a move is cut.
fn chords(m: &Move, tolerance_mm: f64) -> u32 {
    let (centre, sweep_rad) = match m.path {
        Path::Line => return 1,
        Path::Curve { .. } => return CURVE_CHORDS,
        Path::Arc { centre, sweep_rad, .. } => (centre, sweep_rad),
    };
    let (x, y) = (m.from.0[0] - centre[0], m.from.0[1] - centre[1]);
    let sagitta = tolerance_mm.max(ARC_TOLERANCE_MM) * CHORD_SHARE;
    let radius = (x * x + y * y).sqrt().max(sagitta);
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
