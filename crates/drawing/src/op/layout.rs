//! The drawing as a whole on the table (Profiler reference, "Layout").

use super::OpError;
use super::edit::mirrored;
use crate::{Drawing, Editor, Shape};
use kerf_geom::{Point2, Transform2, Vec2};
use std::sync::Arc;

pub(super) fn left(draft: &mut Editor) {
    if let Some(bounds) = draft.drawing.bounds() {
        shift(&mut draft.drawing, Point2::default() - bounds.min);
    }
}

pub(super) fn surface(draft: &mut Editor) {
    left(draft);
    raise(&mut draft.drawing, |(_, top)| -top);
}

pub(super) fn bottom(draft: &mut Editor, bottom_mm: f64) -> Result<(), OpError> {
    if bottom_mm > 0.0 {
        let (what, bound) = ("ZBottom above ZSurface", "0 or below");
        return Err(OpError::Bound { what, value: bottom_mm, bound });
    }
    left(draft);
    raise(&mut draft.drawing, |(low, _)| bottom_mm - low);
    Ok(())
}

/// Turned and put back at the origin: (x, y) goes to (height − y, x) (readings, P-26).
pub(super) fn rotate90(draft: &mut Editor) {
    left(draft);
    let turn = Transform2::turned(Point2::default(), std::f64::consts::FRAC_PI_2);
    every(&mut draft.drawing, |shape| shape.mapped(&turn));
    left(draft);
    draft.drawing.moved = Vec2::default();
}

/// Mirrored and put back at the origin: (x, y) goes to (width − x, y).
pub(super) fn mirror(draft: &mut Editor) {
    left(draft);
    let map = Transform2::mirrored(Point2::default(), Vec2::new(0.0, 1.0));
    every(&mut draft.drawing, |shape| mirrored(shape, &map, false));
    left(draft);
    draft.drawing.moved = Vec2::default();
}

pub(super) fn origin(draft: &mut Editor, at: Point2) {
    shift(&mut draft.drawing, Point2::default() - at);
}

pub(super) fn cad_origin(draft: &mut Editor) {
    let back = -draft.drawing.moved;
    shift(&mut draft.drawing, back);
    draft.drawing.moved = Vec2::default();
}

fn shift(drawing: &mut Drawing, by: Vec2) {
    if by != Vec2::default() {
        let map = Transform2::moved(by);
        every(drawing, |shape| shape.mapped(&map));
        drawing.moved = drawing.moved + by;
    }
}

/// Raises all 3D shapes by what `by` makes of their lowest and highest point.
fn raise(drawing: &mut Drawing, by: impl Fn((f64, f64)) -> f64) {
    let heights = drawing.shapes.iter().filter_map(|shape| shape.z_mm.as_ref()).flatten();
    let range = heights
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, top), z| (low.min(*z), top.max(*z)));
    if range.0 > range.1 {
        return;
    }
    let by = by(range);
    every(drawing, |shape| {
        let raised = |z: &Vec<f64>| z.iter().map(|z| z + by).collect();
        Shape { z_mm: shape.z_mm.as_ref().map(raised), ..shape.clone() }
    });
}

fn every(drawing: &mut Drawing, change: impl Fn(&Shape) -> Shape) {
    for shape in &mut drawing.shapes {
        *shape = Arc::new(change(shape));
    }
}
