//! The same path with another start or the other direction, and parts of it.

use super::{Place, Polyarc, Vertex};
use crate::{Segment, Transform2, tol};

impl Polyarc {
    /// Travelled the other way. A closed polyarc keeps its start.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let count = self.vertices.len();
        let bulge = |number: usize| {
            if number < self.segment_count() { -self.vertices[number].bulge } else { 0.0 }
        };
        let shift = usize::from(self.closed);
        let vertices = (0..count)
            .map(|k| {
                let at = self.vertices[(2 * count - 1 - k + shift) % count].at;
                let before = (2 * count - 2 - k + shift) % count;
                Vertex { at, bulge: if self.closed || k + 1 < count { bulge(before) } else { 0.0 } }
            })
            .collect();
        Self { vertices, closed: self.closed }
    }

    /// A closed polyarc that starts at a place of its path, which becomes a vertex if it is none. An
    /// open one is returned as it is.
    #[must_use]
    pub fn started_at(&self, place: &Place) -> Self {
        if !self.closed || place.segment >= self.segment_count() {
            return self.clone();
        }
        let (mut split, number) = self.with_vertex_at(place);
        split.vertices.rotate_left(number);
        split
    }

    /// The same path with a vertex at a place, and the number of that vertex.
    #[must_use]
    pub fn with_vertex_at(&self, place: &Place) -> (Self, usize) {
        let mut result = self.clone();
        if place.segment >= self.segment_count() {
            return (result, 0);
        }
        let segment = self.segment(place.segment);
        if place.at.distance(segment.start()) <= tol::SAME_PLACE_MM {
            return (result, place.segment);
        }
        if place.at.distance(segment.end()) <= tol::SAME_PLACE_MM {
            return (result, (place.segment + 1) % self.vertices.len());
        }
        let (before, after) = segment.split(place.share);
        result.vertices[place.segment].bulge = before.bulge();
        let vertex = Vertex { at: place.at, bulge: after.bulge() };
        result.vertices.insert(place.segment + 1, vertex);
        (result, place.segment + 1)
    }

    /// The part of the path from one place to another, in the direction of travel. On a closed
    /// polyarc it may run past the start; equal places give the whole way round.
    #[must_use]
    pub fn between(&self, from: &Place, to: &Place) -> Self {
        let wraps = (to.segment, to.share) <= (from.segment, from.share);
        let count = self.segment_count();
        if count == 0 || (wraps && !self.closed) {
            return Self::default();
        }
        let mut parts: Vec<Segment> = Vec::new();
        if !wraps && from.segment == to.segment {
            parts.push(self.segment(from.segment).part(from.share, to.share));
            return Self::from_segments(&parts, false);
        }
        let last = if wraps { to.segment + count } else { to.segment };
        parts.push(self.segment(from.segment).part(from.share, 1.0));
        parts.extend((from.segment + 1..last).map(|n| self.segment(n % count)));
        parts.push(self.segment(to.segment).part(0.0, to.share));
        parts.retain(|s| s.length() > tol::SAME_PLACE_MM);
        Self::from_segments(&parts, false)
    }

    /// Moved, turned, scaled or mirrored. For transforms that keep circles circular
    /// ([`Transform2::keeps_circles`]).
    #[must_use]
    pub fn similar(&self, transform: &Transform2) -> Self {
        let sign = transform.determinant().signum();
        let moved = |v: &Vertex| Vertex { at: transform.apply(v.at), bulge: v.bulge * sign };
        Self { vertices: self.vertices.iter().map(moved).collect(), closed: self.closed }
    }
}
