//! Draws what was typed, as the machine makes it.

use super::pen::Pen;
use kerf_trace::ExecutedMove;
use kerf_wire::preview::TypedPath;

/// Segments that pages draw many times a second; beyond them the older half is no longer drawn.
const MOST: usize = 20_000;

/// The path of what was typed since it began anew. Vertices are in the machine's frame.
#[derive(Debug)]
pub struct Typed {
    key: u32,
    pen: Pen,
}

impl Default for Typed {
    fn default() -> Self {
        Self { key: 0, pen: Pen::new([0.0; 3]) }
    }
}

impl Typed {
    /// Draws a move.
    pub fn follow(&mut self, made: &ExecutedMove<'_>) {
        self.pen.follow(made, 0, 0);
        self.shorten();
    }

    /// Of too many segments the later half stays.
    fn shorten(&mut self) {
        if self.pen.path.len() > MOST {
            self.pen.path.keep_last(MOST / 2);
            self.key += 1;
        }
    }

    /// Begins anew.
    pub fn clear(&mut self) {
        *self = Self { key: self.key + 1, ..Self::default() };
    }

    /// Returns what pages are told of it.
    pub fn summary(&self) -> TypedPath {
        TypedPath { key: self.key, segments: self.pen.path.len() as u32 }
    }

    /// Its segments from one on, as they go over HTTP; nothing where there are none, or it began anew.
    pub fn piece(&self, key: u32, from: usize) -> Option<Vec<u8>> {
        let path = Some(&self.pen.path).filter(|_| key == self.key)?;
        path.bytes(from, path.len())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::path::Segment;
    use super::*;
    use kerf_wire::preview::CUT;

    #[test]
    fn what_begins_anew_is_known_by_another_key() {
        let mut typed = Typed::default();
        assert_eq!(typed.summary(), TypedPath { key: 0, segments: 0 });
        assert_eq!(typed.piece(0, 0), None);
        typed.clear();
        assert_eq!(typed.summary(), TypedPath { key: 1, segments: 0 });
    }

    #[test]
    fn of_very_many_segments_the_later_half_is_drawn_on() {
        let mut typed = Typed::default();
        let segment = |made| Segment { end_s: 0.0, line: 1, made, kind: CUT };
        (0..MOST as u32)
            .for_each(|made| typed.pen.path.push([f64::from(made), 0.0, 0.0], segment(made)));
        typed.shorten();
        assert_eq!(typed.summary(), TypedPath { key: 0, segments: MOST as u32 });
        typed.pen.path.push([0.0; 3], segment(0));
        typed.shorten();
        assert_eq!(typed.summary(), TypedPath { key: 1, segments: MOST as u32 / 2 });
    }
}
