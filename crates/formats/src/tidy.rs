//! Tidies shapes in the same way for every reader, so that a drawing that is written and read again is the same.

use kerf_drawing::Shape;
use kerf_geom::{Polyarc, tol};

/// The shape without segments that nobody can see; nothing when none is left. An open path whose end is
/// its start is closed: both are the same to a machine, and only closed shapes have an inside. Shapes
/// with heights stay as they are. Not for places to drill, which have no segment.
pub fn tidied(shape: Shape) -> Option<Shape> {
    if shape.z_mm.is_some() {
        return Some(shape);
    }
    let path = closed_by_its_end(straightened(shape.path).tidied());
    (path.segment_count() > 0).then_some(Shape { path, ..shape })
}

/// Arcs that rise above their chord by less than this are lines, millimetres: what programs that round their
/// numbers make of a line. Their radius would be that of the Earth.
const STRAIGHT_MM: f64 = 1e-6;

fn straightened(mut path: Polyarc) -> Polyarc {
    for n in 0..path.segment_count() {
        let (from, to) = (path.vertices[n], path.vertices[(n + 1) % path.vertices.len()]);
        if 0.5 * from.bulge.abs() * from.at.distance(to.at) < STRAIGHT_MM && from.bulge.abs() < 1e-6
        {
            path.vertices[n].bulge = 0.0;
        }
    }
    path
}

fn closed_by_its_end(path: Polyarc) -> Polyarc {
    let ends = path.start().zip(path.vertices.last().map(|last| last.at));
    let meets = ends.is_some_and(|(start, end)| start.distance(end) <= tol::SAME_PLACE_MM);
    if path.closed || !meets || path.vertices.len() < 3 {
        return path;
    }
    Polyarc { closed: true, ..path }.tidied()
}
