//! A path as a chain of straight segments, and its pieces as bytes.

use kerf_control::Clocks;
use kerf_wire::preview::{CUT, Detail, PIECE};

/// A chain of segments; vertices in mm from its origin, machine frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    origin: [f64; 3],
    /// One more than segments.
    vertices: Vec<[f32; 3]>,
    segments: Vec<Segment>,
    /// Greatest distance from the true path, mm.
    tolerance: f64,
}

/// Facts about a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Time when it is over, seconds.
    pub end_s: f32,
    /// Line of the part file.
    pub line: u32,
    /// The move it belongs to.
    pub made: u32,
    /// Jog, cut or nothing.
    pub kind: u8,
}

impl Path {
    /// A path that begins at a place, known as well as a circle is drawn by chords.
    pub fn new(start: [f64; 3], tolerance: f64) -> Self {
        Self { origin: start, vertices: vec![[0.0; 3]], segments: Vec::new(), tolerance }
    }

    /// Returns the origin of the vertices.
    pub const fn origin(&self) -> [f64; 3] {
        self.origin
    }

    /// Returns the number of segments.
    pub fn len(&self) -> usize {
        self.segments.len()
    }

    /// Puts the times of a controller in place of those of the plan.
    pub fn retime(&mut self, clocks: &Clocks) {
        for segment in &mut self.segments {
            segment.end_s = clocks.own_s(f64::from(segment.end_s)) as f32;
        }
    }

    /// Goes on to a place.
    pub fn push(&mut self, to: [f64; 3], segment: Segment) {
        self.vertices.push(std::array::from_fn(|i| (to[i] - self.origin[i]) as f32));
        self.segments.push(segment);
    }

    /// The same path with each vertex elsewhere: by its number and its place in the machine frame.
    pub fn moved(&self, to: impl Fn(usize, [f64; 3]) -> [f64; 3]) -> Self {
        let there = |(number, vertex): (usize, &[f32; 3])| {
            let place = std::array::from_fn(|i| f64::from(vertex[i]) + self.origin[i]);
            let moved = to(number, place);
            std::array::from_fn(|i| (moved[i] - self.origin[i]) as f32)
        };
        Self { vertices: self.vertices.iter().enumerate().map(there).collect(), ..self.clone() }
    }

    /// Returns what a page is told of it.
    pub fn detail(&self) -> Detail {
        Detail {
            tolerance: self.tolerance,
            segments: self.len() as u32,
            pieces: self.len().div_ceil(PIECE) as u32,
        }
    }

    /// Bounds of the cuts, machine frame.
    pub fn cut_bounds(&self) -> Option<[[f64; 3]; 2]> {
        let cuts = self.segments.iter().enumerate().filter(|(_, s)| s.kind == CUT);
        let ends = cuts.flat_map(|(i, _)| [self.vertices[i], self.vertices[i + 1]]);
        let [low, high] = bounds(ends)?;
        let place = |v: [f32; 3]| std::array::from_fn(|i| f64::from(v[i]) + self.origin[i]);
        Some([place(low), place(high)])
    }

    /// Length of the diagonal of its bounds, mm.
    pub fn diagonal(&self) -> f64 {
        let Some([low, high]) = bounds(self.vertices.iter().copied()) else { return 0.0 };
        distance(low, high)
    }

    /// The same path without vertices that are nearer than a tolerance to the one before.
    pub fn coarser(&self, tolerance: f64) -> Self {
        let mut coarser = Self { tolerance, ..Self::new(self.origin, tolerance) };
        for (index, segment) in self.segments.iter().enumerate() {
            let (from, to) = (coarser.vertices[coarser.len()], self.vertices[index + 1]);
            let next = self.segments.get(index + 1);
            let ends = next.is_none_or(|next| next.kind != segment.kind);
            if ends || distance(from, to) >= tolerance {
                coarser.vertices.push(to);
                coarser.segments.push(*segment);
            }
        }
        coarser
    }

    /// A piece as it goes over HTTP (see [`kerf_wire::preview`]); nothing when there is no such piece.
    pub fn piece(&self, number: usize) -> Option<Vec<u8>> {
        let from = number.checked_mul(PIECE)?;
        self.bytes(from, (from + PIECE).min(self.len()))
    }

