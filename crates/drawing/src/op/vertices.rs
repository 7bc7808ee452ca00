//! Vertices and segments of one shape (Profiler reference, "Edit").

use super::OpError;
use super::edit::above_zero;
use crate::{Editor, Shape};
use kerf_geom::{Bounds2, Point2, Polyarc, Segment, Vec2};
use std::sync::Arc;

pub(super) fn bulge(
    draft: &mut Editor,
    shape: usize,
    at: Point2,
    bulge: f64,
) -> Result<(), OpError> {
    change(draft, shape, |path| {
        let segment = segment_at(path, at)?;
        path.vertices[segment].bulge = bulge;
        Ok(())
    })
}

/// The bulge that gives a radius r over a chord c is r/h − √((r/h)² − 1) with h = c/2; the side stays,
/// and a line bends to the right of travel like a positive bulge.
pub(super) fn radius(
    draft: &mut Editor,
    shape: usize,
    at: Point2,
    radius: f64,
) -> Result<(), OpError> {
    above_zero("the radius", radius)?;
    change(draft, shape, |path| {
        let number = segment_at(path, at)?;
        let segment = path.segment(number);
        let half = 0.5 * segment.start().distance(segment.end());
        let ratio = radius / half;
        // The half circle is allowed to be missed by rounding.
        if ratio < 1.0 - 1e-9 {
            return Err(format!("a radius of {radius} is less than half of the chord, {half}"));
        }
        let size = ratio - (ratio * ratio - 1.0).max(0.0).sqrt();
        let side = if path.vertices[number].bulge < 0.0 { -1.0 } else { 1.0 };
        path.vertices[number].bulge = side * size;
        Ok(())
    })
}

/// Arcs on both sides go through the middle they had (Profiler reference, "Adjust vertex").
pub(super) fn shift(
    draft: &mut Editor,
    shape: usize,
    at: Point2,
    to: Point2,
) -> Result<(), OpError> {
    change(draft, shape, |path| {
        let vertex = vertex_at(path, at)?;
        let count = path.segment_count();
        let before = (vertex > 0 || path.closed)
            .then(|| (vertex + path.vertices.len() - 1) % path.vertices.len());
        let sides: Vec<usize> =
            before.into_iter().chain([vertex]).filter(|segment| *segment < count).collect();
        let middles: Vec<Point2> = sides.iter().map(|n| path.segment(*n).at(0.5)).collect();
        path.vertices[vertex].at = to;
        for (number, middle) in sides.into_iter().zip(middles) {
            if path.vertices[number].bulge != 0.0 {
                let segment = path.segment(number);
                path.vertices[number].bulge =
                    Segment::bulge_through(segment.start(), middle, segment.end());
            }
        }
        Ok(())
    })
}

pub(super) fn stretch(draft: &mut Editor, a: Point2, b: Point2, by: Vec2) -> Result<(), OpError> {
    let window = Bounds2::of(a, b);
    let reached = |place: &usize| {
        let vertices = &draft.drawing.shapes[*place].path.vertices;
        vertices.iter().any(|vertex| window.holds(vertex.at))
    };
    if !draft.selected()?.iter().any(reached) {
        return Err(OpError::NothingThere("no vertex of the selected shapes", "in the window"));
    }
    draft.change_selected(|_, shape| {
        let mut shape = shape.clone();
        let inside = shape.path.vertices.iter_mut().filter(|vertex| window.holds(vertex.at));
        inside.for_each(|vertex| vertex.at += by);
        Ok(shape)
    })
}

/// Moves single vertices, each found before any of them moves. Vertices of several selected shapes at one place go
/// together, as in a window round that place.
pub(super) fn stretch_at(draft: &mut Editor, at: &[Point2], by: Vec2) -> Result<(), OpError> {
    let selected = draft.selected()?;
    let shapes = selected.iter().map(|place| &draft.drawing.shapes[*place]);
    let all: Vec<Point2> =
        shapes.flat_map(|shape| shape.path.vertices.iter().map(|vertex| vertex.at)).collect();
    let nearest = |place: &Point2| {
        let near = |a: &&Point2, b: &&Point2| a.distance(*place).total_cmp(&b.distance(*place));
        all.iter().min_by(near).copied()
    };
    let moved: Vec<Point2> = at.iter().filter_map(nearest).collect();
    draft.change_selected(|_, shape| {
        let mut shape = shape.clone();
        let picked = shape.path.vertices.iter_mut().filter(|vertex| moved.contains(&vertex.at));
        picked.for_each(|vertex| vertex.at += by);
        Ok(shape)
    })
}

/// The segment that ended at a vertex keeps its bulge and goes on to the next vertex.
pub(super) fn delete(draft: &mut Editor, shape: usize, at: &[Point2]) -> Result<(), OpError> {
    let (_, found) = draft.shape(shape)?;
    if found.z_mm.is_some() {
        let why = "vertices can be deleted from flat shapes only; it is a 3D shape".into();
        return Err(OpError::Shape { shape, at: None, why });
    }
    change(draft, shape, |path| {
        let mut vertices = Vec::new();
        for place in at {
            vertices.push(vertex_at(path, *place)?);
        }
        vertices.sort_unstable();
        vertices.dedup();
        for vertex in vertices.into_iter().rev() {
            path.vertices.remove(vertex);
        }
        let least = if path.closed && path.vertices.iter().all(|v| v.bulge == 0.0) { 3 } else { 2 };
        if path.vertices.len() < least {
            return Err(format!("{} vertices would be left: too few", path.vertices.len()));
        }
        if let (false, Some(last)) = (path.closed, path.vertices.last_mut()) {
            last.bulge = 0.0;
        }
        Ok(())
    })
}

fn change(
    draft: &mut Editor,
    shape: usize,
    make: impl FnOnce(&mut Polyarc) -> Result<(), String>,
) -> Result<(), OpError> {
    let (place, found) = draft.shape(shape)?;
    let mut changed: Shape = found.as_ref().clone();
    make(&mut changed.path).map_err(|why| OpError::Shape { shape, at: None, why })?;
    changed.start_inserted = false;
    draft.drawing.shapes[place] = Arc::new(changed);
    Ok(())
}

fn segment_at(path: &Polyarc, at: Point2) -> Result<usize, String> {
    let nearest = path.nearest(at).filter(|_| path.segment_count() > 0);
    nearest.map(|(place, _)| place.segment).ok_or_else(|| "it has no segments".into())
}

fn vertex_at(path: &Polyarc, at: Point2) -> Result<usize, String> {
    let far = |n: &usize| path.vertices[*n].at.distance(at);
    let nearest = (0..path.vertices.len()).min_by(|a, b| far(a).total_cmp(&far(b)));
    nearest.ok_or_else(|| "it has no vertices".into())
}
