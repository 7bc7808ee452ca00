//! Length, area, bounds, places along the path, the nearest place.

use super::Polyarc;
use crate::segment::{square, twice_cap_area};
use crate::{Bounds2, Point2, Vec2};

/// A place on a polyarc.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// Number of the segment.
    pub segment: usize,
    /// Share of the segment's path, 0 … 1.
    pub share: f64,
    /// Coordinates of the place.
    pub at: Point2,
}

impl Polyarc {
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
    pub fn nearest(&self, place: Point2) -> Option<(Place, f64)> {
        if let [only] = self.vertices.as_slice() {
            let found = Place { segment: 0, share: 0.0, at: only.at };
            return Some((found, only.at.distance(place)));
        }
        let mut best: Option<(Place, f64)> = None;
        for (number, segment) in self.segments().enumerate() {
            let distance = segment.distance(place);
            if best.is_none_or(|(_, least)| distance < least) {
                let foot = segment.nearest(place);
                let found = Place { segment: number, share: foot.share, at: foot.at };
                best = Some((found, distance));
            }
        }
        best
    }

    /// The place after a length of path; before the start it is the start, past the end the end.
    pub fn place_after(&self, length: f64) -> Option<Place> {
        let mut left = length.max(0.0);
        let mut last = None;
        for (segment, s) in self.segments().enumerate() {
            let long = s.length();
            let share = if long > 0.0 { (left / long).min(1.0) } else { 1.0 };
            last = Some(Place { segment, share, at: s.at(share) });
            if left <= long {
                return last;
            }
            left -= long;
        }
        let only = |at| Place { segment: 0, share: 0.0, at };
        last.or_else(|| self.start().map(only))
    }

    /// Length of path from the start to a place.
    pub fn length_to(&self, place: &Place) -> f64 {
        let before: f64 = self.segments().take(place.segment).map(|s| s.length()).sum();
        let within = self.segments().nth(place.segment).map_or(0.0, |s| s.length() * place.share);
        before + within
    }

    /// Unit direction of travel at a place.
    pub fn direction(&self, place: &Place) -> Vec2 {
        self.segments().nth(place.segment).map_or(Vec2::default(), |s| s.direction(place.share))
    }
}
