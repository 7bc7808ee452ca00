//! The same path otherwise: with another start or the other direction, tidied, merged, and parts of it.

use super::place::PolyarcPlace;
use super::{Polyarc, Vertex};
use crate::segment::square;
use crate::{Point2, Segment, Transform2, tol};

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
    pub fn started_at(&self, place: &PolyarcPlace) -> Self {
        if !self.closed || place.segment >= self.segment_count() {
            return self.clone();
        }
        let (mut split, number) = self.with_vertex_at(place);
        split.vertices.rotate_left(number);
        split
    }

    /// The same path with a vertex at a place, and the number of that vertex.
    #[must_use]
    pub fn with_vertex_at(&self, place: &PolyarcPlace) -> (Self, usize) {
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
    pub fn between(&self, from: &PolyarcPlace, to: &PolyarcPlace) -> Self {
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

    /// The same path with as few vertices as it needs: neighbours on one line, or on one circle and
    /// together no more than half of it, become one. The start of a closed path may move.
    #[must_use]
    pub fn merged(&self) -> Self {
        let mut segments: Vec<Segment> = Vec::with_capacity(self.segment_count());
        for segment in self.segments() {
            match segments.last().and_then(|last| one(last, &segment)) {
                Some(both) => {
                    segments.pop();
                    segments.push(both);
                }
                None => segments.push(segment),
            }
        }
        if let (true, [first, .., last]) = (self.closed, segments.as_slice())
            && segments.len() > 2
            && let Some(both) = one(last, first)
        {
            segments[0] = both;
            segments.pop();
        }
        if segments.is_empty() { self.clone() } else { Self::from_segments(&segments, self.closed) }
    }
}

/// The one segment that two are parts of, if they are: what lies between its ends passes the joint
/// within [`tol::CONTACT_MM`].
fn one(first: &Segment, second: &Segment) -> Option<Segment> {
    let (start, joint, end) = (first.start(), first.end(), second.end());
    let near = |s: &Segment| s.distance(joint) <= tol::CONTACT_MM;
    match (first, second) {
        (Segment::Line { .. }, Segment::Line { .. }) => {
            let both = Segment::line(start, end);
            let onward = first.direction(0.0).dot(second.direction(0.0)) > 0.0;
            (onward && near(&both)).then_some(both)
        }
        (
            Segment::Arc { centre: c, radius: r, sweep_rad: a, .. },
            Segment::Arc { centre: d, radius: s, sweep_rad: b, .. },
        ) => {
            let circle = c.distance(*d) <= tol::CONTACT_MM && (r - s).abs() <= tol::CONTACT_MM;
            let half = (a + b).abs() <= std::f64::consts::PI + 1e-9;
            let both = Segment::bulged(start, end, (0.25 * (a + b)).tan());
            (circle && half && a * b > 0.0 && near(&both)).then_some(both)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_split_is_whole_again() {
        let shape = Polyarc::rounded_rectangle(Point2::new(0., 0.), Point2::new(60., 20.), 4.0);
        let mut split = shape.clone();
        for k in 1..9 {
            let place = split.place_after(f64::from(k) * 15.3).expect("a place");
            split = split.with_vertex_at(&place).0;
        }
        assert!(split.vertices.len() > shape.vertices.len() + 6);
        let merged = split.merged();
        assert_eq!(merged.vertices.len(), shape.vertices.len());
        assert!((merged.signed_area() - shape.signed_area()).abs() < 1e-9);
        let circle = Polyarc::circle(Point2::new(0., 0.), 5.0);
        assert_eq!(circle.merged().vertices.len(), 2);
    }
}
