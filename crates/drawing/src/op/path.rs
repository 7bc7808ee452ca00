//! Start of a cut and its direction (Profiler reference, "Path").

use super::OpError;
use crate::{Editor, Nesting, Shape};
use kerf_geom::{Point2, Polyarc, Segment};
use std::sync::Arc;

pub(super) fn reverse(draft: &mut Editor) -> Result<(), OpError> {
    draft.change_selected(|_, shape| Ok(shape.reversed()))
}

pub(super) fn pause(draft: &mut Editor, on: bool) -> Result<(), OpError> {
    draft.change_selected(|_, shape| Ok(Shape { pause: on, ..shape.clone() }))
}

/// Outer shapes become counter-clockwise, what lies in them clockwise, and so on inwards. Shapes that
/// cross each other are told: neither contains the other.
pub(super) fn directions(draft: &mut Editor) -> Vec<String> {
    let shapes = &mut draft.drawing.shapes;
    let nesting = Nesting::of(shapes);
    for (n, shape) in shapes.iter_mut().enumerate() {
        let wanted = if nesting.depth(n).is_multiple_of(2) { 1.0 } else { -1.0 };
        if shape.is_closed() && shape.path.signed_area() * wanted < 0.0 {
            *shape = Arc::new(shape.reversed());
        }
    }
    let both_closed =
        |pair: &&(usize, usize)| shapes[pair.0].is_closed() && shapes[pair.1].is_closed();
    nesting.across().iter().filter(both_closed).map(warn_of_crossing).collect()
}

fn warn_of_crossing(pair: &(usize, usize)) -> String {
    let (a, b) = (pair.0 + 1, pair.1 + 1);
    format!("shapes {a} and {b} cross each other: check their directions")
}

pub(super) fn start(draft: &mut Editor, number: usize, at: Point2) -> Result<(), OpError> {
    let (place, shape) = draft.shape(number)?;
    let changed = if shape.is_closed() { started_at(shape, at) } else { started_at_end(shape, at) };
    draft.drawing.shapes[place] = Arc::new(changed);
    Ok(())
}

/// An open shape begins at one of its ends: the nearer one.
fn started_at_end(shape: &Shape, at: Point2) -> Shape {
    let far = |end: Option<Point2>| end.map_or(f64::INFINITY, |end| end.distance(at));
    if far(shape.path.end()) < far(shape.path.start()) { shape.reversed() } else { shape.clone() }
}

/// A closed shape begins anywhere. A vertex that an earlier start has inserted goes away when it
/// lies within one line or one arc.
fn started_at(shape: &Shape, at: Point2) -> Shape {
    let plain = without_inserted_start(shape);
    let Some((place, _)) = plain.path.nearest(at) else { return shape.clone() };
    let (split, vertex) = plain.path.with_vertex_at(&place);
    let inserted = split.vertices.len() > plain.path.vertices.len();
    let mut z_mm = plain.z_mm.clone();
    if let Some(z) = &mut z_mm {
        if inserted {
            z.insert(vertex, plain.height_at(&place));
        }
        z.rotate_left(vertex);
    }
    let mut path = split;
    path.vertices.rotate_left(vertex);
    Shape { path, z_mm, start_inserted: inserted, ..plain }
}

fn without_inserted_start(shape: &Shape) -> Shape {
    let count = shape.path.segment_count();
    let removable = shape.start_inserted && shape.z_mm.is_none() && count > 2;
    let joined =
        removable.then(|| joined(&shape.path.segment(count - 1), &shape.path.segment(0))).flatten();
    let Some(joined) = joined else {
        return Shape { start_inserted: false, ..shape.clone() };
    };
    let mut vertices = shape.path.vertices.clone();
    vertices.remove(0);
    if let Some(last) = vertices.last_mut() {
        last.bulge = joined.bulge();
    }
    Shape { path: Polyarc { vertices, closed: true }, start_inserted: false, ..shape.clone() }
}

/// The one segment that two segments are parts of, if they are and it is no full circle.
fn joined(first: &Segment, second: &Segment) -> Option<Segment> {
    let (start, end) = (first.start(), second.end());
    match (first, second) {
        (Segment::Line { .. }, Segment::Line { .. }) => Some(Segment::line(start, end)),
        (Segment::Arc { sweep_rad: a, .. }, Segment::Arc { sweep_rad: b, .. }) => {
            Some(Segment::bulged(start, end, (0.25 * (a + b)).tan()))
        }
        _ => None,
    }
}
