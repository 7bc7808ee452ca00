//! Lines and arcs end to end: the shape of everything that is drawn and cut.

mod cross;
mod measure;
mod place;
mod remade;
mod winding;

pub use cross::Crossing;
pub use measure::Position;
pub use place::PolyarcPlace;
pub(crate) use winding::winding_of;

use crate::{Point2, Segment, Vec2};
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_8;

/// A place on a polyarc and the curve of the segment that starts there: tan(sweep / 4), positive
/// counter-clockwise, 0 for a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Vertex {
    /// Place of the vertex.
    pub at: Point2,
    /// The curve of the segment that starts here. The last vertex of an open polyarc has none.
    pub bulge: f64,
}

impl Vertex {
    /// A vertex at a place with a bulge.
    pub const fn new(x: f64, y: f64, bulge: f64) -> Self {
        Self { at: Point2::new(x, y), bulge }
    }
}

/// Lines and circular arcs, end to end.
///
/// A closed one returns from its last vertex to its first. A circle is two half circles, so it has two
/// vertices. A single vertex is a point, such as the place of a hole.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Polyarc {
    /// The places and curves, in the order of travel.
    pub vertices: Vec<Vertex>,
    /// Travel returns to the first vertex.
    pub closed: bool,
}

impl Polyarc {
    /// An open polyarc.
    pub fn open(vertices: Vec<Vertex>) -> Self {
        Self { vertices, closed: false }
    }

    /// A closed polyarc.
    pub fn closed(vertices: Vec<Vertex>) -> Self {
        Self { vertices, closed: true }
    }

    /// Straight lines through places.
    pub fn lines(places: impl IntoIterator<Item = Point2>, closed: bool) -> Self {
        let vertices = places.into_iter().map(|at| Vertex { at, bulge: 0.0 }).collect();
        Self { vertices, closed }
    }

    /// A circle, counter-clockwise from its rightmost place: two half circles.
    pub fn circle(centre: Point2, radius: f64) -> Self {
        let side = Vec2::new(radius, 0.0);
        let half = |at| Vertex { at, bulge: 1.0 };
        Self::closed(vec![half(centre + side), half(centre - side)])
    }

    /// An upright rectangle between two opposite corners, counter-clockwise from the lower left one.
    pub fn rectangle(a: Point2, b: Point2) -> Self {
        let (low, high) =
            (Point2::new(a.x.min(b.x), a.y.min(b.y)), Point2::new(a.x.max(b.x), a.y.max(b.y)));
        let corners = [low, Point2::new(high.x, low.y), high, Point2::new(low.x, high.y)];
        Self::lines(corners, true)
    }

    /// A rectangle with rounded corners. The radius is held to half the shorter side.
    pub fn rounded_rectangle(a: Point2, b: Point2, radius: f64) -> Self {
        let (w, h) = ((b.x - a.x).abs(), (b.y - a.y).abs());
        let r = radius.min(w.min(h) * 0.5);
        if r <= 0.0 {
            return Self::rectangle(a, b);
        }
        let low = Point2::new(a.x.min(b.x), a.y.min(b.y));
        let corner = FRAC_PI_8.tan();
        let at = |x: f64, y: f64, bulge: f64| Vertex { at: low + Vec2::new(x, y), bulge };
        let round = vec![
            at(r, 0.0, 0.0),
            at(w - r, 0.0, corner),
            at(w, r, 0.0),
            at(w, h - r, corner),
            at(w - r, h, 0.0),
            at(r, h, corner),
            at(0.0, h - r, 0.0),
            at(0.0, r, corner),
        ];
        Self::closed(round).tidied()
    }

    /// An arc about a centre, from a mathematical angle over a sweep (radians, counter-clockwise
    /// positive). A full turn or more gives the closed circle from that angle.
    pub fn arc(centre: Point2, radius: f64, from_rad: f64, sweep_rad: f64) -> Self {
        let start = centre + Vec2::from_angle(from_rad) * radius;
        if sweep_rad.abs() >= std::f64::consts::TAU {
            let bulge = sweep_rad.signum();
            let across = centre + (centre - start);
            return Self::closed([start, across].map(|at| Vertex { at, bulge }).to_vec());
        }
        let end = centre + Vec2::from_angle(from_rad + sweep_rad) * radius;
        let arc = Segment::Arc { start, end, centre, radius, sweep_rad };
        Self::from_segments(&[arc], false).with_short_arcs()
    }

    /// Returns the number of segments.
    pub fn segment_count(&self) -> usize {
        match (self.vertices.len(), self.closed) {
            (0 | 1, _) => 0,
            (n, true) => n,
            (n, false) => n - 1,
        }
    }

    /// The segment that starts at a vertex.
    ///
    /// # Panics
    /// When there is no such segment, as indexing does.
    pub fn segment(&self, number: usize) -> Segment {
        let from = self.vertices[number];
        let to = self.vertices.get(number + 1).unwrap_or(&self.vertices[0]);
        Segment::bulged(from.at, to.at, from.bulge)
    }

    /// The segments in the order of travel.
    pub fn segments(&self) -> impl ExactSizeIterator<Item = Segment> + DoubleEndedIterator + '_ {
        (0..self.segment_count()).map(|number| self.segment(number))
    }

    /// Returns the place where travel begins.
    pub fn start(&self) -> Option<Point2> {
        self.vertices.first().map(|v| v.at)
    }

    /// Returns the place where travel ends; for a closed polyarc where it began.
    pub fn end(&self) -> Option<Point2> {
        if self.closed { self.start() } else { self.vertices.last().map(|v| v.at) }
    }

    /// A polyarc through segments that follow each other. Only their starts and curves are kept, and
    /// the end of the last when it stays open.
    pub fn from_segments(segments: &[Segment], closed: bool) -> Self {
        Self::from_parts(segments.iter(), closed)
    }

    pub(crate) fn from_parts<'a>(
        segments: impl DoubleEndedIterator<Item = &'a Segment> + ExactSizeIterator + Clone,
        closed: bool,
    ) -> Self {
        let mut vertices = Vec::with_capacity(segments.len() + 1);
        vertices.extend(segments.clone().map(|s| Vertex { at: s.start(), bulge: s.bulge() }));
        if let (false, Some(last)) = (closed, segments.last()) {
            vertices.push(Vertex { at: last.end(), bulge: 0.0 });
        }
        Self { vertices, closed }
    }

    /// Each segment as an open polyarc of its own.
    pub fn exploded(&self) -> Vec<Self> {
        self.segments().map(|s| Self::from_segments(&[s], false)).collect()
    }
}

#[cfg(test)]
mod tests;
