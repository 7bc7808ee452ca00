//! Corners rounded and cut, paths beside shapes, joining, breaking, trimming (Profiler reference,
//! "Edit").

use super::OpError;
use super::edit::above_zero;
use crate::{Editor, Kind, Shape};
use kerf_geom::{Coarse, GeomError, Offsetter, Point2, Polyarc, edit};
use std::sync::Arc;

/// Directions that differ by less make no corner, radians.
const NO_CORNER_RAD: f64 = 1e-6;

pub(super) fn fillet(draft: &mut Editor, radius: f64, at: Option<Point2>) -> Result<(), OpError> {
    above_zero("the radius", radius)?;
    corners(draft, at, |path, vertex| edit::fillet(path, vertex, radius))
}

pub(super) fn chamfer(draft: &mut Editor, length: f64, at: Option<Point2>) -> Result<(), OpError> {
    above_zero("the length", length)?;
    corners(draft, at, |path, vertex| edit::chamfer(path, vertex, length))
}

type Change<'a> = dyn Fn(&Polyarc, usize) -> Result<Polyarc, GeomError> + 'a;

fn corners(
    draft: &mut Editor,
    at: Option<Point2>,
    change: impl Fn(&Polyarc, usize) -> Result<Polyarc, GeomError>,
) -> Result<(), OpError> {
    if draft
        .selected()?
        .iter()
        .all(|place| corner_vertices(&draft.drawing.shapes[*place].path).is_empty())
    {
        return Err(OpError::NothingThere("no corner", "in the selected shapes"));
    }
    match at {
        None => draft.change_selected(|number, shape| every_corner(number, shape, &change)),
        Some(at) => nearest_corner(draft, at, &change),
    }
}

/// Corners are changed from the last to the first, so that numbers of those left stay.
fn every_corner(number: usize, shape: &Shape, change: &Change) -> Result<Shape, OpError> {
    flat_only(number, shape)?;
    let mut path = shape.path.clone();
    for vertex in corner_vertices(&shape.path).into_iter().rev() {
        path = change(&path, vertex).map_err(|error| told(number, &error))?;
    }
    Ok(Shape { path, start_inserted: false, ..shape.clone() })
}

fn nearest_corner(draft: &mut Editor, at: Point2, change: &Change) -> Result<(), OpError> {
    let corners = draft.selected()?.into_iter().flat_map(|place| {
        let path = &draft.drawing.shapes[place].path;
        let far = move |vertex: usize| (path.vertices[vertex].at.distance(at), place, vertex);
        corner_vertices(path).into_iter().map(far).collect::<Vec<_>>()
    });
    let nearest = corners.min_by(|a, b| a.0.total_cmp(&b.0));
    let Some((_, place, vertex)) = nearest else { return Ok(()) };
    let shape = &draft.drawing.shapes[place];
    flat_only(place + 1, shape)?;
    let path = change(&shape.path, vertex).map_err(|error| told(place + 1, &error))?;
    draft.drawing.shapes[place] = Arc::new(Shape { path, ..shape.as_ref().clone() });
    Ok(())
}

fn corner_vertices(path: &Polyarc) -> Vec<usize> {
    let count = path.segment_count();
    let turns = |vertex: &usize| {
        let before = path.segment((vertex + count - 1) % count).direction(1.0);
        let after = path.segment(*vertex).direction(0.0);
        before.cross(after).atan2(before.dot(after)).abs() > NO_CORNER_RAD
    };
    let first = usize::from(!path.closed);
    (first..count).filter(turns).collect()
}

fn flat_only(shape: usize, found: &Shape) -> Result<(), OpError> {
    if found.z_mm.is_none() {
        return Ok(());
    }
    Err(OpError::Shape {
        shape,
        at: None,
        why: "only flat shapes can be changed so; it is a 3D shape".into(),
    })
}

fn told(shape: usize, error: &GeomError) -> OpError {
    OpError::Shape { shape, at: None, why: error.to_string() }
}

