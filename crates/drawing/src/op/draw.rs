//! New shapes (Profiler reference, "Draw").

use super::OpError;
use super::edit::above_zero;
use crate::{Editor, Shape};
use kerf_geom::{Point2, Polyarc, Vertex};

pub(super) fn circle(draft: &mut Editor, centre: Point2, radius: f64) -> Result<(), OpError> {
    above_zero("the radius", radius)?;
    draft.drawing.add(Shape::flat(Polyarc::circle(centre, radius)));
    Ok(())
}

pub(super) fn rectangle(draft: &mut Editor, a: Point2, b: Point2) -> Result<(), OpError> {
    let size = b - a;
    for (what, value) in [("the width", size.x), ("the height", size.y)] {
        if value == 0.0 {
            return Err(OpError::Bound { what, value, bound: "other than 0" });
        }
    }
    let corners = [a, Point2::new(b.x, a.y), b, Point2::new(a.x, b.y)];
    draft.drawing.add(Shape::flat(Polyarc::lines(corners, true)));
    Ok(())
}

pub(super) fn point(draft: &mut Editor, at: Point2) {
    draft.drawing.add(Shape::point(at));
}

pub(super) fn polyarc(
    draft: &mut Editor,
    vertices: &[Vertex],
    closed: bool,
) -> Result<(), OpError> {
    let path = Polyarc { vertices: vertices.to_vec(), closed }.tidied();
    if path.segment_count() == 0 {
        return Err(OpError::SamePlace("all points of the line"));
    }
    draft.drawing.add(Shape::flat(path));
    Ok(())
}
