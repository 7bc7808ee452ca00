//! New shapes (Profiler reference, "Draw").

use super::edit::above_zero;
use super::{OpError, spot};
use crate::{Editor, Shape, heighten};
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

/// Tells whether lines that end where they began go round something: then they are closed (Profiler reference,
/// glossary, "Polyline"). A way there and back along itself is not.
fn comes_back(vertices: &[Vertex]) -> bool {
    let [first, inner @ .., last] = vertices else { return false };
    let arcs = inner.iter().chain([first]).any(|vertex| vertex.bulge != 0.0);
    first.at == last.at && inner.len() > usize::from(!arcs)
}

pub(super) fn polyarc(
    draft: &mut Editor,
    vertices: &[Vertex],
    closed: bool,
) -> Result<Vec<String>, OpError> {
    let returns = closed || comes_back(vertices);
    let path = Polyarc { vertices: vertices.to_vec(), closed: returns }.tidied();
    if path.segment_count() == 0 {
        return Err(OpError::SamePlace("all points of the line"));
    }
    draft.drawing.add(Shape::flat(path));
    let told = |at| {
        format!(
            "shape {}: a segment without length{} is left out",
            draft.drawing.shapes.len(),
            spot(Some(at))
        )
    };
    Ok(repeated(vertices).map(told).collect())
}

/// Straight lines with heights; a single place is a place to drill to its height. A way straight down is one; the same place again is none.
pub(super) fn space_line(
    draft: &mut Editor,
    places: &[[f64; 3]],
    closed: bool,
) -> Result<Vec<String>, OpError> {
    let (given, mut places) = (places.len(), places.to_vec());
    places.dedup();
    if closed && places.len() > 2 && places.first() == places.last() {
        places.pop();
    }
    if places.len() < 2 && given > 1 {
        return Err(OpError::SamePlace("all points of the line"));
    }
    let closed = closed && places.len() > 1;
    let path = Polyarc::lines(places.iter().map(|[x, y, _]| Point2::new(*x, *y)), closed);
    let z_mm = places.iter().map(|[_, _, z]| *z).collect();
    let number = draft.drawing.shapes.len();
    draft.drawing.add(Shape::with_heights(path, z_mm));
    let made = heighten(&mut draft.drawing, number..number + 1);
    Ok(made.iter().map(ToString::to_string).collect())
}

/// Places that are drawn again at once; the last one again says that the line ends there.
fn repeated(vertices: &[Vertex]) -> impl Iterator<Item = Point2> {
    let before_last = &vertices[..vertices.len().saturating_sub(1)];
    before_last.windows(2).filter(|pair| pair[0].at == pair[1].at).map(|pair| pair[0].at)
}
