//! What is asked of a polyarc: length, area, bounds, places along it, what lies in it and what crosses it.

use super::Polyarc;
use super::cross::{self, Crossing};
use super::place::PolyarcPlace;
use super::winding::winding_of;
use crate::segment::{square, twice_cap_area};
use crate::{Bounds2, BoxTree, GeomError, Point2, Segment, Vec2, tol};

/// Position of a place relative to a closed contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Position {
    /// The contour winds round it.
    Inside,
    /// The contour does not wind round it.
    Outside,
    /// It is on the contour, within [`tol::SAME_PLACE_MM`].
    OnEdge,
}

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

    /// Length of the path.
    pub fn length(&self) -> f64 {
        // A sum of nothing is −0.
        self.segments().map(|s| s.length()).sum::<f64>() + 0.0
    }

    /// Area enclosed, positive when travelled counter-clockwise. An open polyarc is closed by a
    /// straight line.
    ///
    /// A = ½ Σ (pᵢ × pᵢ₊₁) + ½ Σ r²(sweep − sin sweep), computed from the first vertex so that
    /// contours far from the origin keep their digits.
    pub fn signed_area(&self) -> f64 {
        let Some(origin) = self.start() else { return 0.0 };
        let mut twice = 0.0;
        let next = self.vertices.iter().skip(1).chain(self.vertices.first());
        for (number, (from, to)) in self.vertices.iter().zip(next).enumerate() {
            twice += (from.at - origin).cross(to.at - origin);
            if from.bulge != 0.0 && number < self.segment_count() {
                twice += twice_cap_area(square(to.at - from.at), from.bulge);
            }
        }
        twice * 0.5
    }

    /// The smallest upright rectangle around the path, arcs counted exactly.
    pub fn bounds(&self) -> Bounds2 {
        let mut bounds: Bounds2 = self.vertices.iter().map(|v| v.at).collect();
        for (number, v) in self.vertices.iter().enumerate() {
            if v.bulge != 0.0 && number < self.segment_count() {
                bounds.merge(&self.segment(number).bounds());
            }
        }
        bounds
    }

    /// The place of the path nearest to another place, and how far it is; nothing for an empty one.
    /// Many questions to one polyarc are answered faster by [`crate::Indexed`].
    pub fn nearest(&self, place: Point2) -> Option<(PolyarcPlace, f64)> {
        if let [only] = self.vertices.as_slice() {
            let found = PolyarcPlace { segment: 0, share: 0.0, at: only.at };
            return Some((found, only.at.distance(place)));
        }
        let mut best: Option<(PolyarcPlace, f64)> = None;
        for (number, segment) in self.segments().enumerate() {
            let distance = segment.distance(place);
            if best.is_none_or(|(_, least)| distance < least) {
                let foot = segment.nearest(place);
                let found = PolyarcPlace { segment: number, share: foot.share, at: foot.at };
                best = Some((found, distance));
            }
        }
        best
    }

    /// The place after a length of path; before the start it is the start, past the end the end.
    pub fn place_after(&self, length: f64) -> Option<PolyarcPlace> {
        let mut left = length.max(0.0);
        let mut last = None;
        for (segment, s) in self.segments().enumerate() {
            let long = s.length();
            let share = if long > 0.0 { (left / long).min(1.0) } else { 1.0 };
            last = Some(PolyarcPlace { segment, share, at: s.at(share) });
            if left <= long {
                return last;
            }
            left -= long;
        }
        let only = |at| PolyarcPlace { segment: 0, share: 0.0, at };
        last.or_else(|| self.start().map(only))
    }

    /// Length of path from the start to a place.
    pub fn length_to(&self, place: &PolyarcPlace) -> f64 {
        let before: f64 = self.segments().take(place.segment).map(|s| s.length()).sum();
        let within = self.segments().nth(place.segment).map_or(0.0, |s| s.length() * place.share);
        before + within
    }

    /// Unit direction of travel at a place.
    pub fn direction(&self, place: &PolyarcPlace) -> Vec2 {
        self.segments().nth(place.segment).map_or(Vec2::default(), |s| s.direction(place.share))
    }

    /// Counts how often the contour winds counter-clockwise round a place that is not on it. An open
    /// polyarc is closed by a straight line.
    ///
    /// Counts crossings of the ray from the place to the right: up +1, down −1. Each segment is cut
    /// where it turns from up to down, and counts its lower end but not its upper one, so that a
    /// vertex on the ray is counted once.
    pub fn winding(&self, place: Point2) -> i32 {
        let closing = match (self.closed, self.start(), self.vertices.last()) {
            (false, Some(start), Some(last)) => winding_of(&Segment::line(last.at, start), place),
            _ => 0,
        };
        self.segments().map(|s| winding_of(&s, place)).sum::<i32>() + closing
    }

    /// Returns the position of a place: inside if the contour winds round it, in either direction. For a contour that
    /// crosses itself, loops count as inside however they are turned.
    pub fn position(&self, place: Point2) -> Position {
        if self.segments().any(|s| s.distance(place) <= tol::SAME_PLACE_MM) {
            Position::OnEdge
        } else if self.winding(place) != 0 {
            Position::Inside
        } else {
            Position::Outside
        }
    }

    /// Tells whether another polyarc lies inside this closed one. The two may touch; they must not cross
    /// ([`Polyarc::crossings`] tells), as the contours of a part and its holes do not.
    pub fn contains(&self, other: &Self) -> bool {
        if !self.bounds().grown(tol::SAME_PLACE_MM).holds_box(&other.bounds()) {
            return false;
        }
        let middles = other.segments().map(|s| s.at(0.5));
        let places = middles.chain(other.vertices.iter().map(|v| v.at));
        let decided = places.map(|p| self.position(p)).find(|&p| p != Position::OnEdge);
        // Wholly on the edge: one is the other, or a part of it.
        decided.is_none_or(|p| p == Position::Inside)
    }

    /// The boxes of all segments, for finding them by place.
    pub fn index(&self) -> BoxTree {
        BoxTree::new(self.segments().map(|s| s.bounds().grown(tol::CONTACT_MM)))
    }

    /// All places shared with another polyarc, in the order of travel along this one. Touching counts.
    pub fn crossings(&self, other: &Self) -> Vec<Crossing> {
        cross::crossings(self, other)
    }

    /// All places where the polyarc crosses or touches itself, in the order of travel; the joints of
    /// neighbouring segments are none.
    pub fn self_crossings(&self) -> Vec<Crossing> {
        cross::self_crossings(self)
    }

    /// One of the places where the polyarc crosses or touches itself; it does not look for the others.
    pub fn crosses_itself(&self) -> Option<Crossing> {
        cross::crosses_itself(self)
    }

    /// Returns `true` if the polyarc is closed and neither crosses nor touches itself.
    pub fn is_simple(&self) -> bool {
        self.closed && self.segment_count() > 1 && self.crosses_itself().is_none()
    }
}