pub(super) fn offset(
    draft: &mut Editor,
    distance: f64,
    keep: bool,
) -> Result<Vec<String>, OpError> {
    if distance == 0.0 {
        return Err(OpError::Bound { what: "the distance", value: 0.0, bound: "other than 0" });
    }
    let (mut warnings, offsetter) = (Vec::new(), Offsetter::default());
    for place in draft.selected()?.into_iter().rev() {
        let shape = draft.drawing.shapes[place].clone();
        flat_only(place + 1, &shape)?;
        let found =
            offsetter.offset(&shape.path, distance).map_err(|error| told(place + 1, &error))?;
        if let Some(coarse) = Coarse::of(&found) {
            warnings.insert(0, format!("shape {}: {coarse}", place + 1));
        }
        if found.is_empty() {
            let why = format!("nothing is left of it at {distance} mm");
            return Err(OpError::Shape { shape: place + 1, at: None, why });
        }
        let beside = |path| Shape { path, start_inserted: false, ..shape.as_ref().clone() };
        let mut with: Vec<Shape> = found.into_iter().map(|found| beside(found.path)).collect();
        if keep {
            with.insert(0, shape.as_ref().clone());
        }
        draft.replace(place, with);
    }
    Ok(warnings)
}

/// Joined shapes take the place, group and marks of the first of their parts.
pub(super) fn join(draft: &mut Editor, distance: Option<f64>, merge: bool) -> Result<(), OpError> {
    let distance = distance.unwrap_or(draft.join_mm);
    above_zero("the distance", distance)?;
    let places = draft.selected()?;
    let flat: Vec<usize> =
        places.into_iter().filter(|n| draft.drawing.shapes[*n].z_mm.is_none()).collect();
    let paths: Vec<Polyarc> = flat.iter().map(|n| draft.drawing.shapes[*n].path.clone()).collect();
    let ends = if merge { edit::Ends::Merge } else { edit::Ends::Keep };
    let mut gone = vec![false; draft.drawing.shapes.len()];
    for joined in edit::join(&paths, distance, ends) {
        let mut members: Vec<usize> = joined.members.iter().map(|member| flat[*member]).collect();
        members.sort_unstable();
        let Some((first, others)) = members.split_first() else { continue };
        let shape = &draft.drawing.shapes[*first];
        let whole = Shape { path: joined.path, start_inserted: false, ..shape.as_ref().clone() };
        if !others.is_empty() || whole.path != shape.path {
            draft.drawing.shapes[*first] = Arc::new(whole);
        }
        others.iter().for_each(|n| gone[*n] = true);
    }
    draft.remove(&gone);
    draft.join_mm = distance;
    Ok(())
}

pub(super) fn break_at(draft: &mut Editor, number: usize, at: Point2) -> Result<(), OpError> {
    let (place, shape) = draft.shape(number)?;
    flat_only(number, shape)?;
    let shape = shape.clone();
    let parts = shape.path.nearest(at).map(|(found, _)| edit::broken(&shape.path, &found));
    // An open shape in one part is what it was.
    let Some(parts) = parts.filter(|parts| shape.is_closed() || parts.len() > 1) else {
        let why = if shape.kind() == Kind::Point { "it is a point" } else { "it ends there" };
        let why = format!("{why}: there is nothing to break");
        return Err(OpError::Shape { shape: number, at: None, why });
    };
    replace_paths(draft, place, &shape, parts);
    Ok(())
}

/// The shape that is picked is the nearest one; what cuts it are the selected shapes, itself included.
pub(super) fn trim(draft: &mut Editor, at: Point2) -> Result<(), OpError> {
    let cutters = draft.selected()?;
    let far = |n: &usize| draft.drawing.shapes[*n].path.nearest(at).map_or(f64::INFINITY, |f| f.1);
    let nearest = (0..draft.drawing.shapes.len()).min_by(|a, b| far(a).total_cmp(&far(b)));
    let Some(place) = nearest else { return Ok(()) };
    let shape = draft.drawing.shapes[place].clone();
    flat_only(place + 1, &shape)?;
    let cutters: Vec<Polyarc> =
        cutters.iter().map(|n| draft.drawing.shapes[*n].path.clone()).collect();
    let rest = edit::trimmed(&shape.path, at, &cutters).map_err(|error| told(place + 1, &error))?;
    replace_paths(draft, place, &shape, rest);
    Ok(())
}

fn replace_paths(draft: &mut Editor, place: usize, shape: &Shape, paths: Vec<Polyarc>) {
    let part = |path| Shape { path, start_inserted: false, ..shape.clone() };
    draft.replace(place, paths.into_iter().map(part).collect());
}
