//! Points as a shape of a drawing, and back.

use crate::way::arc;
use crate::{Digitizer, Dimension, Kind, Point, Refusal, Stand};
use kerf_drawing::Shape;
use kerf_geom::{Point2, Polyarc, Segment, Vertex, tol};

impl Digitizer {
    /// The points as a shape of the black group. A closed one returns from the last point to the first by a
    /// line; a last point where the first one is closes it by itself. One point is a place to drill.
    ///
    /// In 2D it has no heights, in 3D those of its points above ZSurface.
    ///
    /// # Errors
    /// Too few points, or an arc point that makes no arc.
    pub fn shape(&self, closed: bool, surface_mm: f64) -> Result<Shape, Refusal> {
        self.check_ends()?;
        let shape = match self.dimension {
            Dimension::Two => Shape::flat(Polyarc { vertices: self.vertices()?, closed }.tidied()),
            Dimension::Three => self.in_space(closed, surface_mm),
        };
        let path = &shape.path;
        if self.points.len() > 1 && path.vertices.len() < 2 {
            return Err(Refusal::OnePlace);
        }
        let curved = path.vertices.iter().any(|vertex| vertex.bulge != 0.0);
        if closed && path.vertices.len() < if curved { 2 } else { 3 } {
            return Err(Refusal::TooFewToClose);
        }
        path.check().map_err(|_| Refusal::TooFar)?;
        Ok(shape)
    }

    fn check_ends(&self) -> Result<(), Refusal> {
        let [first, .., last] = self.points.as_slice() else {
            let only = self.points.first().ok_or(Refusal::NoPoints)?;
            return if only.kind == Kind::Arc { Err(Refusal::ArcAtEnd(1)) } else { Ok(()) };
        };
        let ends = [(first, 1), (last, self.points.len())];
        let arc = ends.into_iter().find(|(point, _)| point.kind == Kind::Arc);
        arc.map_or(Ok(()), |(_, number)| Err(Refusal::ArcAtEnd(number)))
    }

    /// The line points, each with the bulge of the arc that follows.
    fn vertices(&self) -> Result<Vec<Vertex>, Refusal> {
        let mut vertices: Vec<Vertex> = Vec::with_capacity(self.points.len());
        for (n, point) in self.points.iter().enumerate() {
            if point.kind == Kind::Line {
                vertices.push(Vertex { at: point.stand.at, bulge: 0.0 });
                continue;
            }
            let through = n.checked_sub(1).and_then(|before| self.points.get(before..=n + 1));
            let arc = through.and_then(arc).ok_or(Refusal::NoArc(n + 1))?;
            if let Some(start) = vertices.last_mut() {
                start.bulge = arc.bulge();
            }
        }
        Ok(vertices)
    }

    /// Lines with heights. Points above each other are two, the same place twice is one.
    fn in_space(&self, closed: bool, surface_mm: f64) -> Shape {
        let same =
            |a: &Stand, b: &Stand| a.at.distance(b.at).hypot(a.z_mm - b.z_mm) <= tol::SAME_PLACE_MM;
        let mut stands: Vec<Stand> = self.points.iter().map(|point| point.stand).collect();
        stands.dedup_by(|b, a| same(a, b));
        while let (true, [first, _, .., last]) = (closed, stands.as_slice()) {
            if !same(first, last) {
                break;
            }
            stands.pop();
        }
        let path = Polyarc::lines(stands.iter().map(|stand| stand.at), closed);
        let z_mm = stands.iter().map(|stand| Stand::new(0.0, 0.0, stand.z_mm - surface_mm).z_mm);
        Shape::with_heights(path, z_mm.collect())
    }

    /// Replaces the points by those of a shape, the first one current: its vertices, and the middles of its
    /// arcs as arc points. A closed shape whose last segment is an arc ends with its first point again.
    ///
    /// A flat shape lies at the height of the tool and is worked on in 2D, one with heights in 3D.
    ///
    /// # Errors
    /// A shape with heights and arcs, which there are none of in 3D, or one without vertices.
    pub fn load(&mut self, shape: &Shape, surface_mm: f64, tool: &Stand) -> Result<(), Refusal> {
        let path = &shape.path;
        if path.vertices.is_empty() {
            return Err(Refusal::NoShape);
        }
        let curved = (0..path.segment_count()).any(|n| path.vertices[n].bulge != 0.0);
        if shape.z_mm.is_some() && curved {
            return Err(Refusal::ArcInSpace);
        }
        let z_mm = |n| shape.z_mm.as_ref().map_or(tool.z_mm, |_| surface_mm + shape.height_mm(n));
        let mut points = Vec::with_capacity(path.vertices.len() * 2);
        for (n, vertex) in path.vertices.iter().enumerate() {
            points.push(point(vertex.at, z_mm(n), Kind::Line));
            if n < path.segment_count() && vertex.bulge != 0.0 {
                points.push(point(path.segment(n).at(0.5), z_mm(n), Kind::Arc));
            }
        }
        if points.last().is_some_and(|last| last.kind == Kind::Arc) {
            points.push(point(path.vertices[0].at, z_mm(0), Kind::Line));
        }
        let three = shape.z_mm.is_some();
        let dimension = if three { Dimension::Three } else { Dimension::Two };
        let next = if three { Kind::Line } else { self.next };
        *self = Self { points, current: 1, dimension, next, unsaved: false };
        Ok(())
    }

    /// The segments through the points, for a picture: a line where points make no arc yet.
    pub fn segments(&self) -> Vec<Segment> {
        (1..self.points.len()).map(|number| self.between(number, number + 1)).collect()
    }
}

fn point(at: Point2, z_mm: f64, kind: Kind) -> Point {
    Point::new(Stand { at, z_mm }, kind)
}

/// Which of some shapes passes nearest to a place, and how far it is, millimetres.
///
/// # Errors
/// There are none.
pub fn nearest_shape<'a>(
    shapes: impl IntoIterator<Item = &'a Shape>,
    at: Point2,
) -> Result<(usize, f64), Refusal> {
    let far = |shape: &Shape| shape.path.nearest(at).map(|(_, far)| far);
    let ways = shapes.into_iter().enumerate().filter_map(|(n, shape)| Some((n, far(shape)?)));
    ways.min_by(|(_, a), (_, b)| a.total_cmp(b)).ok_or(Refusal::NoShape)
}