    /// Its segments: where each begins and ends, machine frame, and its kind.
    pub fn places(&self) -> impl Iterator<Item = ([f64; 3], [f64; 3], u8)> {
        let place = |v: [f32; 3]| std::array::from_fn(|i| f64::from(v[i]) + self.origin[i]);
        let ends = self.vertices.windows(2).map(move |ends| (place(ends[0]), place(ends[1])));
        ends.zip(&self.segments).map(|((from, to), segment)| (from, to, segment.kind))
    }

    /// Leaves out all but its last segments.
    pub fn keep_last(&mut self, segments: usize) {
        let gone = self.len().saturating_sub(segments);
        self.segments.drain(..gone);
        self.vertices.drain(..gone);
    }

    /// Segments from one to before another as they go over HTTP; nothing when there are none.
    pub fn bytes(&self, from: usize, to: usize) -> Option<Vec<u8>> {
        let segments = self.segments.get(from..to).filter(|s| !s.is_empty())?;
        let mut bytes = Vec::with_capacity(20 + segments.len() * 25);
        bytes.extend((segments.len() as u32).to_le_bytes());
        bytes.extend(0u32.to_le_bytes());
        for coordinate in self.vertices[from..=to].iter().flatten() {
            bytes.extend(coordinate.to_le_bytes());
        }
        segments.iter().for_each(|s| bytes.extend(s.end_s.to_le_bytes()));
        segments.iter().for_each(|s| bytes.extend(s.line.to_le_bytes()));
        segments.iter().for_each(|s| bytes.extend(s.made.to_le_bytes()));
        bytes.extend(segments.iter().map(|s| s.kind));
        Some(bytes)
    }
}

fn bounds(places: impl Iterator<Item = [f32; 3]>) -> Option<[[f32; 3]; 2]> {
    places.fold(None, |bounds, at| {
        let [low, high] = bounds.unwrap_or([at, at]);
        let least = std::array::from_fn(|i| low[i].min(at[i]));
        Some([least, std::array::from_fn(|i| high[i].max(at[i]))])
    })
}

fn distance(a: [f32; 3], b: [f32; 3]) -> f64 {
    let square = |i: usize| f64::from(a[i] - b[i]).powi(2);
    (square(0) + square(1) + square(2)).sqrt()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_wire::preview::JOG;

    fn segment(made: u32, kind: u8) -> Segment {
        Segment { end_s: made as f32, line: made + 1, made, kind }
    }

    /// A jog to the start, then a row of cuts a tenth of a millimetre long.
    fn row(count: u32) -> Path {
        let mut path = Path::new([100.0, 0.0, 0.0], 0.0);
        path.push([200.0, 0.0, 0.0], segment(0, JOG));
        for n in 1..=count {
            path.push([200.0 + f64::from(n) * 0.1, 0.0, 0.0], segment(n, CUT));
        }
        path
    }

    #[test]
    fn a_coarser_path_keeps_ends_and_kinds() {
        let coarse = row(1000).coarser(1.0);
        assert_eq!(coarse.segments[0].kind, JOG);
        assert!((100..=102).contains(&coarse.len()), "{}", coarse.len());
        assert_eq!(coarse.vertices.last(), row(1000).vertices.last());
        assert_eq!(coarse.segments.last().unwrap().made, 1000);
    }

    #[test]
    fn a_piece_is_as_long_as_it_says() {
        let path = row(PIECE as u32);
        let count = |bytes: &[u8]| u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
        let first = path.piece(0).unwrap();
        assert_eq!(count(&first), PIECE);
        assert_eq!(first.len(), 8 + 12 * (PIECE + 1) + 13 * PIECE);
        let second = path.piece(1).unwrap();
        assert_eq!((count(&second), second.len()), (1, 8 + 24 + 13));
        // It begins where the first one ends.
        assert_eq!(second[8..20], first[8 + 12 * PIECE..8 + 12 * (PIECE + 1)]);
        assert_eq!(path.piece(2), None);
        assert_eq!(path.piece(usize::MAX), None);
    }

    #[test]
    fn the_last_segments_stay_where_they_were() {
        let mut path = row(9);
        path.keep_last(4);
        assert_eq!(path.bytes(0, 4), row(9).bytes(6, 10));
        assert_eq!((path.len(), path.bytes(4, 4)), (4, None));
    }

    #[test]
    fn bounds_are_those_of_the_cuts() {
        let [low, high] = row(10).cut_bounds().unwrap();
        assert!((low[0] - 200.0).abs() < 1e-4 && (high[0] - 201.0).abs() < 1e-4);
        assert_eq!(Path::new([0.0; 3], 0.0).cut_bounds(), None);
    }
}
