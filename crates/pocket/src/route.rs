//! Pieces of path put together, with the tool down wherever that is possible.

use crate::inside::Inside;
use kerf_geom::{Point2, Polyarc, Segment, tol};

/// Paths that grow at the end of the last one.
pub(crate) struct Route<'a> {
    inside: &'a Inside,
    done: Vec<Polyarc>,
    now: Vec<Segment>,
}

impl<'a> Route<'a> {
    pub fn new(inside: &'a Inside) -> Self {
        Self { inside, done: Vec::new(), now: Vec::new() }
    }

    /// Returns the place of the tool; nothing when it is up.
    pub fn end(&self) -> Option<Point2> {
        self.now.last().map(Segment::end)
    }

    /// Goes to the beginning of a piece and follows it: straight where the centre may go so, else along one
    /// of the rings if both places lie on it, else through the air.
    pub fn add(&mut self, piece: Polyarc, rings: &[Polyarc]) {
        let Some(start) = piece.start() else { return };
        if let Some(end) = self.end() {
            match self.way(end, start, rings) {
                Some(way) => self.now.extend(way),
                None => self.lift(),
            }
        }
        self.now.extend(piece.segments());
    }

    fn way(&self, from: Point2, to: Point2, rings: &[Polyarc]) -> Option<Vec<Segment>> {
        if self.inside.joins(from, to) {
            return Some(vec![Segment::line(from, to)]);
        }
        rings.iter().find_map(|ring| along(ring, from, to))
    }

    /// Ends the path.
    pub fn lift(&mut self) {
        let mut segments = std::mem::take(&mut self.now);
        segments.retain(|segment| segment.length() > tol::SAME_PLACE_MM);
        if !segments.is_empty() {
            self.done.push(Polyarc::from_segments(&segments, false));
        }
    }

    /// All paths.
    pub fn paths(mut self) -> Vec<Polyarc> {
        self.lift();
        self.done
    }
}

/// The shorter way along a ring that both places lie on.
fn along(ring: &Polyarc, from: Point2, to: Point2) -> Option<Vec<Segment>> {
    let on = |at: Point2| ring.nearest(at).filter(|found| found.1 <= 10.0 * tol::SAME_PLACE_MM);
    let ((from, _), (to, _)) = (on(from)?, on(to)?);
    let (there, back) = (ring.between(&from, &to), ring.between(&to, &from).reversed());
    let shorter = if back.length() < there.length() { back } else { there };
    Some(shorter.segments().collect())
}
