//! Conditions that have to hold before anything is computed, and the tidying that makes them hold.

use super::{Polyarc, Vertex};
use crate::segment::square;
use crate::{GeomError, Point2, tol};

impl Polyarc {
    /// Checks that every number is finite and every place, the tops of arcs too, within
    /// [`tol::FARTHEST_MM`].
    ///
    /// # Errors
    /// Names the first vertex that is not.
    pub fn check(&self) -> Result<(), GeomError> {
        for (vertex, v) in self.vertices.iter().enumerate() {
            if !(v.at.x.is_finite() && v.at.y.is_finite() && v.bulge.is_finite()) {
                return Err(GeomError::NotFinite { vertex });
            }
            if v.at.x.abs().max(v.at.y.abs()) > tol::FARTHEST_MM {
                return Err(GeomError::TooFar { vertex });
            }
        }
        let rises = |vertex: &usize| {
            let from = self.vertices[*vertex];
            let to = self.vertices.get(vertex + 1).unwrap_or(&self.vertices[0]);
            let rise_squared = || 0.25 * from.bulge * from.bulge * square(to.at - from.at);
            from.bulge != 0.0 && rise_squared() > tol::FARTHEST_MM * tol::FARTHEST_MM
        };
        let far = (0..self.segment_count()).find(rises);
        far.map_or(Ok(()), |vertex| Err(GeomError::TooFar { vertex }))
    }

    /// The same path without segments shorter than [`tol::SAME_PLACE_MM`]. A closed polyarc that
    /// ends where it began loses the repeated vertex.
    #[must_use]
    pub fn tidied(&self) -> Self {
        let mut vertices: Vec<Vertex> = Vec::with_capacity(self.vertices.len());
        for &v in &self.vertices {
            match vertices.last_mut() {
                // The segment between the two has no length; the curve that goes on is the later one.
                Some(last) if last.at.distance(v.at) <= tol::SAME_PLACE_MM => last.bulge = v.bulge,
                _ => vertices.push(v),
            }
        }
        while let (true, [first, .., last]) = (self.closed, vertices.as_slice()) {
            if first.at.distance(last.at) > tol::SAME_PLACE_MM {
                break;
            }
            vertices.pop();
        }
        Self { vertices, closed: self.closed }
    }

    /// Tidied and with short arcs, in an empty list; to `names` is added for each segment of the result the segment it was a part
    /// of.
    pub(crate) fn tidied_with_names(&self, vertices: Vec<Vertex>, names: &mut Vec<usize>) -> Self {
        let near = |a: Point2, b: Point2| square(a - b) <= tol::SAME_PLACE_MM * tol::SAME_PLACE_MM;
        let mut ready = Self { vertices, closed: self.closed };
        ready.vertices.reserve(self.vertices.len());
        let count = self.segment_count();
        for (number, v) in self.vertices.iter().enumerate() {
            let is_last = number == count;
            match ready.vertices.last_mut() {
                Some(last) if near(last.at, v.at) => {
                    last.bulge = v.bulge;
                    names.pop();
                }
                _ => ready.vertices.push(*v),
            }
            if is_last {
                break;
            }
            names.push(number);
            if v.bulge.abs() > 1.0 {
                let (a, b) = self.segment(number).split(0.5);
                ready.vertices.pop();
                ready.vertices.extend([a, b].map(|s| Vertex { at: s.start(), bulge: s.bulge() }));
                names.push(number);
            }
        }
        while let (true, [first, .., last]) = (self.closed, ready.vertices.as_slice()) {
            if !near(first.at, last.at) {
                break;
            }
            ready.vertices.pop();
            names.pop();
        }
        ready
    }

    /// The same path with no arc of more than half a circle: each is cut into equal parts.
    #[must_use]
    pub fn with_short_arcs(&self) -> Self {
        if self.vertices.iter().all(|v| v.bulge.abs() <= 1.0) {
            return self.clone();
        }
        let mut vertices = Vec::with_capacity(self.vertices.len() + 4);
        for (number, &v) in self.vertices.iter().enumerate() {
            vertices.push(v);
            if v.bulge.abs() > 1.0 && number < self.segment_count() {
                vertices.pop();
                let (a, b) = self.segment(number).split(0.5);
                vertices.extend([a, b].map(|s| Vertex { at: s.start(), bulge: s.bulge() }));
            }
        }
        Self { vertices, closed: self.closed }
    }
}
